#include "oracle/certified/equilibrium.hpp"

#include "oracle/certified/root.hpp"

namespace lubjoint::certified {

EquilibriumBalls equilibrium(const LawEntry& law, const EquilibriumState& state) {
  const Ball spin(state.omega_sum);
  const Ball scale = force_scale(law, state.viscosity, state.length, state.radius, Ball(state.clearance));
  const Ball wx(state.load_x);
  const Ball wy(state.load_y);
  const auto force_at = [&](const Ball& epsilon) {
    const PolarBalls ratio = force_ratio(law.law, {epsilon, epsilon * spin, Ball(0)});
    return PolarBalls{scale * ratio.radial, scale * ratio.tangential};
  };
  const auto excess = [&](const Ball& epsilon) {
    const PolarBalls f = force_at(epsilon);
    return f.radial * f.radial + f.tangential * f.tangential - wx * wx - wy * wy;
  };
  // No force at ε = 0, a boundless one towards ε = 1.
  const Ball epsilon = enclosed_root(excess, Ball(0), Ball(1));
  const auto [radial, tangential] = force_at(epsilon);
  // In complex numbers (F_r + i F_t) r = −W.
  const Ball square = radial * radial + tangential * tangential;
  const Ball rx = -((wx * radial + wy * tangential) / square);
  const Ball ry = -((wy * radial - wx * tangential) / square);
  const Ball forward = state.omega_sum > 0 ? tangential : -tangential;
  return {epsilon, epsilon * rx, epsilon * ry, atan2(forward, -radial)};
}

}  // namespace lubjoint::certified

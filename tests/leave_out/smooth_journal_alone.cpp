// A free journal on a film without a jump, with the implicit integrator. What it is made of is the test.
#include <cstdio>

#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "lubjoint/motion/film_modes.hpp"
#include "lubjoint/ode/exact_jacobian.hpp"
#include "lubjoint/ode/radau_iia.hpp"

int main() {
  using Law = lubjoint::PinkusSternlicht;
  using State = std::array<double, 4>;
  const lubjoint::LubricatedJoint<Law, double> joint(lubjoint::Bearing<double>(0.04, 0.0098, 2e-4),
                                                     lubjoint::Lubricant<double>(0.4));
  const lubjoint::FreeJournal<Law> journal(joint, {0.13, lubjoint::Vector2<double>(0, -31.2753), 0, 52.36});
  const lubjoint::SmoothMode<Law> mode(journal);
  const auto rate = [&](const State& y, State& dydt, double t) { mode.rate(y, dydt, t); };
  const auto jacobian = [&](const State& y, auto& j, double t) {
    lubjoint::exact_jacobian([&](const auto& x, auto& dxdt) { mode.rate(x, dxdt, t); }, y, j);
  };
  lubjoint::RadauIIA5<double, 4> stepper(1e-8, {1e-8, 1e-8, 1e-6, 1e-6});
  State y{};
  double t = 0;
  double dt = 1e-6;
  while (t < 1) stepper.try_step(std::make_pair(rate, jacobian), y, t, dt);
  const auto force = mode.force(t, y);
  std::printf("%.17g %.17g %.17g\n", t, force.x(), force.y());
}

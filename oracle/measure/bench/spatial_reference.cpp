#include "oracle/measure/bench/spatial_reference.hpp"

#include <algorithm>

#include "lubjoint/ode/explicit_integrators.hpp"
#include "oracle/trajectories/spatial_slider_crank_scene.hpp"

namespace lubjoint::reports {

namespace {

using Real = long double;
using Mechanism = mechanisms::LubricatedSpatialSliderCrank<PinkusSternlicht, Real>;
using State = Mechanism::State;

class Equations final : public OdeSystem<Real, 6> {
 public:
  explicit Equations(const Mechanism& mechanism) : mechanism_(mechanism) {}
  void rate(const State& y, State& dydt, const Real& t) override { mechanism_.rate(t, y, dydt); }
  void jacobian(const State&, Jacobian&, const Real&) override {}
  void time_slope(const State&, State&, const Real&) override {}

 private:
  const Mechanism& mechanism_;
};

/// Steps to each time and looks there. @param reach  (from, y, to)
template <class Reach>
Reference looked_at(const Mechanism& mechanism, State y, const std::vector<double>& times, const Reach& reach) {
  Reference seen;
  Real t = 0;
  for (const double time : times) {
    reach(t, y, Real(time));
    t = Real(time);
    const auto e = mechanism.eccentricity(y);
    seen.emplace_back(static_cast<double>(e[0]), static_cast<double>(e[1]));
  }
  return seen;
}

}  // namespace

SpatialReference spatial_reference(const SpatialScene& scene, const std::vector<double>& times) {
  const auto mechanism = lubricated_spatial_slider_crank<PinkusSternlicht, Real>(scene);
  const State start = mechanism.start(Real(crank_angle_of(scene)), Real(crank_speed_of(scene)));
  constexpr Real tolerance = 1e-12L;  // of a method of order 14
  mechanisms::Lobatto<Real, 6> lobatto(tolerance);
  const Reference one =
      looked_at(mechanism, start, times, [&](Real from, State& y, Real to) { lobatto.reach(mechanism, from, y, to); });
  constexpr Real of_step = 1e-15L;
  State allowed;
  mechanism.weights(start, allowed);
  for (Real& each : allowed) each *= of_step;
  Fehlberg78Integrator<Real, 6> fehlberg({0, allowed, of_step});
  Equations equations(mechanism);
  Real dt = 1e-6L * scene.run.duration;
  const Reference other = looked_at(mechanism, start, times, [&](Real t, State& y, Real to) {
    while (t < to) {
      const Real wanted = dt;
      const bool last = t + dt >= to;
      if (last) dt = to - t;
      if (!fehlberg.try_step(equations, y, t, dt) || !last) continue;
      t = to;
      dt = std::max(dt, wanted);
    }
  });
  double apart = 0;
  for (std::size_t i = 0; i < times.size(); ++i) apart = std::max(apart, (one[i] - other[i]).norm());
  return {times, one, apart};
}

}  // namespace lubjoint::reports

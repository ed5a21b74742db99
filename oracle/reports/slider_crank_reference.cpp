#include "oracle/reports/slider_crank_reference.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <stdexcept>

#include "lubjoint/film/law_list.hpp"
#include "oracle/reports/slider_crank_scene.hpp"

namespace lubjoint::reports {

namespace {

using mechanisms::DeviationState;

/// Integrates to a time exactly; a trial step beyond the wall is halved.
template <class R>
class Integration {
 public:
  explicit Integration(double tolerance)
      : stepper_(boost::numeric::odeint::make_controlled(R(tolerance), R(0), Pair())) {}

  template <class Mechanism>
  void to(const Mechanism& mechanism, DeviationState<R>& y, R& t, const R& goal) {
    const auto rate = [&](const auto& x, auto& dxdt, const R& s) { mechanism.rate(x, dxdt, s); };
    if (dt_ == 0) dt_ = (goal - t) / 1000;
    while (t < goal) {
      const R wanted = dt_;
      const bool last = dt_ >= goal - t;
      if (last) dt_ = goal - t;
      const DeviationState<R> before = y;
      const R t_before = t;
      try {
        const bool accepted = stepper_.try_step(rate, y, t, dt_) == boost::numeric::odeint::success;
        if (accepted && last) {
          t = goal;
          dt_ = std::max(dt_, wanted);
        }
      } catch (const FilmDomainError&) {
        y = before;
        t = t_before;
        dt_ /= 2;
      }
    }
  }

 private:
  using Pair = boost::numeric::odeint::runge_kutta_fehlberg78<DeviationState<R>, R>;
  boost::numeric::odeint::controlled_runge_kutta<Pair> stepper_;
  R dt_ = 0;
};

template <class Law>
std::vector<ReferenceSample> run_with(const Scene& scene, const std::vector<double>& times, double tolerance) {
  using R = long double;
  const auto mechanism = lubricated_slider_crank<Law, R>(scene);
  Integration<R> integration(tolerance);
  DeviationState<R> y{0, 0, 0, 0};
  R t = 0;
  std::vector<ReferenceSample> samples;
  for (const double time : times) {
    integration.to(mechanism, y, t, R(time));
    const auto pin = mechanism.pin(t, y);
    samples.push_back({pin.eccentricity.template cast<double>(), pin.force.template cast<double>(),
                       static_cast<double>(mechanism.driving_moment(t, y))});
  }
  return samples;
}

template <class Law>
PeriodicOrbit orbit_with(const Scene& scene, const Vector2<double>& last) {
  const auto mechanism = lubricated_slider_crank<Law, double>(scene);
  const double period = boost::math::constants::two_pi<double>() / crank_speed_of(scene);
  const auto revolution = [&](const Eigen::Vector4d& start) {
    DeviationState<double> y{start(0), start(1), start(2), start(3)};
    double t = 0;
    Integration<double>(1e-11).to(mechanism, y, t, period);
    return Eigen::Vector4d(y[0], y[1], y[2], y[3]);
  };
  Eigen::Vector4d y = revolution(revolution(Eigen::Vector4d::Zero()));
  PeriodicOrbit orbit;
  Eigen::Matrix4d map;
  for (int iteration = 0; iteration < 4; ++iteration) {
    const Eigen::Vector4d end = revolution(y);
    // Difference quotients: truncation of the order of the step, rounding of the integration 1e-11 over it.
    const double step = 1e-6;
    for (int k = 0; k < 4; ++k) map.col(k) = (revolution(y + step * Eigen::Vector4d::Unit(k)) - end) / step;
    orbit.residual = (end - y).head<2>().norm();
    if (orbit.residual < 1e-9) break;
    y -= (map - Eigen::Matrix4d::Identity()).lu().solve(end - y);
  }
  const Eigen::EigenSolver<Eigen::Matrix4d> solver(map, false);
  for (int k = 0; k < 4; ++k) orbit.multipliers.push_back(solver.eigenvalues()(k));
  std::sort(orbit.multipliers.begin(), orbit.multipliers.end(),
            [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
  orbit.distance = (mechanism.eccentricity(0, y(0), y(1)) - last).norm();
  return orbit;
}

}  // namespace

mechanisms::SliderCrank<double> slider_crank_of(const Scene& scene) { return mechanism_of<double>(scene); }

double crank_speed_of(const Scene& scene) {
  for (const SceneConstraint& each : scene.constraints) {
    if (const auto* driver = std::get_if<SceneDriver>(&each.kind)) return driver->speed;
  }
  throw std::invalid_argument(scene.file + " has no driver");
}

std::vector<ReferenceSample> minimal_coordinates_run(const Scene& scene, const std::vector<double>& times,
                                                     double tolerance) {
  require_film_law(scene.joints.at(0).film);
  if (scene.joints[0].film != PinkusSternlicht::name) {
    throw std::invalid_argument("minimal coordinates are run with pinkus_sternlicht alone");
  }
  return run_with<PinkusSternlicht>(scene, times, tolerance);
}

PeriodicOrbit periodic_orbit(const Scene& scene, const Vector2<double>& last) {
  return orbit_with<PinkusSternlicht>(scene, last);
}

}  // namespace lubjoint::reports

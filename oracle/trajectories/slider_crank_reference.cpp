#include "oracle/trajectories/slider_crank_reference.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <stdexcept>

#include "lubjoint/film/law_list.hpp"
#include "oracle/trajectories/slider_crank_scene.hpp"

namespace lubjoint::reports {

namespace {

using mechanisms::DeviationState;

/// Integrates to a time exactly; a trial step beyond the wall is halved.
template <class R>
class Integration {
 public:
  /// @param first_step  0: a thousandth of the first stretch
  explicit Integration(double tolerance, const R& first_step = R(0))
      : stepper_(boost::numeric::odeint::make_controlled(R(tolerance), R(0), Pair())), dt_(first_step) {}

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
  R dt_;
};

/// A start (q, q̇) of all bodies as deviation from the ideal mechanism with its crank at 0.
template <class R>
DeviationState<R> deviation_of(const Scene& scene, const std::vector<R>& start) {
  const auto m = mechanism_of<R>(scene);
  const R speed(crank_speed_of(scene));
  const R c(scene.joints.at(0).clearance);
  const mechanisms::IdealMotion<R> ideal = mechanisms::ideal_motion<R>(m, {R(0), speed, R(0)});
  const auto coordinate = [&](const std::string& body, std::size_t k) {
    return 3 * static_cast<std::size_t>(&body_of(scene, body) - scene.bodies.data()) + k;
  };
  const std::size_t rates = 3 * scene.bodies.size();
  const std::size_t phi = coordinate("rod", 2);
  const std::size_t x = coordinate("slider", 0);
  return {m.rod_length * (start.at(phi) - ideal.rod.value) / c, (start.at(x) - ideal.slider.value) / c,
          m.rod_length * (start.at(rates + phi) - ideal.rod.rate) / (c * speed),
          (start.at(rates + x) - ideal.slider.rate) / (c * speed)};
}

/// A run of one law in 64-bit significands, sampled, and the states of the samples.
template <class Law>
class Run {
 public:
  using R = long double;

  Run(const Scene& scene, const std::vector<double>& times, double tolerance, const std::vector<long double>& start)
      : mechanism_(lubricated_slider_crank<Law, R>(scene)), times_(times), tolerance_(tolerance) {
    Integration<R> integration(tolerance);
    DeviationState<R> y{0, 0, 0, 0};
    if (!start.empty()) y = deviation_of<R>(scene, start);
    R t = 0;
    for (const double time : times) {
      integration.to(mechanism_, y, t, R(time));
      states_.push_back(y);
      samples_.push_back(sample(t, y));
    }
  }

  const std::vector<ReferenceSample>& samples() const { return samples_; }

  /// @param quantity  of a sample
  template <class Quantity>
  Peak peak(const Quantity& quantity) const {
    std::vector<double> values;
    for (const ReferenceSample& each : samples_) values.push_back(quantity(each));
    const std::size_t last = values.size() - 1;
    const auto largest = std::max_element(values.begin(), values.end());
    Peak best{*largest, times_[static_cast<std::size_t>(largest - values.begin())]};
    // What a maximum can gain between samples is far less than a tenth of it.
    const double near = best.value - std::abs(best.value) / 10;
    for (std::size_t i = 0; i <= last; ++i) {
      if (values[i] < near || (i > 0 && values[i] < values[i - 1]) || (i < last && values[i] < values[i + 1])) continue;
      const std::size_t from = i == 0 ? 0 : i - 1;
      const auto found =
          boost::math::tools::brent_find_minima([&](double time) { return -quantity(sample_between(from, time)); },
                                                times_[from], times_[std::min(i + 1, last)], 24);
      if (-found.second > best.value) best = {-found.second, found.first};
    }
    return best;
  }

 private:
  ReferenceSample sample(const R& t, const DeviationState<R>& y) const {
    const auto pin = mechanism_.pin(t, y);
    return {pin.eccentricity.template cast<double>(), pin.force.template cast<double>(),
            static_cast<double>(mechanism_.driving_moment(t, y))};
  }

  ReferenceSample sample_between(std::size_t from, double time) const {
    DeviationState<R> y = states_[from];
    R t = times_[from];
    if (time > times_[from]) Integration<R>(tolerance_, R(times_[1] - times_[0]) / 8).to(mechanism_, y, t, R(time));
    return sample(t, y);
  }

  mechanisms::LubricatedSliderCrank<Law, R> mechanism_;
  std::vector<double> times_;
  double tolerance_;
  std::vector<DeviationState<R>> states_;
  std::vector<ReferenceSample> samples_;
};

void require_minimal_coordinates(const Scene& scene) {
  require_film_law(scene.joints.at(0).film);
  if (scene.joints[0].film != PinkusSternlicht::name) {
    throw std::invalid_argument("minimal coordinates are run with pinkus_sternlicht alone");
  }
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

bool has_contact(const Scene& scene) {
  return std::any_of(scene.joints.begin(), scene.joints.end(),
                     [](const SceneJoint& j) { return j.contact.has_value(); });
}

bool has_minimal_coordinates(const Scene& scene) {
  if (scene.joints.size() != 1 || scene.joints[0].film != PinkusSternlicht::name || has_contact(scene)) return false;
  try {
    slider_crank_of(scene);
    return crank_speed_of(scene) > 0;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

std::vector<ReferenceSample> minimal_coordinates_run(const Scene& scene, const std::vector<double>& times,
                                                     double tolerance, const std::vector<long double>& start) {
  require_minimal_coordinates(scene);
  return Run<PinkusSternlicht>(scene, times, tolerance, start).samples();
}

ReferenceRun minimal_coordinates_run_with_peaks(const Scene& scene, const std::vector<double>& times,
                                                double tolerance) {
  require_minimal_coordinates(scene);
  if (times.size() < 2) throw std::invalid_argument("peaks need two times at least");
  const Run<PinkusSternlicht> run(scene, times, tolerance, {});
  const Peak least = run.peak([](const ReferenceSample& s) { return -s.driving_moment; });
  return {run.samples(),
          {run.peak([](const ReferenceSample& s) { return s.eccentricity_ratio.norm(); }),
           run.peak([](const ReferenceSample& s) { return s.force.norm(); }),
           run.peak([](const ReferenceSample& s) { return s.driving_moment; }),
           {-least.value, least.t}}};
}

PeriodicOrbit periodic_orbit(const Scene& scene, const Vector2<double>& last) {
  return orbit_with<PinkusSternlicht>(scene, last);
}

}  // namespace lubjoint::reports

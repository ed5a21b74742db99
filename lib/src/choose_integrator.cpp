#include "choose_integrator.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <sstream>

namespace lubjoint::detail {

namespace {

/// An eigenvalue problem of this size takes about a millisecond.
constexpr Eigen::Index largest_eigenvalue_problem = 48;

/// dopri5's region of stability reaches to −3.3 on the real axis.
constexpr double stability_reach = 3.3;

/// What dies out in a film does so within the tolerance only where its rate times the step is of the size of the
/// tolerance's fifth root: from this tolerance down that, and not stability, limits an explicit step of order 5. Of ∫λ
/// dt dopri5 takes 0.007 to 0.02 τ^(−1/5) on the slider-cranks from 1e-7 to 1e-12 (data/measured/bench-scenes.csv).
constexpr double followed_below = 4e-8;

/// An explicit step of order 5 costs 6 evaluations; one of Radau about 25, its Jacobian and factors counted.
constexpr double implicit_step_cost = 4;

/// One of radau_iia9, likewise, where its tolerances are tight: seven Newton iterations of five stages, or with films'
/// slopes of its own at each four, and as many for what is seen of its inside.
constexpr double order_nine_step_cost = 7.5;

/// From this tolerance down radau_iia9 is the faster one, samples and records included; above, its steps cost more for
/// the same tolerance and are nearer than it asks. In absolute coordinates steps so long make more of the rounding of
/// places than of errors.
constexpr double order_nine_from = 1e-10;

/// Below this tolerance the pair of order 8 needs fewer evaluations than the one of order 5, where the motion is
/// smooth. With films and contacts it does, too, but its error is then further above the tolerance: at 1e-12, 4e-7
/// clearances on the impact, where order 5 leaves 3e-11 (data/measured/bench-scenes.csv).
constexpr double high_order_below = 1e-6;

std::string rounded(double steps) {
  std::ostringstream text;
  text.precision(2);
  text << steps;
  return text.str();
}

}  // namespace

RunSettings pilot_settings(const RunSettings& settings) {
  RunSettings pilot = settings;
  pilot.relative_tolerance = pilot.absolute_tolerance = pilot_tolerance;
  pilot.output_interval = settings.duration / pilot_samples;
  return pilot;
}

double fastest_decay(const Eigen::MatrixXd& jacobian, const std::vector<double>& tolerances) {
  if (!jacobian.allFinite()) return INFINITY;
  if (jacobian.rows() <= largest_eigenvalue_problem) return std::max(0.0, -jacobian.eigenvalues().real().minCoeff());
  const auto scale = Eigen::Map<const Eigen::VectorXd>(tolerances.data(), jacobian.rows());
  return (scale.cwiseInverse().asDiagonal() * jacobian * scale.asDiagonal()).cwiseAbs().rowwise().sum().maxCoeff();
}

IntegratorChoice choose_integrator(const StiffnessMeasure& measure, double relative_tolerance) {
  if (!measure.pilot_finished)
    return {"radau_iia5", "a pilot run did not finish, which asks for the method that bears most"};
  // Order 5: steps grow with the fifth root of the tolerance.
  const auto more = [&](double from, double order) { return std::pow(from / relative_tolerance, 1 / order); };
  const double accuracy_steps = measure.pilot_steps * more(pilot_tolerance, 5);
  const double decay_steps = measure.stability_steps / stability_reach * std::max(1.0, more(followed_below, 5));
  const std::string counts = (relative_tolerance < followed_below ? "what dies out" : "stability") +
                             std::string(" asks an explicit method for ") + rounded(decay_steps) +
                             " steps, accuracy for about " + rounded(accuracy_steps);
  const bool stiff = decay_steps > implicit_step_cost * accuracy_steps;
  if (measure.independent && (stiff || !measure.smooth) && relative_tolerance <= order_nine_from) {
    const double order_nine_steps = measure.pilot_steps * more(pilot_tolerance, 10);
    if (std::max(decay_steps, accuracy_steps) > order_nine_step_cost * order_nine_steps)
      return {"radau_iia9", (stiff ? "stiff: " : "") + counts + ", order 9 for about " + rounded(order_nine_steps)};
  }
  if (stiff) return {"radau_iia5", "stiff: " + counts};
  const bool high_order = measure.smooth && relative_tolerance < high_order_below;
  return {high_order ? "fehlberg78" : "dopri5", "not stiff: " + counts};
}

}  // namespace lubjoint::detail

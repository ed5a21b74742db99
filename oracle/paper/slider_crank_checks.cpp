#include "oracle/paper/slider_crank_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>

namespace lubjoint::reports {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double position_limit = 1e-8;  // c: some thousand steps of 1e-10 each
constexpr double velocity_limit =
    1e-6;  // c times the crank's speed: the rate of the cubic between steps loses two digits

/// What the limits of position and velocity allow a force to be off, over its peak.
/// F grows as (1 − ε)^(-5/2) or slower: 5/2 δε/(1 − ε). Its damping at the centre is 6πS (long bearing).
double force_limit(const Scene& scene, const ReferencePeaks& peaks) {
  const SceneJoint& joint = scene.joints.at(0);
  const double r = joint.journal_radius;
  const double scale = joint.viscosity * joint.length * r * r * r / (joint.clearance * joint.clearance);
  const double damping = 6 * boost::math::constants::pi<double>() * scale;
  return 2.5 * position_limit / (1 - peaks.eccentricity_ratio.value) +
         damping * velocity_limit * crank_speed_of(scene) / peaks.force.value;
}

/// Distance of two times of a motion that may repeat itself after a turn.
double time_difference(double one, double other, double turn) { return std::abs(std::remainder(one - other, turn)); }

/// Largest difference at the samples; infinite if they do not belong together, or one is not a number.
template <class Difference>
double largest_difference(const MultibodyTrajectory& run, const ReferenceRun& reference, const Difference& difference) {
  if (run.samples.empty() || run.samples.size() != reference.samples.size()) return infinity;
  double largest = 0;
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const double found = difference(run.samples[i], reference.samples[i]);
    if (std::isnan(found)) return infinity;
    largest = std::max(largest, found);
  }
  return largest;
}

double ratio_difference(const Scene& scene, const MultibodyTrajectory& run, const ReferenceRun& reference) {
  const double c = scene.joints.at(0).clearance;
  return largest_difference(run, reference, [&](const MultibodySample& sample, const ReferenceSample& expected) {
    return (sample.joints[0].eccentricity / c - expected.eccentricity_ratio).norm();
  });
}

}  // namespace

std::vector<Check> compare_with_minimal_coordinates(const Scene& scene, const MultibodyTrajectory& run,
                                                    const ReferenceRun& reference) {
  const double c = scene.joints.at(0).clearance;
  const ReferencePeaks& peaks = reference.peaks;
  const double least_gap = 1 - peaks.eccentricity_ratio.value;
  const double largest_moment = std::max(peaks.max_moment.value, -peaks.min_moment.value);
  const double allowed_force = force_limit(scene, peaks);
  const double turn = boost::math::constants::two_pi<double>() / crank_speed_of(scene);
  const std::string at_outputs = "minimal coordinates at every output time";
  const std::string peak = "minimal coordinates";
  const std::string force_reason = "1e-8 c and 1e-6 c spin, times the film's stiffness near the wall and its damping";
  std::vector<Check> checks;
  const bool finished = run.outcome.status == RunStatus::finished;
  checks.push_back(Check::holds("run", "the scene's duration", finished, finished ? "ends" : run.outcome.message,
                                "the run reaches the end of the scene"));
  checks.push_back(Check::at_most("e/c", at_outputs, ratio_difference(scene, run, reference), position_limit, "c",
                                  "some thousand steps of 1e-10 each"));
  checks.push_back(
      Check::at_most("joint force", at_outputs,
                     largest_difference(run, reference,
                                        [&](const MultibodySample& sample, const ReferenceSample& expected) {
                                          return (sample.joints[0].force - expected.force).norm() / peaks.force.value;
                                        }),
                     allowed_force, "of its peak", force_reason));
  checks.push_back(Check::at_most(
      "driving moment", at_outputs,
      largest_difference(run, reference,
                         [&](const MultibodySample& sample, const ReferenceSample& expected) {
                           return std::abs(sample.driving_moments[0] - expected.driving_moment) / largest_moment;
                         }),
      allowed_force, "of its peak", "as the joint force, which it carries"));
  checks.push_back(
      Check::at_most("film thickness", at_outputs,
                     largest_difference(run, reference,
                                        [&](const MultibodySample& sample, const ReferenceSample& expected) {
                                          const double film = c * (1 - expected.eccentricity_ratio.norm());
                                          return std::abs(sample.joints[0].film_thickness - film) / film;
                                        }),
                     position_limit / least_gap, "of itself", "1e-8 c over the least film"));
  const JointExtremes& joint = run.joints.at(0);
  const DriverExtremes& driver = run.drivers.at(0);
  checks.push_back(Check::at_most("least film", peak,
                                  (peaks.eccentricity_ratio.value - joint.eccentricity.value / c) / least_gap,
                                  position_limit / least_gap, "of itself", "1e-8 c over the least film"));
  checks.push_back(Check::at_most("largest force", peak, joint.force.value / peaks.force.value - 1, allowed_force,
                                  "of itself", force_reason));
  checks.push_back(Check::at_most("moment's extremes", peak,
                                  std::max(std::abs(driver.max_moment.value - peaks.max_moment.value),
                                           std::abs(driver.min_moment.value - peaks.min_moment.value)) /
                                      largest_moment,
                                  allowed_force, "of the larger", "as the joint force, which it carries"));
  checks.push_back(Check::at_most("times of these", peak,
                                  std::max({time_difference(joint.eccentricity.t, peaks.eccentricity_ratio.t, turn),
                                            time_difference(joint.force.t, peaks.force.t, turn),
                                            time_difference(driver.max_moment.t, peaks.max_moment.t, turn),
                                            time_difference(driver.min_moment.t, peaks.min_moment.t, turn)}),
                                  6e-7, "s",
                                  "a peak is flat: known to 1e-7, it is placed to 3e-4 of a radian of the crank, 6e-7 "
                                  "s; in either turn, as the second may repeat the first"));
  return checks;
}

Check energy_check(const MultibodyTrajectory& run, double tolerance) {
  const char* what = "energy";
  const char* against = "the work of drivers, loads and film, integrated along";
  if (run.outcome.status != RunStatus::finished) {
    return Check::holds(what, against, false, run.outcome.message, "the run must reach its end");
  }
  if (!run.energy_residual) return Check::not_checked(what, "the run kept no ledger");
  return Check::at_most(what, against, *run.energy_residual / run.energy_scale, 100 * tolerance, "of the largest",
                        "a hundred times the tolerance of a step");
}

Check swapped_check(const Scene& swapped, const MultibodyTrajectory& run, const ReferenceRun& reference) {
  // What the peak of a force that grows as (1 - e/c)^(-5/2) or slower says of e/c.
  const double gap = 1 - reference.peaks.eccentricity_ratio.value;
  const double force = std::abs(run.joints.at(0).force.value / reference.peaks.force.value - 1) * gap / 3;
  return Check::at_most("bearing on the slider", "minimal coordinates with the bearing there: e/c and peak force",
                        std::max(ratio_difference(swapped, run, reference), force), 1e-6, "c",
                        "some hundred steps of 1e-8 each; the peak force as e/c");
}

}  // namespace lubjoint::reports

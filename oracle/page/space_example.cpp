#include "oracle/page/space_example.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lubjoint::reports::page {

namespace {

/// Largest difference at the output times after the start, infinite if they do not belong together or one is not a
/// number.
template <class Difference>
double largest_difference(const SpatialTrajectory& run, const std::vector<SpacePin>& reference,
                          const Difference& difference) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (reference.empty() || run.samples.size() != reference.size() + 1) return infinity;
  double largest = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const double found = difference(run.samples[i + 1].joints.at(0), reference[i]);
    if (std::isnan(found)) return infinity;
    largest = std::max(largest, found);
  }
  return largest;
}

}  // namespace

std::vector<SpacePin> space_reference(const SpatialScene& scene, const std::vector<double>& times) {
  constexpr double tolerance =
      1e-8;  // of a method of order 14: errors of 1e-11 c and 2e-7 of the largest force were measured
  const auto mechanism = lubricated_spatial_slider_crank<PinkusSternlicht, double>(scene);
  auto y = mechanism.start(crank_angle_of(scene), crank_speed_of(scene));
  mechanisms::Lobatto<double, 6> steps(tolerance);
  std::vector<SpacePin> pins;
  double before = 0;
  for (const double t : times) {
    steps.reach(mechanism, before, y, t);
    before = t;
    const auto found = mechanism.pin(y);
    pins.push_back({Vector3<double>(found.eccentricity[0], found.eccentricity[1], found.eccentricity[2]),
                    Vector3<double>(found.force[0], found.force[1], found.force[2])});
  }
  return pins;
}

std::vector<Check> space_checks(const SpatialScene& scene, const SpatialTrajectory& run,
                                const std::vector<SpacePin>& reference) {
  const double c = scene.joints.at(0).plane.clearance;
  const double tolerance = std::max(scene.run.relative_tolerance, scene.run.absolute_tolerance);
  const double angle_tolerance = tolerance * c / scene_units(scene).mechanism;
  const std::string at_outputs = "minimal coordinates at every output time";
  const bool finished = run.outcome.status == RunStatus::finished;
  double largest_force = 0;
  for (const SpacePin& pin : reference) largest_force = std::max(largest_force, pin.force.norm());
  std::vector<Check> checks;
  checks.push_back(Check::holds("run", "the scene's duration", finished, finished ? "ends" : run.outcome.message,
                                "the run reaches the end of the scene"));
  checks.push_back(Check::at_most("e/c", at_outputs,
                                  largest_difference(run, reference,
                                                     [&](const SpatialJointSample& found, const SpacePin& pin) {
                                                       return (found.eccentricity / c - pin.eccentricity).norm();
                                                     }),
                                  10 * tolerance, "c", "ten times the tolerance of a step: the film damps"));
  checks.push_back(Check::at_most("joint force", at_outputs,
                                  largest_difference(run, reference,
                                                     [&](const SpatialJointSample& found, const SpacePin& pin) {
                                                       return (found.force - pin.force).norm() / largest_force;
                                                     }),
                                  100 * tolerance, "of its peak",
                                  "a hundred times the tolerance of a step: the film follows the journal's velocity, "
                                  "which is known less well than its place"));
  const char* many_steps = "a hundred times the tolerance of a step, which is in clearances";
  checks.push_back(Check::at_most("constraints", "their own equations", run.drift.position, 100 * tolerance * c,
                                  "m or rad", many_steps));
  checks.push_back(Check::at_most("tilt", "the thrust faces, which allow none", run.joints.at(0).tilt.value,
                                  100 * angle_tolerance, "rad", "a hundred times the tolerance of a step, of angles"));
  checks.push_back(Check::at_most("Euler parameters", "|p| = 1 before they are normalised", run.drift.norm,
                                  angle_tolerance, "", "the tolerance of a step, of angles: each ends with |p| = 1"));
  const char* energy = "energy";
  const char* against = "the work of the film, integrated along";
  if (run.energy_residual) {
    checks.push_back(Check::at_most(energy, against, *run.energy_residual / run.energy_scale, 100 * tolerance,
                                    "of the largest", "a hundred times the tolerance of a step"));
  } else {
    checks.push_back(Check::not_checked(energy, "the run kept no ledger"));
  }
  return checks;
}

SpaceExample run_space_example(const SpatialScene& scene) {
  SpaceExample example;
  example.scene = scene;
  example.scene.energy_ledger = true;
  example.run = simulate_spatial(example.scene);
  std::vector<double> times;
  for (const SpatialSample& sample : example.run.samples) times.push_back(sample.t);
  if (!times.empty()) times.erase(times.begin());  // the start is given, not found
  example.verdict.checks = space_checks(example.scene, example.run, space_reference(example.scene, times));
  return example;
}

std::string space_example_table(const SpaceExample& example) {
  const SpatialJointExtremes& peak = example.run.joints.at(0);
  const double c = example.scene.joints.at(0).plane.clearance;
  return fmt::format(
      "In space: {}, {}\n\nlargest e/c {:.6f}, least film {:.3f} um, largest force {:.3f} N, largest tilt {:.1e} rad; "
      "agreement: {}\n{}",
      example.scene.name, example.scene.joints[0].plane.film, peak.eccentricity.value / c,
      1e6 * (c - peak.eccentricity.value), peak.force.value, peak.tilt.value, example.verdict.in_letters(),
      check_legend({&example.verdict}));
}

}  // namespace lubjoint::reports::page

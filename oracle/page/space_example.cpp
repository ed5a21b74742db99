#include "oracle/page/space_example.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "oracle/mechanisms/lubricated_spatial_slider_crank.hpp"

namespace lubjoint::reports::page {

namespace {

template <class Joint>
const Joint& constraint_of(const SpatialScene& scene, const std::string& name) {
  for (const SpatialSceneConstraint& each : scene.constraints) {
    const Joint* joint = std::get_if<Joint>(&each.constraint);
    if (each.name == name && joint != nullptr) return *joint;
  }
  throw std::invalid_argument(scene.file + " has no such constraint \"" + name +
                              "\"; allowed is a spatial slider-crank");
}

/// What the mechanism is made of, as its scene names it.
struct Parts {
  explicit Parts(const SpatialScene& scene)
      : main_bearing(constraint_of<RevoluteJoint<double>>(scene, "main-bearing")),
        crank_pin(constraint_of<SphericalJoint<double>>(scene, "crank-pin")) {
    if (scene.joints.size() != 1 || scene.joints[0].plane.film != PinkusSternlicht::name) {
      throw std::invalid_argument(scene.file + " must have one joint, with the film pinkus_sternlicht");
    }
  }
  const RevoluteJoint<double>& main_bearing;
  const SphericalJoint<double>& crank_pin;
};

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

mechanisms::SpatialSliderCrank<double> spatial_slider_crank_of(const SpatialScene& scene) {
  const Parts parts(scene);
  const SpatialSceneJoint& pin = scene.joints[0];
  const SpatialSceneBody& crank = scene.bodies.at(parts.crank_pin.first.body);
  const SpatialSceneBody& rod = scene.bodies.at(pin.bearing.body);
  const SpatialSceneBody& slider = scene.bodies.at(pin.journal.body);
  mechanisms::SpatialSliderCrank<double> m;
  m.crank_length = (parts.crank_pin.first.point - parts.main_bearing.second.point).norm();
  m.crank_mass = crank.mass;
  m.crank_inertia = crank.inertia(0, 0);
  m.crank_centre = parts.main_bearing.second.point.norm();
  m.rod_length = (pin.bearing.point - parts.crank_pin.second.point).norm();
  m.rod_mass = rod.mass;
  m.rod_inertia_along = rod.inertia(0, 0);
  m.rod_inertia_cross = rod.inertia(2, 2);
  m.rod_inertia_third = rod.inertia(1, 1);
  m.slider_mass = slider.mass;
  m.slider_inertia = slider.inertia(0, 0);
  m.offset_y = parts.main_bearing.first.point.y();
  m.offset_z = parts.main_bearing.first.point.z();
  m.gravity = -scene.gravity.z();
  return m;
}

double crank_speed_of(const SpatialScene& scene) { return scene.bodies.at(Parts(scene).crank_pin.first.body).spin.x(); }

std::vector<SpacePin> space_reference(const SpatialScene& scene, const std::vector<double>& times) {
  using Mechanism = mechanisms::LubricatedSpatialSliderCrank<PinkusSternlicht, double>;
  constexpr double tolerance =
      1e-8;  // of a method of order 14: errors of 1e-11 c and 2e-7 of the largest force were measured
  const SpatialBodyPoint<double>& pin = Parts(scene).crank_pin.first;
  const SceneJoint& joint = scene.joints[0].plane;
  const mechanisms::SpatialSliderCrank<double> crank = spatial_slider_crank_of(scene);
  const Mechanism mechanism(crank, Bearing<double>(joint.length, joint.journal_radius, joint.clearance),
                            Lubricant<double>(joint.viscosity));
  const Vector3<double> start = point_motion(frame_at_start(scene, pin.body), pin.point).position;
  auto y = mechanism.start(std::atan2(crank.offset_y - start.y(), start.z() - crank.offset_z), crank_speed_of(scene));
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

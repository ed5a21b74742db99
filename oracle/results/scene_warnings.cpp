#include "oracle/results/scene_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/scene/multibody_scene.hpp"

namespace lubjoint::reports {

namespace {

constexpr double share = 0.01;  ///< of a length, a radian or a speed: what a correction of rounding never reaches

const Driver<double>* driver_of(const SceneConstraint& constraint) {
  return std::get_if<Driver<double>>(&constraint.constraint);
}

}  // namespace

std::string unit_guess(double given, double needed) {
  if (needed == 0 || given == 0) return {};
  const double ratio = given / needed;
  const auto is = [ratio](double factor) { return std::abs(ratio / factor - 1) < share; };
  if (is(30 / std::numbers::pi)) return ": rpm?";
  if (is(180 / std::numbers::pi)) return ": degrees?";
  return {};
}

double safe_film_thickness(const SceneJoint& joint) { return 1.5e-4 * 2 * (joint.journal_radius + joint.clearance); }

std::vector<std::string> joint_unit_warnings(const std::vector<SceneJoint>& joints, double mechanism,
                                             bool is_mechanism) {
  std::vector<std::string> warnings;
  for (const SceneJoint& joint : joints) {
    const double ratio = joint.clearance / (joint.journal_radius + joint.clearance);
    if (ratio < 1e-4 || ratio > 0.05 * (1 + 1e-9)) {  // the paper's widest bearing has 0.05 itself
      warnings.push_back(fmt::format(
          "warning: joint \"{}\" has a clearance of {:g} m in a bearing of radius {:g} m, c/R = {:.3g}; bearings have "
          "1e-4 to 0.05. Lengths are in metres, clearance and radius both radial.",
          joint.name, joint.clearance, joint.journal_radius + joint.clearance, ratio));
    }
    if (is_mechanism && joint.journal_radius > mechanism) {
      warnings.push_back(fmt::format(
          "warning: the journal of joint \"{}\", of radius {:g} m, is larger than the mechanism, whose points are at "
          "most {:g} m from their mass centres. Lengths are in metres.",
          joint.name, joint.journal_radius, mechanism));
    }
  }
  return warnings;
}

std::vector<std::string> driver_unit_warnings(const std::string& driver, const std::string& body, double speed,
                                              double spin, double given) {
  std::vector<std::string> warnings;
  for (const auto& [high, low, word] :
       {std::tuple{given, speed, "the body's spin"}, std::tuple{speed, given, "the driver's speed"}}) {
    const std::string guess = unit_guess(high, low);
    if (guess.empty()) continue;
    warnings.push_back(
        fmt::format("warning: driver \"{}\" turns body \"{}\" at {:g} rad/s, whose spin is {:g} rad/s{} "
                    "Speeds are in rad/s, and {} looks like another unit.",
                    driver, body, speed, spin, guess, word));
  }
  return warnings;
}

std::vector<std::string> unit_warnings(const Scene& scene) {
  std::vector<std::string> warnings =
      joint_unit_warnings(scene.joints, scene_units(scene).mechanism, scene.bodies.size() > 1);
  for (const SceneConstraint& each : scene.constraints) {
    const Driver<double>* driver = driver_of(each);
    if (driver == nullptr || driver->shape) continue;
    const SceneBody& body = scene.bodies[driver->second];
    const double ground = driver->first != ground_body ? scene.bodies[driver->first].spin : 0;
    const auto of_driver = driver_unit_warnings(each.name, body.name, driver->speed, body.spin, body.spin - ground);
    warnings.insert(warnings.end(), of_driver.begin(), of_driver.end());
  }
  return warnings;
}

std::vector<std::string> law_warnings(const Scene& scene) {
  std::vector<std::string> warnings;
  for (const SceneJoint& joint : scene.joints) {
    if (joint.film == no_film) continue;
    with_film_law<NamedFilmLaws>(joint.film, [&]<class Law>() {
      if constexpr (ShapedFilmLaw<Law>) {
        const std::string warning = Law::warning(joint.length / (2 * joint.journal_radius));
        if (!warning.empty()) warnings.push_back(fmt::format("warning: joint \"{}\": {}", joint.name, warning));
      }
    });
  }
  return warnings;
}

std::vector<std::string> correction_warnings(const Scene& scene, const MultibodyTrajectory& run) {
  std::vector<std::string> warnings;
  if (run.samples.empty() || scene.constraints.empty()) return warnings;
  const std::vector<double>& start = run.samples.front().state;
  const std::size_t n = 3 * scene.bodies.size();
  const double mechanism = scene_units(scene).mechanism;
  double fastest = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    fastest = std::max(
        {fastest, std::hypot(start[n + 3 * b], start[n + 3 * b + 1]), std::abs(start[n + 3 * b + 2]) * mechanism});
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SceneBody& given = scene.bodies[b];
    const double* q = start.data() + 3 * b;
    const Vector2<double> position(q[0], q[1]);
    const Vector2<double> velocity(q[n], q[n + 1]);
    std::string moved;
    const auto say = [&](const std::string& what) { moved += (moved.empty() ? "" : "; ") + what; };
    if ((position - given.position).norm() > share * mechanism) {
      say(fmt::format("position ({:g}, {:g}) m given, ({:g}, {:g}) needed", given.position.x(), given.position.y(),
                      position.x(), position.y()));
    }
    if (std::abs(q[2] - given.angle) > share) {
      say(fmt::format("angle {:g} rad given, {:g} needed{}", given.angle, q[2], unit_guess(given.angle, q[2])));
    }
    if ((velocity - given.velocity).norm() > share * std::max(velocity.norm(), given.velocity.norm()) &&
        (velocity - given.velocity).norm() > share * fastest) {
      say(fmt::format("velocity ({:g}, {:g}) m/s given, ({:g}, {:g}) needed", given.velocity.x(), given.velocity.y(),
                      velocity.x(), velocity.y()));
    }
    const double spin = q[n + 2];
    if (std::abs(spin - given.spin) > share * std::max(std::abs(spin), std::abs(given.spin)) &&
        std::abs(spin - given.spin) * mechanism > share * fastest) {
      say(fmt::format("spin {:g} rad/s given, {:g} needed{}", given.spin, spin, unit_guess(given.spin, spin)));
    }
    if (moved.empty()) continue;
    warnings.push_back(
        fmt::format("warning: the start of body \"{}\" was moved onto the constraints: {}", given.name, moved));
  }
  return warnings;
}

std::string thin_film_warning(const SceneJoint& joint, double thickness, double t) {
  const double safe = safe_film_thickness(joint);
  if (joint.film == no_film || thickness >= safe || (joint.contact && thickness <= 0)) return {};
  return fmt::format(
      "warning: the film of joint \"{}\" is {:.3g} um thin at {:.6g} s, less than the {:.3g} um that are safe (1.5e-4 "
      "of the bearing's diameter): rough surfaces would touch there, and the film's force is not to be trusted.",
      joint.name, 1e6 * thickness, t, 1e6 * safe);
}

}  // namespace lubjoint::reports

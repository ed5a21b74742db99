#include "lubjoint/scene/multibody_scene.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "lubjoint/scene/scene_file.hpp"
#include "multibody_simulation.hpp"

namespace lubjoint {

template class MultibodyOde<double>;
template const FilmFunctions<double>& film_functions<double>(std::string_view law);
template StartCorrection<double> assemble_start(const PlanarSystem<double>& system, const double& t,
                                                const double& length, std::vector<double>& y);

namespace {

/// Every point that a constraint, a joint or a spring fixes to a body.
template <class Visit>
void for_each_anchor(const Scene& scene, const Visit& visit) {
  for (const SceneConstraint& each : scene.constraints) each.visit_points(visit);
  for (const SceneJoint& joint : scene.joints) {
    visit(joint.bearing);
    visit(joint.journal);
  }
  for (const SceneSpring& each : scene.springs) {
    if (const auto* spring = std::get_if<TranslationalSpring<double>>(&each.spring)) {
      visit(spring->first);
      visit(spring->second);
    }
  }
}

/// Length of a spring in a state [m].
double length_of(const TranslationalSpring<double>& spring, const std::vector<double>& y) {
  const auto place = [&](const SceneAnchor& at) {
    const PlanarMotion<double> body = motion_in(y, at.body);
    return Vector2<double>(body.position + inertial_vector(body, at.point));
  };
  return (place(spring.second) - place(spring.first)).norm();
}

JournalMotion<double> motion_at(const std::vector<double>& y, const JointElement<double>& joint) {
  return joint
      .kinematics(PlanarFrame<double>(motion_in(y, joint.bearing_at.body)),
                  PlanarFrame<double>(motion_in(y, joint.journal_at.body)))
      .motion;
}

}  // namespace

SceneUnits scene_units(const Scene& scene) {
  SceneUnits units{0, 0, 0, 1 / scene.run.duration, 0};
  for_each_anchor(scene, [&](const SceneAnchor& anchor) {
    if (!anchor.on_ground()) units.mechanism = std::max(units.mechanism, anchor.point.norm());
  });
  for (const SceneSpring& each : scene.springs) {  // bodies that hang on springs at their mass centres
    const auto* spring = std::get_if<TranslationalSpring<double>>(&each.spring);
    if (spring && units.mechanism == 0) units.mechanism = length_of(*spring, scene_start<double>(scene));
  }
  if (units.mechanism == 0) units.mechanism = scene.joints.empty() ? 1 : scene.joints.front().journal_radius;
  units.length = units.mechanism;
  for (const SceneJoint& joint : scene.joints) units.length = std::min(units.length, joint.clearance);
  units.angle = units.length / units.mechanism;
  const auto at_least = [&](double rate) { units.rate = std::max(units.rate, std::abs(rate)); };
  at_least(std::sqrt(scene.gravity.norm() / units.mechanism));
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SceneBody& body = scene.bodies[b];
    at_least(body.spin);
    at_least(body.velocity.norm() / units.mechanism);
    units.energy += (body.mass * body.velocity.squaredNorm() + body.inertia * body.spin * body.spin) / 2 +
                    body.mass * scene.gravity.norm() * units.mechanism;
  }
  for (const SceneLoad& load : scene.loads) {
    at_least(std::sqrt(std::abs(load.moment) / scene.bodies[load.body].inertia));
    units.energy += std::abs(load.moment) + load.force.norm() * units.mechanism;
    if (load.harmonic) at_least(load.harmonic->rate);
  }
  for (const SceneSpring& each : scene.springs) {
    for (const std::size_t b : {each.first_body(), each.second_body()}) {
      if (b == ground_body) continue;
      if (const auto* spring = std::get_if<TranslationalSpring<double>>(&each.spring)) {
        at_least(std::sqrt(spring->stiffness / scene.bodies[b].mass));
        units.energy += std::abs(spring->preload) * units.mechanism;
      } else {
        at_least(std::sqrt(std::get<RotationalSpring<double>>(each.spring).stiffness / scene.bodies[b].inertia));
      }
    }
  }
  for (const SceneConstraint& each : scene.constraints) {
    if (const auto* driver = std::get_if<Driver<double>>(&each.constraint)) at_least(driver->speed);
  }
  for (const SceneBody& body : scene.bodies) {
    units.energy = std::max(units.energy, body.mass * std::pow(units.length * units.rate, 2));
  }
  return units;
}

namespace detail {

PreparedScene prepare(const Scene& scene) {
  PreparedScene prepared{planar_system<double>(scene), scene_start<double>(scene), {}};
  try {
    prepared.correction = assemble_start(prepared.system, 0.0, scene_units(scene).mechanism, prepared.start);
  } catch (const ConstraintError& error) {
    throw SceneError(scene.file + ": constraints: " + error.what());
  }
  for (std::size_t k = 0; k < scene.springs.size(); ++k) {
    const auto* spring = std::get_if<TranslationalSpring<double>>(&scene.springs[k].spring);
    if (spring == nullptr || length_of(*spring, prepared.start) > 1e-12 * scene_units(scene).mechanism) continue;
    throw SceneError(scene.file + ": springs[" + std::to_string(k) + "] \"" + scene.springs[k].name +
                     "\" has length 0 at the start that fulfils the constraints; allowed is a length above 0: a spring "
                     "of length 0 has no direction");
  }
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const JointElement<double>& joint = prepared.system.joints()[j];
    const SceneJoint& given = scene.joints[j];
    const Vector2<double> e = motion_at(prepared.start, joint).eccentricity / given.clearance;
    if (joint.contact || one_minus_squared_norm(e.x(), e.y()) > 0) continue;
    std::ostringstream message;
    message << scene.file << ": joints[" << j << "] \"" << given.name << "\": its journal starts at eccentricity ratio "
            << e.norm() << "; allowed are eccentricity ratios in [0, 1), or a transition to contact";
    throw SceneError(message.str());
  }
  return prepared;
}

}  // namespace detail

}  // namespace lubjoint

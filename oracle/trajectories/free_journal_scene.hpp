/// A scene of one journal in a bearing on the ground, as oracle/mechanisms takes it.
#pragma once

#include <algorithm>
#include <stdexcept>

#include "lubjoint/scene/scene.hpp"
#include "oracle/mechanisms/free_journal.hpp"

namespace lubjoint::reports {

/// A journal alone in a bearing on the ground, on a film, with or without transition to contact; bearing and journal at
/// the origin of ground and body; no constraint but a driver that turns the journal.
inline bool is_lone_journal(const Scene& scene) {
  if (scene.bodies.size() != 1 || scene.joints.size() != 1 || scene.constraints.size() > 1) return false;
  const bool driven = std::all_of(scene.constraints.begin(), scene.constraints.end(), [](const SceneConstraint& c) {
    const auto* driver = std::get_if<Driver<double>>(&c.constraint);
    return driver && driver->first == ground_body;
  });
  const SceneJoint& joint = scene.joints[0];
  const bool moments =
      std::any_of(scene.loads.begin(), scene.loads.end(), [](const SceneLoad& load) { return load.moment != 0; });
  return driven && joint.bearing.on_ground() && !joint.journal.on_ground() && is_zero(joint.bearing.point) &&
         is_zero(joint.journal.point) && joint.film != no_film && !moments &&
         joint.contact.has_value() == joint.transition.has_value();
}

/// Exactly the scene's numbers; sums and products in the scalar asked for.
/// @throws std::invalid_argument  a scene of another kind
template <class R>
mechanisms::FreeJournalCase<R> free_journal_case(const Scene& scene) {
  if (!is_lone_journal(scene)) {
    throw std::invalid_argument(scene.file + ": allowed is a journal alone, on a film, in a bearing on the ground");
  }
  const SceneBody& body = scene.bodies[0];
  const SceneJoint& joint = scene.joints[0];
  mechanisms::FreeJournalCase<R> journal{R(joint.length), R(joint.journal_radius), R(joint.clearance),
                                         R(joint.viscosity), R(body.mass)};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    journal.load[k] = R(body.mass) * R(scene.gravity(i));
    for (const SceneLoad& load : scene.loads) journal.load[k] += R(load.force(i));
    journal.eccentricity[k] = R(body.position(i)) / R(joint.clearance);
    journal.velocity[k] = R(body.velocity(i)) / R(joint.clearance);
  }
  journal.spin = R(body.spin);
  const bool driven = !scene.constraints.empty();
  if (driven) {
    const auto& driver = std::get<Driver<double>>(scene.constraints[0].constraint);
    journal.spin = R(driver.speed);
    journal.spin_acceleration = R(driver.acceleration);
  }
  if (!joint.contact) return journal;
  const SceneContact& contact = *joint.contact;
  mechanisms::BearingWall<R> wall;
  wall.stiffness = mechanisms::seat_stiffness<R>(journal.journal_radius, journal.clearance,
                                                 {R(contact.bearing_modulus), R(contact.bearing_poisson)},
                                                 {R(contact.journal_modulus), R(contact.journal_poisson)});
  wall.restitution = R(contact.restitution);
  wall.min_impact_speed = R(contact.min_impact_speed);
  wall.blend = R(joint.transition->e0);
  wall.widening = R(joint.transition->e1);
  wall.friction = R(contact.friction);
  wall.slow_sliding = R(contact.slow_sliding);
  journal.wall = wall;
  if (contact.friction > 0 && !driven) journal.inertia = R(body.inertia);
  return journal;
}

}  // namespace lubjoint::reports

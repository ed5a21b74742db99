/// Scenes made in code.
#pragma once

#include <string>

#include "lubjoint/scene/scene.hpp"

namespace lubjoint::test {

inline SceneBody body(const std::string& name, double mass, double inertia, const Vector2<double>& position,
                      double angle = 0) {
  SceneBody result;
  result.name = name;
  result.mass = mass;
  result.inertia = inertia;
  result.position = position;
  result.angle = angle;
  return result;
}

/// Steel on steel; a journal of 9.8 mm in 0.2 mm of clearance, dry.
inline SceneJoint dry_joint(const SceneAnchor& bearing, const SceneAnchor& journal, double restitution) {
  SceneJoint joint;
  joint.name = "bearing";
  joint.film = no_film;
  joint.length = 0.04;
  joint.journal_radius = 0.0098;
  joint.clearance = 0.0002;
  joint.bearing = bearing;
  joint.journal = journal;
  joint.contact = SceneContact{207e9, 0.3, 207e9, 0.3, restitution, 1e-3, 0.0, 1e-3};
  return joint;
}

inline void set_tolerance(Scene& scene, double tolerance) {
  scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
}

/// A chain of n rods of 0.1 m that hangs from the ground at an angle from the vertical.
inline Scene pendulum_chain(std::size_t n, double angle) {
  Scene scene;
  scene.file = scene.name = "chain";
  scene.gravity = {0, -9.81};
  const double length = 0.1;
  const Vector2<double> along(std::sin(angle), -std::cos(angle));
  for (std::size_t i = 0; i < n; ++i) {
    const double middle = length * (static_cast<double>(i) + 0.5);
    scene.bodies.push_back(body("rod" + std::to_string(i), 0.1, 1e-4, middle * along, angle));
    SceneAnchor above;
    if (i > 0) above = {i - 1, {0, -length / 2}};
    scene.constraints.push_back({"pin" + std::to_string(i), Revolute<double>{above, {i, {0, length / 2}}}});
  }
  scene.energy_ledger = true;
  return scene;
}

}  // namespace lubjoint::test

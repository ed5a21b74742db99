/// What the closed form and the minimal coordinates need of a slider-crank scene.
#pragma once

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "lubjoint/scene/scene.hpp"
#include "oracle/mechanisms/lubricated_slider_crank.hpp"

namespace lubjoint::reports {

/// @throws std::invalid_argument if the scene has no such body
inline const SceneBody& body_of(const Scene& scene, const std::string& name) {
  for (const SceneBody& body : scene.bodies) {
    if (body.name == name) return body;
  }
  throw std::invalid_argument(scene.file + " has no body \"" + name + "\"; allowed is a slider-crank scene");
}

/// Speed of the scene's driver [rad/s]. @throws std::invalid_argument if it has none
inline double crank_speed_of(const Scene& scene) {
  for (const SceneConstraint& each : scene.constraints) {
    if (const auto* driver = std::get_if<SceneDriver>(&each.kind)) return driver->speed;
  }
  throw std::invalid_argument(scene.file + " has no driver");
}

/// Length of a body of the mechanism: between the outermost points that hold it. The mass centre is in the middle.
template <class R>
R length_between_joints(const Scene& scene, const SceneBody& body) {
  R least = std::numeric_limits<R>::max();
  R most = std::numeric_limits<R>::lowest();
  const auto consider = [&](const SceneAnchor& anchor) {
    if (!anchor.body || &scene.bodies[*anchor.body] != &body) return;
    least = std::min<R>(least, R(anchor.point.x()));
    most = std::max<R>(most, R(anchor.point.x()));
  };
  for (const SceneConstraint& each : scene.constraints) {
    if (const auto* pin = std::get_if<SceneRevolute>(&each.kind)) {
      consider(pin->first);
      consider(pin->second);
    }
  }
  for (const SceneJoint& joint : scene.joints) {
    consider(joint.bearing);
    consider(joint.journal);
  }
  if (!(most > 0) || least != -most) {
    throw std::invalid_argument(scene.file + ": body \"" + body.name +
                                "\" must be held at both ends, its mass centre in the middle");
  }
  return R(most - least);
}

/// Masses and lengths, exactly those of the scene's numbers.
/// @throws std::invalid_argument  a scene that is no slider-crank with mass centres at mid-length
template <class R>
mechanisms::SliderCrank<R> mechanism_of(const Scene& scene) {
  const SceneBody& crank = body_of(scene, "crank");
  const SceneBody& rod = body_of(scene, "rod");
  mechanisms::SliderCrank<R> m;
  m.crank_length = length_between_joints<R>(scene, crank);
  m.rod_length = length_between_joints<R>(scene, rod);
  m.crank_mass = R(crank.mass);
  m.crank_inertia = R(crank.inertia);
  m.rod_mass = R(rod.mass);
  m.rod_inertia = R(rod.inertia);
  m.slider_mass = R(body_of(scene, "slider").mass);
  return m;
}

/// The scene in minimal coordinates.
template <FilmLaw Law, class R>
mechanisms::LubricatedSliderCrank<Law, R> lubricated_slider_crank(const Scene& scene) {
  const SceneJoint& joint = scene.joints.at(0);
  const bool on_rod = joint.bearing.body && scene.bodies[*joint.bearing.body].name == "rod";
  return {mechanism_of<R>(scene), R(crank_speed_of(scene)),
          Bearing<R>(R(joint.length), R(joint.journal_radius), R(joint.clearance)), Lubricant<R>(R(joint.viscosity)),
          on_rod ? mechanisms::BearingOn::rod : mechanisms::BearingOn::slider};
}

}  // namespace lubjoint::reports

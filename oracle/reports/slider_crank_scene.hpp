/// What the closed form and the minimal coordinates need of a slider-crank scene.
#pragma once

#include <stdexcept>
#include <string>

#include "lubjoint/scene/scene.hpp"
#include "oracle/mechanisms/lubricated_slider_crank.hpp"
#include "oracle/reports/slider_crank_reference.hpp"

namespace lubjoint::reports {

/// @throws std::invalid_argument if the scene has no such body
inline const SceneBody& body_of(const Scene& scene, const std::string& name) {
  for (const SceneBody& body : scene.bodies) {
    if (body.name == name) return body;
  }
  throw std::invalid_argument(scene.file + " has no body \"" + name + "\"; allowed is a slider-crank scene");
}

/// Masses and lengths: the scene starts extended, mass centres at mid-length.
template <class R>
mechanisms::SliderCrank<R> mechanism_of(const Scene& scene) {
  const SceneBody& crank = body_of(scene, "crank");
  const SceneBody& rod = body_of(scene, "rod");
  mechanisms::SliderCrank<R> m;
  m.crank_length = 2 * R(crank.position.x());
  m.rod_length = 2 * (R(rod.position.x()) - m.crank_length);
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

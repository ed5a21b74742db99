/// What minimal coordinates and other engines need of a scene of the spatial slider-crank with a lubricated gudgeon
/// pin.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "lubjoint/scene/spatial_scene.hpp"
#include "oracle/mechanisms/lubricated_spatial_slider_crank.hpp"

namespace lubjoint::reports {

/// The constraint of a kind and a name. @throws std::invalid_argument if the scene has no such constraint
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
struct SpatialSliderCrankParts {
  /// @throws std::invalid_argument  a scene without its constraints main-bearing and crank-pin, or its one joint
  explicit SpatialSliderCrankParts(const SpatialScene& scene)
      : main_bearing(constraint_of<RevoluteJoint<double>>(scene, "main-bearing")),
        crank_pin(constraint_of<SphericalJoint<double>>(scene, "crank-pin")) {
    if (scene.joints.size() != 1 || scene.joints[0].plane.film != PinkusSternlicht::name) {
      throw std::invalid_argument(scene.file + " must have one joint, with the film pinkus_sternlicht");
    }
  }
  const RevoluteJoint<double>& main_bearing;
  const SphericalJoint<double>& crank_pin;
};

/// Lengths, masses and inertias of the mechanism, from its scene. @throws std::invalid_argument as its parts
template <class R = double>
mechanisms::SpatialSliderCrank<R> spatial_slider_crank_of(const SpatialScene& scene) {
  const SpatialSliderCrankParts parts(scene);
  const SpatialSceneJoint& pin = scene.joints[0];
  const SpatialSceneBody& crank = scene.bodies.at(parts.crank_pin.first.body);
  const SpatialSceneBody& rod = scene.bodies.at(pin.bearing.body);
  const SpatialSceneBody& slider = scene.bodies.at(pin.journal.body);
  mechanisms::SpatialSliderCrank<R> m;
  m.crank_length = R((parts.crank_pin.first.point - parts.main_bearing.second.point).norm());
  m.crank_mass = R(crank.mass);
  m.crank_inertia = R(crank.inertia(0, 0));
  m.crank_centre = R(parts.main_bearing.second.point.norm());
  m.rod_length = R((pin.bearing.point - parts.crank_pin.second.point).norm());
  m.rod_mass = R(rod.mass);
  m.rod_inertia_along = R(rod.inertia(0, 0));
  m.rod_inertia_cross = R(rod.inertia(2, 2));
  m.rod_inertia_third = R(rod.inertia(1, 1));
  m.slider_mass = R(slider.mass);
  m.slider_inertia = R(slider.inertia(0, 0));
  m.offset_y = R(parts.main_bearing.first.point.y());
  m.offset_z = R(parts.main_bearing.first.point.z());
  m.gravity = R(-scene.gravity.z());
  return m;
}

/// Speed of the crank at the start [rad/s]. @throws std::invalid_argument as its parts
inline double crank_speed_of(const SpatialScene& scene) {
  return scene.bodies.at(SpatialSliderCrankParts(scene).crank_pin.first.body).spin.x();
}

/// Angle of the crank at the start, from the z direction [rad]. @throws std::invalid_argument as its parts
inline double crank_angle_of(const SpatialScene& scene) {
  const SpatialSliderCrankParts parts(scene);
  const SpatialBodyPoint<double>& pin = parts.crank_pin.first;
  const Vector3<double> start = point_motion(frame_at_start(scene, pin.body), pin.point).position;
  const Vector3<double>& axis = parts.main_bearing.first.point;
  return std::atan2(axis.y() - start.y(), start.z() - axis.z());
}

/// What errors are measured in: e/c in the plane of the mechanism, along the x axis and away from it to the crank pin.
class PinInPlane {
 public:
  /// @throws std::invalid_argument as the mechanism's parts
  explicit PinInPlane(const SpatialScene& scene) : clearance_(0) {
    const SpatialBodyPoint<double>& pin = SpatialSliderCrankParts(scene).crank_pin.first;
    const BodyAxes<double>& bearing = scene.joints[0].bearing;
    clearance_ = scene.joints[0].plane.clearance;
    const Vector3<double> outward = away(inertial_vector(frame_at_start(scene, bearing.body), bearing.axis));
    side_ = outward.dot(point_motion(frame_at_start(scene, pin.body), pin.point).position) < 0 ? -1 : 1;
  }
  /// @param n  the bearing's axis;  @param e  [m]; both inertial
  Vector2<double> operator()(const Vector3<double>& n, const Vector3<double>& e) const {
    return {e.x() / clearance_, side_ * away(n).dot(e) / clearance_};
  }

 private:
  /// n × x
  static Vector3<double> away(const Vector3<double>& n) { return {0, n.z(), -n.y()}; }

  double clearance_;
  double side_ = 1;
};

/// The scene in minimal coordinates. @throws std::invalid_argument as its parts
template <FilmLaw Law, class R>
mechanisms::LubricatedSpatialSliderCrank<Law, R> lubricated_spatial_slider_crank(const SpatialScene& scene) {
  const auto mechanism = spatial_slider_crank_of<R>(scene);
  const SceneJoint& joint = scene.joints[0].plane;
  return {mechanism, Bearing<R>(R(joint.length), R(joint.journal_radius), R(joint.clearance)),
          Lubricant<R>(R(joint.viscosity))};
}

}  // namespace lubjoint::reports

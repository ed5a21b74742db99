/// What a run is asked to measure along its way.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "lubjoint/multibody/planar_body.hpp"

namespace lubjoint {

/// Force and moment of a constraint on its second body, at the joint.
struct ReactionSensor {
  std::size_t constraint;  ///< its number
};
/// Position and velocity of a point.
struct PointSensor {
  BodyPoint<double> at;  ///< fixed to a body
};
/// Distance between two points, and its rate.
struct DistanceSensor {
  BodyPoint<double> first;   ///< fixed to a body or the ground
  BodyPoint<double> second;  ///< likewise
};
/// Angle of a body against another, and its rate.
struct AngleSensor {
  std::size_t first;   ///< body i; may be the ground
  std::size_t second;  ///< body j
};
/// Tension of a spring, or the moment of a rotational one, with its damper's share.
struct SpringSensor {
  std::size_t spring;  ///< its number
};

/// A sensor of any kind, and the name that its columns begin with.
struct Sensor {
  std::string name;  ///< unique in the scene
  /// What it measures.
  std::variant<ReactionSensor, PointSensor, DistanceSensor, AngleSensor, SpringSensor> of;
};

/// The quantities of a sensor, in the order of its values.
inline std::vector<const char*> sensor_quantities(const Sensor& sensor) {
  struct Names {
    std::vector<const char*> operator()(const ReactionSensor&) const { return {"fx", "fy", "moment"}; }
    std::vector<const char*> operator()(const PointSensor&) const { return {"x", "y", "vx", "vy"}; }
    std::vector<const char*> operator()(const DistanceSensor&) const { return {"distance", "rate"}; }
    std::vector<const char*> operator()(const AngleSensor&) const { return {"angle", "rate"}; }
    std::vector<const char*> operator()(const SpringSensor&) const { return {"tension"}; }
  };
  return std::visit(Names(), sensor.of);
}

}  // namespace lubjoint

/// What a run in space is asked to measure along its way.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "lubjoint/multibody/sensor.hpp"
#include "lubjoint/multibody/spatial/constraint_row.hpp"

namespace lubjoint {

/// Position and velocity of a point in space.
struct SpatialPointSensor {
  SpatialBodyPoint<double> at;  ///< fixed to a body
};
/// Distance between two points in space, and its rate.
struct SpatialDistanceSensor {
  SpatialBodyPoint<double> first;   ///< fixed to a body or the ground
  SpatialBodyPoint<double> second;  ///< likewise
};

/// Angle of a body against another about the axis of a joint, counted through revolutions, and its rate.
struct SpatialAngleSensor {
  std::size_t angle;  ///< its number among the system's counted angles
};

/// A sensor of any kind in space, and the name that its columns begin with.
struct SpatialSensor {
  std::string name;  ///< unique in the scene
  /// What it measures. Reactions and springs are those of the plane's numbers.
  std::variant<ReactionSensor, SpatialPointSensor, SpatialDistanceSensor, SpatialAngleSensor, SpringSensor> of;
};

/// The quantities of a sensor in space, in the order of its values.
inline std::vector<const char*> sensor_quantities(const SpatialSensor& sensor) {
  struct Names {
    std::vector<const char*> operator()(const ReactionSensor&) const { return {"fx", "fy", "fz", "mx", "my", "mz"}; }
    std::vector<const char*> operator()(const SpatialPointSensor&) const { return {"x", "y", "z", "vx", "vy", "vz"}; }
    std::vector<const char*> operator()(const SpatialDistanceSensor&) const { return {"distance", "rate"}; }
    std::vector<const char*> operator()(const SpatialAngleSensor&) const { return {"angle", "rate"}; }
    std::vector<const char*> operator()(const SpringSensor&) const { return {"tension"}; }
  };
  return std::visit(Names(), sensor.of);
}

}  // namespace lubjoint

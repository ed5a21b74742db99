/// The spatial slider-crank in minimal coordinates and extended precision: what its races are measured by.
#pragma once

#include <vector>

#include "lubjoint/scene/spatial_scene.hpp"
#include "oracle/trajectories/reference.hpp"

namespace lubjoint::reports {

struct SpatialReference {
  std::vector<double> times;  ///< [s]
  Reference seen;             ///< e/c in the mechanism's plane at each time, as PinInPlane has it
  double agreement;           ///< largest difference of its two methods
};

/// By Lobatto IIIC of order 14 and by Fehlberg's pair of orders 7 and 8.
/// @throws std::invalid_argument  a scene that is no spatial slider-crank
SpatialReference spatial_reference(const SpatialScene& scene, const std::vector<double>& times);

}  // namespace lubjoint::reports

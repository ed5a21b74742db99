/// Constraints, and what is fixed to bodies, of a scene file in space.
#pragma once

#include "lubjoint/scene/spatial_scene.hpp"
#include "table_reader.hpp"

namespace lubjoint {

std::vector<std::string> body_names(const SpatialScene& scene);

/// @throws SceneError  as do all below
EulerParameters<double> read_orientation(TableReader table);
/// {body, point}
SpatialBodyPoint<double> read_spatial_point(TableReader table, const SpatialScene& scene);
/// Keys body and point of a table that has others: a place, or the name of a point.
SpatialBodyPoint<double> read_body_point(TableReader& table, const SpatialScene& scene, bool ground_is_allowed);
/// {body, point, axis}, its axis required
BodyAxes<double> read_axes(TableReader table, const SpatialScene& scene);
/// The same; without an axis of its own it has the other's at t = 0.
BodyAxes<double> read_axes_like(TableReader table, const SpatialScene& scene, const BodyAxes<double>& other);
/// The angle about a revolute or cylindrical constraint that the key names: its number in scene.angles, which it is
/// added to where it is new. @param zero  the angle at the scene's start, as its file gives it
std::size_t read_angle(TableReader& table, std::string_view key, SpatialScene& scene, double zero);
/// A constraint of a scene whose bodies are known, and, for a driver, the constraints before it.
SpatialSceneConstraint read_spatial_constraint(TableReader table, const SpatialScene& scene);

}  // namespace lubjoint

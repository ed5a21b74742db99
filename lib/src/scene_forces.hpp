/// Loads, springs and sensors of a scene file.
#pragma once

#include "lubjoint/scene/scene.hpp"
#include "table_reader.hpp"

namespace lubjoint {

/// Where an anchor is at t = 0, inertial [m].
Vector2<double> position_of(const SceneAnchor& anchor, const Scene& scene);

/// The swing of a load, in the plane or in space. @param acts  is any of its amplitudes other than 0?
/// @throws SceneError  as do all below
SceneHarmonic read_harmonic(TableReader& table, bool acts);
SceneLoad read_load(TableReader table, const Scene& scene);
/// A spring of a scene whose constraints are known.
SceneSpring read_spring(TableReader table, const Scene& scene);
/// A sensor of a scene whose constraints and springs are known.
Sensor read_sensor(TableReader table, const Scene& scene);

}  // namespace lubjoint

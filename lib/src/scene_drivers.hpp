/// Drivers of a scene file.
#pragma once

#include "lubjoint/scene/scene.hpp"
#include "table_reader.hpp"

namespace lubjoint {

/// A driver that turns a body, or moves one along a guide that stands before it in the file.
/// @throws SceneError
AnyConstraint<double> read_driver(TableReader& table, const Scene& scene);

}  // namespace lubjoint

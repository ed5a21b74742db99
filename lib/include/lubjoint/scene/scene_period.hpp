/// What repeats in a scene.
#pragma once

#include <optional>

#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

/// The period that a scene's drivers, tables and harmonic loads share; nothing if they have none in common, or if
/// nothing in the scene repeats.
std::optional<double> scene_period(const Scene& scene);

}  // namespace lubjoint

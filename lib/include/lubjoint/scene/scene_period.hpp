/// What repeats in a scene.
#pragma once

#include <optional>

#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

/// The period that a scene's drivers, tables and harmonic loads share; nothing if they have none in common, or if
/// anything in the scene does not repeat: a table of time that is not periodic, a driver that speeds up, a slide driver
/// that moves on. A motor that turns evenly repeats with its revolution, A cos(νt + ψ) of a driver with 2π/ν.
std::optional<double> scene_period(const Scene& scene);

}  // namespace lubjoint

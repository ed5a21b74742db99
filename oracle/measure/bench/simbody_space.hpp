/// Simbody on the spatial slider-crank with a lubricated gudgeon pin. Optional when the program is built.
#pragma once

#include <memory>
#include <vector>

#include "lubjoint/scene/spatial_scene.hpp"
#include "oracle/measure/bench/bench_case.hpp"
#include "oracle/mechanisms/simbody_spatial_engine.hpp"

namespace lubjoint::reports {

/// What is made of the film's law before Simbody is given it: a test falsifies it.
using FilmChange = std::function<mechanisms::SimbodyFilmLaw(mechanisms::SimbodyFilmLaw)>;

/// Starts where the scene does, on its constraints.
/// @param scene  a spatial slider-crank, with its constraints main-bearing, crank-pin, guide and thrust-faces
/// @param change  none: the law as it is
/// @returns nothing if Simbody was not built in
/// @throws std::invalid_argument  another mechanism; SceneError  a scene that can't start
std::unique_ptr<BenchCase> simbody_spatial_case(const SpatialScene& scene, const std::vector<double>& times,
                                                const Reference& reference, const FilmChange& change = {});

}  // namespace lubjoint::reports

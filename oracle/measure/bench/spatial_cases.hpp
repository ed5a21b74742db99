/// Mechanisms in space as races: the spatial slider-crank, and mechanisms of the plane that are turned out of it.
#pragma once

#include "lubjoint/scene/spatial_scene.hpp"
#include "oracle/measure/bench/bench_case.hpp"

namespace lubjoint::reports {

/// A spatial slider-crank with a lubricated gudgeon pin: in minimal, absolute and independent coordinates and, where
/// Simbody is built in, in its own. The reference is two integrators of extended precision in minimal coordinates.
/// @throws std::invalid_argument  another mechanism;  SceneError  one that can't start
BenchScene bench_scene(const SpatialScene& scene);

/// The same mechanism, its plane turned anywhere in space, by the default integrator in independent coordinates: what
/// space costs. Formulation embedded.
/// @param scene  of the plane, with films and without contact
std::unique_ptr<BenchCase> embedded_case(const Scene& scene, const std::vector<double>& times,
                                         const Reference& reference);

}  // namespace lubjoint::reports

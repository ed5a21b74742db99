/// What `coordinates = "auto"` picks in space, and the method that steps in independent coordinates.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lubjoint/motion/spatial_ode.hpp"
#include "lubjoint/scene/scene_coordinates.hpp"
#include "lubjoint/scene/spatial_scene.hpp"

namespace lubjoint {

/// @param system  whose rows to leave out are known: the others count
/// @throws SceneError  independent ones are asked for, and the constraints leave no freedom
CoordinatesChoice choose_coordinates(const SpatialScene& scene, const SpatialSystem<double>& system);

/// Steps in independent coordinates by the integrator of that name.
/// @param tolerances  of all states of the equations;  @param run  with the tolerances that these were made with
std::unique_ptr<Integrator<double, run_time_size>> independent_method(const std::string& name,
                                                                      const SpatialScene& scene,
                                                                      SpatialOde<double>& ode, const RunSettings& run,
                                                                      const std::vector<double>& tolerances);

}  // namespace lubjoint

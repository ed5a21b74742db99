/// What `coordinates = "auto"` picks, and the method that steps in independent ones.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

/// The coordinates of a run.
struct CoordinatesChoice {
  bool independent;    ///< or absolute
  std::string reason;  ///< empty if the scene names them
};

/// @throws SceneError  independent ones are asked for, and the constraints leave no freedom
CoordinatesChoice choose_coordinates(const Scene& scene, const PlanarSystem<double>& system);

/// Steps in independent coordinates by the integrator of that name.
/// @param tolerances  of all states of the equations;  @param run  with the tolerances that these were made with
std::unique_ptr<Integrator<double, run_time_size>> independent_method(const std::string& name, const Scene& scene,
                                                                      MultibodyOde<double>& ode, const RunSettings& run,
                                                                      const std::vector<double>& tolerances);

}  // namespace lubjoint

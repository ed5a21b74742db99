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

/// What the choice depends on.
struct CoordinatesCase {
  SceneCoordinates asked;                   ///< by the scene
  const SceneStabilisation& stabilisation;  ///< likewise
  const std::string& file;                  ///< of the scene, for messages
  std::size_t coordinates;                  ///< of all bodies, those of an orientation counted as three
  std::size_t constraints;                  ///< independent rows of Φ
};
/// Of a scene in the plane or in space. @throws SceneError  as below
CoordinatesChoice choose_coordinates(const CoordinatesCase& given);
/// @throws SceneError  independent ones are asked for, and the constraints leave no freedom
CoordinatesChoice choose_coordinates(const Scene& scene, const PlanarSystem<double>& system);

/// A tolerance of a run in absolute coordinates, as tight as gives errors of the same size in independent ones.
double tolerance_of_independent(double given);

/// Steps in independent coordinates by the integrator of that name.
/// @param tolerances  of all states of the equations;  @param run  with the tolerances that these were made with
std::unique_ptr<Integrator<double, run_time_size>> independent_method(const std::string& name, const Scene& scene,
                                                                      MultibodyOde<double>& ode, const RunSettings& run,
                                                                      const std::vector<double>& tolerances);

}  // namespace lubjoint

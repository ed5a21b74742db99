/// What simulate_multibody needs of a scene.
#pragma once

#include <vector>

#include "lubjoint/multibody/planar_system.hpp"
#include "lubjoint/multibody/start_correction.hpp"
#include "lubjoint/scene/scene.hpp"

namespace lubjoint::detail {

/// A system that is ready to run, and its start on the constraints.
struct PreparedScene {
  PlanarSystem<double> system;
  std::vector<double> start;
  StartCorrection<double> correction;
};

/// @throws SceneError
PreparedScene prepare(const Scene& scene);

}  // namespace lubjoint::detail

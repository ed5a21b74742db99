#include "multibody_simulation.hpp"

namespace lubjoint::detail {

MultibodyTrajectory simulate_multibody_radau(const Scene& scene) {
  return simulate_multibody_with<RunTimeRadau<double>>(scene);
}

}  // namespace lubjoint::detail

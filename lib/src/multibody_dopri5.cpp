#include "multibody_simulation.hpp"

namespace lubjoint::detail {

MultibodyTrajectory simulate_multibody_dopri5(const Scene& scene) {
  return simulate_multibody_with<RunTimeDopri5<double>>(scene);
}

}  // namespace lubjoint::detail

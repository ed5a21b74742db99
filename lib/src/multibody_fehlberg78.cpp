#include "multibody_simulation.hpp"

namespace lubjoint::detail {

MultibodyTrajectory simulate_multibody_fehlberg78(const Scene& scene) {
  return simulate_multibody_with<RunTimeFehlberg78<double>>(scene);
}

}  // namespace lubjoint::detail

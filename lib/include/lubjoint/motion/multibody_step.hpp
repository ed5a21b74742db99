/// A step of a multibody run.
#pragma once

#include <vector>

#include "lubjoint/joint/transition.hpp"
#include "lubjoint/multibody/joint_element.hpp"
#include "lubjoint/ode/step_interpolant.hpp"

namespace lubjoint {

/// A step of a multibody run.
template <class R>
struct MultibodyStep : StepInterpolant<std::vector<R>> {
  std::vector<JointMemory<R>> memory;  ///< of the joints during the step
  bool sampled_by_steps = false;       ///< samples inside it are made by the method, not by the interpolant
};

}  // namespace lubjoint

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

  /// May it begin with other values than the one before it has ended with? Its joints may be in other pieces.
  bool begins_anew() const { return !memory.empty(); }

  /// The state of a sample at a time of the step.
  /// @param by_method  by_method(step, t, y) puts the state into y by the integrator itself: an interpolant's error in
  ///                   an explicit step of higher order may be a thousand tolerances, and so may that of a step to an
  ///                   event
  /// @param look_inside  look_inside(step, t, y) does so by the interpolant
  template <class ByMethod, class Inside>
  void sample_at(const R& t, const ByMethod& by_method, const Inside& look_inside, std::vector<R>& y) const {
    if (t == this->t_new) {
      y = this->y_new;
    } else if (sampled_by_steps) {
      by_method(*this, t, y);
    } else {
      look_inside(*this, t, y);
    }
  }
};

}  // namespace lubjoint

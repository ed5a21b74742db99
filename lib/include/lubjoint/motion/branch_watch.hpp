/// After a singular position: has the mechanism gone on as its velocity led?
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/motion/multibody_step.hpp"

namespace lubjoint {

/// Where constraints are not independent, several motions meet. That of a mechanism is the one on which the velocity is
/// continuous; a step that ends near the position may leave by another, in which some bodies turn at other speeds at
/// once. So the velocities shortly before and after are compared, in the norm of the kinetic energy: while the fastest
/// body turns by less than a fifth of a radian they change by less than half, if the motion is smooth.
template <class R>
class BranchWatch {
 public:
  using State = std::vector<R>;                          ///< (q, q̇, work)
  using Step = std::shared_ptr<const MultibodyStep<R>>;  ///< an accepted one

  /// @param ode  whose runs are watched
  explicit BranchWatch(const MultibodyOde<R>& ode) : ode_(ode) {}

  /// The next accepted step.
  void step(const Step& step) {
    steps_.push_back(step);
    // What two places in a row may ask for, and no more: the fastest turn within half a radian.
    while (steps_.size() > 4 && steps_[1]->t_new < step->t_new - 10 * window(step->y_new)) steps_.pop_front();
  }

  /// A singular position that the run has passed.
  void passed(double t) { waiting_ = t; }

  /// Of the position passed last, once the run is far enough beyond it: when did it leave its branch?
  std::optional<double> left() {
    if (!waiting_) return std::nullopt;
    const Step& last = steps_.back();
    const R at(*waiting_);
    const R half = window(last->y_new);
    if (last->t_new < at + half) return std::nullopt;
    const State before = velocities(std::max<R>(at - half, steps_.front()->t_old));
    const State after = velocities(at + half);
    waiting_.reset();
    R size(0), change(0);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const R weight = 1 / ode_.system().inverse_mass(i / 3)[i % 3];
      size += weight * before[i] * before[i];
      change += weight * (after[i] - before[i]) * (after[i] - before[i]);
    }
    if (4 * change < size) return std::nullopt;
    return static_cast<double>(at);
  }

 private:
  /// Time in which the fastest body turns by a tenth of a radian.
  R window(const State& y) const {
    using std::abs;
    R fastest(0);
    const std::size_t n = ode_.system().coordinates();
    for (std::size_t i = n + 2; i < 2 * n; i += planar_coordinates) fastest = std::max<R>(fastest, abs(y[i]));
    return fastest > 0 ? R(0.1) / fastest : R(0);
  }

  State velocities(const R& t) {
    const auto in = std::find_if(steps_.begin(), steps_.end(), [&](const Step& each) { return each->t_new >= t; });
    const std::size_t n = ode_.system().coordinates();
    (*in)->state_at(t, n, state_);
    return {state_.begin() + static_cast<std::ptrdiff_t>(n), state_.begin() + static_cast<std::ptrdiff_t>(2 * n)};
  }

  const MultibodyOde<R>& ode_;
  std::deque<Step> steps_;
  std::optional<double> waiting_;
  State state_;
};

}  // namespace lubjoint

/// What a pilot run says of a scene's stiffness, in the plane and in space.
#pragma once

#include <stdexcept>
#include <vector>

#include "choose_integrator.hpp"
#include "lubjoint/motion/multibody_pieces.hpp"

namespace lubjoint::detail {

/// The joints' memories along a run that is over: the equations keep those of its end.
template <class Ode>
class MemoryAlong {
 public:
  MemoryAlong(Ode& ode, const std::vector<MemoryChange<double>>& changes) : ode_(ode), changes_(changes) {}
  void go_to(double t) {
    for (; next_ < changes_.size() && changes_[next_].t <= t; ++next_) {
      ode_.memory()[changes_[next_].joint] = changes_[next_].memory;
    }
  }

 private:
  Ode& ode_;
  const std::vector<MemoryChange<double>>& changes_;
  std::size_t next_ = 0;
};

/// Runs the pilot and looks at the Jacobian of each of its samples.
/// @param settings  of the pilot;  @param smooth  has the scene neither film nor contact?
template <class Run, class Ode>
StiffnessMeasure measure_by_pilot(Run& pilot, Ode& ode, const std::vector<double>& start, const RunSettings& settings,
                                  const std::vector<double>& tolerances, bool smooth) {
  const RunOutcome outcome = pilot.run(start);
  StiffnessMeasure measure{outcome.status == RunStatus::finished, static_cast<double>(outcome.steps), 0, smooth};
  Eigen::MatrixXd jacobian;
  MemoryAlong<Ode> memory(ode, pilot.memories());
  for (const auto& sample : pilot.recorder().samples()) {
    memory.go_to(sample.t);
    try {
      ode.jacobian(sample.state, jacobian, sample.t);
    } catch (const std::domain_error&) {  // a sample between two steps, in a film thinner than a pilot's tolerance
      continue;
    }
    measure.stability_steps += settings.output_interval * fastest_decay(jacobian, tolerances);
  }
  return measure;
}

}  // namespace lubjoint::detail

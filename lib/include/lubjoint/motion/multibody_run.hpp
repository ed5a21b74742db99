/// A multibody system from its start to its end, through every contact and along every slide.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lubjoint/motion/multibody_pieces.hpp"
#include "lubjoint/motion/multibody_recorder.hpp"
#include "lubjoint/motion/multibody_stops.hpp"
#include "lubjoint/motion/singular_watch.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/run/event_run.hpp"

namespace lubjoint {

/// Contact and the jumps of half films are followed event by event.
template <class R>
class MultibodyRun {
 public:
  using State = std::vector<R>;                 ///< (q, q̇, work)
  using Method = Integrator<R, run_time_size>;  ///< that makes the steps

  /// @param method  with the tolerance of every state in its own unit
  MultibodyRun(MultibodyOde<R>& ode, const RunSettings& settings, std::unique_ptr<Method> method,
               ConstraintUpkeep upkeep)
      : ode_(ode),
        settings_(settings),
        method_(std::move(method)),
        pieces_(ode, upkeep, R(settings.absolute_tolerance)),
        engine_(pieces_, *method_, settings_, outcome_),
        recorder_(ode, settings, method_->looks_inside()),
        watch_(ode, settings.relative_tolerance) {}

  /// The parts of a run refer to each other.
  MultibodyRun(const MultibodyRun&) = delete;
  MultibodyRun& operator=(const MultibodyRun&) = delete;  ///< likewise

  /// @param start  (q, q̇), fulfils the constraints, and every film exists
  RunOutcome run(const State& start) {
    y_ = start;
    y_.resize(ode_.dimension(), R(0));  // work: none yet
    t_ = R(0);
    R dt(1e-6 * settings_.duration);
    pieces_.start(t_, y_);
    recorder_.start(t_, y_);
    watch_.start(t_, y_);
    RunResult result = engine_.run(t_, y_, dt, [this](const auto& accepted, const auto&, const auto&) {
      auto step = std::make_shared<MultibodyStep<R>>();
      static_cast<StepInterpolant<State>&>(*step) = accepted;
      step->memory = ode_.memory();
      step->sampled_by_steps = !is_implicit() || accepted.shortened;
      // The rate at an event is that of a state with the run's errors, which a stiff film multiplies.
      if (is_implicit() && accepted.shortened) step->smooth_rates = false;
      try {
        recorder_.step(step, by_method());
      } catch (const std::domain_error&) {  // its ends are inside a film, and what lies between them is not
        leaves_film_ = true;
        return false;
      }
      singular_ = watch_.step(step, by_method());
      return !singular_ && unresolved_contact().empty();
    });
    if (result.end == RunEnd::duration_reached && (singular_ = watch_.finish(by_method())))
      result.end = RunEnd::refused;
    if (result.end != RunEnd::duration_reached) stop(result);
    pieces_.finish(t_);
    recorder_.finish(t_, y_, by_method());
    outcome_.t_end = static_cast<double>(t_);
    outcome_.rhs_evaluations = ode_.evaluations();
    outcome_.jacobian_evaluations = method_->counts().jacobians;
    outcome_.factorisations = method_->counts().factorisations;
    outcome_.mode_changes = pieces_.changes_after_start();
    return outcome_;
  }

  const MultibodyRecorder<R>& recorder() const { return recorder_; }            ///< what the run has left
  const std::vector<ContactEvent>& events() const { return pieces_.events(); }  ///< of contact, in order
  const std::vector<JointSlide>& slides() const { return pieces_.slides(); }    ///< of half films
  /// What the joints remembered, from when on: the equations keep what they remember at the end.
  const std::vector<MemoryChange<R>>& memories() const { return pieces_.changes(); }
  const State& state() const { return y_; }  ///< at the end

 private:
  /// The state inside a step as the recorder asks for it: by the method from the step's start, in the step's pieces.
  auto by_method() {
    return [this](const MultibodyStep<R>& step, const R& t, State& y) {
      const std::vector<JointMemory<R>> memory = std::exchange(ode_.memory(), step.memory);
      const bool reached = engine_.reach(step, t, y);
      ode_.memory() = memory;
      if (!reached) step.state_at(t, ode_.system().coordinates(), y);
    };
  }

  std::string unresolved_contact() {
    return detail::unresolved_contact_reason(ode_, t_, y_, settings_.absolute_tolerance);
  }

  bool is_implicit() const { return method_->counts().jacobians > 0; }

  void stop(const RunResult& result) {
    outcome_.status = RunStatus::stopped;
    outcome_.message = "stopped at t = " + detail::number(static_cast<double>(t_)) + " s: " + reason(result);
  }

  /// "joint "pin" is at eccentricity ratio 0.99; "
  std::string nearest() { return detail::nearest_joint(ode_, t_, y_).words; }

  std::string reason(const RunResult& result) {
    const auto joint = [&] { return "joint \"" + pieces_.joint_of(result.margin).name + "\""; };
    const bool touches = pieces_.is_of_contact(result.margin);
    if (singular_) {
      return "the mechanism passed, at " + detail::number(singular_->t) + " s, " + watch_.words(*singular_);
    }
    if (const auto here = watch_.at(t_, y_)) return "the mechanism is at " + watch_.words(*here);
    switch (result.end) {
      case RunEnd::step_limit:
        return detail::step_limit_reason(ode_, t_, y_, settings_.max_steps, is_implicit());
      case RunEnd::stalled:
        return detail::stall_reason(ode_, t_, y_, is_implicit());
      case RunEnd::refused:
        if (leaves_film_)
          return nearest() +
                 "a journal passes its wall inside a step whose ends are in the film; use a tighter tolerance";
        return unresolved_contact();
      case RunEnd::not_located:
        return nearest() + (touches ? "a contact of " : "a change of the film's side of ") + joint() +
               " can't be located; use a tighter tolerance";
      case RunEnd::stuck:
        return nearest() + joint() +
               (touches ? " can't leave a seam of its contact"
                        : " can't leave the jump of its half film at a = 0; use a law without a jump, such as "
                          "a dynamic one");
      default:
        return detail::no_step_reason(ode_, t_, y_);
    }
  }

  MultibodyOde<R>& ode_;
  RunSettings settings_;
  std::unique_ptr<Method> method_;
  RunOutcome outcome_;
  MultibodyPieces<R> pieces_;
  EventRun<MultibodyPieces<R>> engine_;
  MultibodyRecorder<R> recorder_;
  SingularWatch<R> watch_;
  std::optional<SingularPosition> singular_;  ///< that the run passed
  bool leaves_film_ = false;
  State y_;
  R t_{};
};

}  // namespace lubjoint

/// A multibody system from its start to its end, through every contact and along every slide.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lubjoint/motion/branch_watch.hpp"
#include "lubjoint/motion/multibody_pieces.hpp"
#include "lubjoint/motion/multibody_recorder.hpp"
#include "lubjoint/motion/multibody_stops.hpp"
#include "lubjoint/motion/singular_watch.hpp"
#include "lubjoint/motion/spring_watch.hpp"
#include "lubjoint/motion/watched_springs.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/run/event_run.hpp"

namespace lubjoint {

/// What a run does at a position where its constraints are not independent.
enum class AtSingularPosition {
  stop,  ///< it ends there: more than one motion may follow
  pass   ///< it goes on by steps that end on both sides of it, on the branch that its velocity leads to
};

/// What a run is asked to do beside its settings.
struct MultibodyOptions {
  std::vector<Sensor> sensors = {};                           ///< what is measured
  AtSingularPosition at_singular = AtSingularPosition::stop;  ///< positions that it passes
};

/// Contact and the jumps of half films are followed event by event.
template <class R>
class MultibodyRun {
 public:
  using State = std::vector<R>;                 ///< (q, q̇, work)
  using Method = Integrator<R, run_time_size>;  ///< that makes the steps

  /// @param method  with the tolerance of every state in its own unit
  MultibodyRun(MultibodyOde<R>& ode, const RunSettings& settings, std::unique_ptr<Method> method,
               ConstraintUpkeep upkeep, MultibodyOptions options = {})
      : ode_(ode),
        settings_(settings),
        options_(std::move(options)),
        method_(std::move(method)),
        pieces_(ode, upkeep, R(settings.absolute_tolerance)),
        engine_(pieces_, *method_, settings_, outcome_, guard_),
        recorder_(ode, settings, method_->looks_inside(), options_.sensors),
        watch_(ode, settings.relative_tolerance),
        springs_(PlanarSprings<R>(ode), settings.relative_tolerance, method_->looks_inside()),
        branch_(ode) {}

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
    springs_.start(y_);
    RunResult result = engine_.run(t_, y_, dt, [this](const auto& accepted, const auto&, const auto&) {
      auto step = std::make_shared<MultibodyStep<R>>();
      static_cast<StepInterpolant<State>&>(*step) = accepted;
      step->memory = ode_.memory();
      step->sampled_by_steps = !is_implicit() || accepted.shortened;
      // The rate at an event is that of a state with the run's errors, which a stiff film multiplies.
      if (is_implicit() && accepted.shortened) step->smooth_rates = false;
      try {
        recorder_.step(step, by_method());
      } catch (const SpringWithoutDirection&) {
        spring_ = springs_.step(step, by_method());
        return false;
      } catch (const std::domain_error&) {  // its ends are inside a film, and what lies between them is not
        leaves_film_ = true;
        return false;
      }
      spring_ = springs_.step(step, by_method());
      const std::optional<SingularPosition> singular = watch_.step(step, by_method());
      if (options_.at_singular == AtSingularPosition::pass) {
        branch_.step(step);
        if (singular) branch_.passed(singular->t);
        if ((left_branch_ = branch_.left())) return false;
      }
      return !spring_ && !stops_at(singular) && unresolved_contact().empty();
    });
    if (result.end == RunEnd::duration_reached && stops_at(watch_.finish(by_method()))) result.end = RunEnd::refused;
    if (result.end != RunEnd::duration_reached) stop(result);
    pieces_.finish(t_);
    recorder_.finish(t_, y_);
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
  /// Where the constraints were not independent, and the run went on; in order.
  const std::vector<SingularPosition>& passed() const { return passed_; }
  /// The constraint that repeats others at a singular position.
  const std::string& constraint(const SingularPosition& position) const { return watch_.constraint(position); }

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

  /// Does the run end at what a watch has found? If not, it is kept.
  bool stops_at(const std::optional<SingularPosition>& found) {
    if (!found) return false;
    if (options_.at_singular == AtSingularPosition::stop) {
      singular_ = found;
      return true;
    }
    // Two neighbouring intervals between looks may show the same place.
    if (passed_.empty() || found->t - passed_.back().t > 1e-6 * settings_.duration) passed_.push_back(*found);
    return false;
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
    if (left_branch_) {
      return "the mechanism has left, at the singular position that it passed at " + detail::number(*left_branch_) +
             " s, the branch that its velocity led to; use a looser relative_tolerance, whose steps end further from "
             "it";
    }
    if (spring_) return springs_.words(*spring_);
    if (const auto here = springs_.at(t_, y_)) return springs_.words(*here);
    if (singular_) {
      return "the mechanism passed, at " + detail::number(singular_->t) + " s, " + watch_.words(*singular_);
    }
    if (const auto here = watch_.at(t_, y_)) {
      if (options_.at_singular == AtSingularPosition::stop) return "the mechanism is at " + watch_.words(*here);
      return "the mechanism is at a singular position, where \"" + watch_.constraint(*here) +
             "\" repeats what other constraints fix, and no step leads on; use a looser relative_tolerance, whose "
             "steps end further from it";
    }
    const bool at_event = result.end == RunEnd::not_located || result.end == RunEnd::stuck;
    if (at_event && pieces_.is_of_knot(result.margin)) return detail::knot_words();
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
        return nearest() + joint() + (touches ? " can't leave a seam of its contact" : detail::stuck_on_jump_words());
      default:
        return detail::no_step_reason(ode_, t_, y_);
    }
  }

  MultibodyOde<R>& ode_;
  RunSettings settings_;
  MultibodyOptions options_;
  std::unique_ptr<Method> method_;
  RunOutcome outcome_;
  MultibodyPieces<R> pieces_;
  StallGuard<R> guard_;
  EventRun<MultibodyPieces<R>> engine_;
  MultibodyRecorder<R> recorder_;
  SingularWatch<R> watch_;
  SpringWatch<R, PlanarSprings<R>> springs_;
  BranchWatch<R> branch_;
  std::optional<double> left_branch_;         ///< where
  std::optional<SingularPosition> singular_;  ///< that the run passed
  std::vector<SingularPosition> passed_;      ///< and went on
  std::optional<SpringAtZero> spring_;        ///< that has lost its direction
  bool leaves_film_ = false;
  State y_;
  R t_{};
};

}  // namespace lubjoint

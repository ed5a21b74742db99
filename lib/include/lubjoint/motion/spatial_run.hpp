/// A system in space from its start to its end, through every contact.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lubjoint/motion/spatial_pieces.hpp"
#include "lubjoint/motion/spatial_recorder.hpp"
#include "lubjoint/motion/spatial_watched_springs.hpp"
#include "lubjoint/motion/spring_watch.hpp"
#include "lubjoint/motion/stop_words.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/run/event_run.hpp"

namespace lubjoint {

/// Contact and the jumps of half films are followed event by event. Positions at which constraints are not independent
/// stop a run where a step meets one; no watch looks for those that steps pass by.
template <class R>
class SpatialRun {
 public:
  using State = std::vector<R>;                 ///< (r, p; ṙ, ω′; work)
  using Method = Integrator<R, run_time_size>;  ///< that makes the steps

  /// @param method  with the tolerance of every state in its own unit
  /// @param resolution  by which the run's errors are told from what is there
  /// @param sensors  what is measured beside bodies, joints and constraints; kept by reference
  SpatialRun(SpatialOde<R>& ode, const RunSettings& settings, std::unique_ptr<Method> method, ConstraintUpkeep upkeep,
             const SpatialResolution& resolution, const std::vector<SpatialSensor>& sensors)
      : ode_(ode),
        settings_(settings),
        method_(std::move(method)),
        pieces_(ode, upkeep, resolution.angle / 20, R(settings.absolute_tolerance)),
        engine_(pieces_, *method_, settings_, outcome_, guard_),
        recorder_(ode, settings, method_->looks_inside(), resolution, sensors),
        springs_(SpatialSprings<R>(ode.system()), settings.relative_tolerance, method_->looks_inside()) {}

  /// The parts of a run refer to each other.
  SpatialRun(const SpatialRun&) = delete;
  SpatialRun& operator=(const SpatialRun&) = delete;  ///< likewise

  /// @param start  (r, p; ṙ, ω′), fulfils the constraints, and every film exists
  RunOutcome run(const State& start) {
    y_ = start;
    y_.resize(ode_.dimension(), R(0));  // work: none yet
    t_ = R(0);
    R dt(1e-6 * settings_.duration);
    ode_.start_turns(t_, y_);
    pieces_.start(t_, y_);
    recorder_.start(t_, y_);
    springs_.start(y_);
    const RunResult result = engine_.run(t_, y_, dt, [this](const auto& accepted, const auto&, const auto&) {
      auto step = std::make_shared<MultibodyStep<R>>();
      static_cast<StepInterpolant<State>&>(*step) = accepted;
      step->memory = std::as_const(ode_).memory();
      const bool outruns_interpolant = method_->is_of_order_nine() && !accepted.inside;
      step->sampled_by_steps = !is_implicit() || accepted.shortened || outruns_interpolant;
      // The rate at an event is that of a state with the run's errors, which a stiff film multiplies.
      if (is_implicit() && accepted.shortened) step->smooth_rates = false;
      if (!ode_.turns().empty()) count_turns(*step);
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
      return !spring_ && recorder_.is_redundant_still();
    });
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

  const SpatialRecorder<R>& recorder() const { return recorder_; }              ///< what the run has left
  const std::vector<ContactEvent>& events() const { return pieces_.events(); }  ///< of contact, in order
  const std::vector<JointSlide>& slides() const { return pieces_.slides(); }    ///< of half films
  /// What the joints remembered, from when on: the equations keep what they remember at the end.
  const std::vector<MemoryChange<R>>& memories() const { return pieces_.changes(); }
  /// How far Euler parameters and constraints were off.
  SpatialDrift drift() const {
    SpatialDrift drift = recorder_.drift();
    drift.norm = pieces_.norm_drift();
    return drift;
  }
  const State& state() const { return y_; }  ///< at the end

 private:
  /// The state inside a step as the recorder asks for it: by the method from the step's start, in the step's pieces.
  auto by_method() {
    return [this](const MultibodyStep<R>& step, const R& t, State& y) {
      const std::vector<JointMemory<R>> memory = std::exchange(ode_.memory(), step.memory);
      const bool reached = engine_.reach(step, t, y);
      ode_.memory() = memory;
      if (!reached) spatial_state_at<R>(step, ode_.system().bodies().size(), t, y);
    };
  }

  /// Follows the angles through a step as closely as its extremes are looked for.
  void count_turns(const MultibodyStep<R>& step) {
    const std::size_t looks = method_->looks_inside();
    State y;
    for (std::size_t i = 1; i < looks; ++i) {
      const R t = step.t_old + (step.t_new - step.t_old) * R(static_cast<double>(i) / static_cast<double>(looks));
      spatial_state_at<R>(step, ode_.system().bodies().size(), t, y);
      ode_.count_turns(t, y);
    }
    ode_.count_turns(step.t_new, step.y_new);
  }

  bool is_implicit() const { return method_->counts().jacobians > 0; }

  void stop(const RunResult& result) {
    outcome_.status = RunStatus::stopped;
    outcome_.message = "stopped at t = " + detail::number(static_cast<double>(t_)) + " s: " + reason(result);
  }

  struct Nearest {
    double gap = 1;     ///< 1 − |ê|
    std::string words;  ///< "joint "pin" is at eccentricity ratio 0.99; "
  };
  Nearest nearest() {
    Nearest nearest;
    ode_.system().place(y_.data(), ode_.workspace());
    for (std::size_t j = 0; j < ode_.system().joints().size(); ++j) {
      const SpatialJointElement<R>& joint = ode_.system().joints()[j];
      if (!(axes_cosine(j) > R(least_tilt_cosine))) continue;
      const Vector2<R> e = ode_.system().joint_kinematics(j, ode_.workspace()).motion.eccentricity;
      const R& c = joint.plane.bearing.clearance();
      const Vector2<double> ratio(static_cast<double>(e.x() / c), static_cast<double>(e.y() / c));
      const double gap = detail::film_gap(ratio);
      if (!nearest.words.empty() && !(gap < nearest.gap)) continue;
      nearest = {gap,
                 "joint \"" + joint.name() + "\" is at eccentricity ratio " + detail::eccentricity_words(ratio) + "; "};
    }
    return nearest;
  }

  /// |n·n_J| of a joint, from the frames of the workspace.
  R axes_cosine(std::size_t j) {
    using std::abs;
    const SpatialJointElement<R>& joint = ode_.system().joints()[j];
    const SpatialFrame<R>& i = ode_.system().frame(joint.bearing_at.body, ode_.workspace());
    const SpatialFrame<R>& k = ode_.system().frame(joint.journal_at.body, ode_.workspace());
    return abs(dot(inertial_vector(i, joint.bearing_at.axis), inertial_vector(k, joint.journal_at.axis)));
  }

  /// A row that was left out, and is not fulfilled any more.
  std::string left_out_words() {
    const SpatialWorkspace<R>& w = ode_.at(t_, y_);
    for (const std::size_t row : ode_.system().left_out()) {
      const double off = std::abs(static_cast<double>(w.rows[row].value));
      if (off <= recorder_.largest_left_out(row)) continue;
      return "constraint " + detail::constraint_of_row(ode_.system(), row) +
             " has a row that others implied at the start, and that is now off by " + detail::number(off) +
             (ode_.system().row_is_length(row) ? " m" : " rad") +
             ", more than theirs could: it is redundant no more; give the scene constraints that are independent, or "
             "none that disagree";
    }
    return {};
  }

  std::string reason(const RunResult& result) {
    if (spring_) return springs_.words(*spring_);
    if (const auto here = springs_.at(t_, y_)) return springs_.words(*here);
    if (result.end == RunEnd::refused && !leaves_film_) return left_out_words();
    const Nearest near = nearest();
    const auto joint = [&] { return "joint \"" + pieces_.joint_of(result.margin).name() + "\""; };
    using Kind = typename SpatialPieces<R>::Kind;
    const Kind kind = pieces_.kind_of(result.margin);
    const bool at_event = result.end == RunEnd::not_located || result.end == RunEnd::stuck;
    if (at_event && kind == Kind::knot) return detail::knot_words();
    if (result.end == RunEnd::handed_over) {
      const std::size_t j = static_cast<std::size_t>(&pieces_.joint_of(result.margin) - ode_.system().joints().data());
      const double tilt = static_cast<double>(ode_.system().joint_kinematics(j, ode_.workspace()).tilt());
      return near.words + "the film of " + joint() + " ends at its edge: with a tilt of " + detail::number(tilt) +
             " rad the journal's edge meets the wall, which is outside the model; give the joint a transition to "
             "contact, a shorter bearing, or constraints that keep its axes parallel";
    }
    try {
      ode_.system().evaluate_kinematics(t_, y_.data(), ode_.workspace());
      ode_.system().factorise(ode_.workspace());
      if (ode_.workspace().schur.size() > 0 && ode_.workspace().schur.least_share() < R(1e-8)) return singular_words();
    } catch (const SingularConstraints&) {
      return singular_words();
    }
    for (std::size_t j = 0; j < ode_.system().joints().size(); ++j) {
      if (axes_cosine(j) > R(10 * least_tilt_cosine)) continue;
      return "joint \"" + ode_.system().joints()[j].name() +
             "\": its journal lies across its bearing, whose middle plane its axis does not pierce; let constraints "
             "keep its axes from crossing";
    }
    switch (result.end) {
      case RunEnd::step_limit:
        return near.words + detail::step_limit_words(settings_.max_steps, is_implicit(), near.gap);
      case RunEnd::stalled:
        return near.words + detail::stall_words() + detail::remedy_words(is_implicit(), near.gap);
      case RunEnd::refused:
        return near.words +
               "a journal passes its wall inside a step whose ends are in the film; use a tighter tolerance";
      case RunEnd::not_located:
        return near.words +
               (kind == Kind::contact ? "a contact of "
                : kind == Kind::side  ? "a change of the film's side of "
                                      : "the film's edge at the wall of ") +
               joint() + " can't be located; use a tighter tolerance";
      case RunEnd::stuck:
        return near.words + joint() +
               (kind == Kind::contact ? " can't leave a seam of its contact" : detail::stuck_on_jump_words());
      default:
        if (near.words.empty()) {
          return "no step, however short, gives a finite state; use a looser relative_tolerance, or lower the loads "
                 "and speeds";
        }
        return near.words +
               "no step, however short, gives a finite state; raise the viscosity, lower the load or the clearance, or "
               "give the joint a transition to contact";
    }
  }

  std::string singular_words() {
    const std::size_t kept = ode_.workspace().schur.least_row();
    std::size_t row = 0;
    for (std::size_t seen = 0; row + 1 < ode_.system().constraint_rows(); ++row) {
      const auto& without = ode_.system().left_out();
      if (std::binary_search(without.begin(), without.end(), row)) continue;
      if (seen++ == kept) break;
    }
    return "the mechanism is at a singular position, where the constraints are not independent: " +
           detail::constraint_of_row(ode_.system(), row) +
           " repeats what others fix; let the run end before it, or choose constraints that stay independent";
  }

  SpatialOde<R>& ode_;
  RunSettings settings_;
  std::unique_ptr<Method> method_;
  RunOutcome outcome_;
  SpatialPieces<R> pieces_;
  StallGuard<R> guard_;
  EventRun<SpatialPieces<R>> engine_;
  SpatialRecorder<R> recorder_;
  SpringWatch<R, SpatialSprings<R>> springs_;
  std::optional<SpringAtZero> spring_;  ///< where the run met one
  bool leaves_film_ = false;
  State y_;
  R t_{};
};

}  // namespace lubjoint

/// A multibody system from its start to its end, through every contact.
#pragma once

#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "lubjoint/motion/contact_events.hpp"
#include "lubjoint/motion/multibody_recorder.hpp"
#include "lubjoint/motion/multibody_stops.hpp"
#include "lubjoint/multibody/assembly.hpp"
#include "lubjoint/ode/integrator.hpp"

namespace lubjoint {

/// How a run keeps its constraints: by the accelerations alone (Baumgarte's terms are part of the system), or by
/// projection of every accepted step.
enum class ConstraintUpkeep { by_accelerations, by_projection };

/// Contact is followed event by event. The jump of a half film at a = 0 is not: a free journal's run has a mode for
/// motion that slides on it, this run crosses
/// it back and forth, with the force of sliding in its samples, or stops there with a message that says so.
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
        upkeep_(upkeep),
        method_(std::move(method)),
        recorder_(ode, settings, method_->looks_inside()) {}

  /// @param start  (q, q̇), fulfils the constraints, and every film exists
  RunOutcome run(const State& start) {
    y_ = start;
    y_.resize(ode_.dimension(), R(0));  // work: none yet
    t_ = R(0);
    dt_ = R(1e-6 * settings_.duration);
    start_memory();
    rate_ = y_;
    ode_.rate(y_, rate_, t_);
    recorder_.start(t_, y_);
    integrate();
    recorder_.finish(t_, y_, by_method());
    outcome_.t_end = static_cast<double>(t_);
    outcome_.rhs_evaluations = ode_.evaluations();
    outcome_.jacobian_evaluations = method_->counts().jacobians;
    outcome_.factorisations = method_->counts().factorisations;
    return outcome_;
  }

  const MultibodyRecorder<R>& recorder() const { return recorder_; }   ///< what the run has left
  const std::vector<ContactEvent>& events() const { return events_; }  ///< of contact, in order
  const State& state() const { return y_; }                            ///< at the end

 private:
  using Step = MultibodyStep<R>;

  void start_memory() {
    if (!ode_.has_contact()) return;
    // The motion decides the phase; with no phase known yet the forces are not asked for.
    ode_.system().evaluate_kinematics(t_, y_.data(), ode_.workspace());
    for (std::size_t j = 0; j < ode_.memory().size(); ++j) {
      ode_.memory()[j] = detail::starting_memory(ode_.system().joints()[j], motion_of(j));
    }
  }

  void integrate() {
    const R t_end(settings_.duration);
    const R shortest = 8 * std::numeric_limits<R>::epsilon();
    R stall_mark = t_;
    std::size_t stall_steps = 0;
    while (t_end - t_ > shortest * t_end) {
      if (outcome_.steps + outcome_.rejected_steps >= settings_.max_steps) {
        return stop(detail::step_limit_reason(ode_, t_, y_, settings_.max_steps, is_implicit()));
      }
      if (++stall_steps >= stall_limit) {
        if (t_ - stall_mark < R(stall_share) * t_end) {
          return stop(detail::stall_reason(ode_.system()));
        }
        stall_mark = t_;
        stall_steps = 0;
      }
      auto step = std::make_shared<Step>();
      step->t_old = t_;
      step->y_old = y_;
      step->rate_old = rate_;
      step->memory = ode_.memory();
      step->smooth_rates = method_->has_smooth_rates();
      const R wanted = dt_;
      const R goal = next_stop(t_end);
      const bool last = dt_ >= goal - t_;
      if (last) dt_ = goal - t_;
      if (!method_->try_step(ode_, y_, t_, dt_) || !accept(last && goal - t_ <= R(1e-9) * (goal - step->t_old), goal)) {
        if (t_ > step->t_old) {
          dt_ = (t_ - step->t_old) / 2;
          method_->reset();
        }
        t_ = step->t_old;
        y_ = step->y_old;
        rate_ = step->rate_old;
        ++outcome_.rejected_steps;
        const R floor = shortest * std::max<R>(t_, R(1e-3) * t_end);
        if (!(dt_ > floor)) return stop(detail::no_step_reason(ode_, t_, y_));
        continue;
      }
      ++outcome_.steps;
      if (last && t_ == goal) dt_ = std::max<R>(dt_, wanted);
      close(*step);
      if (ode_.has_contact() && find_event(*step)) {
        if (!resolve_event(*step)) return;
        close(*step);
        if (step->t_new > step->t_old) recorder_.step(step, by_method());
        if (!resolves_contact()) return;
        change_phase();
        continue;
      }
      if (upkeep_ == ConstraintUpkeep::by_projection) {
        project_onto_constraints(ode_.system(), t_, y_, ode_.workspace());
        method_->replace_state(y_);
        ode_.rate(y_, rate_, t_);
        method_->refine_end_rate(rate_);
        close(*step);
      }
      recorder_.step(step, by_method());
      if (!resolves_contact()) return;
    }
    t_ = t_end;
  }

  /// The end, or the next output where steps are to end at outputs.
  R next_stop(const R& t_end) const {
    if (!settings_.stop_at_outputs) return t_end;
    const R interval(settings_.output_interval);
    using std::floor;
    const R next = (floor(R(t_ / interval * (1 + 4 * std::numeric_limits<double>::epsilon()))) + 1) * interval;
    return std::min<R>(t_end, R(static_cast<double>(next)));
  }

  /// Every number is one and every film exists at the new state.
  /// @param last  the step was to end at the goal, and has ended there: an integrator may have made it shorter
  bool accept(bool last, const R& goal) {
    for (const R& value : y_) {
      if (!std::isfinite(static_cast<double>(value))) return false;
    }
    if (last) t_ = goal;
    try {
      ode_.rate(y_, rate_, t_);
    } catch (const std::domain_error&) {
      return false;
    }
    method_->refine_end_rate(rate_);
    return true;
  }

  void close(Step& step) const {
    step.t_new = t_;
    step.y_new = y_;
    step.rate_new = rate_;
    step.is_explicit = !is_implicit();
  }

  // Contact.

  struct Crossing {
    std::size_t joint = 0;
    bool outwards = false;
    R t_before{};  ///< not yet crossed
    R t_beyond{};
  };

  Vector2<R> eccentricity(const R& t, const State& y, std::size_t joint) {
    ode_.system().evaluate_kinematics(t, y.data(), ode_.workspace());
    return motion_of(joint).eccentricity;
  }

  /// From the frames of the workspace.
  JournalMotion<R> motion_of(std::size_t joint) { return ode_.system().journal_motion(joint, ode_.workspace()); }

  detail::SeamMargins<R> margins(const R& t, const State& y, std::size_t joint) {
    return detail::seam_margins(ode_.system().joints()[joint], ode_.memory()[joint].phase, eccentricity(t, y, joint));
  }

  /// The first seam that a step crosses, looked for inside it as well: a journal may touch and leave within one.
  bool find_event(const Step& step) {
    const std::size_t pieces = 2 * method_->looks_inside();
    State y;
    R t_before = step.t_old;
    for (std::size_t i = 1; i <= pieces; ++i) {
      const R t =
          i == pieces
              ? step.t_new
              : R(step.t_old + (step.t_new - step.t_old) * static_cast<double>(i) / static_cast<double>(pieces));
      if (i == pieces) {
        y = step.y_new;
      } else {
        step.state_at(t, ode_.system().coordinates(), y);
      }
      bool found = false;
      for (std::size_t j = 0; j < ode_.memory().size(); ++j) {
        if (!ode_.system().joints()[j].has_contact()) continue;
        const detail::SeamMargins<R> m = margins(t, y, j);
        if (m.inner >= -slack && m.outer >= -slack) continue;
        const Crossing crossing{j, m.outer < -slack, t_before, t};
        // Of several joints in the same piece the one that crosses first, by its root on the interpolant.
        if (!found || root_inside(step, crossing) < root_inside(step, crossing_)) crossing_ = crossing;
        found = true;
      }
      if (found) return true;
      t_before = t;
    }
    return false;
  }

  R margin(const R& t, const State& y, const Crossing& crossing) {
    const detail::SeamMargins<R> m = margins(t, y, crossing.joint);
    return crossing.outwards ? m.outer : m.inner;
  }

  R root_inside(const Step& step, const Crossing& crossing) {
    State y;
    R low = step.t_old;
    R high = crossing.t_beyond;
    for (int i = 0; i < 40; ++i) {
      const R middle = (low + high) / 2;
      step.state_at(middle, ode_.system().coordinates(), y);
      (margin(middle, y, crossing) < -slack ? high : low) = middle;
    }
    return high;
  }

  /// Steps to the crossing itself with the method, not on an interpolant, and leaves the state just beyond it.
  bool resolve_event(const Step& step) {
    const auto state_at = [&](const R& t, State& y) {
      y = step.y_old;
      return t <= step.t_old || step_to(step.t_old, t, y);
    };
    State y;
    bool failed = false;
    const auto value = [&](const R& t) {
      if (!state_at(t, y)) failed = true;
      return failed ? R(0) : margin(t, y, crossing_);
    };
    // A phase that has just begun starts on its seam: if it never left it, the crossing is its start.
    R t_event = step.t_old;
    if (value(crossing_.t_beyond) >= 0) {
      t_event = crossing_.t_beyond;  // crossed on the interpolant, touched by the method: on the seam to rounding
    } else {
      const R low = value(crossing_.t_before) > 0 ? crossing_.t_before : step.t_old;
      if (value(low) > 0) {
        std::uintmax_t iterations = 80;
        const boost::math::tools::eps_tolerance<R> tolerance(std::numeric_limits<R>::digits - 2);
        t_event = boost::math::tools::toms748_solve(value, low, crossing_.t_beyond, tolerance, iterations).second;
      }
    }
    if (failed || !state_at(t_event, y)) {
      stop("a contact of joint \"" + ode_.system().joints()[crossing_.joint].name + "\" can't be located");
      return false;
    }
    y_ = y;
    t_ = t_event;
    if (t_ > step.t_old) {
      if (upkeep_ == ConstraintUpkeep::by_projection) project_onto_constraints(ode_.system(), t_, y_, ode_.workspace());
      events_without_progress_ = 0;
    } else if (++events_without_progress_ > 20) {
      stop("joint \"" + ode_.system().joints()[crossing_.joint].name + "\" can't leave a seam of its contact");
      return false;
    }
    ode_.rate(y_, rate_, t_);
    return true;
  }

  bool step_to(const R& t_start, const R& t_goal, State& y) {
    const auto method = method_->fresh();
    R t = t_start;
    R dt = t_goal - t;
    for (int trials = 0; t < t_goal; ++trials) {
      if (trials > 400) return false;
      if (t + dt >= t_goal - 4 * std::numeric_limits<R>::epsilon() * t_goal) dt = t_goal - t;
      if (!method->try_step(ode_, y, t, dt)) continue;
      if (t_goal - t <= std::numeric_limits<R>::epsilon() * t_goal) break;
    }
    return true;
  }

  /// The state inside a step as the recorder asks for it: by the method from the step's start, in the step's phases.
  auto by_method() {
    return [this](const Step& step, const R& t, State& y) {
      const std::vector<JointMemory<R>> memory = std::exchange(ode_.memory(), step.memory);
      y = step.y_old;
      const bool reached = t <= step.t_old || step_to(step.t_old, t, y);
      ode_.memory() = memory;
      if (!reached) step.state_at(t, ode_.system().coordinates(), y);
    };
  }

  bool resolves_contact() {
    const std::string reason = detail::unresolved_contact_reason(ode_, t_, y_, settings_.absolute_tolerance);
    if (!reason.empty()) stop(reason);
    return reason.empty();
  }

  void change_phase() {
    const std::size_t j = crossing_.joint;
    const JointElement<R>& joint = ode_.system().joints()[j];
    JointMemory<R>& memory = ode_.memory()[j];
    const Vector2<R> before = ode_.at(t_, y_).joints[j].total();
    const R speed = detail::normal_speed(motion_of(j));
    ContactEvent event{static_cast<double>(t_),
                       j,
                       memory.phase,
                       detail::next_phase(joint, memory.phase, crossing_.outwards),
                       static_cast<double>(speed),
                       0,
                       0};
    detail::enter_phase(joint, memory, event.to, speed);
    ode_.rate(y_, rate_, t_);
    const Vector2<R> after = ode_.at(t_, y_).joints[j].total();
    event.force_before = static_cast<double>(before.norm());
    event.force_jump = static_cast<double>((after - before).norm());
    events_.push_back(event);
    ++outcome_.mode_changes;
    method_->reset();
    dt_ = std::max<R>(dt_ / 1000, R(1e-9 * settings_.duration));
  }

  // Stops.

  bool is_implicit() const { return method_->counts().jacobians > 0; }

  void stop(const std::string& reason) {
    outcome_.status = RunStatus::stopped;
    outcome_.message = "stopped at t = " + detail::number(static_cast<double>(t_)) + " s: " + reason;
  }

  /// A margin that starts at zero may be negative by the rounding of coordinates a thousand clearances long.
  const R slack = R(1e-12) * (std::numeric_limits<R>::epsilon() / R(std::numeric_limits<double>::epsilon()));

  MultibodyOde<R>& ode_;
  RunSettings settings_;
  ConstraintUpkeep upkeep_;
  std::unique_ptr<Method> method_;
  MultibodyRecorder<R> recorder_;
  RunOutcome outcome_;
  std::vector<ContactEvent> events_;
  Crossing crossing_;
  std::size_t events_without_progress_ = 0;
  State y_;
  State rate_;
  R t_{};
  R dt_{};
};

}  // namespace lubjoint

/// A free journal on its film, from its start to its end, through all modes.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "lubjoint/motion/film_modes.hpp"
#include "lubjoint/motion/journal_recorder.hpp"
#include "lubjoint/motion/mode_system.hpp"
#include "lubjoint/motion/stop_words.hpp"
#include "lubjoint/ode/integrators.hpp"

namespace lubjoint {

namespace detail {

/// Message of a run that could not go on: where it was, and what to change.
inline std::string stop_message(RunEnd end, const std::string& joint, double t, const JournalState<double>& y,
                                const RunSettings& settings, std::string_view method) {
  const std::string where = "stopped at t = " + number(t) + " s: joint \"" + joint + "\" is at eccentricity ratio " +
                            eccentricity_words({y[0], y[1]});
  if (end == RunEnd::step_limit) {
    return where + "; " + step_limit_words(settings.max_steps, is_stiff_integrator(method), film_gap({y[0], y[1]}));
  }
  const std::string remedy =
      "the film can't carry this load in double precision; raise the viscosity or lower the load or the clearance";
  if (end == RunEnd::stalled) {
    return where + "; " + stall_words() +
           (is_stiff_integrator(method) ? remedy : "radau_iia5 needs far fewer where the film is stiff");
  }
  return where + "; no step, however short, gives a finite state with eccentricity ratio below 1: " + remedy;
}

/// What w is measured against [1/s]: the mean spin, or the rate at which the load moves the journal, be it the film or
/// inertia that holds it back.
template <class Law>
double rate_scale(const FreeJournal<Law>& journal) {
  const double load = journal.drive().load.norm();
  const double film_rate = load / journal.joint().force_scale();
  const double inertial_rate = std::sqrt(load / journal.inertia());
  return std::max({std::abs(journal.drive().mean_spin()), std::min(film_rate, inertial_rate), 1e-3});
}

}  // namespace detail

/// What the runs of all journals share: a mode from its start to its end, and what is left of it.
class ModeRuns {
 public:
  const JournalRecorder& recorder() const { return recorder_; }  ///< what the run has left

 protected:
  /// @param rate_scale  what velocities are measured against [1/s];  @param method  one of method_names
  ModeRuns(double rate_scale, std::string joint_name, std::string method, const RunSettings& settings)
      : joint_name_(std::move(joint_name)), settings_(settings), recorder_(settings), rate_scale_(rate_scale) {
    outcome_.integrator = std::move(method);
  }

  /// Time 0, and a first step.
  void begin() {
    t_ = 0;
    dt_ = 1e-6 * settings_.duration;
  }

  /// A mode's motion from t_ on, until it ends or an event does. @param y  its start, and then its end
  template <class Mode>
  RunResult integrate(const Mode& mode, std::array<double, Mode::dimension>& y) {
    const double position = settings_.absolute_tolerance;
    const double velocity = position * rate_scale_;
    constexpr std::size_t n = Mode::dimension;
    constexpr bool is_first_order = Mode::coordinates == 0;
    StepTolerance<double, n> tolerance{settings_.relative_tolerance, {}, settings_.relative_tolerance};
    for (std::size_t i = 0; i < n; ++i) {
      tolerance.absolute[i] = is_first_order || i < Mode::coordinates ? position : velocity;
    }
    const auto method = make_integrator<n>(outcome_.integrator, tolerance);
    const std::size_t looks = method->looks_inside();
    // The quintic's error in an explicit step of higher order may be a hundred tolerances and more; a motion of first
    // order has but a cubic.
    const bool by_steps = is_first_order || !is_stiff_integrator(outcome_.integrator);
    ModeSystem<Mode> system(mode, outcome_.rhs_evaluations);
    const RunResult result =
        EventRun<ModeSystem<Mode>>(system, *method, settings_, outcome_, guard_)
            .run(t_, y, dt_, [&](const auto& step, const auto& state_at, const auto& stepped_at) {
              const auto sample_at = [&](double t) { return by_steps ? stepped_at(t) : state_at(t); };
              recorder_.step(mode, step.t_old, step.t_new, state_at, sample_at, looks);
              return true;
            });
    outcome_.jacobian_evaluations += method->counts().jacobians;
    outcome_.factorisations += method->counts().factorisations;
    return result;
  }

  /// What is left of a run: why it ended, and its last row.
  template <class Mode, class State>
  void conclude(const Mode& mode, const RunResult& result, const State& y) {
    if (result.end != RunEnd::duration_reached) {
      outcome_.status = RunStatus::stopped;
      outcome_.message =
          detail::stop_message(result.end, joint_name_, t_, mode.journal(t_, y), settings_, outcome_.integrator);
    }
    recorder_.finish(mode, t_, y);
  }

  std::string joint_name_;    ///< for messages
  RunSettings settings_;      ///< of the scene
  JournalRecorder recorder_;  ///< samples, extremes and ledger
  RunOutcome outcome_;        ///< status and counts
  StallGuard<double> guard_;  ///< against steps that get nowhere
  double rate_scale_;         ///< of velocities [1/s]
  double t_ = 0;              ///< the time [s]
  double dt_ = 0;             ///< the next step [s]
};

/// Runs a journal without mass.
template <class Law>
class MasslessRun : public ModeRuns {
 public:
  /// @param method  one of method_names
  MasslessRun(const MasslessJournal<Law>& journal, std::string joint_name, std::string method,
              const RunSettings& settings)
      : ModeRuns(1, std::move(joint_name), std::move(method), settings), journal_(journal) {}

  /// @param start  ê at t = 0; a place outside the clearance circle is the caller's error
  RunOutcome run(MasslessState<double> start) {
    begin();
    const MasslessMode<Law> mode(journal_);
    recorder_.start(mode, t_, start);
    conclude(mode, integrate(mode, start), start);
    outcome_.t_end = t_;
    return outcome_;
  }

 private:
  const MasslessJournal<Law>& journal_;
};

/// Runs a free journal. Law: a FilmLaw, a CompiledLaw or ChosenLaw.
template <class Law>
class JournalRun : public ModeRuns {
 public:
  /// @param method  one of method_names
  JournalRun(const FreeJournal<Law>& journal, std::string joint_name, std::string method, const RunSettings& settings)
      : ModeRuns(detail::rate_scale(journal), std::move(joint_name), std::move(method), settings), journal_(journal) {}

  /// @param start  ê and w at t = 0; a state outside the clearance circle is the caller's error
  RunOutcome run(const JournalState<double>& start) {
    begin();
    y_ = start;
    if constexpr (FilmOf<Law, double>::jumps) {
      run_half_film();
    } else {
      const SmoothMode<Law> mode(journal_);
      recorder_.start(mode, t_, y_);
      conclude(mode, integrate(mode, y_), y_);
    }
    outcome_.t_end = t_;
    return outcome_;
  }

 private:
  enum class Phase { converging, mirrored, sliding };

  // The half films: one mode after another.

  /// Line of centres r, and ρ, β on it, for a journal at a = 0. A journal at rest is looked at a moment later, when
  /// its acceleration has given it a direction.
  struct OnTheJump {
    Vector2<double> line;
    double rho;
    double beta;
    double t;
  };

  OnTheJump on_the_jump() const {
    const JournalDrive<double>& drive = journal_.drive();
    const FilmState<double> film = journal_.film(y_);
    const Vector2<double> acceleration = drive.load / journal_.inertia();
    if (!is_zero(film.velocity)) {
      const Vector2<double> r = direction(is_zero(film.eccentricity) ? film.velocity : film.eccentricity);
      return {r, dot(r, film.eccentricity), dot(r, film.velocity), t_};
    }
    if (is_zero(film.eccentricity) && is_zero(acceleration)) return {Vector2<double>(1, 0), 0, 0, t_};
    const Vector2<double> r = direction(is_zero(film.eccentricity) ? acceleration : film.eccentricity);
    const double fastest = std::max(std::abs(drive.mean_spin()), std::sqrt(acceleration.norm()));
    if (fastest == 0) return {r, dot(r, film.eccentricity), 0, t_};  // nothing will ever move it
    const double moment = 1e-6 / fastest;
    const double a_r = dot(r, acceleration);
    return {r, dot(r, film.eccentricity) + a_r * moment * moment / 2, a_r * moment, t_ + moment};
  }

  /// Filippov's rule at a = 0, where Φ is the tangential force that would keep it and X the film's on the converging
  /// side: slide if |Φ| ≤ X; else the film goes to the side to which it is driven.
  Phase decide_on_the_jump() const {
    const OnTheJump here = on_the_jump();
    const SlidingMode<Law> sliding(journal_, t_, here.line);
    const std::array<double, 2> y{here.rho, here.beta};
    const double reach = sliding.tangential_reach(y);
    const double needed = sliding.tangential_force(here.t, y);
    if (reach > 0 && std::abs(needed) <= reach) return Phase::sliding;
    if (needed >= reach) return Phase::converging;
    return Phase::mirrored;
  }

  /// Sine of the angle between ê and u, above 0 where a < 0; 0 where either is zero. Of unit vectors: a product of
  /// lengths may underflow.
  double sine() const {
    const FilmState<double> film = journal_.film(y_);
    if (is_zero(film.eccentricity) || is_zero(film.velocity)) return 0;
    return cross(direction(film.eccentricity), direction(film.velocity));
  }

  Phase first_phase() const {
    const double turning = sine();
    if (turning == 0) return decide_on_the_jump();
    return turning > 0 ? Phase::mirrored : Phase::converging;
  }

  /// Where the journal is off a = 0 beyond any error, to which a step of loose tolerance may bring it.
  std::optional<Phase> side_off_the_jump() const {
    const double off = sine();
    if (std::abs(off) <= wrong_side(journal_.film(y_).velocity.norm(), std::abs(journal_.drive().mean_spin())))
      return std::nullopt;
    return off > 0 ? Phase::mirrored : Phase::converging;
  }

  /// Is a rounding of w worth more of the film's force than the load? No velocity in double precision balances it then.
  bool rounding_outweighs_load() const {
    const OnTheJump here = on_the_jump();
    const double fastest = std::max(std::abs(here.beta), std::abs(journal_.drive().mean_spin()));
    const Vector2<double> rounding = std::numeric_limits<double>::epsilon() * fastest * perpendicular(here.line);
    const FilmState<double> film{journal_.film(y_).eccentricity, rounding};
    return journal_.joint().force(film, HalfFilmSide::converging).norm() > journal_.drive().load.norm();
  }

  void run_half_film() {
    Phase phase = first_phase();
    bool from_jump = sine() == 0;
    bool started = false;
    double last_event = -1;
    int events_without_progress = 0;
    while (true) {
      RunResult result;
      if (phase == Phase::sliding) {
        const OnTheJump here = on_the_jump();
        const bool at_rest = here.t > t_;
        const SlidingMode<Law> mode(journal_, t_, here.line);
        std::array<double, 2> y{dot(here.line, Vector2<double>(y_[0], y_[1])), at_rest ? 0.0 : here.beta};
        if (!std::exchange(started, true)) recorder_.start(mode, t_, y);
        const double t_start = t_;
        result = integrate(mode, y);
        recorder_.slid(t_start, t_);
        y_ = mode.journal(t_, y);
        if (result.end != RunEnd::handed_over) return conclude(mode, result, y);
        const bool beyond = y[0] < 0;
        phase = (result.margin == 0) != beyond ? Phase::converging : Phase::mirrored;
        from_jump = true;
      } else {
        const HalfFilmSide side = phase == Phase::converging ? HalfFilmSide::converging : HalfFilmSide::mirrored;
        const SidedMode<Law> mode(journal_, side, from_jump);
        if (!std::exchange(started, true)) recorder_.start(mode, t_, y_);
        result = integrate(mode, y_);
        if (result.end != RunEnd::handed_over) return conclude(mode, result, y_);
        // So near the wall that on its line of centres the journal is at it, to rounding.
        if (!(std::abs(on_the_jump().rho) < 1)) return conclude(mode, {RunEnd::step_too_short, 0}, y_);
        if (const std::optional<Phase> beyond = side_off_the_jump()) {
          phase = *beyond;
          from_jump = false;
        } else {
          from_jump = true;
          const Phase next = decide_on_the_jump();
          const Phase other = phase == Phase::converging ? Phase::mirrored : Phase::converging;
          phase = next == Phase::sliding ? next : other;
        }
      }
      ++outcome_.mode_changes;
      events_without_progress = t_ > last_event ? 0 : events_without_progress + 1;
      last_event = t_;
      if (events_without_progress > 20) {
        outcome_.status = RunStatus::stopped;
        outcome_.message = "stopped at t = " + detail::number(t_) + " s: joint \"" + joint_name_ +
                           "\" is at eccentricity ratio " + detail::eccentricity_words({y_[0], y_[1]}) +
                           (rounding_outweighs_load()
                                ? ": one rounding of its velocity changes the film's force by more than the load; "
                                  "lower the viscosity or raise the clearance"
                                : " and can't leave the jump of its half film at a = 0; use a law without a jump, "
                                  "such as a dynamic one");
        recorder_.finish(SidedMode<Law>(journal_, HalfFilmSide::converging, false), t_, y_);
        return;
      }
    }
  }

  const FreeJournal<Law>& journal_;
  JournalState<double> y_{};
};

}  // namespace lubjoint

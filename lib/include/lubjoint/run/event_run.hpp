/// The step loop of every run: steps, checks of the state, and events, which are located by stepping to them.
#pragma once

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/ode/step_interpolant.hpp"
#include "lubjoint/run/outcome.hpp"

namespace lubjoint {

/// Distance of a state from a surface where the equations change.
template <class R>
struct Margin {
  R value;     ///< positive while the present piece of the equations lasts
  R rounding;  ///< what rounding may make of 0: the surface is crossed where value < −rounding
};

/// What follows an event.
enum class AfterEvent {
  go_on,      ///< the system has changed its equations: the same states, another piece
  keep_pace,  ///< so it has, but the rate has not jumped, its derivatives alone: steps stay as long as they were
  hand_over   ///< another system takes over, as where sliding leaves fewer states
};

/// Equations of motion in pieces, each smooth, and the surfaces between them. It has Real, State, dimension
/// (run_time_size if known when the program runs), coordinates() = how many states are places, and
/// - has_events: may it ever have a margin, or be held? If not, nothing of events is compiled;
/// - looks_each: how often a margin is looked at in each of the pieces that the method divides its step into;
/// - watches(): is there a margin to look at in this run?
/// - equations(): of the present piece, continued smoothly beyond its surfaces;
/// - admissible(t, y): is every number finite, and is there a film where one is needed? Else the step is rejected;
/// - margins(t, y, list): of the present piece, always as many;
/// - hold(t, y, exactly): puts a state back onto what its equations keep only to their error (constraints, a slide),
///   and says whether it has changed it;
/// - cross(margin, t, y): the piece beyond that surface.
template <class S>
concept EventSystem = requires(S& system, const typename S::Real& t, typename S::State& y, const typename S::State& at,
                               std::vector<Margin<typename S::Real>>& margins) {
  { S::has_events } -> std::convertible_to<bool>;
  { S::looks_each } -> std::convertible_to<std::size_t>;
  { system.watches() } -> std::convertible_to<bool>;
  { system.equations() } -> std::convertible_to<OdeSystem<typename S::Real, S::dimension>&>;
  { system.coordinates() } -> std::convertible_to<std::size_t>;
  { system.admissible(t, at) } -> std::convertible_to<bool>;
  system.margins(t, at, margins);
  { system.hold(t, y, true) } -> std::convertible_to<bool>;
  { system.cross(std::size_t(), t, y) } -> std::same_as<AfterEvent>;
};

/// How a run of one system ended.
enum class RunEnd {
  duration_reached,  ///< the run is over
  handed_over,       ///< at an event
  refused,           ///< the observer would not go on
  step_limit,        ///< RunSettings::max_steps
  step_too_short,    ///< no step, however short, succeeds
  stalled,           ///< many steps for next to no time
  not_located,       ///< an event that no step reaches
  stuck              ///< event upon event at the same time
};

/// Why and where a run of one system ended.
struct RunResult {
  RunEnd end = RunEnd::duration_reached;  ///< why
  std::size_t margin = 0;                 ///< of the last event
};

/// Notices a run that would never end. One for all systems of a run: each may last but a few steps.
template <class R>
class StallGuard {
 public:
  /// Before a trial step at t. Have stall_limit of them brought less than stall_share of the duration?
  bool is_stalled(const R& t, const R& duration) {
    if (++steps_ < stall_limit) return false;
    if (t - mark_ < R(stall_share) * duration) return true;
    mark_ = t;
    steps_ = 0;
    return false;
  }

 private:
  R mark_{};
  std::size_t steps_ = 0;
};

/// Integrates a system from (t, y) to the end of the run or to where another system takes over. Events are as accurate
/// as the solution: the method itself steps to them, not an interpolant.
template <EventSystem System>
class EventRun {
 public:
  using R = typename System::Real;                  ///< scalar
  using State = typename System::State;             ///< of the system
  using Method = Integrator<R, System::dimension>;  ///< that makes the steps
  using Step = StepInterpolant<State>;              ///< an accepted one

  /// All are kept by reference; steps are counted in the outcome.
  EventRun(System& system, Method& method, const RunSettings& settings, RunOutcome& outcome, StallGuard<R>& guard)
      : system_(system), method_(method), settings_(settings), outcome_(outcome), guard_(guard) {
    step_.smooth_rates = method.has_smooth_rates();
  }

  /// @param dt  the first step's length, then the next one's
  /// @param observe  observe(step, state_at, stepped_at) sees every accepted step, and says whether to go on:
  ///   state_at(t) is the state inside it on the interpolant, stepped_at(t) the same by the method's own steps
  template <class Observer>
  RunResult run(R& t, State& y, R& dt, Observer&& observe) {
    const R t_end(settings_.duration);
    const R shortest = 8 * epsilon();
    step_.rate_new = y;  // of its size
    if (t_end - t > shortest * t_end) system_.equations().rate(y, step_.rate_new, t);
    const auto state_at = [this](const R& at) -> const State& { return inside(at); };
    const auto stepped_at = [this](const R& at) -> const State& {
      return at < step_.t_new ? stepped_to(at) : step_.y_new;
    };
    int rejections = 0;
    std::size_t at_once = 0;
    while (t_end - t > shortest * t_end) {
      if (outcome_.steps + outcome_.rejected_steps >= settings_.max_steps) return {RunEnd::step_limit, 0};
      if (guard_.is_stalled(t, t_end)) return {RunEnd::stalled, 0};
      step_.t_old = t;
      step_.y_old = y;
      step_.rate_old = step_.rate_new;
      step_.shortened = false;
      step_.inside = {};
      step_.has_middle = false;
      const R wanted = dt;
      const R goal = next_stop(t);
      const bool last = dt >= goal - t;
      if (last) dt = goal - t;
      const bool stepped = method_.try_step(system_.equations(), y, t, dt);
      // A method may have made its step shorter than asked.
      if (stepped && last && goal - t <= R(1e-9) * (goal - step_.t_old)) t = goal;
      // A step so short that time does not notice is none.
      if (!stepped || !(t > step_.t_old) || !close_step(t, y)) {
        if (stepped) {
          dt = (t - step_.t_old) / 2;
          method_.reset();
        }
        t = step_.t_old;
        y = step_.y_old;
        step_.rate_new = step_.rate_old;
        ++outcome_.rejected_steps;
        if (++rejections > max_rejections) return {RunEnd::step_too_short, 0};
        if (!(dt > shortest * std::max<R>(t, shortest * t_end))) return {RunEnd::step_too_short, 0};
        continue;
      }
      rejections = 0;
      ++outcome_.steps;
      if (last && t == goal) dt = std::max<R>(dt, wanted);
      if constexpr (System::has_events) {
        const std::optional<Event> event = system_.watches() ? find_event() : std::nullopt;
        if (event) {
          if (!event->located) return {RunEnd::not_located, event->margin};
          t = event->t;
          y = event_state_;
          if (t > step_.t_old) {
            at_once = 0;
            system_.hold(t, y, true);
            step_.t_new = t;
            step_.y_new = y;
            step_.shortened = true;
            step_.inside = {};
            step_.has_middle = false;
            system_.equations().rate(y, step_.rate_new, t);
            if (!observe(step_, stepped_at, stepped_at)) return {RunEnd::refused, 0};
          } else if (++at_once > most_at_once) {
            return {RunEnd::stuck, event->margin};
          }
          dt = std::max<R>((t - step_.t_old) / 1000, R(1e-9) * t_end);
          const AfterEvent after = system_.cross(event->margin, t, y);
          if (after == AfterEvent::hand_over) return {RunEnd::handed_over, event->margin};
          if (after == AfterEvent::keep_pace) dt = wanted;
          method_.reset();
          system_.equations().rate(y, step_.rate_new, t);
          continue;
        }
        if (system_.hold(t, y, false)) {
          method_.replace_state(y);
          system_.equations().rate(y, step_.rate_new, t);
          method_.end_rate(step_.rate_new);
          step_.y_new = y;
          method_.see_inside(system_.equations(), step_);
        }
      }
      if (!observe(step_, state_at, stepped_at)) return {RunEnd::refused, 0};
      if (!settings_.knots.empty() && knots_until(t) != knots_until(step_.t_old)) method_.reset();
    }
    t = t_end;
    return {RunEnd::duration_reached, 0};
  }

  /// Steps from a step's start to exactly t, in the system's present piece; false if that can't be done.
  bool reach(const Step& step, const R& t_goal, State& y) {
    y = step.y_old;
    R t = step.t_old;
    if (!(t_goal > t)) return true;
    const auto method = method_.fresh();
    R dt = t_goal - t;
    int trials = 0;
    while (t < t_goal) {
      dt = std::min<R>(dt, t_goal - t);
      if (t + dt >= t_goal - 4 * epsilon() * t_goal) dt = t_goal - t;
      State trial = y;
      R t_trial = t;
      if (method->try_step(system_.equations(), trial, t_trial, dt) && system_.admissible(t_trial, trial)) {
        y = trial;
        t = t_trial;
      } else if (++trials > max_rejections) {
        return false;
      }
      if (t_goal - t <= epsilon() * t_goal) break;
    }
    return true;
  }

 private:
  static R epsilon() { return std::numeric_limits<R>::epsilon(); }

  /// In a row. Halving leads from any first step to the shortest one in less; a method that rejects more often without
  /// a shorter step is stuck.
  static constexpr int max_rejections = 400;

  /// Events that follow each other at the same time: a few, where several joints change at once.
  static constexpr std::size_t most_at_once = 20;

  /// Of a step, in search of a moment at which a piece is off the surface that it started on.
  static constexpr int most_halvings = 30;

  struct Event {
    std::size_t margin;
    R t;           ///< where it is, or within a step beyond it
    bool located;  ///< and event_state_ is the state there
  };

  /// How many knots lie up to a time, those within its rounding counted.
  std::size_t knots_until(const R& t) const {
    const double reached = static_cast<double>(t) * (1 + 4 * std::numeric_limits<double>::epsilon());
    return static_cast<std::size_t>(std::upper_bound(settings_.knots.begin(), settings_.knots.end(), reached) -
                                    settings_.knots.begin());
  }

  /// The end, the next knot, or the next output where steps are to end at outputs.
  R next_stop(const R& t) const {
    R t_end(settings_.duration);
    if (!settings_.knots.empty()) {
      const std::size_t next = knots_until(t);
      if (next < settings_.knots.size()) t_end = std::min<R>(t_end, R(settings_.knots[next]));
    }
    if (!settings_.stop_at_outputs) return t_end;
    const R interval(settings_.output_interval);
    using std::floor;
    const R next = (floor(R(t / interval * (1 + 4 * std::numeric_limits<double>::epsilon()))) + 1) * interval;
    return std::min<R>(t_end, R(static_cast<double>(next)));
  }

  /// A step that ends without a film or a number is rejected: Odeint itself would accept it.
  bool close_step(const R& t, const State& y) {
    if (!system_.admissible(t, y)) return false;
    step_.t_new = t;
    step_.y_new = y;
    try {
      system_.equations().rate(y, step_.rate_new, t);
    } catch (const std::domain_error&) {
      return false;
    }
    method_.end_rate(step_.rate_new);
    method_.see_inside(system_.equations(), step_);
    return true;
  }

  const State& stepped_to(const R& at) {
    reach(step_, at, look_);
    return look_;
  }

  /// On the interpolant; where that leaves the film, by the method.
  const State& inside(const R& at) {
    if (at >= step_.t_new) return step_.y_new;
    step_.state_at(at, system_.coordinates(), look_);
    return system_.admissible(at, look_) ? look_ : stepped_to(at);
  }

  /// The first surface that a step crosses. It is looked for inside the step as well: a margin may be crossed and
  /// crossed back within one.
  std::optional<Event> find_event() {
    const std::size_t pieces = System::looks_each * method_.looks_inside();
    R before = step_.t_old;
    for (std::size_t i = 1; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(pieces);
      const R at = i == pieces ? step_.t_new : R(step_.t_old + (step_.t_new - step_.t_old) * share);
      if (const std::optional<std::size_t> margin = first_crossed(before, at)) {
        if (const std::optional<Event> event = locate(*margin, before, at)) return event;
      }
      before = at;
    }
    return std::nullopt;
  }

  bool is_crossed(const Margin<R>& margin) const { return margin.value < -margin.rounding; }

  /// Margins inside the step, or nothing where there is no film on the interpolant.
  bool look(const R& at) {
    try {
      system_.margins(at, inside(at), margins_);
      return true;
    } catch (const std::domain_error&) {
      return false;
    }
  }

  /// Of several margins that are negative at a time, the one that is crossed first, by its root on the interpolant.
  std::optional<std::size_t> first_crossed(const R& before, const R& at) {
    if (!look(at)) return std::nullopt;
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < margins_.size(); ++i) {
      if (is_crossed(margins_[i])) all.push_back(i);
    }
    if (all.empty()) return std::nullopt;
    R low = before;
    R high = at;
    for (int i = 0; all.size() > 1 && i < 40; ++i) {
      const R middle = (low + high) / 2;
      if (!look(middle)) break;
      std::vector<std::size_t> earlier;
      for (const std::size_t k : all) {
        if (is_crossed(margins_[k])) earlier.push_back(k);
      }
      if (earlier.empty()) {
        low = middle;
      } else {
        high = middle;
        all = earlier;
      }
    }
    return all.front();
  }

  /// By the method's own steps from the start of the step.
  /// @returns nothing if the method does not cross there: it was the interpolant
  std::optional<Event> locate(std::size_t margin, const R& before, const R& beyond) {
    bool failed = false;
    const auto value = [&](const R& at) {
      if (failed || !reach(step_, at, event_state_)) {
        failed = true;
        return R(0);
      }
      system_.margins(at, event_state_, margins_);
      return margins_[margin].value;
    };
    const auto event_at = [&](const R& at) {
      if (failed || !reach(step_, at, event_state_)) return Event{margin, at, false};
      return Event{margin, at, true};
    };
    const bool at_end = beyond == step_.t_new;
    const R f_beyond = value(beyond);
    if (failed) return event_at(beyond);
    if (!(f_beyond < 0)) {
      if (!at_end) return std::nullopt;
      event_state_ = step_.y_new;  // crossed in this step, touched in the shorter ones
      return Event{margin, step_.t_new, true};
    }
    R low = before;
    R f_low = value(low);
    if (!(f_low > 0) && low > step_.t_old) {
      low = step_.t_old;
      f_low = value(low);
    }
    // A piece that has just begun starts on its surface, to rounding or to the method's error. It may have left it
    // before it came back: if it never did, the crossing is its start.
    if (!(f_low > 0)) low = beyond;
    for (int halvings = 0; halvings < most_halvings && !failed && !(f_low > 0); ++halvings) {
      low = step_.t_old + (low - step_.t_old) / 2;
      f_low = value(low);
    }
    if (failed || !(f_low > 0)) return event_at(step_.t_old);
    std::uintmax_t iterations = 80;
    const boost::math::tools::eps_tolerance<R> tolerance(std::numeric_limits<R>::digits - 2);
    const auto root =
        boost::math::tools::toms748_solve(value, low, beyond, f_low, f_beyond, tolerance, iterations).second;
    return event_at(root);
  }

  System& system_;
  Method& method_;
  const RunSettings& settings_;
  RunOutcome& outcome_;
  StallGuard<R>& guard_;
  Step step_;
  State look_{};         ///< at a time inside the step
  State event_state_{};  ///< where an event is
  std::vector<Margin<R>> margins_;
};

}  // namespace lubjoint

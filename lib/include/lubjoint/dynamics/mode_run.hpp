/// Integration of one mode: steps, checks of the state, events, and what an observer sees.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "lubjoint/dynamics/exact_jacobian.hpp"
#include "lubjoint/dynamics/outcome.hpp"
#include "lubjoint/film/film_state.hpp"

namespace lubjoint {

/// A mode as the steppers see it: its rate, counted, and its exact Jacobian.
template <class Mode>
class ModeSystem {
 public:
  static constexpr std::size_t dimension = Mode::dimension;
  using State = std::array<double, dimension>;

  ModeSystem(const Mode& mode, std::size_t& evaluations) : mode_(mode), evaluations_(evaluations) {}

  void rate(const State& y, State& dydt, double t) {
    ++evaluations_;
    mode_.rate(y, dydt, t);
  }
  template <class Matrix>
  void jacobian(const State& y, Matrix& j, double t) const {
    exact_jacobian([this, t](const auto& x, auto& dxdt) { mode_.rate(x, dxdt, t); }, y, j);
  }

 private:
  const Mode& mode_;
  std::size_t& evaluations_;
};

enum class ModeEnd { duration_reached, event, step_limit, step_too_short };

/// Why and where a mode ended.
struct ModeResult {
  ModeEnd end = ModeEnd::duration_reached;
  std::size_t margin = 0;  ///< which margin an event crossed
};

namespace detail {

/// A margin that starts at zero may be negative by rounding; one this small has not been crossed. Margins of sided
/// modes are sines of angles between computed unit vectors: a few epsilon.
inline constexpr double margin_slack = 16 * std::numeric_limits<double>::epsilon();

template <class State>
bool is_finite(const State& y) {
  return std::all_of(y.begin(), y.end(), [](double v) { return std::isfinite(v); });
}

/// Film exists, and every number is one. A step that ends elsewhere is rejected: Odeint itself would accept it.
template <class Mode, class State>
bool is_admissible(const Mode& mode, double t, const State& y) {
  if (!is_finite(y)) return false;
  const JournalState<double> journal = mode.journal(t, y);
  return one_minus_squared_norm(journal[0], journal[1]) > 0;
}

/// Steps from (t, y) to exactly t_goal with a stepper of its own; false if it can't.
template <class Mode, class Stepper, class State>
bool step_to(const Mode& mode, Stepper stepper, ModeSystem<Mode>& system, double t, double t_goal, State& y) {
  stepper.reset();
  double dt = t_goal - t;
  int trials = 0;
  while (t < t_goal) {
    dt = std::min(dt, t_goal - t);
    if (t + dt >= t_goal - 4 * std::numeric_limits<double>::epsilon() * t_goal) dt = t_goal - t;
    State trial = y;
    double t_trial = t;
    if (stepper.try_step(system, trial, t_trial, dt) && is_admissible(mode, t_trial, trial)) {
      y = trial;
      t = t_trial;
    } else if (++trials > 200) {
      return false;
    }
    if (t_goal - t <= std::numeric_limits<double>::epsilon() * t_goal) break;
  }
  return true;
}

}  // namespace detail

/// Integrates a mode from (t, y) until the duration is reached, a margin is crossed, or no step can be made.
/// Events are located by stepping to them with the same method, not on an interpolant: they are as accurate as the
/// solution. `observe(t_old, t_new, state_at)` sees every accepted step; state_at(t) is the mode's state inside it.
template <class Mode, class Stepper, class Observer>
ModeResult run_mode(const Mode& mode, Stepper& stepper, double& t, std::array<double, Mode::dimension>& y, double& dt,
                    const RunSettings& settings, RunOutcome& outcome, Observer&& observe) {
  using State = std::array<double, Mode::dimension>;
  ModeSystem<Mode> system(mode, outcome.rhs_evaluations);
  const double t_end = settings.duration;
  const double shortest = 8 * std::numeric_limits<double>::epsilon();

  const auto crossed = [&](double at, const State& state) -> std::optional<std::size_t> {
    const auto margins = mode.margins(at, state);
    for (std::size_t i = 0; i < margins.size(); ++i) {
      if (margins[i] < -detail::margin_slack) return i;
    }
    return std::nullopt;
  };

  while (t_end - t > shortest * t_end) {
    if (outcome.steps + outcome.rejected_steps >= settings.max_steps) return {ModeEnd::step_limit, 0};
    const double t_old = t;
    const State y_old = y;
    const double wanted = dt;
    const bool last = dt >= t_end - t;
    if (last) dt = t_end - t;
    const bool accepted = stepper.try_step(system, y, t, dt);
    if (!accepted || !detail::is_admissible(mode, t, y)) {
      if (accepted) {
        dt = 0.5 * (t - t_old);
        stepper.reset();
      }
      t = t_old;
      y = y_old;
      ++outcome.rejected_steps;
      if (!(dt > shortest * std::max(t, 1e-3 * t_end))) return {ModeEnd::step_too_short, 0};
      continue;
    }
    ++outcome.steps;
    if (last) dt = std::max(dt, wanted);

    if constexpr (Mode::margin_count > 0) {
      std::optional<std::size_t> event = crossed(t, y);
      double t_beyond = t;
      if constexpr (Stepper::has_dense_output) {  // a margin may be crossed and crossed back within a long step
        for (int i = 1; i < 8 && !event; ++i) {
          State inside;
          const double at = t_old + (t - t_old) * i / 8;
          stepper.state_at(system, at, inside);
          if (!detail::is_admissible(mode, at, inside)) continue;
          event = crossed(at, inside);
          if (event) t_beyond = at;
        }
      }
      if (event) {
        const std::size_t which = *event;
        const auto margin_at = [&](double at) {
          State state = y_old;
          if (at > t_old && !detail::step_to(mode, stepper, system, t_old, at, state)) return 0.0;
          return mode.margins(at, state)[which];
        };
        double t_event = t_old;
        if (margin_at(t_old) > 0 && margin_at(t_beyond) < 0) {
          std::uintmax_t iterations = 60;
          const boost::math::tools::eps_tolerance<double> tolerance(48);
          const auto bracket = boost::math::tools::toms748_solve(margin_at, t_old, t_beyond, tolerance, iterations);
          t_event = bracket.second;
        }
        y = y_old;
        t = t_old;
        if (t_event > t_old) {
          detail::step_to(mode, stepper, system, t_old, t_event, y);
          t = t_event;
          const auto state_at = [&](double at) {
            State state = y_old;
            if (at > t_old) detail::step_to(mode, stepper, system, t_old, at, state);
            return state;
          };
          observe(t_old, t, state_at);
        }
        dt = std::max(1e-3 * (t - t_old), 1e-9 * t_end);
        return {ModeEnd::event, which};
      }
    }
    const auto state_at = [&](double at) {
      State state;
      if (at >= t) return y;
      stepper.state_at(system, at, state);
      return state;
    };
    observe(t_old, t, state_at);
  }
  t = t_end;
  return {ModeEnd::duration_reached, 0};
}

}  // namespace lubjoint

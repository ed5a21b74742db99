/// Integration of one mode: steps, checks of the state, events, and what an observer sees.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "lubjoint/film/film_state.hpp"
#include "lubjoint/motion/outcome.hpp"
#include "lubjoint/multibody/free_journal.hpp"
#include "lubjoint/ode/exact_jacobian.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/ode/step_interpolant.hpp"

namespace lubjoint {

/// A mode as the integrators see it: its rate, counted, and its exact derivatives.
template <class Mode>
class ModeSystem final : public OdeSystem<double, Mode::dimension> {
 public:
  using Base = OdeSystem<double, Mode::dimension>;  ///< what integrators see
  using State = typename Base::State;               ///< of the mode

  /// @param evaluations  counted up by every rate
  ModeSystem(const Mode& mode, std::size_t& evaluations) : mode_(mode), evaluations_(evaluations) {}

  void rate(const State& y, State& dydt, const double& t) override {
    ++evaluations_;
    mode_.rate(y, dydt, t);
  }
  void jacobian(const State& y, typename Base::Jacobian& j, const double& t) override {
    exact_jacobian([this, t](const auto& x, auto& dxdt) { mode_.rate(x, dxdt, t); }, y, j);
  }
  void time_slope(const State&, State& slope, const double& t) override { mode_.time_slope(t, slope); }

 private:
  const Mode& mode_;
  std::size_t& evaluations_;
};

/// How the integration of a mode ended.
enum class ModeEnd {
  duration_reached,  ///< the run is over
  event,             ///< a margin was crossed
  step_limit,        ///< RunSettings::max_steps
  step_too_short,    ///< no step, however short, succeeds
  stalled            ///< many steps for next to no time
};

/// Why and where a mode ended.
struct ModeResult {
  ModeEnd end = ModeEnd::duration_reached;  ///< why
  std::size_t margin = 0;                   ///< which margin an event crossed
};

/// Integrates a mode from (t, y) until the duration is reached, a margin is crossed, or no step can be made.
/// Events are located by stepping to them with the same method, not on an interpolant: they are as accurate as the
/// solution. `observe(t_old, t_new, state_at, stepped_at)` sees every accepted step; state_at(t) is the mode's state
/// inside it on the interpolant, stepped_at(t) the same by the method's own steps.
template <class Mode>
class ModeRun {
 public:
  using State = std::array<double, Mode::dimension>;   ///< of the mode
  using Method = Integrator<double, Mode::dimension>;  ///< that makes the steps

  /// All four are kept by reference; steps and evaluations are counted in the outcome.
  ModeRun(const Mode& mode, Method& method, const RunSettings& settings, RunOutcome& outcome)
      : mode_(mode), method_(method), settings_(settings), outcome_(outcome), system_(mode, outcome.rhs_evaluations) {
    step_.smooth_rates = method.has_smooth_rates();
  }

  /// Integrates from (t, y); dt is the first step's length, then the next one's.
  template <class Observer>
  ModeResult run(double& t, State& y, double& dt, Observer&& observe) {
    const double t_end = settings_.duration;
    const double shortest = 8 * std::numeric_limits<double>::epsilon();
    if (t_end - t > shortest * t_end) system_.rate(y, step_.rate_new, t);
    int rejections = 0;
    double stall_mark = t;
    std::size_t stall_steps = 0;
    while (t_end - t > shortest * t_end) {
      if (outcome_.steps + outcome_.rejected_steps >= settings_.max_steps) return {ModeEnd::step_limit, 0};
      if (++stall_steps > stall_limit) {
        if (t - stall_mark < stall_share * t_end) return {ModeEnd::stalled, 0};
        stall_mark = t;
        stall_steps = 0;
      }
      step_.t_old = t;
      step_.y_old = y;
      step_.rate_old = step_.rate_new;
      const double wanted = dt;
      const bool last = dt >= t_end - t;
      if (last) dt = t_end - t;
      const bool stepped = method_.try_step(system_, y, t, dt);
      if (!stepped || !close_step(t, y)) {
        if (stepped) {
          dt = 0.5 * (t - step_.t_old);
          method_.reset();
        }
        t = step_.t_old;
        y = step_.y_old;
        step_.rate_new = step_.rate_old;
        ++outcome_.rejected_steps;
        if (++rejections > max_rejections) return {ModeEnd::step_too_short, 0};
        if (!(dt > shortest * std::max(t, shortest * t_end))) return {ModeEnd::step_too_short, 0};
        continue;
      }
      rejections = 0;
      ++outcome_.steps;
      if (last && t_end - t <= shortest * t_end) dt = std::max(dt, wanted);
      if constexpr (Mode::margin_count > 0) {
        if (const std::optional<Crossing> crossing = find_crossing()) {
          stop_at(*crossing, t, y);
          const auto stepped_at = [this](double at) { return stepped_to(at); };
          if (t > step_.t_old) observe(step_.t_old, t, stepped_at, stepped_at);
          dt = std::max(1e-3 * (t - step_.t_old), 1e-9 * t_end);
          return {ModeEnd::event, crossing->margin};
        }
      }
      observe(
          step_.t_old, t, [this](double at) { return inside(at); },
          [this](double at) { return at < step_.t_new ? stepped_to(at) : step_.y_new; });
    }
    t = t_end;
    return {ModeEnd::duration_reached, 0};
  }

 private:
  /// In a row. Halving leads from any first step to the shortest one in less; a method that rejects more often without
  /// a shorter step is stuck.
  static constexpr int max_rejections = 400;

  /// A margin that starts at zero may be negative by rounding; one this small has not been crossed. Margins of sided
  /// modes are sines of angles between computed unit vectors: a few epsilon.
  static constexpr double slack = 16 * std::numeric_limits<double>::epsilon();

  struct Crossing {
    std::size_t margin;
    double t_beyond;
  };

  /// Film exists, and every number is one.
  bool is_admissible(double t, const State& y) const {
    if (!std::all_of(y.begin(), y.end(), [](double v) { return std::isfinite(v); })) return false;
    const JournalState<double> journal = mode_.journal(t, y);
    const double left = one_minus_squared_norm(journal[0], journal[1]);
    if (left > 1e-14) return true;
    if (!(left > 0)) return false;
    try {
      mode_.force(t, y);  // a mode's own ε may round to 1 where that of x and y does not
    } catch (const std::domain_error&) {
      return false;
    }
    return true;
  }

  /// A step that ends without a film or a number is rejected: Odeint itself would accept it.
  bool close_step(double t, const State& y) {
    if (!is_admissible(t, y)) return false;
    step_.t_new = t;
    step_.y_new = y;
    try {
      system_.rate(y, step_.rate_new, t);
    } catch (const std::domain_error&) {
      return false;
    }
    method_.refine_end_rate(step_.rate_new);
    return true;
  }

  /// Steps from the last step's start to exactly t_goal; false if that can't be done.
  bool step_to(double t_goal, State& y) {
    y = step_.y_old;
    double t = step_.t_old;
    double dt = t_goal - t;
    const auto method = method_.fresh();
    int trials = 0;
    while (t < t_goal) {
      dt = std::min(dt, t_goal - t);
      if (t + dt >= t_goal - 4 * std::numeric_limits<double>::epsilon() * t_goal) dt = t_goal - t;
      State trial = y;
      double t_trial = t;
      if (method->try_step(system_, trial, t_trial, dt) && is_admissible(t_trial, trial)) {
        y = trial;
        t = t_trial;
      } else if (++trials > 200) {
        return false;
      }
      if (t_goal - t <= std::numeric_limits<double>::epsilon() * t_goal) break;
    }
    return true;
  }

  State stepped_to(double at) {
    State y = step_.y_old;
    if (at > step_.t_old) step_to(at, y);
    return y;
  }

  /// On the interpolant; where that leaves the clearance circle, by the method.
  State inside(double at) {
    if (at >= step_.t_new) return step_.y_new;
    State y;
    step_.state_at(at, Mode::dimension / 2, y);
    return is_admissible(at, y) ? y : stepped_to(at);
  }

  std::optional<std::size_t> crossed(double at, const State& y) const {
    const auto margins = mode_.margins(at, y);
    for (std::size_t i = 0; i < margins.size(); ++i) {
      if (margins[i] < -slack) return i;
    }
    return std::nullopt;
  }

  /// A margin may be crossed and crossed back within a long step.
  std::optional<Crossing> find_crossing() {
    const std::size_t pieces = method_.looks_inside();
    for (std::size_t i = 1; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(pieces);
      const double at = i == pieces ? step_.t_new : step_.t_old + (step_.t_new - step_.t_old) * share;
      if (const auto margin = crossed(at, inside(at))) return Crossing{*margin, at};
    }
    return std::nullopt;
  }

  void stop_at(const Crossing& crossing, double& t, State& y) {
    const auto margin_at = [&](double at) {
      State state = step_.y_old;
      if (at > step_.t_old && !step_to(at, state)) return 0.0;
      return mode_.margins(at, state)[crossing.margin];
    };
    t = step_.t_old;
    if (margin_at(t) > 0) {
      // The interpolant may cross a little before the method does: the bracket grows to the step's end.
      double beyond = crossing.t_beyond;
      if (!(margin_at(beyond) < 0)) beyond = step_.t_new;
      if (margin_at(beyond) < 0) {
        std::uintmax_t iterations = 60;
        const boost::math::tools::eps_tolerance<double> tolerance(48);
        t = boost::math::tools::toms748_solve(margin_at, step_.t_old, beyond, tolerance, iterations).second;
      } else {
        t = crossing.t_beyond;
      }
    }
    y = stepped_to(t);
  }

  const Mode& mode_;
  Method& method_;
  const RunSettings& settings_;
  RunOutcome& outcome_;
  ModeSystem<Mode> system_;
  StepInterpolant<State> step_;
};

}  // namespace lubjoint

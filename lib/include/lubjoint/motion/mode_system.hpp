/// A mode of a free journal as integrators and runs see it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "lubjoint/film/film_state.hpp"
#include "lubjoint/multibody/free_journal.hpp"
#include "lubjoint/ode/exact_jacobian.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/run/event_run.hpp"

namespace lubjoint {

/// A mode's rate, counted, its exact derivatives, and its margins (EventSystem). Another mode follows each event.
template <class Mode>
class ModeSystem final : public OdeSystem<double, Mode::dimension> {
 public:
  using Base = OdeSystem<double, Mode::dimension>;            ///< what integrators see
  using Real = double;                                        ///< scalar
  using State = typename Base::State;                         ///< of the mode
  static constexpr std::size_t dimension = Mode::dimension;   ///< number of states
  static constexpr bool has_events = Mode::margin_count > 0;  ///< can it end before the run does?
  static constexpr std::size_t looks_each = 1;                ///< a = 0 is not crossed and left in a piece of a step

  /// @param evaluations  counted up by every rate
  ModeSystem(const Mode& mode, std::size_t& evaluations)
      : mode_(mode), evaluations_(evaluations), unparted_(starts_unparted(mode)) {}

  void rate(const State& y, State& dydt, const double& t) override {
    ++evaluations_;
    mode_.rate(y, dydt, t);
  }
  void jacobian(const State& y, typename Base::Jacobian& j, const double& t) override {
    if constexpr (requires { mode_.jacobian(y, j); }) {
      mode_.jacobian(y, j);
    } else {
      exact_jacobian([this, t](const auto& x, auto& dxdt) { mode_.rate(x, dxdt, t); }, y, j);
    }
  }
  void time_slope(const State&, State& slope, const double& t) override { mode_.time_slope(t, slope); }

  /// ê·w, where the film kinks.
  void kinks(const State& y, const double& t, std::vector<double>& values) override {
    values.clear();
    if constexpr (requires { mode_.kinks(); }) {
      if (!mode_.kinks()) return;
      const JournalState<double> at = mode_.journal(t, y);
      values.push_back(at[0] * at[2] + at[1] * at[3]);
    }
  }

  static constexpr bool watches() { return has_events; }                    ///< whatever the run
  ModeSystem& equations() { return *this; }                                 ///< of this mode
  static constexpr std::size_t coordinates() { return Mode::coordinates; }  ///< ê or ρ, or none

  /// Film exists, and every number is finite.
  bool admissible(double t, const State& y) const {
    if (!std::all_of(y.begin(), y.end(), [](double v) { return std::isfinite(v); })) return false;
    const double left = film_left(t, y);
    if (left > 1e-14) return true;
    if (!(left > 0)) return false;
    try {
      mode_.force(t, y);  // a mode's own ε may round to 1 where that of x and y does not
    } catch (const std::domain_error&) {
      return false;
    }
    return true;
  }

  /// Of the mode. A margin that starts at zero may be negative by rounding: those of sided modes are sines of angles
  /// between computed unit vectors, known to a few epsilon. A side ends at a = 0 once it has parted from it; before
  /// that, where it is wrong beyond any error.
  void margins(double t, const State& y, std::vector<Margin<double>>& list) const {
    double least = rounding;
    if constexpr (may_be_unparted) {
      if (unparted_) least = std::max(least, mode_.wrong_side(y));
    }
    list.clear();
    for (const double value : mode_.margins(t, y)) list.push_back({value, least});
  }

  /// Nothing drifts; has a side parted?
  bool hold(double t, const State& y, bool exactly) {
    if constexpr (may_be_unparted) {
      if (unparted_ && !exactly) unparted_ = !(mode_.margins(t, y)[0] > rounding);
    }
    return false;
  }
  /// The caller knows which mode follows.
  static AfterEvent cross(std::size_t, double, const State&) { return AfterEvent::hand_over; }

 private:
  static constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  static constexpr bool may_be_unparted = requires(const Mode& mode) { mode.begins_unparted(); };

  static bool starts_unparted(const Mode& mode) {
    if constexpr (may_be_unparted) {
      return mode.begins_unparted();
    } else {
      return false;
    }
  }

  /// 1 − ε².
  double film_left(double t, const State& y) const {
    if constexpr (Mode::coordinates == 0) {  // ê is the state, and velocities are asked for inside the film alone
      return one_minus_squared_norm(y[0], y[1]);
    } else {
      const JournalState<double> journal = mode_.journal(t, y);
      return one_minus_squared_norm(journal[0], journal[1]);
    }
  }

  const Mode& mode_;
  std::size_t& evaluations_;
  bool unparted_;  ///< is it on a side that has not left a = 0 yet?
};

}  // namespace lubjoint

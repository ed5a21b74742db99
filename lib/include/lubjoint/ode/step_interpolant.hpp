/// The motion inside a step.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace lubjoint {

/// State and rate at both ends of a step of y = (q, q̇, rest): positions by the quintic that meets positions,
/// velocities and accelerations at both ends (error of order 6 in the step), velocities by its derivative (order 5),
/// the rest by the cubic (order 4). Any integrator's steps get the same interpolant, but for those whose rates at the
/// ends are no accelerations to rely on: there positions are cubic as well.
/// A derivative of positions has their rounding over the step, up to 15/8 · 2u |q|/h with u the unit roundoff. In a
/// step so short that the cubic of velocities and accelerations is as near, velocities are that cubic's.
template <class State>
struct StepInterpolant {
  using R = typename State::value_type;  ///< of the states
  R t_old{};                             ///< start of the step [s]
  R t_new{};                             ///< its end [s]
  State y_old{};                         ///< state at its start
  State y_new{};                         ///< state at its end
  State rate_old{};                      ///< ẏ at its start
  State rate_new{};                      ///< ẏ at its end
  bool smooth_rates = true;              ///< Integrator::has_smooth_rates
  bool shortened = false;                ///< it ends at an event, with a rate that is not the method's own
  struct Nothing {};
  /// inside(t, y) puts the motion that the method itself sees in place of the polynomials', from which it starts; none:
  /// they are all there is.
  [[no_unique_address]] std::conditional_t<std::is_same_v<State, std::vector<R>>, std::function<void(const R&, State&)>,
                                           Nothing>
      inside = {};

  /// The state at a time inside the step.
  /// @param n  number of coordinates
  void state_at(const R& t, std::size_t n, State& y) const {
    using std::abs;
    const R h = t_new - t_old;
    const R s = (t - t_old) / h;
    y = y_old;
    for (std::size_t i = 0; i < n; ++i) {
      // Increments over the constant-acceleration start; a cubic, quartic and quintic term close the end.
      const R v0 = h * y_old[n + i];
      R a0 = h * h * rate_old[n + i];
      R a1 = h * h * rate_new[n + i];
      if (!smooth_rates) {  // those of the cubic
        const R x1 = y_new[i] - y_old[i];
        const R v1 = h * y_new[n + i];
        a0 = 6 * x1 - 4 * v0 - 2 * v1;
        a1 = 2 * v0 + 4 * v1 - 6 * x1;
      }
      const R dx = (y_new[i] - y_old[i]) - v0 - a0 / 2;
      const R dv = h * y_new[n + i] - v0 - a0;
      const R da = a1 - a0;
      const R c3 = 10 * dx - 4 * dv + da / 2;
      const R c4 = -15 * dx + 7 * dv - da;
      const R c5 = 6 * dx - 3 * dv + da / 2;
      y[i] += s * (v0 + s * (a0 / 2 + s * (c3 + s * (c4 + s * c5))));
      const R of_positions = s * (a0 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5))) / h;
      const R of_velocities = cubic(y_new[n + i] - y_old[n + i], h * rate_old[n + i], h * rate_new[n + i], s);
      const R rounding = 2 * std::numeric_limits<R>::epsilon() * (abs(y_old[i]) + abs(y_new[i])) / h;
      y[n + i] += abs(of_positions - of_velocities) <= rounding ? of_velocities : of_positions;
    }
    for (std::size_t i = 2 * n; i < y.size(); ++i) {
      y[i] += cubic(y_new[i] - y_old[i], h * rate_old[i], h * rate_new[i], s);
    }
    if constexpr (!std::is_same_v<decltype(inside), Nothing>) {
      if (inside) inside(t, y);
    }
  }

 private:
  /// The cubic from 0 to dx with slopes v0 and v1, at s.
  static R cubic(const R& dx, const R& v0, const R& v1, const R& s) {
    const R over = dx - v0;
    const R dv = v1 - v0;
    return s * (v0 + s * ((3 * over - dv) + s * (dv - 2 * over)));
  }
};

}  // namespace lubjoint

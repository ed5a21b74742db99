/// The motion inside a step.
#pragma once

#include <array>
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
/// Long steps have their middle, too: then positions are of degree 8 (error of order 9), the rest of degree 5 (order
/// 6). A derivative of positions has their rounding over the step, up to 15/8 · 2u |q|/h with u the unit roundoff. In a
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
  bool has_middle = false;               ///< are these two of the step?
  State y_middle{};                      ///< state in its middle
  State rate_middle{};                   ///< ẏ there
  struct Nothing {};
  /// inside(t, y) puts the motion that the method itself sees in place of the polynomials', from which it starts; none:
  /// they are all there is.
  [[no_unique_address]] std::conditional_t<std::is_same_v<State, std::vector<R>>, std::function<void(const R&, State&)>,
                                           Nothing>
      inside = {};

  /// The state at a time inside the step.
  /// @param n  number of coordinates
  void state_at(const R& t, std::size_t n, State& y) const {
    if (has_middle) {
      by_middle(from_middle(t), n, y);
    } else {
      by_ends(R((t - t_old) / (t_new - t_old)), n, y);
    }
    if constexpr (!std::is_same_v<decltype(inside), Nothing>) {
      if (inside) inside(t, y);
    }
  }

  /// Number i of the state, one of an integral, inside a step that has its middle.
  R integral_at(const R& t, std::size_t i) const { return y_middle[i] + quintic(i, from_middle(t)); }

 private:
  /// The state at s of the step's length.
  void by_ends(const R& s, std::size_t n, State& y) const {
    using std::abs;
    const R h = t_new - t_old;
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
  }

  /// In half steps from the middle: −1 at the start, 1 at the end.
  R from_middle(const R& t) const { return ((t - t_old) - (t_new - t)) / (t_new - t_old); }

  /// The same by the middle, at x half steps from it.
  void by_middle(const R& x, std::size_t n, State& y) const {
    using std::abs;
    const R half = (t_new - t_old) / 2;
    y = y_middle;
    for (std::size_t i = 0; i < n; ++i) {
      const std::array<R, 2> place = octic(i, n, x);
      y[i] += place[0];
      const R of_positions = place[1] / half;
      const R of_velocities = y_middle[n + i] + quintic(n + i, x);
      const R rounding = 4 * std::numeric_limits<R>::epsilon() * (abs(y_old[i]) + abs(y_new[i])) / half;
      y[n + i] = abs(of_positions - of_velocities) <= rounding ? of_velocities : of_positions;
    }
    for (std::size_t i = 2 * n; i < y.size(); ++i) y[i] += quintic(i, x);
  }

  /// Of coordinate i, from its value in the middle, and its slope by x: the polynomial of degree 8 with values, slopes
  /// and second derivatives in three places. Its even and its odd part have three coefficients each that the middle
  /// leaves open.
  std::array<R, 2> octic(std::size_t i, std::size_t n, const R& x) const {
    const R half = (t_new - t_old) / 2;
    const R before = y_old[i] - y_middle[i];
    const R after = y_new[i] - y_middle[i];
    const R v0 = half * y_middle[n + i];
    const R v1 = half * y_old[n + i];
    const R v2 = half * y_new[n + i];
    const R a0 = half * half * rate_middle[n + i];
    const R a1 = half * half * rate_old[n + i];
    const R a2 = half * half * rate_new[n + i];
    const R e1 = a0 / 2;
    R a = (after + before) / 2 - e1;
    R b = (v2 - v1) / 2 - a0;
    R c = (a2 + a1) / 2 - a0;
    const R e4 = (24 * a - 9 * b + c) / 8;
    const R e3 = (b - 4 * a) / 2 - 2 * e4;
    const R e2 = a - e3 - e4;
    a = (after - before) / 2 - v0;
    b = (v2 + v1) / 2 - v0;
    c = (a2 - a1) / 2;
    const R o3 = (15 * a - 7 * b + c) / 8;
    const R o2 = (b - 3 * a) / 2 - 2 * o3;
    const R o1 = a - o2 - o3;
    const R xx = x * x;
    const R even = xx * (e1 + xx * (e2 + xx * (e3 + xx * e4)));
    const R odd = x * (v0 + xx * (o1 + xx * (o2 + xx * o3)));
    const R slope =
        v0 + xx * (3 * o1 + xx * (5 * o2 + xx * 7 * o3)) + x * (2 * e1 + xx * (4 * e2 + xx * (6 * e3 + xx * 8 * e4)));
    return {R(even + odd), slope};
  }

  /// Of number i, from its value in the middle: the polynomial of degree 5 with values and slopes in three places.
  R quintic(std::size_t i, const R& x) const {
    const R half = (t_new - t_old) / 2;
    const R before = y_old[i] - y_middle[i];
    const R after = y_new[i] - y_middle[i];
    const R slope0 = half * rate_middle[i];
    const R slope1 = half * rate_old[i];
    const R slope2 = half * rate_new[i];
    R a = (after + before) / 2;
    R b = (slope2 - slope1) / 2;
    const R e2 = (b - 2 * a) / 2;
    const R e1 = a - e2;
    a = (after - before) / 2 - slope0;
    b = (slope2 + slope1) / 2 - slope0;
    const R o2 = (b - 3 * a) / 2;
    const R o1 = a - o2;
    const R xx = x * x;
    return xx * (e1 + xx * e2) + x * (slope0 + xx * (o1 + xx * o2));
  }

  /// The cubic from 0 to dx with slopes v0 and v1, at s.
  static R cubic(const R& dx, const R& v0, const R& v1, const R& s) {
    const R over = dx - v0;
    const R dv = v1 - v0;
    return s * (v0 + s * ((3 * over - dv) + s * (dv - 2 * over)));
  }
};

}  // namespace lubjoint

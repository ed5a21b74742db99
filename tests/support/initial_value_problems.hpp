/// Initial value problems with exact solutions, and how fast an integrator approaches them.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "lubjoint/ode/radau_iia.hpp"

namespace lubjoint::test {

/// Autonomous and nonlinear: x' = x(1 − x), y' = −y²/2.
template <class R>
struct Logistic {
  static constexpr std::size_t dimension = 2;
  static constexpr double duration = 3;
  using State = std::array<R, 2>;

  static void rate(const State& x, State& dxdt, const R&) { dxdt = {x[0] * (1 - x[0]), -x[1] * x[1] / 2}; }
  template <class Matrix>
  static void jacobian(const State& x, Matrix& j, const R&) {
    j << 1 - 2 * x[0], R(0), R(0), -x[1];
  }
  static void time_slope(const State&, State& slope, const R&) { slope = {R(0), R(0)}; }
  static State exact(const R& t) {
    using std::exp;
    return {1 / (1 + 9 * exp(-t)), 2 / (1 + t)};
  }
};

/// Non-autonomous: x' = x cos t, y' = −2t y².
template <class R>
struct Driven {
  static constexpr std::size_t dimension = 2;
  static constexpr double duration = 3;
  using State = std::array<R, 2>;

  static void rate(const State& x, State& dxdt, const R& t) {
    using std::cos;
    dxdt = {x[0] * cos(t), -2 * t * x[1] * x[1]};
  }
  template <class Matrix>
  static void jacobian(const State& x, Matrix& j, const R& t) {
    using std::cos;
    j << cos(t), R(0), R(0), -4 * t * x[1];
  }
  static void time_slope(const State& x, State& slope, const R& t) {
    using std::sin;
    slope = {-x[0] * sin(t), -2 * x[1] * x[1]};
  }
  static State exact(const R& t) {
    using std::exp;
    using std::sin;
    return {exp(sin(t)), 1 / (1 + t * t)};
  }
};

/// Prothero and Robinson: x' = λ(x − sin t) + cos t, stiff for large −λ, with the solution sin t whatever λ.
template <class R>
struct ProtheroRobinson {
  static constexpr std::size_t dimension = 1;
  static constexpr double duration = 2;
  using State = std::array<R, 1>;

  R lambda = -1;

  void rate(const State& x, State& dxdt, const R& t) const {
    using std::cos;
    using std::sin;
    dxdt = {lambda * (x[0] - sin(t)) + cos(t)};
  }
  template <class Matrix>
  void jacobian(const State&, Matrix& j, const R&) const {
    j << lambda;
  }
  static State exact(const R& t) {
    using std::sin;
    return {sin(t)};
  }
};

template <class State>
double distance(const State& x, const State& y) {
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    largest = std::max(largest, std::abs(static_cast<double>(x[i] - y[i])));
  }
  return largest;
}

/// The pair (f, jacobian) that Odeint's implicit steppers take.
template <class R, class Problem>
auto odeint_system(const Problem& problem) {
  using State = typename Problem::State;
  return std::make_pair([problem](const State& x, State& dxdt, R t) { problem.rate(x, dxdt, t); },
                        [problem](const State& x, auto& j, R t) { problem.jacobian(x, j, t); });
}

/// Slope of log(error) over −log(work) of a series, by least squares.
inline double observed_order(const std::vector<double>& work, const std::vector<double>& error) {
  const auto n = static_cast<double>(work.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < work.size(); ++i) {
    const double log_work = std::log(work[i]), log_error = std::log(error[i]);
    x += log_work / n;
    y += log_error / n;
    xx += log_work * log_work / n;
    xy += log_work * log_error / n;
  }
  return -(xy - x * y) / (xx - x * x);
}

}  // namespace lubjoint::test

/// Extrapolation of the linearly implicit Euler method: an integrator of any order for stiff systems of a few states,
/// in any precision. It shares nothing with the library's integrators.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace lubjoint::mechanisms {

/// An integration that can't go on.
class ExtrapolationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// n ≤ N states.
template <class R, std::size_t N>
using ShortState = std::array<R, N>;

/// y' = f(t, y), one step from t to t + H at a time. With steps h = H/n_j, n_j = 2, 3, 4, …, and J ≈ ∂f/∂y at the
/// step's start
///   (I − hJ)(y_{i+1} − y_i) = h f(t_{i+1}, y_i),   T_{j,k} = T_{j,k−1} + (T_{j,k−1} − T_{j−1,k−1})/(n_j/n_{j−k+1} −
///   1).
/// The expansion of Euler's error in powers of h holds for any J, so a difference quotient is good enough. The step is
/// accepted at the row aimed at, or at the next, if its last two columns differ by less than the tolerance; row and
/// length of the next step are those of least work. Source: Deuflhard (1985); Hairer and Wanner, Solving Ordinary
/// Differential Equations II, section IV.9.
///
/// A system has: states(), their number; rate(t, y, dydt), which throws std::domain_error outside of its domain;
/// weights(y, w), the size that a relative error of each state refers to; and increments(y, d), what to vary each state
/// by in a difference quotient.
template <class R, std::size_t N>
class ImplicitExtrapolation {
 public:
  using State = ShortState<R, N>;

  /// @param tolerance  of a step, of each state's weight. Rounding leaves about 1e6 times the scalar's own.
  explicit ImplicitExtrapolation(const R& tolerance) : tolerance_(tolerance) {}

  /// One accepted step of length dt or less; dt becomes the length proposed for the next one.
  /// @throws ExtrapolationError if no step, however short, is accepted
  template <class System>
  void step(const System& system, R& t, State& y, R& dt) {
    if (!(dt > 0)) throw ExtrapolationError("extrapolation: the step length must be above 0");
    prepare(system, t, y);
    for (int trial = 0; trial < 400; ++trial) {
      const R tried = dt;
      if (!(t + dt > t)) break;
      if (attempt(system, t, y, dt)) {
        t += tried;
        ++steps_;
        return;
      }
    }
    throw ExtrapolationError("extrapolation: the step length has shrunk to nothing");
  }

  /// Steps that end at exactly t_goal.
  template <class System>
  void reach(const System& system, R t, State& y, const R& t_goal) {
    R dt = t_goal - t;
    while (t < t_goal) {
      const bool last = dt >= t_goal - t;
      if (last) dt = t_goal - t;
      const R expected = t_goal - t;
      const R before = t;
      step(system, t, y, dt);
      if (last && t - before == expected) break;
      if (t_goal - t <= std::numeric_limits<R>::epsilon() * t_goal) break;
    }
  }

  std::size_t steps() const { return steps_; }
  std::size_t evaluations() const { return evaluations_; }

 private:
  static constexpr std::size_t rows = 18;
  using Matrix = std::array<std::array<R, N>, N>;

  static R pieces(std::size_t j) { return R(static_cast<double>(j + 2)); }

  /// Work of all rows up to j, in evaluations.
  static double work(std::size_t j, std::size_t n) {
    double sum = static_cast<double>(n + 1);
    for (std::size_t i = 0; i <= j; ++i) sum += static_cast<double>(i + 2) + 1;
    return sum;
  }

  template <class System>
  void prepare(const System& system, const R& t, const State& y) {
    n_ = system.states();
    system.weights(y, weight_);
    State d;
    system.increments(y, d);
    State f{};
    State moved_f{};
    evaluate(system, t, y, f);
    for (std::size_t k = 0; k < n_; ++k) {
      State moved = y;
      moved[k] += d[k];
      const R by = moved[k] - y[k];
      evaluate(system, t, moved, moved_f);
      for (std::size_t i = 0; i < n_; ++i) jacobian_[i][k] = (moved_f[i] - f[i]) / by;
    }
  }

  template <class System>
  void evaluate(const System& system, const R& t, const State& y, State& dydt) {
    ++evaluations_;
    system.rate(t, y, dydt);
  }

  template <class System>
  bool attempt(const System& system, const R& t, State& y, R& dt) {
    using std::isfinite;
    using std::pow;
    const R h_all = dt;
    std::array<State, rows> table{};  // row j, columns 0 … j, kept in place
    std::array<double, rows> best_length{};
    std::size_t accepted = rows;
    double error = 0;
    for (std::size_t j = 0; j < rows; ++j) {
      State end = y;
      if (!euler(system, t, h_all, j, end)) {
        dt = h_all / 4;
        return false;
      }
      // table[i] holds T_{j−1, i}; it becomes T_{j, i}.
      State current = end;
      State last = end;
      for (std::size_t k = 1; k <= j; ++k) {
        const R ratio = pieces(j) / pieces(j - k) - 1;
        State next = current;
        for (std::size_t i = 0; i < n_; ++i) next[i] += (current[i] - table[k - 1][i]) / ratio;
        table[k - 1] = current;
        last = current;
        current = next;
      }
      table[j] = current;
      if (j < 2) continue;
      R largest = 0;
      for (std::size_t i = 0; i < n_; ++i) {
        using std::abs;
        largest = std::max<R>(largest, R(abs(current[i] - last[i]) / (tolerance_ * weight_[i])));
      }
      if (!isfinite(largest)) {
        dt = h_all / 4;
        return false;
      }
      const double before = error;
      error = std::min(1e300, static_cast<double>(largest));
      const double factor = std::pow(0.3 / std::max(error, 1e-30), 1.0 / static_cast<double>(j + 1));
      best_length[j] = 0.9 * std::clamp(factor, 1e-3, 10.0);
      if (error <= 1 && j >= target_) {
        accepted = j;
        y = current;
        break;
      }
      if (j > target_ || (j > 5 && error > before)) break;  // a shorter step is cheaper
    }
    // The row with the least work for its length; the one beyond, if that was the last one looked at.
    std::size_t best = 2;
    for (std::size_t j = 2; j < rows && best_length[j] > 0; ++j) {
      if (best_length[j] / work(j, n_) > best_length[best] / work(best, n_)) best = j;
    }
    double factor = best_length[best];
    if (accepted == rows) {
      target_ = best;
      dt = h_all * R(std::clamp(factor, 0.02, 0.5));
      return false;
    }
    target_ = best;
    if (best == accepted && best + 2 < rows) {
      target_ = best + 1;
      factor *= work(best + 1, n_) / work(best, n_);
    }
    dt = h_all * R(std::clamp(factor, 0.05, 8.0));
    return true;
  }

  /// n_j steps of the linearly implicit Euler method; false where they leave the domain.
  template <class System>
  bool euler(const System& system, const R& t, const R& h_all, std::size_t j, State& y) {
    using std::isfinite;
    const R h = h_all / pieces(j);
    Matrix m;
    std::array<std::size_t, N> order{};
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < n_; ++k) m[i][k] = (i == k ? R(1) : R(0)) - h * jacobian_[i][k];
    }
    if (!factorise(m, order)) return false;
    State f{};
    for (std::size_t i = 1; i <= j + 2; ++i) {
      try {
        evaluate(system, R(t + h * R(static_cast<double>(i))), y, f);
      } catch (const std::domain_error&) {
        return false;
      }
      State change{};
      for (std::size_t k = 0; k < n_; ++k) change[k] = h * f[order[k]];
      substitute(m, change);
      for (std::size_t k = 0; k < n_; ++k) {
        y[k] += change[k];
        if (!isfinite(y[k])) return false;
      }
    }
    return true;
  }

  /// LU with row exchange, in place.
  bool factorise(Matrix& m, std::array<std::size_t, N>& order) const {
    using std::abs;
    for (std::size_t i = 0; i < n_; ++i) order[i] = i;
    for (std::size_t k = 0; k < n_; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < n_; ++i) {
        if (abs(m[i][k]) > abs(m[pivot][k])) pivot = i;
      }
      if (m[pivot][k] == 0) return false;
      std::swap(m[pivot], m[k]);
      std::swap(order[pivot], order[k]);
      for (std::size_t i = k + 1; i < n_; ++i) {
        m[i][k] /= m[k][k];
        for (std::size_t l = k + 1; l < n_; ++l) m[i][l] -= m[i][k] * m[k][l];
      }
    }
    return true;
  }

  void substitute(const Matrix& m, State& x) const {
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < i; ++k) x[i] -= m[i][k] * x[k];
    }
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t k = i + 1; k < n_; ++k) x[i] -= m[i][k] * x[k];
      x[i] /= m[i][i];
    }
  }

  R tolerance_;
  std::size_t n_ = 0;
  std::size_t target_ = 4;  ///< row at which the step should be accepted
  State weight_{};
  Matrix jacobian_{};
  std::size_t steps_ = 0;
  std::size_t evaluations_ = 0;
};

}  // namespace lubjoint::mechanisms

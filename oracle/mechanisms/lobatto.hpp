/// The Lobatto IIIC method of eight stages: implicit, of order 14, L-stable and stiffly accurate, in any precision.
/// It shares nothing with the library's integrators.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace lubjoint::mechanisms {

/// An integration that can't go on.
class IntegrationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// n ≤ N states.
template <class R, std::size_t N>
using ShortState = std::array<R, N>;

/// Coefficients on [0, 1]. The nodes are 0, 1 and the zeros of P'_{s−1}(2c − 1); the first column of A is b₁, and the
/// rest is given by the simplifying conditions C(s−1), here with Legendre's polynomials for the powers:
///   Σ_j a_ij P_{k−1}(x_j) = ∫₀^{c_i} P_{k−1}(2τ − 1) dτ,   k = 1 … s−1,   x = 2c − 1.
/// The last row of A is b: the step ends at the last stage.
/// Source: Chipman (1971); Hairer and Wanner, Solving Ordinary Differential Equations II, section IV.5.
template <class R, std::size_t S>
struct LobattoTableau {
  std::array<R, S> c;
  std::array<std::array<R, S>, S> a;

  LobattoTableau() {
    using std::abs;
    using std::cos;
    constexpr std::size_t last = S - 1;
    const R degree(static_cast<double>(last));
    std::array<R, S> x;
    for (std::size_t i = 0; i < S; ++i) {
      x[i] = -cos(R(boost::math::constants::pi<R>() * static_cast<double>(i) / degree));
      if (i == 0 || i == last) continue;
      for (int k = 0; k < 20; ++k) {
        // Newton on P'_{s−1}; Legendre's equation gives P''.
        const auto p = legendre(x[i]);
        const R q = (1 - x[i]) * (1 + x[i]);
        const R slope = degree * (p[last - 1] - x[i] * p[last]) / q;
        const R curvature = (2 * x[i] * slope - degree * (degree + 1) * p[last]) / q;
        x[i] -= slope / curvature;
      }
    }
    x[0] = R(-1);
    x[last] = R(1);
    const R b1 = 1 / (degree * (degree + 1));
    for (std::size_t i = 0; i < S; ++i) c[i] = (1 + x[i]) / 2;
    std::array<std::array<R, S>, S> values;
    for (std::size_t j = 0; j < S; ++j) values[j] = legendre(x[j]);
    for (std::size_t i = 0; i < S; ++i) {
      // Unknown: a_i2 … a_is.
      std::array<std::array<R, S>, S> m;
      for (std::size_t k = 1; k < S; ++k) {
        for (std::size_t j = 1; j < S; ++j) m[k - 1][j - 1] = values[j][k - 1];
        const R integral =
            k == 1 ? c[i] : R((values[i][k] - values[i][k - 2]) / (2 * R(static_cast<double>(2 * k - 1))));
        m[k - 1][last] = integral - b1 * values[0][k - 1];
      }
      for (std::size_t k = 0; k < last; ++k) {
        std::size_t pivot = k;
        for (std::size_t r = k + 1; r < last; ++r) {
          if (abs(m[r][k]) > abs(m[pivot][k])) pivot = r;
        }
        std::swap(m[pivot], m[k]);
        for (std::size_t r = 0; r < last; ++r) {
          if (r == k) continue;
          const R factor = m[r][k] / m[k][k];
          for (std::size_t l = k; l < S; ++l) m[r][l] -= factor * m[k][l];
        }
      }
      a[i][0] = b1;
      for (std::size_t k = 0; k < last; ++k) a[i][k + 1] = m[k][last] / m[k][k];
    }
  }

 private:
  /// P_0 … P_{s−1}.
  static std::array<R, S> legendre(const R& x) {
    std::array<R, S> p;
    p[0] = R(1);
    p[1] = x;
    for (std::size_t k = 2; k < S; ++k) {
      const double n = static_cast<double>(k);
      p[k] = ((2 * n - 1) * x * p[k - 1] - (n - 1) * p[k - 2]) / n;
    }
    return p;
  }
};

/// y' = f(t, y), one step at a time. Y_i = y + H Σ a_ij f(t + c_j H, Y_j) by simplified Newton iterations; the step
/// ends at Y_s. Its first stage stands for its start, and misses it by a term of order s: that jump is the error's
/// estimate, a cautious one, as the step's own error is of order 2s − 1.
///
/// A system has: states(), their number; rate(t, y, dydt), which throws std::domain_error outside of its domain;
/// weights(y, w), the size that a relative error of each state refers to; and increments(y, d), what to vary each state
/// by in a difference quotient.
template <class R, std::size_t N>
class Lobatto {
 public:
  static constexpr std::size_t stages = 8;
  using State = ShortState<R, N>;

  /// @param tolerance  of the jump, in each state's weight
  explicit Lobatto(const R& tolerance) : tolerance_(tolerance) {}

  /// One accepted step of length dt or less; dt becomes the length proposed for the next one.
  /// @return  the length of the step
  /// @throws IntegrationError if no step, however short, is accepted
  template <class System>
  R step(const System& system, const R& t, State& y, R& dt) {
    if (!(dt > 0)) throw IntegrationError("the step length must be above 0");
    prepare(system, t, y);
    for (int trial = 0; trial < 300; ++trial) {
      const R tried = dt;
      if (!(t + dt > t)) break;
      if (attempt(system, t, y, dt)) {
        ++steps_;
        return tried;
      }
    }
    throw IntegrationError("the step length has shrunk to nothing");
  }

  /// Steps from t that end at exactly t_goal.
  template <class System>
  void reach(const System& system, R t, State& y, const R& t_goal) {
    R dt = t_goal - t;
    while (t < t_goal) {
      const R left = t_goal - t;
      if (dt > left) dt = left;
      const R made = step(system, t, y, dt);
      if (made == left) return;
      t += made;
    }
  }

  std::size_t steps() const { return steps_; }

 private:
  static constexpr std::size_t most = stages * N;

  template <class System>
  void prepare(const System& system, const R& t, const State& y) {
    n_ = system.states();
    system.weights(y, weight_);
    State d;
    system.increments(y, d);
    State f{};
    State moved_f{};
    system.rate(t, y, f);
    for (std::size_t k = 0; k < n_; ++k) {
      State moved = y;
      moved[k] += d[k];
      const R by = moved[k] - y[k];
      system.rate(t, moved, moved_f);
      for (std::size_t i = 0; i < n_; ++i) jacobian_[i][k] = (moved_f[i] - f[i]) / by;
    }
  }

  template <class System>
  bool attempt(const System& system, const R& t, State& y, R& dt) {
    using std::abs;
    using std::isfinite;
    static const LobattoTableau<R, stages> tableau;
    const R h = dt;
    if (!factorise(tableau, h)) {
      dt = h / 4;
      return false;
    }
    std::array<State, stages> z{};
    std::array<State, stages> f{};
    double before = 0;
    bool converged = false;
    const double enough =
        std::max(1e-3 * static_cast<double>(tolerance_), 100 * static_cast<double>(std::numeric_limits<R>::epsilon()));
    for (int iteration = 0; iteration < 60 && !converged; ++iteration) {
      try {
        for (std::size_t j = 0; j < stages; ++j) {
          State at = y;
          for (std::size_t i = 0; i < n_; ++i) at[i] += z[j][i];
          system.rate(R(t + tableau.c[j] * h), at, f[j]);
        }
      } catch (const std::domain_error&) {
        break;
      }
      for (std::size_t j = 0; j < stages; ++j) {
        for (std::size_t i = 0; i < n_; ++i) {
          R sum = 0;
          for (std::size_t k = 0; k < stages; ++k) sum += tableau.a[j][k] * f[k][i];
          right_[j * n_ + i] = h * sum - z[j][i];
        }
      }
      substitute();
      double change = 0;
      for (std::size_t j = 0; j < stages; ++j) {
        for (std::size_t i = 0; i < n_; ++i) {
          const R& by = solution_[j * n_ + i];
          z[j][i] += by;
          change = std::max(change, std::min(1e300, static_cast<double>(R(abs(by) / weight_[i]))));
          if (!isfinite(by)) change = 1e300;
        }
      }
      if (change >= 1e300) break;
      converged = change < enough;
      if (iteration > 3 && change > 0.7 * before && !converged) break;
      before = change;
    }
    if (!converged) {
      dt = h / 3;
      return false;
    }
    double error = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      error = std::max(error, static_cast<double>(R(abs(z[0][i]) / (tolerance_ * weight_[i]))));
    }
    const double factor = std::clamp(0.85 * std::pow(std::max(error, 1e-30), -1.0 / stages), 0.1, 4.0);
    if (factor < 1 || factor > 1.2) dt = h * R(factor);
    if (error > 1) return false;
    for (std::size_t i = 0; i < n_; ++i) y[i] += z[stages - 1][i];
    return true;
  }

  /// LU of I − H A ⊗ J.
  bool factorise(const LobattoTableau<R, stages>& tableau, const R& h) {
    using std::abs;
    const std::size_t size = stages * n_;
    for (std::size_t j = 0; j < stages; ++j) {
      for (std::size_t k = 0; k < stages; ++k) {
        for (std::size_t i = 0; i < n_; ++i) {
          for (std::size_t l = 0; l < n_; ++l) {
            m_[j * n_ + i][k * n_ + l] = (j == k && i == l ? R(1) : R(0)) - h * tableau.a[j][k] * jacobian_[i][l];
          }
        }
      }
    }
    for (std::size_t i = 0; i < size; ++i) order_[i] = i;
    for (std::size_t k = 0; k < size; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < size; ++i) {
        if (abs(m_[i][k]) > abs(m_[pivot][k])) pivot = i;
      }
      if (m_[pivot][k] == 0) return false;
      std::swap(m_[pivot], m_[k]);
      std::swap(order_[pivot], order_[k]);
      const R inverse = 1 / m_[k][k];
      for (std::size_t i = k + 1; i < size; ++i) {
        if (m_[i][k] == 0) continue;
        m_[i][k] *= inverse;
        for (std::size_t l = k + 1; l < size; ++l) m_[i][l] -= m_[i][k] * m_[k][l];
      }
    }
    return true;
  }

  void substitute() {
    const std::size_t size = stages * n_;
    for (std::size_t i = 0; i < size; ++i) {
      R sum = right_[order_[i]];
      for (std::size_t k = 0; k < i; ++k) sum -= m_[i][k] * solution_[k];
      solution_[i] = sum;
    }
    for (std::size_t i = size; i-- > 0;) {
      for (std::size_t k = i + 1; k < size; ++k) solution_[i] -= m_[i][k] * solution_[k];
      solution_[i] /= m_[i][i];
    }
  }

  R tolerance_;
  std::size_t n_ = 0;
  State weight_{};
  std::array<std::array<R, N>, N> jacobian_{};
  std::array<std::array<R, most>, most> m_{};
  std::array<std::size_t, most> order_{};
  std::array<R, most> right_{};
  std::array<R, most> solution_{};
  std::size_t steps_ = 0;
};

}  // namespace lubjoint::mechanisms

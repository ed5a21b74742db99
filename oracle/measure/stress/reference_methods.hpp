/// Two integrators of different families for reference motions, in any precision: collocation at Radau's points
/// (implicit Runge–Kutta, order 13) and extrapolation of the linearly implicit Euler method. Written for this purpose:
/// they share no code with the integrators that are judged.
///
/// A system has `static constexpr int size`, a type `State` (Eigen column of that size), `rate(t, y)` and `scale(y)` or
/// `scale(t, y)`: what each component's error is measured against. A rate outside its domain throws std::domain_error.
#pragma once

#include <Eigen/Dense>
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

namespace lubjoint::reports::stress_reference {

using Quad = boost::multiprecision::float128;

/// A trial step: the new state, and its estimated error over scale and tolerance. None if there is no solution.
template <class State, class R>
struct TrialStep {
  State state;
  R error;
};

/// Largest component over its scale.
template <class State>
auto weighted_size(const State& v, const State& scale) {
  using std::abs;
  using R = typename State::Scalar;
  R largest(0);
  for (int i = 0; i < v.size(); ++i) {
    const R each = abs(v(i)) / scale(i);
    if (!(each < std::numeric_limits<R>::infinity())) return std::numeric_limits<R>::infinity();  // NaN, too
    largest = std::max(largest, each);
  }
  return largest;
}

/// A system's scales at (t, y).
template <class System>
auto scale_of(const System& system, const typename System::Scalar& t, const typename System::State& y) {
  if constexpr (requires { system.scale(t, y); }) {
    return system.scale(t, y);
  } else {
    return system.scale(y);
  }
}

/// ∂f/∂y by central differences: half the digits at least of a Jacobian that only drives iterations.
template <class System>
auto jacobian_of(const System& system, const typename System::Scalar& t, const typename System::State& y) {
  using R = typename System::Scalar;
  using std::pow;
  constexpr int n = System::size;
  static const R share = pow(std::numeric_limits<R>::epsilon(), R(1) / 3);  // least sum of truncation and rounding
  Eigen::Matrix<R, n, n> j;
  const auto scale = scale_of(system, t, y);
  for (int k = 0; k < n; ++k) {
    typename System::State up = y;
    typename System::State down = y;
    up(k) += share * scale(k);
    down(k) -= share * scale(k);
    j.col(k) = (system.rate(t, up) - system.rate(t, down)) / (up(k) - down(k));
  }
  return j;
}

/// Radau's right points on (0, 1] and the matrix of the collocation method on them.
template <class R>
struct RadauPoints {
  Eigen::Matrix<R, Eigen::Dynamic, 1> nodes;
  Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic> matrix;  ///< A_ij = ∫₀^{c_i} l_j

  /// Zeros of P_s(x) − P_{s−1}(x), bracketed on a fine grid; the matrix from the monomials, all in quadruple precision:
  /// of its digits, Vandermonde's condition takes some six.
  explicit RadauPoints(int stages) : nodes(stages), matrix(stages, stages) {
    const auto f = [stages](const Quad& x) {
      Quad before = 1;
      Quad now = x;
      for (int k = 1; k < stages; ++k) {
        const Quad next = ((2 * k + 1) * x * now - k * before) / (k + 1);
        before = now;
        now = next;
      }
      return Quad(now - before);
    };
    std::vector<Quad> found;
    constexpr int grid = 1000;
    for (int i = 0; i < grid; ++i) {
      Quad low = Quad(2 * i) / grid - 1;
      Quad high = Quad(2 * i + 2) / grid - 1;
      if (i == grid - 1 || f(low) * f(high) > 0) continue;  // the last zero is 1 itself
      for (int k = 0; k < 120; ++k) {
        const Quad middle = (low + high) / 2;
        (f(low) * f(middle) <= 0 ? high : low) = middle;
      }
      found.push_back((1 + low) / 2);
    }
    found.emplace_back(1);
    if (static_cast<int>(found.size()) != stages) throw std::logic_error("Radau's points were not all found");
    using Matrix = Eigen::Matrix<Quad, Eigen::Dynamic, Eigen::Dynamic>;
    Matrix powers(stages, stages);
    Matrix integrals(stages, stages);
    for (int i = 0; i < stages; ++i) {
      Quad power = 1;
      for (int k = 0; k < stages; ++k) {
        powers(i, k) = power;
        power *= found[static_cast<std::size_t>(i)];
        integrals(i, k) = power / (k + 1);
      }
    }
    const Matrix a = powers.transpose().partialPivLu().solve(integrals.transpose()).transpose();
    for (int i = 0; i < stages; ++i) {
      nodes(i) = R(found[static_cast<std::size_t>(i)]);
      for (int j = 0; j < stages; ++j) matrix(i, j) = R(a(i, j));
    }
  }
};

/// Collocation at 7 Radau points, order 13; its error is the distance to that at 5 points, order 9.
template <class System>
class Collocation {
 public:
  using R = typename System::Scalar;
  using State = typename System::State;
  static constexpr int order = 9;
  static constexpr const char* name = "collocation at Radau's points";

  explicit Collocation(const R& tolerance) : tolerance_(tolerance) {}

  std::optional<TrialStep<State, R>> trial(const System& system, const R& t, const State& y, const R& h) const {
    static const RadauPoints<R> fine(7);
    static const RadauPoints<R> coarse(5);
    static const Stages interpolation = interpolate(fine, coarse);
    const auto scale = scale_of(system, t, y);
    const auto j = jacobian_of(system, t, y);
    Stages z = Stages::Zero(n, 7);
    if (!solve(system, fine, t, y, h, j, scale, z)) return std::nullopt;
    Stages z5 = z * interpolation;
    if (!solve(system, coarse, t, y, h, j, scale, z5)) return std::nullopt;
    const State error = z.col(6) - z5.col(4);
    return TrialStep<State, R>{y + z.col(6), weighted_size(error, scale) / tolerance_};
  }

 private:
  static constexpr int n = System::size;
  using Stages = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;

  /// Values at the coarse points of the polynomial through 0 and the fine points.
  static Stages interpolate(const RadauPoints<R>& fine, const RadauPoints<R>& coarse) {
    Stages weights(fine.nodes.size(), coarse.nodes.size());
    for (int j = 0; j < coarse.nodes.size(); ++j) {
      const R x = coarse.nodes(j);
      for (int i = 0; i < fine.nodes.size(); ++i) {
        R w = x / fine.nodes(i);
        for (int k = 0; k < fine.nodes.size(); ++k) {
          if (k != i) w *= (x - fine.nodes(k)) / (fine.nodes(i) - fine.nodes(k));
        }
        weights(i, j) = w;
      }
    }
    return weights;
  }

  /// Newton's method with the Jacobian of the step's start, until rounding ends it.
  bool solve(const System& system, const RadauPoints<R>& points, const R& t, const State& y, const R& h,
             const Eigen::Matrix<R, n, n>& j, const State& scale, Stages& z) const {
    const int s = static_cast<int>(points.nodes.size());
    Stages m = Stages::Identity(n * s, n * s);
    for (int a = 0; a < s; ++a) {
      for (int b = 0; b < s; ++b) m.block(n * a, n * b, n, n) -= R(h * points.matrix(a, b)) * j;
    }
    const Eigen::PartialPivLU<Stages> lu(m);
    Stages rates(n, s);
    Eigen::Matrix<R, Eigen::Dynamic, 1> residual(n * s);
    R last(0);
    for (int iteration = 0; iteration < 60; ++iteration) {
      for (int a = 0; a < s; ++a) rates.col(a) = system.rate(R(t + h * points.nodes(a)), State(y + z.col(a)));
      for (int a = 0; a < s; ++a) {
        State each = -z.col(a);
        for (int b = 0; b < s; ++b) each += R(h * points.matrix(a, b)) * rates.col(b);
        residual.segment(n * a, n) = each;
      }
      const Eigen::Matrix<R, Eigen::Dynamic, 1> change = lu.solve(residual);
      R size(0);
      for (int a = 0; a < s; ++a) {
        z.col(a) += change.segment(n * a, n);
        const R each = weighted_size(State(change.segment(n * a, n)), scale);
        if (!(each <= size)) size = each;
      }
      if (!(size < 1e10)) return false;
      if (size <= tolerance_ / 100) return true;
      if (iteration > 2 && size > last / 2) return size <= tolerance_;  // rounding, or no convergence
      last = size;
    }
    return false;
  }

  R tolerance_;
};

/// Linearly implicit Euler steps, 1, 2, …, K of them, extrapolated to none: order K, for stiff systems as for others.
template <class System>
class Extrapolation {
 public:
  using R = typename System::Scalar;
  using State = typename System::State;
  /// The weights of more columns cost more digits than they gain.
  static constexpr int order = std::numeric_limits<R>::digits > 100 ? 14 : 9;
  static constexpr const char* name = "extrapolated linearly implicit Euler steps";

  explicit Extrapolation(const R& tolerance) : tolerance_(tolerance) {}

  std::optional<TrialStep<State, R>> trial(const System& system, const R& t, const State& y, const R& h) const {
    const auto scale = scale_of(system, t, y);
    using Matrix = Eigen::Matrix<R, n, n>;
    // In units of the scales: pivots chosen among places of 1 and rates of 1e9 cost the digits that are extrapolated.
    const Matrix j = scale.cwiseInverse().asDiagonal() * jacobian_of(system, t, y) * scale.asDiagonal();
    // Changes since the start of the step: small numbers, whose rounding is small.
    std::vector<State> table;
    R error(0);
    for (int k = 1; k <= order; ++k) {
      const R step = h / k;
      const Eigen::PartialPivLU<Matrix> lu(Matrix(Matrix::Identity() - step * j));
      State moved = State::Zero();
      for (int i = 0; i < k; ++i) {
        const State rate = system.rate(R(t + (i + 1) * step), State(y + moved));
        moved += scale.cwiseProduct(lu.solve(State(step * rate.cwiseQuotient(scale))));
      }
      State now = moved;
      for (int m = 1; m < k; ++m) {
        const State before = table[static_cast<std::size_t>(m - 1)];
        table[static_cast<std::size_t>(m - 1)] = now;
        now += (now - before) / (R(k) / (k - m) - 1);
      }
      if (k == order) error = weighted_size(State(now - table.back()), scale);
      table.push_back(now);
    }
    if (!(error < 1e10)) return std::nullopt;
    return TrialStep<State, R>{State(y + table.back()), error / tolerance_};
  }

 private:
  static constexpr int n = System::size;
  R tolerance_;
};

/// Where a motion of one piece got to.
struct PieceEnd {
  int margin = -1;  ///< that was crossed; −1: the goal was reached
};

/// Steps of one of the methods from (t, y) to a goal, or to where one of the system's margins turns negative; there
/// the time is found by trial steps from the last state, to the last digits.
/// `system.margins(t, y)` are positive inside of a piece; one that starts at zero or below (a piece begins where one
/// is crossed) counts from when it has been positive.
template <class System, template <class> class Method>
class Piece {
 public:
  using R = typename System::Scalar;
  using State = typename System::State;

  Piece(const System& system, const R& tolerance, const R& first_step)
      : system_(system), method_(tolerance), h_(first_step) {}

  PieceEnd to(R& t, State& y, const R& goal) {
    using std::pow;
    while (t < goal) {
      if (++steps_ > most_steps) throw std::runtime_error("the reference needs more steps than it is given");
      const R wanted = h_;
      const bool last = h_ * R(1.0001) >= goal - t;
      const R h = last ? R(goal - t) : h_;
      if (!(t + h > t)) throw std::runtime_error("the reference's step has shrunk to nothing");
      const auto trial = try_step(t, y, h);
      if (!trial || trial->error > 1) {
        const R factor = trial ? R(R(0.9) * pow(trial->error, R(-1) / R(Method<System>::order))) : R(0.25);
        h_ = h * std::max(R(0.1), std::min(R(0.7), factor));
        continue;
      }
      const R factor = trial->error > 0 ? R(R(0.9) * pow(trial->error, R(-1) / R(Method<System>::order))) : R(4);
      h_ = h * std::max(R(0.3), std::min(R(4), factor));
      if (last) h_ = std::max(h_, wanted);
      const auto before = system_.margins(t, y);
      const auto after = system_.margins(R(t + h), trial->state);
      int first = -1;
      R earliest = h;
      for (std::size_t i = 0; i < after.size(); ++i) {
        if (before[i] > 0) armed_ |= 1u << i;
        if ((armed_ >> i & 1u) == 0 || !(after[i] < -system_.noise())) {
          if (after[i] > 0) armed_ |= 1u << i;
          continue;
        }
        const R at = crossing(i, t, y, h, before[i], after[i]);
        if (first < 0 || at < earliest) {
          first = static_cast<int>(i);
          earliest = at;
        }
      }
      if (first >= 0) {
        const auto end = try_step(t, y, earliest);
        if (!end) throw std::runtime_error("the reference has no state at an event");
        t += earliest;
        y = end->state;
        return {first};
      }
      t = last ? goal : R(t + h);
      y = trial->state;
    }
    return {};
  }

  const R& step() const { return h_; }

 private:
  /// More than any motion takes whose digits are there: what needs more is at the bottom of its rounding.
  static constexpr std::size_t most_steps = 20'000;

  std::optional<TrialStep<State, R>> try_step(const R& t, const State& y, const R& h) const {
    try {
      return method_.trial(system_, t, y, h);
    } catch (const std::domain_error&) {  // a stage beyond the wall
      return std::nullopt;
    }
  }

  /// Length of the step at whose end the margin is zero or just below: Illinois' false position.
  R crossing(std::size_t i, const R& t, const State& y, const R& h, R f_low, R f_high) const {
    R low(0);
    R high = h;
    if (!(f_low > 0)) f_low = -f_high;  // it was positive, and begins within its noise: halve
    for (int k = 0; k < 100 && high - low > 4 * std::numeric_limits<R>::epsilon() * (t + h); ++k) {
      const R middle = low + (high - low) * f_low / (f_low - f_high);
      if (!(middle > low && middle < high)) break;
      const auto trial = try_step(t, y, middle);
      if (!trial) throw std::runtime_error("the reference has no state at an event");
      const R f = system_.margins(R(t + middle), trial->state)[i];
      if (f > 0) {
        low = middle;
        f_low = f;
        f_high /= 2;
      } else {
        high = middle;
        f_high = f;
        f_low /= 2;
        if (f == 0) break;
      }
    }
    return high;
  }

  const System& system_;
  Method<System> method_;
  R h_;
  std::size_t steps_ = 0;
  unsigned armed_ = 0;
};

}  // namespace lubjoint::reports::stress_reference

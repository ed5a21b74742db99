/// Andrews' squeezing mechanism in the angles of its seven bodies: six closing conditions in place of twenty pins'
/// rows.
#pragma once

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace lubjoint::mechanisms {

/// Data: Schiehlen (ed.), Multibody Systems Handbook (1990); Hairer and Wanner, Solving Ordinary Differential Equations
/// II, section VII.7. Every mass centre is a fixed point plus turned body-fixed vectors, Σ A(α_j) v_j, and so is every
/// closing condition; with A(α)v⊥ the derivative of A(α)v, the equations of motion follow term by term.
template <class R>
class Andrews {
 public:
  static constexpr std::size_t bodies = 7;  ///< K1 to K7
  /// Angles of the bodies, then their rates.
  using State = std::array<R, 2 * bodies>;

  Andrews() {
    const auto mm = [](int hundredths) { return R(hundredths) / 100000; };  // hundredths of a millimetre, in m
    masses_ = {R(4325) / 100000, R(365) / 100000, R(2373) / 100000, R(706) / 100000,
               R(7050) / 100000, R(706) / 100000, R(5498) / 100000};
    const R unit = R(1) / 10000000000LL;
    inertias_ = {21940 * unit, 4410 * unit, 52550 * unit, 5667 * unit, 116900 * unit, 5667 * unit, 191200 * unit};
    const Vector a{mm(-6934), mm(-227)};
    const Vector b{mm(-3635), mm(3273)};
    const Term to_f{0, {mm(700), R(0)}};
    const Term to_g{4, {mm(4000), R(0)}};
    const Term to_h{6, {R(0), mm(-4000)}};
    centres_[0] = {{0, {mm(92), R(0)}}};
    centres_[1] = {to_f, {1, {mm(-1150), R(0)}}};
    centres_[2] = {{2, {mm(1043), mm(-1874)}}};
    centres_[3] = {to_g, {3, {R(0), mm(1421 - 2000)}}};
    centres_[4] = {{4, {mm(2308), mm(916)}}};
    centres_[5] = {to_h, {5, {mm(2000 - 1421), R(0)}}};
    centres_[6] = {{6, {mm(-449), mm(-1228)}}};
    // E by way of the drive, less E by way of B, of A and G, of A and H.
    const std::vector<Term> to_e{to_f, {1, {mm(-2800), R(0)}}};
    closings_[0] = close(to_e, b, {{2, {R(0), mm(-3500)}}});
    closings_[1] = close(to_e, a, {to_g, {3, {R(0), mm(-2000)}}});
    closings_[2] = close(to_e, a, {to_h, {5, {mm(2000), R(0)}}});
    to_d_ = {2, {mm(2000), mm(-1800)}};
    from_c_to_b_ = {b.x - mm(1400), b.y - mm(7200)};
  }

  R moment = R(33) / 1000;           ///< of the drive on K1 [N m]
  R stiffness = R(4530);             ///< of the spring [N/m]
  R free_length = R(7785) / 100000;  ///< of the spring [m]

  /// The start from rest, from β, Θ, γ, φ, δ, Ω and ε.
  static State start(const std::array<R, bodies>& q) {
    return {q[0], q[0] + q[1], q[2], q[3] + q[4], q[4], q[5] + q[6], q[6], 0, 0, 0, 0, 0, 0, 0};
  }
  /// β, Θ, γ, φ, δ, Ω and ε of a state.
  static std::array<R, bodies> relative(const State& y) {
    return {y[0], y[1] - y[0], y[2], y[3] - y[4], y[4], y[5] - y[6], y[6]};
  }

  /// ẏ.
  void operator()(const State& y, State& rate, const R&) const {
    using Matrix = Eigen::Matrix<R, 13, 13>;
    using Column = Eigen::Matrix<R, 13, 1>;
    Matrix matrix = Matrix::Zero();
    Column right = Column::Zero();
    for (std::size_t k = 0; k < bodies; ++k) {
      matrix(at(k), at(k)) += inertias_[k];
      // m r̈ = m Σ (α̈_j v_j⊥ − α̇_j² v_j), seen along every v_i⊥.
      for (const Term& i : centres_[k]) {
        const Vector across = turned(i, y).across();
        for (const Term& j : centres_[k]) {
          const Vector v = turned(j, y);
          matrix(at(i.body), at(j.body)) += masses_[k] * across.dot(v.across());
          right(at(i.body)) += masses_[k] * across.dot(v) * y[bodies + j.body] * y[bodies + j.body];
        }
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      for (const Term& j : closings_[c].terms) {
        const Vector v = turned(j, y);
        const Vector across = v.across();
        const R squared = y[bodies + j.body] * y[bodies + j.body];
        for (std::size_t k = 0; k < 2; ++k) {
          const Eigen::Index row = at(bodies + 2 * c + k);
          const R column = k == 0 ? across.x : across.y;
          matrix(row, at(j.body)) += column;
          matrix(at(j.body), row) += column;
          right(row) += squared * (k == 0 ? v.x : v.y);
        }
      }
    }
    right(0) += moment;
    const Vector arm = turned(to_d_, y);
    const Vector span{from_c_to_b_.x + arm.x, from_c_to_b_.y + arm.y};
    using std::sqrt;
    const R length = sqrt(span.dot(span));
    right(2) -= stiffness * (length - free_length) / length * span.dot(arm.across());
    const Column solution = matrix.partialPivLu().solve(right);
    for (std::size_t k = 0; k < bodies; ++k) {
      rate[k] = y[bodies + k];
      rate[bodies + k] = solution(at(k));
    }
  }

  /// Largest distance by which a closing condition is off [m].
  R open(const State& y) const {
    using std::sqrt;
    R largest(0);
    for (const Closing& closing : closings_) {
      Vector sum = closing.fixed;
      for (const Term& j : closing.terms) {
        const Vector v = turned(j, y);
        sum.x += v.x;
        sum.y += v.y;
      }
      largest = std::max<R>(largest, sqrt(sum.dot(sum)));
    }
    return largest;
  }

 private:
  struct Vector {
    R x, y;
    R dot(const Vector& other) const { return x * other.x + y * other.y; }
    Vector across() const { return {-y, x}; }
  };
  /// A(α of a body) v.
  struct Term {
    std::size_t body;
    Vector v;
  };
  struct Closing {
    Vector fixed;
    std::vector<Term> terms;
  };

  static Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

  static Vector turned(const Term& term, const State& y) {
    using std::cos;
    using std::sin;
    const R c = cos(y[term.body]);
    const R s = sin(y[term.body]);
    return {c * term.v.x - s * term.v.y, s * term.v.x + c * term.v.y};
  }

  static Closing close(const std::vector<Term>& way, const Vector& from, const std::vector<Term>& other) {
    Closing closing{{-from.x, -from.y}, way};
    for (const Term& term : other) closing.terms.push_back({term.body, {-term.v.x, -term.v.y}});
    return closing;
  }

  std::array<R, bodies> masses_, inertias_;
  std::array<std::vector<Term>, bodies> centres_;
  std::array<Closing, 3> closings_;
  Term to_d_;
  Vector from_c_to_b_;
};

}  // namespace lubjoint::mechanisms

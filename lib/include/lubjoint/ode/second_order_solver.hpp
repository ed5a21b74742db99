/// The linear systems of an implicit step for equations of motion, at half their size.
#pragma once

#include <Eigen/LU>
#include <complex>
#include <type_traits>

namespace lubjoint {

/// Solves (λI − J) x = r for J = [0 I 0; A B 0; C D 0] of y = (q, v, w): q̇ = v, v̇ = f(q, v), and work w that nothing
/// depends on:
///   (λ² − λB − A) x_q = r_v + (λ − B) r_q,   x_v = λx_q − r_q,   w's rows by substitution:
/// for M coordinates a factorisation of M×M in place of 2M×2M.
/// @tparam S  real or std::complex
/// @tparam M  number of coordinates, or Eigen::Dynamic
template <class S, int M>
class SecondOrderSolver {
 public:
  using Block = Eigen::Matrix<S, M, M>;   ///< A, B
  using Vector = Eigen::Matrix<S, M, 1>;  ///< coordinates or velocities

  /// Factorises λ² − λB − A.
  /// @param jacobian  of the whole system; @param m  number of coordinates
  template <class Matrix>
  void factorise(const Matrix& jacobian, Eigen::Index m, const S& shift) {
    shift_ = shift;
    const auto a = jacobian.block(m, 0, m, m);
    const auto b = jacobian.block(m, m, m, m);
    b_ = b.template cast<S>();
    k_ = -a.template cast<S>() - shift * b_;
    k_.diagonal().array() += shift * shift;
    if constexpr (small) {
      inverse_ = k_.inverse();
    } else {
      lu_.compute(k_);
    }
  }

  /// Solves for the coordinates, then the velocities.
  /// @param r  in its first 2m elements the right-hand side, replaced by x_q and x_v; w's rows are the caller's
  template <class Right>
  void solve_in_place(Right&& r, Eigen::Index m) {
    r_q_ = r.segment(0, m);
    right_.noalias() = -b_ * r_q_;
    right_ += r.segment(m, m) + shift_ * r_q_;
    if constexpr (small) {
      x_q_.noalias() = inverse_ * right_;
    } else {
      x_q_.noalias() = lu_.solve(right_);
    }
    r.segment(0, m) = x_q_;
    r.segment(m, m) = shift_ * x_q_ - r_q_;
  }

 private:
  static constexpr bool small = M == 1 || M == 2;

  static constexpr Eigen::Index start_size = M == Eigen::Dynamic ? 0 : M;

  struct Nothing {};
  S shift_{};
  Block b_ = Block::Zero(start_size, start_size);
  Block k_ = b_;
  Block inverse_ = b_;  ///< of small ones
  [[no_unique_address]] std::conditional_t<small, Nothing, Eigen::PartialPivLU<Block>> lu_;
  Vector r_q_ = Vector::Zero(start_size);
  Vector right_ = r_q_;
  Vector x_q_ = r_q_;
};

/// Number of coordinates of a Jacobian of that form; 0 if it is of another.
template <class Matrix>
Eigen::Index second_order_coordinates(const Matrix& jacobian) {
  const Eigen::Index n = jacobian.rows();
  Eigen::Index m = 0;
  while (m < n && jacobian(0, m) == 0) ++m;
  if (m == 0 || 2 * m > n) return 0;
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      if (jacobian(i, j) != (j == i + m ? 1 : 0)) return 0;
    }
  }
  for (Eigen::Index j = 2 * m; j < n; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) {
      if (jacobian(i, j) != 0) return 0;
    }
  }
  return m;
}

}  // namespace lubjoint

/// The linear systems of a step of Radau IIA for equations of motion, with a Jacobian of each stage's own.
#pragma once

#include <Eigen/LU>
#include <array>
#include <cstddef>

#include "lubjoint/ode/radau_tableau.hpp"
#include "lubjoint/ode/second_order_solver.hpp"

namespace lubjoint {

/// Solves Σ_j (A⁻¹)_ij x_j / h − J_i x_i = r_i over the stages for J_i = [0 I 0; K_i D_i 0; C E 0] of y = (q, v, w):
/// q̇ = v, v̇ = f(q, v), and work w that nothing depends on. Of M coordinates, with s = hA r_q:
///   Σ_j (A⁻¹/h − δ_ij D_i − h A_ij K_i) x_v,j = r_v,i + K_i s_i,   x_q = s + hA x_v,   x_w = hA (r_w + C x_q + E x_v),
/// one real factorisation of as many rows as there are stages times M.
/// @tparam N  number of states, or Eigen::Dynamic
template <class R, int N, int Stages>
class StageSolver {
  static constexpr int half = N == Eigen::Dynamic ? Eigen::Dynamic : (N + 1) / 2;
  static constexpr int unknowns = N == Eigen::Dynamic ? Eigen::Dynamic : half * Stages;
  static constexpr bool is_unrolled = unknowns != Eigen::Dynamic && unknowns <= 8;  ///< by Eigen

 public:
  using Matrix = Eigen::Matrix<R, N, N>;                                   ///< a Jacobian
  using Vector = Eigen::Matrix<R, N, 1>;                                   ///< of states
  using Jacobians = std::array<Matrix, static_cast<std::size_t>(Stages)>;  ///< a part of each stage's
  using AllStages = std::array<Vector, static_cast<std::size_t>(Stages)>;  ///< of the stages

  /// Factorises for J_i = rest + own_i.
  /// @param m  number of coordinates;  @param own  of which the rows of v̇ are read alone
  /// @param rest  kept by reference until the next call
  void factorise(const Matrix& rest, const Jacobians& own, Eigen::Index m, const R& h) {
    rest_ = &rest;
    m_ = m;
    times_a_.noalias() = h * tableau_.a;
    whole_.resize(Stages * m, Stages * m);
    const Block k_rest = of_accelerations(rest, 0);
    const Block d_rest = of_accelerations(rest, m);
    for (Eigen::Index i = 0; i < Stages; ++i) {
      Block& k = stiffness_[at(i)];
      k = k_rest + of_accelerations(own[at(i)], 0);
      for (Eigen::Index j = 0; j < Stages; ++j) {
        auto block = this->block(whole_, i * m, j * m);
        block = -times_a_(i, j) * k;
        block.diagonal().array() += tableau_.a_inverse(i, j) / h;
      }
      this->block(whole_, i * m, i * m) -= d_rest + of_accelerations(own[at(i)], m);
    }
    lu_.compute(whole_);
    if constexpr (!is_unrolled) inverse_pivots_ = lu_.matrixLU().diagonal().cwiseInverse();
    of_middle_ = rest;
    of_middle_.middleRows(m, m) += own[static_cast<std::size_t>(Stages / 2)].middleRows(m, m);
    shift_ = tableau_.gamma / h;
    real_.factorise(of_middle_, m, shift_);
  }

  /// (γ/h − J) x = r, J that of the middle stage.
  void filter(const Vector& r, Vector& x) {
    x = r;
    real_.solve_in_place(x, m_);
    const Eigen::Index works = x.size() - 2 * m_;
    if (works == 0) return;
    add_power(x, works);
    x.tail(works) /= shift_;
  }

  /// Replaces r by x.
  void solve_in_place(AllStages& r) {
    right_.resize(Stages * m_);
    for (Eigen::Index i = 0; i < Stages; ++i) {
      Coordinates& s = integrated_[at(i)];
      s = times_a_(i, 0) * segment(r[0], 0);
      for (Eigen::Index j = 1; j < Stages; ++j) s += times_a_(i, j) * segment(r[at(j)], 0);
      segment(right_, i * m_) = segment(r[at(i)], m_) + stiffness_[at(i)].lazyProduct(s);
    }
    if constexpr (is_unrolled) {
      found_.noalias() = lu_.solve(right_);
    } else {
      found_.noalias() = lu_.permutationP() * right_;
      substitute(found_);
    }
    for (Eigen::Index i = 0; i < Stages; ++i) {
      Vector& x = r[at(i)];
      segment(x, 0) = integrated_[at(i)];
      for (Eigen::Index j = 0; j < Stages; ++j) segment(x, 0) += times_a_(i, j) * segment(found_, j * m_);
      segment(x, m_) = segment(found_, i * m_);
    }
    const Eigen::Index works = r[0].size() - 2 * m_;
    if (works > 0) solve_works(r, works);
  }

 private:
  using Block = Eigen::Matrix<R, half, half>;
  using Coordinates = Eigen::Matrix<R, half, 1>;

  static std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

  // Of m rows, or m rows and columns.
  template <class V>
  auto segment(V& of, Eigen::Index first) const {
    if constexpr (half == Eigen::Dynamic) {
      return of.segment(first, m_);
    } else {
      return of.template segment<half>(first);
    }
  }
  template <class M>
  auto block(M& of, Eigen::Index row, Eigen::Index column) const {
    if constexpr (half == Eigen::Dynamic) {
      return of.block(row, column, m_, m_);
    } else {
      return of.template block<half, half>(row, column);
    }
  }
  auto of_accelerations(const Matrix& jacobian, Eigen::Index column) const { return block(jacobian, m_, column); }

  /// Solves L U x = b. Column by column and with the pivots' inverses no element waits for a sum or a division: Eigen's
  /// row by row, where it does not unroll it, takes twice as long for ten.
  void substitute(Eigen::Matrix<R, unknowns, 1>& x) const {
    const auto& lu = lu_.matrixLU();
    const Eigen::Index n = x.size();
    for (Eigen::Index j = 0; j < n; ++j) {
      const R of_this = x(j);
      for (Eigen::Index i = j + 1; i < n; ++i) x(i) -= lu(i, j) * of_this;
    }
    for (Eigen::Index j = n; j-- > 0;) {
      const R of_this = x(j) *= inverse_pivots_(j);
      for (Eigen::Index i = 0; i < j; ++i) x(i) -= lu(i, j) * of_this;
    }
  }

  /// What C x_q + E x_v adds to the rows of work.
  void add_power(Vector& x, Eigen::Index works) const {
    x.tail(works).noalias() += rest_->block(2 * m_, 0, works, 2 * m_) * x.head(2 * m_);
  }

  void solve_works(AllStages& r, Eigen::Index works) {
    for (Vector& x : r) add_power(x, works);
    for (Eigen::Index w = 2 * m_; w < 2 * m_ + works; ++w) {
      Eigen::Matrix<R, Stages, 1> slopes;
      for (Eigen::Index i = 0; i < Stages; ++i) slopes(i) = r[at(i)](w);
      const Eigen::Matrix<R, Stages, 1> sums = times_a_ * slopes;
      for (Eigen::Index i = 0; i < Stages; ++i) r[at(i)](w) = sums(i);
    }
  }

  static constexpr Eigen::Index start_size = N == Eigen::Dynamic ? 0 : unknowns;

  const RadauTableau<R, Stages>& tableau_ = RadauTableau<R, Stages>::instance();
  const Matrix* rest_ = nullptr;
  Eigen::Index m_ = 0;
  Eigen::Matrix<R, Stages, Stages> times_a_;  ///< hA
  Eigen::Matrix<R, unknowns, unknowns> whole_ = Eigen::Matrix<R, unknowns, unknowns>::Zero(start_size, start_size);
  Eigen::PartialPivLU<Eigen::Matrix<R, unknowns, unknowns>> lu_;
  Eigen::Matrix<R, unknowns, 1> inverse_pivots_;
  Eigen::Matrix<R, unknowns, 1> right_ = Eigen::Matrix<R, unknowns, 1>::Zero(start_size);
  Eigen::Matrix<R, unknowns, 1> found_ = right_;
  std::array<Block, static_cast<std::size_t>(Stages)> stiffness_;
  Matrix of_middle_;  ///< J of the middle stage
  R shift_ = 0;
  SecondOrderSolver<R, half> real_;
  std::array<Coordinates, static_cast<std::size_t>(Stages)> integrated_;
};

}  // namespace lubjoint

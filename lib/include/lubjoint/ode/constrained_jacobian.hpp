/// The linear systems of an implicit step for constrained equations of motion, as sparse as the equations themselves.
#pragma once

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace lubjoint {

/// Derivatives of  M a + Φqᵀ λ = g(q, v),  Φq a = w(q, v)  at a = v̇, in y = (q, v, work): the Jacobian of v̇ is full, as
/// every body feels every other at once, but that of the equations is not. One list of elements of an (n + m)² matrix
///   K(s) = C₀ + C₁/s + C₂/s²,
///   C₀ = [M Φqᵀ; Φq 0],  C₁ = −[G_v 0; H_v 0],  C₂ = −[G_q 0; H_q 0],
/// G = ∂(g − Φqᵀλ) at fixed λ, H = ∂(w − Φq a) at fixed a, columns of q, then of λ.
template <class R>
struct ConstrainedJacobian {
  Eigen::Index coordinates = 0;  ///< n
  Eigen::Index multipliers = 0;  ///< m
  std::vector<int> outer;        ///< where each column's elements begin, and the end of the last
  std::vector<int> inner;        ///< their rows, ascending
  std::vector<R> constant;       ///< of C₀
  std::vector<R> over_shift;     ///< of C₁
  std::vector<R> over_square;    ///< of C₂

  /// Is every number one?
  bool allFinite() const {
    const auto finite = [](const std::vector<R>& numbers) {
      return std::all_of(numbers.begin(), numbers.end(),
                         [](const R& x) { return std::isfinite(static_cast<double>(x)); });
    };
    return finite(constant) && finite(over_shift) && finite(over_square);
  }
};

/// Factors of K(s). With x_v = s x_q − r_q, (sI − J)(x_q, x_v) = (r_q, r_v) is
///   K(s) (x_q, μ/s²) = (C₀ (s r_q + r_v) + C₁ r_q)/s²,  the coordinates' columns of both.
/// An order of elimination that keeps the factors sparse is found once; pivots are chosen by size in each
/// factorisation.
/// @tparam S  real or std::complex
template <class R, class S>
class ConstrainedFactors {
 public:
  /// @throws std::domain_error  K(s) is singular
  void factorise(const ConstrainedJacobian<R>& jacobian, const S& shift) {
    shift_ = shift;
    const Eigen::Index size = jacobian.coordinates + jacobian.multipliers;
    if (matrix_.rows() != size || matrix_.nonZeros() != static_cast<Eigen::Index>(jacobian.inner.size())) {
      matrix_.resize(size, size);
      matrix_.resizeNonZeros(static_cast<Eigen::Index>(jacobian.inner.size()));
      std::copy(jacobian.outer.begin(), jacobian.outer.end(), matrix_.outerIndexPtr());
      std::copy(jacobian.inner.begin(), jacobian.inner.end(), matrix_.innerIndexPtr());
      lu_.analyzePattern(matrix_);
    }
    const S inverse = S(1) / shift;
    for (std::size_t k = 0; k < jacobian.inner.size(); ++k) {
      matrix_.valuePtr()[k] =
          jacobian.constant[k] + inverse * (jacobian.over_shift[k] + inverse * jacobian.over_square[k]);
    }
    lu_.factorize(matrix_);
    if (lu_.info() != Eigen::Success) throw std::domain_error("the matrix of an implicit step is singular");
  }

  /// Replaces (r_q, r_v), the first 2n numbers, by (x_q, x_v).
  template <class Right>
  void solve_in_place(const ConstrainedJacobian<R>& jacobian, Right& r) {
    const Eigen::Index n = jacobian.coordinates;
    right_.setZero(n + jacobian.multipliers);
    for (Eigen::Index column = 0; column < n; ++column) {
      const S both = shift_ * r(column) + r(n + column);
      const auto end = static_cast<std::size_t>(jacobian.outer[static_cast<std::size_t>(column) + 1]);
      for (auto k = static_cast<std::size_t>(jacobian.outer[static_cast<std::size_t>(column)]); k < end; ++k)
        right_(jacobian.inner[k]) += jacobian.constant[k] * both + jacobian.over_shift[k] * r(column);
    }
    right_ /= shift_ * shift_;
    solution_ = lu_.solve(right_);
    for (Eigen::Index i = 0; i < n; ++i) {
      const S place = solution_(i);
      r(n + i) = shift_ * place - r(i);
      r(i) = place;
    }
  }

 private:
  using Vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
  S shift_{};
  Eigen::SparseMatrix<S> matrix_;
  Eigen::SparseLU<Eigen::SparseMatrix<S>> lu_;
  Vector right_, solution_;
};

/// What ShiftedSolver is for a full Jacobian. States behind (q, v) are integrals that nothing depends on: their rates
/// are taken as they come.
/// @tparam Pairs  how many complex systems there are
template <class R, std::size_t Pairs>
class ConstrainedShiftedSolver {
 public:
  using Vector = Eigen::Matrix<R, Eigen::Dynamic, 1>;  ///< a right-hand side
  using Shares = std::array<R, Pairs>;                 ///< a number for each pair

  explicit ConstrainedShiftedSolver(Eigen::Index) {}  ///< takes its memory in the first factorisation

  /// Factorises γI − J and, for each pair, (α + iβ) I − J.
  /// @param jacobian  kept by reference until the next call;  @throws std::domain_error  one is singular
  void factorise(const ConstrainedJacobian<R>& jacobian, const R& gamma, const Shares& alpha, const Shares& beta) {
    jacobian_ = &jacobian;
    gamma_ = gamma;
    real_.factorise(jacobian, gamma);
    for (std::size_t i = 0; i < Pairs; ++i) {
      shifts_[i] = {alpha[i], beta[i]};
      complex_[i].factorise(jacobian, shifts_[i]);
    }
  }

  /// x of the real system.
  void solve(const Vector& r, Vector& x) {
    x = r;
    real_.solve_in_place(*jacobian_, x);
    const Eigen::Index rest = x.size() - 2 * jacobian_->coordinates;
    x.tail(rest) /= gamma_;
  }

  /// Replaces (r, s) by (x, y) of the complex system of a pair.
  void solve_in_place(std::size_t pair, Vector& real, Vector& imaginary) {
    both_.resize(real.size());
    both_.real() = real;
    both_.imag() = imaginary;
    complex_[pair].solve_in_place(*jacobian_, both_);
    both_.tail(both_.size() - 2 * jacobian_->coordinates) /= shifts_[pair];
    real = both_.real();
    imaginary = both_.imag();
  }

 private:
  const ConstrainedJacobian<R>* jacobian_ = nullptr;
  R gamma_ = 0;
  std::array<std::complex<R>, Pairs> shifts_{};
  ConstrainedFactors<R, R> real_;
  std::array<ConstrainedFactors<R, std::complex<R>>, Pairs> complex_;
  Eigen::Matrix<std::complex<R>, Eigen::Dynamic, 1> both_;
};

/// Linear systems of a step of RadauIIA with it.
template <class R>
struct ConstrainedLinear {
  using Jacobian = ConstrainedJacobian<R>;  ///< of the equations behind ∂f/∂y
  template <std::size_t Pairs>
  using Solver = ConstrainedShiftedSolver<R, Pairs>;  ///< solves for the stages and the estimate
  /// Memory is taken by the first evaluation.
  static void prepare(Jacobian&, Eigen::Index) {}
};

}  // namespace lubjoint

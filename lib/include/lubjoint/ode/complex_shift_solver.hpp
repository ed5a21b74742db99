/// The complex linear system of an implicit Runge–Kutta step, in any real scalar.
#pragma once

#include <Eigen/LU>
#include <complex>
#include <type_traits>

namespace lubjoint {

/// Solves ((α + iβ) I − J)(x + iy) = r + is. Built-in scalars: one complex factorisation of N×N. Others, for which
/// std::complex means nothing: the equivalent real system of 2N×2N.
template <class R, int N>
class ComplexShiftSolver {
 public:
  using Vector = Eigen::Matrix<R, N, 1>;  ///< a right-hand side
  using Matrix = Eigen::Matrix<R, N, N>;  ///< J

  /// Takes the memory for n states.
  explicit ComplexShiftSolver(Eigen::Index n)
      : system_(System::Identity(built_in ? n : 2 * n, built_in ? n : 2 * n)),
        lu_(system_),
        right_(Eigen::Matrix<Number, size, 1>::Zero(system_.rows())),
        x_(right_) {}

  /// Factorises (α + iβ) I − J.
  void factorise(const Matrix& jacobian, const R& alpha, const R& beta) {
    const auto n = jacobian.rows();
    if constexpr (std::is_floating_point_v<R>) {
      system_ = -jacobian.template cast<Number>();
      system_.diagonal().array() += Number(alpha, beta);
    } else {
      const Matrix unit = Matrix::Identity(n, n);
      system_.resize(2 * n, 2 * n);
      system_ << alpha * unit - jacobian, -beta * unit, beta * unit, alpha * unit - jacobian;
    }
    lu_.compute(system_);
  }

  /// Replaces (r, s) by (x, y).
  void solve_in_place(Vector& real, Vector& imaginary) {
    const auto n = real.size();
    if constexpr (std::is_floating_point_v<R>) {
      right_.resize(n);
      right_.real() = real;
      right_.imag() = imaginary;
      x_.noalias() = lu_.solve(right_);
      real = x_.real();
      imaginary = x_.imag();
    } else {
      right_.resize(2 * n);
      right_ << real, imaginary;
      x_.noalias() = lu_.solve(right_);
      real = x_.head(n);
      imaginary = x_.tail(n);
    }
  }

 private:
  static constexpr bool built_in = std::is_floating_point_v<R>;
  static constexpr int size = built_in || N == Eigen::Dynamic ? N : 2 * N;
  template <class S, bool>
  struct NumberOf {
    using Type = S;
  };
  template <class S>
  struct NumberOf<S, true> {
    using Type = std::complex<S>;
  };
  using Number = typename NumberOf<R, built_in>::Type;
  using System = Eigen::Matrix<Number, size, size>;

  System system_;
  Eigen::PartialPivLU<System> lu_;
  Eigen::Matrix<Number, size, 1> right_, x_;
};

}  // namespace lubjoint

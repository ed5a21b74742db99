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
  using Vector = Eigen::Matrix<R, N, 1>;
  using Matrix = Eigen::Matrix<R, N, N>;

  void factorise(const Matrix& jacobian, const R& alpha, const R& beta) {
    const auto n = jacobian.rows();
    if constexpr (std::is_floating_point_v<R>) {
      lu_.compute(System::Identity(n, n) * Number(alpha, beta) - jacobian.template cast<Number>());
    } else {
      System system(2 * n, 2 * n);
      const Matrix unit = Matrix::Identity(n, n);
      system << alpha * unit - jacobian, -beta * unit, beta * unit, alpha * unit - jacobian;
      lu_.compute(system);
    }
  }

  /// Replaces (r, s) by (x, y).
  void solve_in_place(Vector& real, Vector& imaginary) const {
    const auto n = real.size();
    if constexpr (std::is_floating_point_v<R>) {
      Eigen::Matrix<Number, N, 1> right(n);
      right.real() = real;
      right.imag() = imaginary;
      const Eigen::Matrix<Number, N, 1> x = lu_.solve(right);
      real = x.real();
      imaginary = x.imag();
    } else {
      constexpr int twice = N == Eigen::Dynamic ? Eigen::Dynamic : 2 * N;
      Eigen::Matrix<R, twice, 1> right(2 * n);
      right << real, imaginary;
      const Eigen::Matrix<R, twice, 1> x = lu_.solve(right);
      real = x.head(n);
      imaginary = x.tail(n);
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

  Eigen::PartialPivLU<System> lu_;
};

}  // namespace lubjoint

/// The real and the complex linear systems of a step of Radau IIA.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "lubjoint/ode/complex_shift_solver.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/ode/kinematic_solver.hpp"
#include "lubjoint/ode/second_order_solver.hpp"

namespace lubjoint {

/// (γI − J) x = r and, of each pair of eigenvalues, ((α + iβ) I − J)(x + iy) = r + is, for one J and many right-hand
/// sides. Equations of motion are recognised by their Jacobian's form and solved at half the size, or, of bodies in
/// space, at 6/13 of it.
/// @tparam Pairs  how many complex systems there are
template <class R, int N, std::size_t Pairs = 1>
class ShiftedSolver {
 public:
  using Vector = Eigen::Matrix<R, N, 1>;  ///< a right-hand side
  using Matrix = Eigen::Matrix<R, N, N>;  ///< J
  using Shares = std::array<R, Pairs>;    ///< a number for each pair

  /// Takes the memory for n states where N is given; else the first factorisation does, of what it needs.
  explicit ShiftedSolver(Eigen::Index n)
      : shifted_(Matrix::Identity(start_size(n), start_size(n))),
        real_(shifted_),
        complex_(complex_of_size(start_size(n), std::make_index_sequence<Pairs>())) {}

  /// Factorises γI − J and, for each pair, (α + iβ) I − J.
  /// @param jacobian  kept by reference until the next call
  void factorise(const Matrix& jacobian, const R& gamma, const Shares& alpha, const Shares& beta) {
    gamma_ = gamma;
    alpha_ = alpha;
    beta_ = beta;
    coordinates_ = can_reduce ? second_order_coordinates(jacobian) : 0;
    if constexpr (N != Eigen::Dynamic) {
      if (2 * coordinates_ != N) coordinates_ = 0;
    }
    if constexpr (can_reduce) {
      if (coordinates_ > 0) {
        jacobian_ = &jacobian;
        reduced_states_ = 2 * coordinates_;
        real_reduced_.factorise(jacobian, coordinates_, gamma);
        for (std::size_t i = 0; i < Pairs; ++i)
          complex_reduced_[i].factorise(jacobian, coordinates_, Complex(alpha[i], beta[i]));
        return;
      }
    }
    if constexpr (may_be_in_space) {
      const Eigen::Index bodies = bodies_of_kinematic_form(jacobian);
      reduced_states_ = KinematicForm::states * bodies;
      if (bodies > 0) {
        jacobian_ = &jacobian;
        real_in_space_.factorise(jacobian, bodies, gamma);
        for (std::size_t i = 0; i < Pairs; ++i)
          complex_in_space_[i].factorise(jacobian, bodies, Complex(alpha[i], beta[i]));
        return;
      }
    }
    shifted_ = -jacobian;
    shifted_.diagonal().array() += gamma;
    real_.compute(shifted_);
    for (std::size_t i = 0; i < Pairs; ++i) complex_[i].factorise(jacobian, alpha[i], beta[i]);
  }

  /// x of the real system.
  void solve(const Vector& r, Vector& x) {
    if constexpr (can_reduce) {
      if (coordinates_ > 0) {
        x = r;
        real_reduced_.solve_in_place(x, coordinates_);
        solve_work(x, R(gamma_));
        return;
      }
    }
    if constexpr (may_be_in_space) {
      if (reduced_states_ > 0) {
        x = r;
        real_in_space_.solve_in_place(x);
        solve_work(x, R(gamma_));
        return;
      }
    }
    x.noalias() = real_.solve(r);
  }

  /// Replaces (r, s) by (x, y) of the complex system of a pair.
  void solve_in_place(std::size_t pair, Vector& real, Vector& imaginary) {
    if constexpr (can_reduce) {
      if (coordinates_ > 0) {
        both_.resize(real.size());
        both_.real() = real;
        both_.imag() = imaginary;
        complex_reduced_[pair].solve_in_place(both_, coordinates_);
        solve_work(both_, Complex(alpha_[pair], beta_[pair]));
        real = both_.real();
        imaginary = both_.imag();
        return;
      }
    }
    if constexpr (may_be_in_space) {
      if (reduced_states_ > 0) {
        both_.resize(real.size());
        both_.real() = real;
        both_.imag() = imaginary;
        complex_in_space_[pair].solve_in_place(both_);
        solve_work(both_, Complex(alpha_[pair], beta_[pair]));
        real = both_.real();
        imaginary = both_.imag();
        return;
      }
    }
    complex_[pair].solve_in_place(real, imaginary);
  }

 private:
  static constexpr bool can_reduce = std::is_floating_point_v<R> && (N == Eigen::Dynamic || N % 2 == 0);
  static constexpr bool may_be_in_space = std::is_floating_point_v<R> && N == Eigen::Dynamic;
  static constexpr int half = N == Eigen::Dynamic ? Eigen::Dynamic : (N + 1) / 2;
  using Complex = std::complex<std::conditional_t<std::is_floating_point_v<R>, R, double>>;

  template <std::size_t... I>
  static std::array<ComplexShiftSolver<R, N>, Pairs> complex_of_size(Eigen::Index n, std::index_sequence<I...>) {
    return {(static_cast<void>(I), ComplexShiftSolver<R, N>(n))...};
  }

  static constexpr Eigen::Index start_size(Eigen::Index n) { return N == Eigen::Dynamic ? 0 : n; }

  /// The rows of work: λ x_w = r_w + C x_q + D x_v.
  template <class Both, class S>
  void solve_work(Both& x, const S& shift) const {
    const Eigen::Index done = reduced_states_;
    for (Eigen::Index i = done; i < x.size(); ++i) {
      auto sum = x(i);
      for (Eigen::Index j = 0; j < done; ++j) sum += (*jacobian_)(i, j) * x(j);
      x(i) = sum / shift;
    }
  }

  R gamma_ = 0;
  Shares alpha_{}, beta_{};
  Eigen::Index coordinates_ = 0;
  Eigen::Index reduced_states_ = 0;  ///< (q, v) of equations of motion that were recognised; behind them is work
  const Matrix* jacobian_ = nullptr;
  SecondOrderSolver<R, half> real_reduced_;
  std::array<SecondOrderSolver<Complex, half>, Pairs> complex_reduced_;
  struct Nothing {};
  [[no_unique_address]] std::conditional_t<may_be_in_space, KinematicSolver<R>, Nothing> real_in_space_;
  [[no_unique_address]] std::conditional_t<may_be_in_space, std::array<KinematicSolver<Complex>, Pairs>, Nothing>
      complex_in_space_;
  Eigen::Matrix<Complex, N, 1> both_ = Eigen::Matrix<Complex, N, 1>::Zero(N == Eigen::Dynamic ? 0 : N);
  Matrix shifted_;
  Eigen::PartialPivLU<Matrix> real_;
  std::array<ComplexShiftSolver<R, N>, Pairs> complex_;
};

/// Linear systems of a step with the Jacobian as a full matrix.
template <class R, std::size_t N>
struct FullLinear {
  static constexpr int dimension = N == run_time_size ? Eigen::Dynamic : static_cast<int>(N);  ///< of Eigen's matrices
  using Jacobian = Eigen::Matrix<R, dimension, dimension>;                                     ///< ∂f/∂y
  template <std::size_t Pairs>
  using Solver = ShiftedSolver<R, dimension, Pairs>;  ///< solves for the stages and the estimate
  /// Takes the memory for n states.
  static void prepare(Jacobian& jacobian, Eigen::Index n) { jacobian.setZero(n, n); }
};

}  // namespace lubjoint

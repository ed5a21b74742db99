/// Jacobians by forward automatic differentiation of the equations of motion themselves.
#pragma once

#include <array>
#include <cstddef>

#include "lubjoint/film/scalar.hpp"

namespace lubjoint {

/// J_ij = ∂f_i/∂x_j of f(x, dxdt), exact to rounding. f must accept arrays of AutoDiffScalar.
template <class R, std::size_t N, class F>
void exact_jacobian(const F& f, const std::array<R, N>& x,
                    Eigen::Matrix<R, static_cast<int>(N), static_cast<int>(N)>& jacobian) {
  using Derivatives = Eigen::Matrix<R, static_cast<int>(N), 1>;
  using Dual = Eigen::AutoDiffScalar<Derivatives>;
  std::array<Dual, N> seeded;
  for (std::size_t j = 0; j < N; ++j) seeded[j] = Dual(x[j], static_cast<int>(N), static_cast<int>(j));
  std::array<Dual, N> rate;
  f(seeded, rate);
  for (std::size_t i = 0; i < N; ++i) jacobian.row(static_cast<Eigen::Index>(i)) = rate[i].derivatives().transpose();
}

}  // namespace lubjoint

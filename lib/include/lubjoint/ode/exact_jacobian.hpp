/// Jacobians by forward automatic differentiation of the equations of motion themselves.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "lubjoint/number/dual.hpp"

namespace lubjoint {

/// J_ij = ∂f_i/∂x_j of f(x, dxdt), exact to rounding. f must accept arrays of Duals.
template <class R, std::size_t N, class F>
void exact_jacobian(const F& f, const std::array<R, N>& x,
                    Eigen::Matrix<R, static_cast<int>(N), static_cast<int>(N)>& jacobian) {
  using Seeded = Dual<R, static_cast<int>(N)>;
  std::array<Seeded, N> seeded;
  for (std::size_t j = 0; j < N; ++j) seeded[j] = Seeded::variable(x[j], static_cast<Eigen::Index>(j));
  std::array<Seeded, N> rate;
  f(seeded, rate);
  for (std::size_t i = 0; i < N; ++i) jacobian.row(static_cast<Eigen::Index>(i)) = rate[i].derivatives().transpose();
}

/// The same for a number of states that is known when the program runs: columns in groups of Group, so that no
/// derivative needs memory of its own. It keeps its work between calls.
template <int Group, class R>
class RunTimeJacobian {
 public:
  using Seeded = Dual<R, Group>;                                    ///< a number with the derivatives of a group
  using Matrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;  ///< the Jacobian

  /// ∂f_i/∂x_j of f(x, dxdt); columns from `columns` on are zero.
  template <class F>
  void fill(const F& f, const std::vector<R>& x, std::size_t columns, Matrix& jacobian) {
    const auto n = static_cast<Eigen::Index>(x.size());
    jacobian.setZero(n, n);
    seeded_.assign(x.begin(), x.end());
    rate_.resize(x.size());
    for (std::size_t start = 0; start < columns; start += Group) {
      const std::size_t end = std::min(columns, start + Group);
      for (std::size_t j = start; j < end; ++j)
        seeded_[j] = Seeded::variable(x[j], static_cast<Eigen::Index>(j - start));
      f(seeded_, rate_);
      const auto first = static_cast<Eigen::Index>(start);
      const auto count = static_cast<Eigen::Index>(end - start);
      for (std::size_t i = 0; i < x.size(); ++i) {
        jacobian.block(static_cast<Eigen::Index>(i), first, 1, count) = rate_[i].derivatives().head(count).transpose();
      }
      for (std::size_t j = start; j < end; ++j) seeded_[j] = Seeded(x[j]);
    }
  }

  /// ∂f_i/∂t of f(x, dxdt, t).
  template <class F>
  void fill_time_slope(const F& f, const std::vector<R>& x, const R& t, std::vector<R>& slope) {
    seeded_.assign(x.begin(), x.end());
    rate_.resize(x.size());
    f(seeded_, rate_, Seeded::variable(t, 0));
    slope.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) slope[i] = rate_[i].derivatives()(0);
  }

 private:
  std::vector<Seeded> seeded_, rate_;
};

}  // namespace lubjoint

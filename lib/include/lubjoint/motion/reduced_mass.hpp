/// The mass that the free coordinates of a system move.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "lubjoint/multibody/small_ldlt.hpp"
#include "lubjoint/ode/integrator.hpp"

namespace lubjoint {

/// VᵀMV and its factors LDLᵀ.
/// @tparam Freedoms  columns of V, or run_time_size;  @tparam Columns  a group of them at one coordinate; all, and more
///                   behind them, where Freedoms is given
template <class R, std::size_t Freedoms, class Columns>
class ReducedMass {
 public:
  /// @param freedoms  columns of V
  explicit ReducedMass(std::size_t freedoms) : f_(freedoms), factors_(freedoms * freedoms) {}

  /// @param n  rows of V;  @param weigh  weigh(i, v): row i of M times a group of columns v
  /// @param columns  V: the first group of columns at every row, then the next group. @throws SingularConstraints
  template <class Weigh>
  void factorise(std::size_t n, const Weigh& weigh, const Columns* columns) {
    if constexpr (Freedoms != run_time_size) {
      std::array<R, Freedoms*(Freedoms + 1) / 2> sums{};  // a triangle, row by row
      for (std::size_t i = 0; i < n; ++i) {
        const Columns weighted = weigh(i, columns);
        std::size_t at = 0;
        for (std::size_t k = 0; k < Freedoms; ++k) {
          for (std::size_t l = 0; l <= k; ++l) sums[at++] += weighted(index(k)) * columns[i](index(l));
        }
      }
      std::size_t at = 0;
      for (std::size_t k = 0; k < Freedoms; ++k) {
        for (std::size_t l = 0; l <= k; ++l) factors_[k * Freedoms + l] = sums[at++];
      }
    } else {
      for (std::size_t g = 0; g * group < f_; ++g) {
        for (std::size_t h = 0; h <= g; ++h) {
          Eigen::Array<R, group, group> block = Eigen::Array<R, group, group>::Zero();
          for (std::size_t i = 0; i < n; ++i) {
            const Columns weighted = weigh(i, columns + g * n);
            for (std::size_t l = 0; l < group; ++l) block.col(index(l)) += weighted * columns[h * n + i](index(l));
          }
          for (std::size_t k = g * group; k < std::min<std::size_t>(f_, (g + 1) * group); ++k) {
            for (std::size_t l = h * group; l < std::min<std::size_t>(k + 1, (h + 1) * group); ++l)
              factors_[k * f_ + l] = block(index(k - g * group), index(l - h * group));
          }
        }
      }
    }
    factorise_ldlt(freedoms(), factors_.data());
  }

  /// Replaces b by the solution of VᵀMV x = b. V: R, or several right-hand sides at once.
  template <class V>
  void solve(V* b) const {
    solve_ldlt(freedoms(), factors_.data(), b);
  }

 private:
  static constexpr std::size_t group = static_cast<std::size_t>(Columns::RowsAtCompileTime);

  std::size_t freedoms() const { return Freedoms == run_time_size ? f_ : Freedoms; }
  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

  std::size_t f_;
  std::vector<R> factors_;
};

}  // namespace lubjoint

/// LDLᵀ factors of a small full matrix, such as the mass that a few free coordinates move.
#pragma once

#include <cstddef>
#include <limits>

#include "lubjoint/multibody/envelope_cholesky.hpp"

namespace lubjoint {

/// Replaces the lower triangle of a symmetric n×n matrix, row by row, by L without its ones and the inverses of D.
/// @throws SingularConstraints  where a pivot is not positive, to 64 units of rounding of its diagonal element
template <class R>
void factorise_ldlt(std::size_t n, R* a) {
  for (std::size_t k = 0; k < n; ++k) {
    R* row = a + k * n;
    const R whole = row[k];
    for (std::size_t l = 0; l < k; ++l) {
      const R* earlier = a + l * n;
      for (std::size_t i = 0; i < l; ++i) row[l] -= row[i] * earlier[i];  // L_ki D_i, not yet divided
    }
    for (std::size_t l = 0; l < k; ++l) {
      const R times_d = row[l];
      row[l] *= a[l * n + l];
      row[k] -= times_d * row[l];
    }
    if (!(row[k] > whole * 64 * std::numeric_limits<R>::epsilon()))
      throw SingularConstraints("the mass that the free coordinates move is singular here");
    row[k] = 1 / row[k];
  }
}

/// Solves with these factors, in place. V: R, or several right-hand sides at once.
template <class R, class V>
void solve_ldlt(std::size_t n, const R* a, V* b) {
  for (std::size_t k = 1; k < n; ++k) {
    for (std::size_t l = 0; l < k; ++l) b[k] -= a[k * n + l] * b[l];
  }
  for (std::size_t k = n; k-- > 0;) {
    b[k] *= a[k * n + k];
    for (std::size_t l = k + 1; l < n; ++l) b[k] -= a[l * n + k] * b[l];
  }
}

}  // namespace lubjoint

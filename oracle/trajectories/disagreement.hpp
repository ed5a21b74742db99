/// How far apart two methods' trajectories are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace lubjoint::reports {

/// A trajectory: at each time the components of several vectors (numbers alone are vectors of one), one after the
/// other.
template <class R>
using TrajectoryValues = std::vector<std::vector<R>>;

/// Largest size of each vector along a trajectory.
/// @param vectors  their numbers of components
template <class R>
std::vector<R> largest_sizes(const TrajectoryValues<R>& rows, const std::vector<std::size_t>& vectors) {
  using std::sqrt;
  std::vector<R> sizes(vectors.size(), R(0));
  for (const std::vector<R>& row : rows) {
    std::size_t k = 0;
    for (std::size_t v = 0; v < vectors.size(); ++v) {
      R square(0);
      for (const std::size_t end = k + vectors[v]; k < end; ++k) square += row[k] * row[k];
      sizes[v] = std::max<R>(sizes[v], R(sqrt(square)));
    }
  }
  return sizes;
}

/// At each time the largest distance of the two methods' vectors, each over its largest size along the trajectory: a
/// vector that passes through zero is not asked for more digits there than elsewhere.
template <class R>
std::vector<double> disagreements(const TrajectoryValues<R>& one, const TrajectoryValues<R>& other,
                                  const std::vector<std::size_t>& vectors) {
  using std::sqrt;
  const std::vector<R> sizes = largest_sizes(one, vectors);
  std::vector<double> result;
  for (std::size_t i = 0; i < one.size(); ++i) {
    double largest = 0;
    std::size_t k = 0;
    for (std::size_t v = 0; v < vectors.size(); ++v) {
      R square(0);
      for (const std::size_t end = k + vectors[v]; k < end; ++k) {
        const R apart = one[i][k] - other[i].at(k);
        square += apart * apart;
      }
      if (square > 0) largest = std::max(largest, static_cast<double>(R(sqrt(square) / sizes[v])));
    }
    result.push_back(largest);
  }
  return result;
}

/// Decimal digits of agreement: −log10 of the largest disagreement.
inline double agreed_digits(const std::vector<double>& disagreements) {
  return -std::log10(std::max(1e-34, *std::max_element(disagreements.begin(), disagreements.end())));
}

}  // namespace lubjoint::reports

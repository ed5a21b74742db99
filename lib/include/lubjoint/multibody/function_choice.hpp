/// Which of many functions of the coordinates are independent of constraints and of each other.
#pragma once

#include <Eigen/QR>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace lubjoint {

/// Numbers of as many functions as the constraints leave freedoms: those whose derivatives along the free directions
/// are largest, one after the other, each without what the earlier ones have of it; preferred ones first. In rising
/// order; none where the constraints are not independent, or there are no such functions.
/// @param constraints  Φq, a row each, in units in which the coordinates are comparable
/// @param functions  derivatives of the functions, a row each, likewise
/// @param preferred  how many of the first functions come first; one that others almost fix (to 0.02 of its size) is
/// left
///                   to the others, which are taken as they come (to 1e-6)
/// @param weight  weight(number) of what is left of a function that is not preferred
template <class R, class Weight>
std::vector<std::size_t> independent_functions(Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic> constraints,
                                               Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic> functions,
                                               std::size_t preferred, const Weight& weight) {
  using Matrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;
  using Row = Eigen::Matrix<R, 1, Eigen::Dynamic>;
  const Eigen::Index n = functions.cols();
  const Eigen::Index m = constraints.rows();
  for (Eigen::Index i = 0; i < m; ++i) {
    const R size = constraints.row(i).norm();
    if (!(size > 0)) return {};
    constraints.row(i) /= size;
  }
  for (Eigen::Index i = 0; i < functions.rows(); ++i) {
    if (const R size = functions.row(i).norm(); size > 0) functions.row(i) /= size;
  }
  if (m > 0) {  // in an orthonormal basis of what Φq leaves free
    Eigen::ColPivHouseholderQR<Matrix> qr(constraints.transpose());
    qr.setThreshold(R(1e-9));  // as in the rank of a start's constraints
    if (qr.rank() < m) return {};
    const Matrix basis = qr.householderQ() * Matrix::Identity(n, n);
    functions = Matrix(functions * basis.rightCols(n - m));
  }
  const auto freedoms = static_cast<std::size_t>(n - m);
  const auto all = static_cast<std::size_t>(functions.rows());
  std::vector<std::size_t> chosen;
  for (const bool first : {true, false}) {
    const std::size_t begin = first ? 0 : preferred;
    const std::size_t end = first ? preferred : all;
    while (chosen.size() < freedoms) {
      std::size_t largest = end;
      R size(0);
      for (std::size_t c = begin; c < end; ++c) {
        const R left = functions.row(static_cast<Eigen::Index>(c)).norm() * (first ? R(1) : R(weight(c)));
        if (!(left > size)) continue;
        size = left;
        largest = c;
      }
      if (largest == end || !(size > R(first ? 0.02 : 1e-6))) break;
      chosen.push_back(largest);
      const Row direction = functions.row(static_cast<Eigen::Index>(largest)).normalized();
      for (Eigen::Index c = 0; c < functions.rows(); ++c)
        functions.row(c) -= functions.row(c).dot(direction) * direction;
    }
  }
  if (chosen.size() < freedoms) return {};
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace lubjoint

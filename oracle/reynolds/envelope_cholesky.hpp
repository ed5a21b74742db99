/// Direct solution of small sparse symmetric positive definite systems whose rows are short to the left of the
/// diagonal.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace lubjoint::oracle {

/// A = L Lᵀ in envelope (skyline) storage: row i keeps the columns first(i)…i, and L fills nothing outside of them.
/// For grids of a few thousand nodes numbered along their short side this is several times faster than a general sparse
/// factorisation, which spends its time on indices. Storage is kept between uses.
class EnvelopeCholesky {
 public:
  /// Starts an empty matrix.
  void clear();
  /// Appends a row of zeros with columns first…n, n its own number.
  void add_row(int first);
  int size() const { return static_cast<int>(first_.size()); }

  /// A(row, column), first(row) ≤ column ≤ row.
  double& at(int row, int column) { return values_[start_of(row) + static_cast<std::size_t>(column - first(row))]; }

  /// Replaces A by L.
  /// @throws std::runtime_error if A is not positive definite
  void factor();
  /// Replaces the right-hand side by the solution; needs factor().
  void solve(Eigen::VectorXd& x) const;

 private:
  int first(int row) const { return first_[static_cast<std::size_t>(row)]; }
  std::size_t start_of(int row) const { return start_[static_cast<std::size_t>(row)]; }

  std::vector<int> first_;
  std::vector<std::size_t> start_;
  std::vector<double> values_;
};

}  // namespace lubjoint::oracle

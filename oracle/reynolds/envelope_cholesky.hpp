/// Direct solution of small sparse symmetric positive definite systems whose rows are short to the left of the
/// diagonal.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace lubjoint::oracle {

/// A = L Lᵀ in envelope (skyline) storage: row i keeps the columns first(i)…i, and L fills nothing outside of them.
/// Storage is kept between uses.
/// Why not Eigen: the cavitated film factors a new pattern of wet nodes in each of its 10 to 20 steps. Measured side by
/// side (GCC 12, -O3 -DNDEBUG; one force to 0.1 %, L/D 0.5 and 2.04, three motions), with 1000 to 2200 unknowns:
///     ε       this class    SimplicialLLT, natural order    SimplicialLLT, AMD      target
///     0.5     1.4…2.5 ms    6.4…8.1 ms                      9.5…16 ms               5 ms
///     0.95    1.3…6.3 ms    1.9…11 ms                       8.7…23 ms               20 ms
/// The rows are contiguous here, so the inner products vectorise; a general factor spends its time on indices. The
/// strips of the smooth films (40 to 90 unknowns) meet their target with Eigen and use it.
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

#include "oracle/reynolds/envelope_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lubjoint::oracle {

void EnvelopeCholesky::clear() {
  first_.clear();
  start_.clear();
  values_.clear();
}

void EnvelopeCholesky::add_row(int first) {
  const int row = size();
  first_.push_back(first);
  start_.push_back(values_.size());
  values_.resize(values_.size() + static_cast<std::size_t>(row - first + 1), 0.0);
}

void EnvelopeCholesky::factor() {
  for (int i = 0; i < size(); ++i) {
    const int first_i = first(i);
    double* row_i = values_.data() + start_of(i);
    double diagonal = row_i[i - first_i];
    for (int j = first_i; j < i; ++j) {
      const int first_j = first(j);
      const double* row_j = values_.data() + start_of(j);
      const int from = std::max(first_i, first_j);
      double sum = row_i[j - first_i];
      if (j > from) {
        const Eigen::Map<const Eigen::VectorXd> left(row_i + (from - first_i), j - from);
        const Eigen::Map<const Eigen::VectorXd> right(row_j + (from - first_j), j - from);
        sum -= left.dot(right);
      }
      sum *= row_j[j - first_j];  // the diagonal of a finished row holds 1/L(j, j)
      row_i[j - first_i] = sum;
      diagonal -= sum * sum;
    }
    if (!(diagonal > 0)) throw std::runtime_error("the matrix of the finite-length film is not positive definite");
    row_i[i - first_i] = 1 / std::sqrt(diagonal);
  }
}

void EnvelopeCholesky::solve(Eigen::VectorXd& x) const {
  for (int i = 0; i < size(); ++i) {
    const int count = i - first(i);
    const Eigen::Map<const Eigen::VectorXd> row(values_.data() + start_of(i), count + 1);
    x[i] = (x[i] - row.head(count).dot(x.segment(first(i), count))) * row[count];
  }
  for (int i = size() - 1; i >= 0; --i) {
    const int count = i - first(i);
    const Eigen::Map<const Eigen::VectorXd> row(values_.data() + start_of(i), count + 1);
    x[i] *= row[count];
    x.segment(first(i), count) -= x[i] * row.head(count);
  }
}

}  // namespace lubjoint::oracle

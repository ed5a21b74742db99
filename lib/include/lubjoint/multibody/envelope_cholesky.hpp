/// Cholesky factors of a symmetric matrix whose rows begin at known columns.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace lubjoint {

/// Thrown where constraints stop being independent during a run: for an integrator, a step that went too far.
class SingularConstraints : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// LLᵀ by rows inside the envelope, which is found once: a chain costs O(n), a small closed loop as much as a full
/// matrix.
template <class R>
class EnvelopeCholesky {
 public:
  EnvelopeCholesky() = default;

  /// @param first  first column of each row that is not zero, at most the row's own number
  explicit EnvelopeCholesky(std::vector<std::size_t> first) : first_(std::move(first)), start_(first_.size() + 1) {
    for (std::size_t i = 0; i < first_.size(); ++i) start_[i + 1] = start_[i] + (i + 1 - first_[i]);
    entries_.resize(start_.back());
  }

  std::size_t size() const { return first_.size(); }      ///< rows
  std::size_t stored() const { return entries_.size(); }  ///< numbers inside the envelope
  /// All entries of the envelope.
  void set_zero() { std::fill(entries_.begin(), entries_.end(), R(0)); }

  /// Entry of the lower triangle, inside the envelope.
  R& operator()(std::size_t row, std::size_t column) { return entries_[origin(row) + column]; }

  /// @throws SingularConstraints if the matrix is not positive definite to rounding
  void factorise() {
    using std::sqrt;
    least_share_ = R(1);
    least_row_ = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const std::size_t row = origin(i);
      for (std::size_t j = first_[i]; j < i; ++j) {
        const std::size_t other = origin(j);
        R sum = entries_[row + j];
        for (std::size_t k = std::max(first_[i], first_[j]); k < j; ++k) sum -= entries_[row + k] * entries_[other + k];
        entries_[row + j] = sum * entries_[other + j];
      }
      const R before = entries_[row + i];
      R sum = before;
      for (std::size_t k = first_[i]; k < i; ++k) sum -= entries_[row + k] * entries_[row + k];
      if (!(sum > before * least_share_)) {
        least_share_ = before > 0 ? R(sum / before) : R(0);
        least_row_ = i;
      }
      if (!(sum > before * 64 * std::numeric_limits<R>::epsilon())) {
        throw SingularConstraints("the constraints are not independent at this position");
      }
      entries_[row + i] =
          1 / sqrt(sum);  // the diagonal is kept inverted: divisions are what a small factorisation waits for
    }
  }

  /// The least share of a diagonal entry that its row left over: sin² of a row's angle to those before it, 0 where the
  /// matrix is singular. Of the last factorisation, which may have thrown.
  const R& least_share() const { return least_share_; }
  std::size_t least_row() const { return least_row_; }  ///< whose that is

  /// Overwrites b by the solution. V: R, or a vector of right-hand sides.
  template <class V>
  void solve(V* b) const {
    for (std::size_t i = 0; i < size(); ++i) {
      const std::size_t row = origin(i);
      for (std::size_t k = first_[i]; k < i; ++k) b[i] -= entries_[row + k] * b[k];
      b[i] *= entries_[row + i];
    }
    for (std::size_t i = size(); i-- > 0;) {
      const std::size_t row = origin(i);
      b[i] *= entries_[row + i];
      for (std::size_t k = first_[i]; k < i; ++k) b[k] -= entries_[row + k] * b[i];
    }
  }

 private:
  /// Where column 0 of a row would be; unsigned, so that the difference may wrap.
  std::size_t origin(std::size_t row) const { return start_[row] - first_[row]; }

  std::vector<std::size_t> first_;
  std::vector<std::size_t> start_{0};
  std::vector<R> entries_;
  R least_share_ = R(1);
  std::size_t least_row_ = 0;
};

}  // namespace lubjoint

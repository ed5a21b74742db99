/// LU factors of a small sparse matrix whose pivots, their order and the list of operations are found once.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace lubjoint {

/// Factors of square matrices that share their places of zeros and suit the same pivots: of equations of motion along a
/// path, whose elements change and whose structure does not. The search costs O(n³); a factorisation and a
/// solution go through their lists and touch no zero. No pivot is looked for while factorising: the caller watches
/// the inverse pivots and searches again when they get small. The numbers are the caller's: elements where he has them,
/// fill behind them.
template <class R>
class ListedLu {
 public:
  using Number = std::uint32_t;  ///< of a row, a column or a place

  /// Finds an order of pivots, each at least a fifth of the largest element that is left, with the least fill.
  /// @param a  row by row, all elements of a size that compares
  /// @param places  where the caller keeps each element that may ever differ from zero, row by row; none: it never does
  /// @param first_free  from where on fill may be kept
  /// @returns false if the rows are dependent to 1e-9 of the largest element
  bool find_order(std::size_t n, std::vector<R> a, const std::vector<Number>& places, std::size_t first_free) {
    using std::abs;
    n_ = n;
    std::vector<unsigned char> pattern(n * n), row_taken(n, 0), column_taken(n, 0);
    for (std::size_t i = 0; i < n * n; ++i) pattern[i] = places[i] != none;
    std::vector<std::size_t> in_row(n), in_column(n);  // elements that are left
    pivot_rows_.clear();
    pivot_columns_.clear();
    const auto at = [n](std::size_t i, std::size_t j) { return i * n + j; };
    for (std::size_t step = 0; step < n; ++step) {
      R largest(0);
      std::fill(in_row.begin(), in_row.end(), 0);
      std::fill(in_column.begin(), in_column.end(), 0);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
          if (row_taken[i] || column_taken[j]) continue;
          largest = std::max<R>(largest, abs(a[at(i, j)]));
          in_row[i] += pattern[at(i, j)];
          in_column[j] += pattern[at(i, j)];
        }
      }
      if (!(largest > R(1e-9))) return false;
      std::size_t best = std::numeric_limits<std::size_t>::max(), best_row = 0, best_column = 0;
      R best_size(0);
      for (std::size_t i = 0; i < n; ++i) {
        if (row_taken[i]) continue;
        for (std::size_t j = 0; j < n; ++j) {
          const R size = abs(a[at(i, j)]);
          if (column_taken[j] || !(size >= largest / 5)) continue;
          const std::size_t fill = (in_row[i] - 1) * (in_column[j] - 1);
          if (fill < best || (fill == best && size > best_size)) {
            best = fill;
            best_row = i;
            best_column = j;
            best_size = size;
          }
        }
      }
      row_taken[best_row] = column_taken[best_column] = 1;
      pivot_rows_.push_back(static_cast<Number>(best_row));
      pivot_columns_.push_back(static_cast<Number>(best_column));
      for (std::size_t i = 0; i < n; ++i) {
        if (row_taken[i] || !pattern[at(i, best_column)]) continue;
        const R factor = a[at(i, best_column)] / a[at(best_row, best_column)];
        for (std::size_t j = 0; j < n; ++j) {
          if (column_taken[j] || !pattern[at(best_row, j)]) continue;
          a[at(i, j)] -= factor * a[at(best_row, j)];
          pattern[at(i, j)] = 1;
        }
      }
    }
    list_operations(places, first_free);
    return true;
  }

  static constexpr Number none = std::numeric_limits<Number>::max();  ///< in place of a place

  std::size_t size() const { return n_; }  ///< n

  /// How many numbers the caller keeps: his own, and fill.
  std::size_t storage() const { return storage_; }

  /// Replaces the elements by the factors: L without its ones, U with the inverses of the pivots.
  void factorise(R* values) const {
    for (const Number place : fill_) values[place] = R(0);
    for (const Pivot& each : pivots_) {
      const R inverse = 1 / values[each.place];
      values[each.place] = inverse;
      for (const RowBelow* row = rows_below_.data() + each.rows_begin; row != rows_below_.data() + each.rows_end;
           ++row) {
        const R factor = values[row->place] * inverse;
        values[row->place] = factor;
        for (const Update* u = updates_.data() + row->begin; u != updates_.data() + row->end; ++u)
          values[u->target] -= factor * values[u->source];
      }
    }
  }

  /// 1/(the k-th pivot) of the factors.
  const R& inverse_pivot(std::size_t k, const R* values) const { return values[pivots_[k].place]; }

  /// Solves A x = b. V: R, or several right-hand sides at once.
  /// @param work  n of them
  template <class V>
  void solve(const R* values, const V* b, V* x, V* work) const {
    const Number* row = pivot_rows_.data();
    for (std::size_t k = 0; k < n_; ++k) work[k] = b[row[k]];
    for (const Element& each : lower_) work[each.row] -= values[each.place] * work[each.column];
    const Element* next = upper_.data();
    for (const LastRow& each : last_rows_) {
      V sum = work[each.pivot];
      for (const Element* end = upper_.data() + each.end; next < end; ++next)
        sum -= values[next->place] * work[next->column];
      sum *= values[each.place];
      work[each.pivot] = sum;
      x[each.column] = sum;
    }
  }

  /// Solves Aᵀ x = b.
  /// @param work  n of them
  template <class V>
  void solve_transposed(const R* values, const V* b, V* x, V* work) const {
    for (std::size_t k = 0; k < n_; ++k) work[k] = b[pivot_columns_[k]];
    // Elements right of a pivot stand by falling rows: from the last to the first they rise.
    std::size_t next = upper_.size();
    for (std::size_t k = 0; k < n_; ++k) {
      work[k] *= values[pivots_[k].place];
      for (; next > 0 && upper_[next - 1].row == k; --next)
        work[upper_[next - 1].column] -= values[upper_[next - 1].place] * work[k];
    }
    for (std::size_t i = lower_.size(); i-- > 0;)
      work[lower_[i].column] -= values[lower_[i].place] * work[lower_[i].row];
    for (std::size_t k = 0; k < n_; ++k) x[pivot_rows_[k]] = work[k];
  }

 private:
  /// A pivot and the rows below it that have an element in its column.
  struct Pivot {
    Number place, rows_begin, rows_end;
  };
  /// One of these, and what its elimination changes in it.
  struct RowBelow {
    Number place, begin, end;
  };
  struct Update {
    Number target, source;
  };
  struct Element {
    Number row, column, place;
  };
  /// A row of U, from the last: its pivot's number and place, its column in A, and the end of its elements.
  struct LastRow {
    Number pivot, place, column, end;
  };

  /// Of the elimination in the order of the pivots.
  void list_operations(const std::vector<Number>& places, std::size_t first_free) {
    std::vector<Number> taken(n_ * n_, none);  // by order of pivots
    auto next = static_cast<Number>(first_free);
    const auto at = [&](std::size_t i, std::size_t j) -> Number& { return taken[i * n_ + j]; };
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < n_; ++j) at(i, j) = places[pivot_rows_[i] * n_ + pivot_columns_[j]];
    }
    pivots_.clear();
    rows_below_.clear();
    updates_.clear();
    lower_.clear();
    fill_.clear();
    for (std::size_t k = 0; k < n_; ++k) {
      Pivot pivot{at(k, k), static_cast<Number>(rows_below_.size()), 0};
      for (std::size_t i = k + 1; i < n_; ++i) {
        if (at(i, k) == none) continue;
        RowBelow row{at(i, k), static_cast<Number>(updates_.size()), 0};
        lower_.push_back({static_cast<Number>(i), static_cast<Number>(k), at(i, k)});
        for (std::size_t j = k + 1; j < n_; ++j) {
          if (at(k, j) == none) continue;
          if (at(i, j) == none) fill_.push_back(at(i, j) = next++);
          updates_.push_back({at(i, j), at(k, j)});
        }
        row.end = static_cast<Number>(updates_.size());
        rows_below_.push_back(row);
      }
      pivot.rows_end = static_cast<Number>(rows_below_.size());
      pivots_.push_back(pivot);
    }
    storage_ = next;
    upper_.clear();
    last_rows_.clear();
    for (std::size_t k = n_; k-- > 0;) {
      for (std::size_t j = k + 1; j < n_; ++j) {
        if (at(k, j) != none) upper_.push_back({static_cast<Number>(k), static_cast<Number>(j), at(k, j)});
      }
      last_rows_.push_back({static_cast<Number>(k), at(k, k), pivot_columns_[k], static_cast<Number>(upper_.size())});
    }
  }

  std::size_t n_ = 0;
  std::size_t storage_ = 0;
  std::vector<Number> pivot_rows_, pivot_columns_;
  std::vector<Number> fill_;   ///< places that elimination fills
  std::vector<Pivot> pivots_;  ///< in their order
  std::vector<RowBelow> rows_below_;
  std::vector<Update> updates_;
  std::vector<Element> lower_;  ///< column by column
  std::vector<Element> upper_;  ///< row by row, from the last
  std::vector<LastRow> last_rows_;
};

}  // namespace lubjoint

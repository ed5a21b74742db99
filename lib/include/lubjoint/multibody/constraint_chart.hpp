/// Coordinates that the constraints leave free, and how the others follow from them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lubjoint/multibody/planar_system.hpp"

namespace lubjoint {

/// A choice of independent coordinates, and factors of the dependent columns Φ_d of Φq. Pivots, their order and the list
/// of operations are found once for a chart; Φ_d of other positions is then factorised by going through the list. Only
/// what can differ from zero is in it: columns of bodies in their mechanism are nearly triangular.
template <class R>
class ConstraintChart {
 public:
  /// @param units  of the coordinates, in which their columns are comparable: one for every coordinate
  ConstraintChart(const PlanarSystem<R>& system, std::vector<R> units)
      : system_(system), units_(std::move(units)), rows_(system.constraint_rows()), columns_(system.coordinates()) {
    find_pattern();
  }

  /// Chooses at the rows of an evaluated workspace, by pivots that are at least a fifth of the largest that is left and
  /// leave the fewest new elements.
  /// @returns false where the constraints don't determine any such choice
  bool choose(const std::vector<ConstraintRow<R>>& rows) {
    using std::abs;
    std::vector<R> a = scattered(rows);
    std::vector<bool> pattern = pattern_;
    for (std::size_t i = 0; i < rows_; ++i) {
      for (std::size_t j = 0; j < columns_; ++j) a[at(i, j)] *= units_[j];
    }
    std::vector<bool> row_taken(rows_, false);
    std::vector<bool> column_taken(columns_, false);
    pivot_rows_.clear();
    dependent_.clear();
    R first(0);
    for (std::size_t step = 0; step < rows_; ++step) {
      // Rows have units of their own: an element counts by its share of its row.
      R largest(0);
      std::vector<R> row_size(rows_, R(0));
      const std::vector<R>& now = a;
      for (std::size_t i = 0; i < rows_; ++i) {
        if (row_taken[i]) continue;
        for (std::size_t j = 0; j < columns_; ++j) {
          if (!column_taken[j]) row_size[i] = std::max<R>(row_size[i], abs(now[at(i, j)]));
        }
        if (row_size[i] / row_scale(rows, i) > largest) largest = row_size[i] / row_scale(rows, i);
      }
      if (!(largest > R(1e-9))) return false;
      std::size_t best = std::numeric_limits<std::size_t>::max();
      std::size_t best_row = 0;
      std::size_t best_column = 0;
      R best_size(0);
      for (std::size_t i = 0; i < rows_; ++i) {
        if (row_taken[i]) continue;
        for (std::size_t j = 0; j < columns_; ++j) {
          if (column_taken[j]) continue;
          const R size = abs(now[at(i, j)]) / row_scale(rows, i);
          if (!(size >= largest / 5)) continue;
          const std::size_t fill = (count_row(pattern, i, column_taken) - 1) * (count_column(pattern, j, row_taken) - 1);
          if (fill < best || (fill == best && size > best_size)) {
            best = fill;
            best_row = i;
            best_column = j;
            best_size = size;
          }
        }
      }
      if (step == 0) first = best_size;
      row_taken[best_row] = true;
      column_taken[best_column] = true;
      pivot_rows_.push_back(best_row);
      dependent_.push_back(best_column);
      for (std::size_t i = 0; i < rows_; ++i) {
        if (row_taken[i] || !pattern[at(i, best_column)]) continue;
        const R factor = a[at(i, best_column)] / a[at(best_row, best_column)];
        for (std::size_t j = 0; j < columns_; ++j) {
          if (column_taken[j] || !pattern[at(best_row, j)]) continue;
          a[at(i, j)] -= factor * a[at(best_row, j)];
          pattern[at(i, j)] = true;
        }
      }
    }
    independent_.clear();
    for (std::size_t j = 0; j < columns_; ++j) {
      if (!column_taken[j]) independent_.push_back(j);
    }
    list_operations();
    factorise(rows);
    chosen_pivots_.resize(rows_);
    for (std::size_t k = 0; k < rows_; ++k) chosen_pivots_[k] = abs(lu_[diagonal_[k]]);
    return true;
  }

  bool is_chosen() const { return !dependent_.empty() || rows_ == 0; }                ///< has a choice been made?
  const std::vector<std::size_t>& independent() const { return independent_; }        ///< coordinates, in their order
  const std::vector<std::size_t>& dependent() const { return dependent_; }            ///< in the order of the pivots

  /// Factors of Φ_d of the rows of an evaluated workspace.
  void factorise(const std::vector<ConstraintRow<R>>& rows) {
    std::fill(lu_.begin(), lu_.end(), R(0));
    for (const Entry& each : entries_) {
      const std::array<R, 3>& columns = each.second ? rows[each.row].second : rows[each.row].first;
      lu_[each.target] += columns[each.column];
    }
    for (const Operation& each : operations_) {
      if (each.divides) {
        lu_[each.target] /= lu_[each.pivot];
      } else {
        lu_[each.target] -= lu_[each.left] * lu_[each.pivot];
      }
    }
  }

  /// How much smaller than when they were chosen the pivots have become: 1 for a fresh chart, 0 where it ends.
  R wear() const {
    using std::abs;
    R least(1);
    for (std::size_t k = 0; k < rows_; ++k) least = std::min<R>(least, abs(lu_[diagonal_[k]]) / chosen_pivots_[k]);
    return least;
  }

  /// Solves Φ_d x = b. b is by rows; x takes its place by pivots: x[k] is of coordinate dependent()[k].
  /// V: R, or its derivatives.
  template <class V>
  void solve(const V* b, V* x) const {
    for (std::size_t k = 0; k < rows_; ++k) x[k] = b[pivot_rows_[k]];
    for (const Element& each : lower_) x[each.row] -= lu_[each.place] * x[each.column];
    std::size_t next = 0;
    for (std::size_t k = rows_; k-- > 0;) {
      for (; next < upper_.size() && upper_[next].row == k; ++next) x[k] -= lu_[upper_[next].place] * x[upper_[next].column];
      x[k] /= lu_[diagonal_[k]];
    }
  }

  /// Solves Φ_dᵀ x = b, b by pivots (of coordinate dependent()[k]); x by rows.
  void solve_transposed(const R* b, R* x) const {
    work_.assign(b, b + rows_);
    // Uᵀ, then Lᵀ: the same elements by columns.
    for (std::size_t k = 0; k < rows_; ++k) {
      work_[k] /= lu_[diagonal_[k]];
      for (const std::size_t e : upper_of_row_[k]) work_[upper_[e].column] -= lu_[upper_[e].place] * work_[k];
    }
    for (std::size_t e = lower_.size(); e-- > 0;) work_[lower_[e].column] -= lu_[lower_[e].place] * work_[lower_[e].row];
    for (std::size_t k = 0; k < rows_; ++k) x[pivot_rows_[k]] = work_[k];
  }

 private:
  struct Entry {
    std::size_t row;
    bool second;
    std::size_t column;  // 0, 1, 2
    std::size_t target;
  };
  struct Operation {
    bool divides;
    std::size_t target, left, pivot;
  };
  struct Element {
    std::size_t row, column, place;
  };

  std::size_t at(std::size_t row, std::size_t column) const { return row * columns_ + column; }

  template <class Put>
  void for_each_entry(const Put& put) const {
    for (std::size_t row = 0; row < rows_; ++row) {
      for (const bool second : {false, true}) {
        const std::size_t body = second ? system_.second_body_of_row(row) : system_.first_body_of_row(row);
        if (body == ground_body) continue;
        for (std::size_t k = 0; k < 3; ++k) put(row, second, k, 3 * body + k);
      }
    }
  }

  std::vector<R> scattered(const std::vector<ConstraintRow<R>>& rows) const {
    std::vector<R> a(rows_ * columns_, R(0));
    for_each_entry([&](std::size_t row, bool second, std::size_t k, std::size_t column) {
      a[at(row, column)] += (second ? rows[row].second : rows[row].first)[k];
    });
    return a;
  }

  R row_scale(const std::vector<ConstraintRow<R>>& rows, std::size_t row) const {
    using std::abs;
    R scale(0);
    for (const bool second : {false, true}) {
      const std::size_t body = second ? system_.second_body_of_row(row) : system_.first_body_of_row(row);
      if (body == ground_body) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        scale = std::max<R>(scale, abs((second ? rows[row].second : rows[row].first)[k]) * units_[3 * body + k]);
      }
    }
    return scale > 0 ? scale : R(1);
  }

  /// Elements that are zero wherever the bodies are: those that are zero at two places without any symmetry.
  void find_pattern() {
    pattern_.assign(rows_ * columns_, false);
    SystemWorkspace<R> w = system_.template workspace<R>();
    std::vector<R> y(2 * columns_);
    for (const double seed : {0.37, 1.91}) {
      for (std::size_t i = 0; i < y.size(); ++i) y[i] = R(std::sin(seed + 1.7 * static_cast<double>(i * i + i)));
      system_.evaluate_kinematics(R(0), y.data(), w);
      const std::vector<R> a = scattered(w.rows);
      for (std::size_t i = 0; i < a.size(); ++i) pattern_[i] = pattern_[i] || a[i] != 0;
    }
  }

  std::size_t count_row(const std::vector<bool>& pattern, std::size_t row, const std::vector<bool>& taken) const {
    std::size_t count = 0;
    for (std::size_t j = 0; j < columns_; ++j) count += !taken[j] && pattern[at(row, j)];
    return count;
  }
  std::size_t count_column(const std::vector<bool>& pattern, std::size_t column, const std::vector<bool>& taken) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rows_; ++i) count += !taken[i] && pattern[at(i, column)];
    return count;
  }

  /// Of the elimination in the order of the pivots.
  void list_operations() {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> place(rows_ * rows_, none);
    std::vector<std::size_t> order(columns_, none);  // of a dependent column
    std::size_t count = 0;
    for (std::size_t k = 0; k < rows_; ++k) order[dependent_[k]] = k;
    std::vector<std::size_t> row_order(rows_);
    for (std::size_t k = 0; k < rows_; ++k) row_order[pivot_rows_[k]] = k;
    const auto taken = [&](std::size_t i, std::size_t j) -> std::size_t& { return place[i * rows_ + j]; };
    for (std::size_t i = 0; i < rows_; ++i) {
      for (std::size_t j = 0; j < rows_; ++j) {
        if (pattern_[at(pivot_rows_[i], dependent_[j])]) taken(i, j) = count++;
      }
    }
    operations_.clear();
    for (std::size_t k = 0; k < rows_; ++k) {
      for (std::size_t i = k + 1; i < rows_; ++i) {
        if (taken(i, k) == none) continue;
        operations_.push_back({true, taken(i, k), 0, taken(k, k)});
        for (std::size_t j = k + 1; j < rows_; ++j) {
          if (taken(k, j) == none) continue;
          if (taken(i, j) == none) taken(i, j) = count++;
          operations_.push_back({false, taken(i, j), taken(i, k), taken(k, j)});
        }
      }
    }
    lu_.assign(count, R(0));
    diagonal_.resize(rows_);
    lower_.clear();
    upper_.clear();
    upper_of_row_.assign(rows_, {});
    for (std::size_t k = 0; k < rows_; ++k) {
      diagonal_[k] = taken(k, k);
      for (std::size_t j = 0; j < k; ++j) {
        if (taken(k, j) != none) lower_.push_back({k, j, taken(k, j)});
      }
    }
    for (std::size_t k = rows_; k-- > 0;) {
      for (std::size_t j = k + 1; j < rows_; ++j) {
        if (taken(k, j) == none) continue;
        upper_of_row_[k].push_back(upper_.size());
        upper_.push_back({k, j, taken(k, j)});
      }
    }
    entries_.clear();
    for_each_entry([&](std::size_t row, bool second, std::size_t k, std::size_t column) {
      if (order[column] == none || !pattern_[at(row, column)]) return;
      entries_.push_back({row, second, k, taken(row_order[row], order[column])});
    });
  }

  const PlanarSystem<R>& system_;
  std::vector<R> units_;
  std::size_t rows_;
  std::size_t columns_;
  std::vector<bool> pattern_;  ///< of Φq: what may differ from zero
  std::vector<std::size_t> pivot_rows_, dependent_, independent_;
  std::vector<R> lu_;
  std::vector<Entry> entries_;
  std::vector<Operation> operations_;
  std::vector<Element> lower_, upper_;
  std::vector<std::vector<std::size_t>> upper_of_row_;
  std::vector<std::size_t> diagonal_;
  std::vector<R> chosen_pivots_;
  mutable std::vector<R> work_;
};

}  // namespace lubjoint

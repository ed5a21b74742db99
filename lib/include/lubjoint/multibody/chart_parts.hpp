/// The Jacobian of a chart of coordinates, of which the time alone prescribes a part.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "lubjoint/multibody/listed_lu.hpp"
#include "lubjoint/multibody/planar_system.hpp"

namespace lubjoint {

/// Bodies of a row of A; each may be the ground.
struct RowSides {
  std::size_t first;   ///< i
  std::size_t second;  ///< j
};

/// Calls visit(row, second, k, column) for the k-th derivative of each row by each of its bodies.
template <class Visit>
void for_each_element(const std::vector<RowSides>& sides, const Visit& visit) {
  for (std::size_t row = 0; row < sides.size(); ++row) {
    for (const bool second : {false, true}) {
      const std::size_t body = second ? sides[row].second : sides[row].first;
      if (body == ground_body) continue;
      for (std::size_t k = 0; k < 3; ++k) visit(row, second, k, 3 * body + k);
    }
  }
}

/// A = [Φq; C] of constraints and functions of a chart in coordinates that the time alone prescribes, such as those of
/// a crank that is driven, and in the others, which are free:
///   A = [P 0; K F],
/// P of constraints of prescribed coordinates alone. It is factorised in the order that was found when it was divided.
/// Its numbers at a place, and its factors, are the caller's, as many for each part as its lu.storage() says.
template <class R>
class ChartParts {
  using Number = typename ListedLu<R>::Number;

 public:
  /// The prescribed coordinates, or the free ones, with their rows of A.
  struct Part {
    std::vector<std::size_t> rows;         ///< of constraints, then of the functions, which are all free
    std::vector<std::size_t> columns;      ///< numbers of the coordinates, as many
    std::vector<std::size_t> constraints;  ///< that have a row here
    std::vector<std::size_t> bodies;       ///< that have a coordinate here
    ListedLu<R> lu;                        ///< of the rows and columns as counted here
    std::vector<R> first_inverse_pivots;   ///< when it was chosen

    std::size_t size() const { return rows.size(); }  ///< of rows, and of columns
  };
  /// What is kept of A at a place: of each part's rows, and its factors.
  struct Numbers {
    const R* prescribed;  ///< P
    const R* free;        ///< K and F
  };

  const Part& prescribed() const { return prescribed_; }  ///< may be empty
  const Part& free() const { return free_; }              ///< the others
  /// Is a row of A one of this part?
  bool is_in(const Part& part, std::size_t row) const { return (is_prescribed_[row] != 0) == (&part == &prescribed_); }
  /// Its number in its part.
  std::size_t place_in_part(std::size_t row) const { return place_in_part_[row]; }

  /// Prescribed are the coordinates that no function moves, if constraints of these alone are as many.
  /// @param sides  of every row of A;  @param may_differ  which of its elements may ever differ from zero, row by row
  /// @param moved  which coordinates a function may move: more than do is slower, fewer are found out
  void divide(const PlanarSystem<R>& system, const std::vector<RowSides>& sides, const std::vector<bool>& may_differ,
              std::vector<bool> moved) {
    n_ = sides.size();
    sides_ = sides;
    const auto is_of_prescribed = [&](std::size_t row) {
      for (std::size_t j = 0; j < n_; ++j) {
        if (may_differ[row * n_ + j] && moved[j]) return false;
      }
      return row < system.constraint_rows();
    };
    is_prescribed_.assign(n_, 0);
    for (std::size_t i = 0; i < n_; ++i) is_prescribed_[i] = is_of_prescribed(i);
    if (std::count(is_prescribed_.begin(), is_prescribed_.end(), 1) != std::count(moved.begin(), moved.end(), false)) {
      moved.assign(n_, true);
      is_prescribed_.assign(n_, 0);
    }
    place_in_part_.assign(n_, 0);
    for (Part* part : {&prescribed_, &free_}) {
      *part = Part();
      const auto add_once = [](std::vector<std::size_t>& to, std::size_t number) {
        if (to.empty() || to.back() != number) to.push_back(number);
      };
      for (std::size_t i = 0; i < n_; ++i) {
        if (!is_in(*part, i)) continue;
        place_in_part_[i] = part->rows.size();
        part->rows.push_back(i);
      }
      for (std::size_t j = 0; j < n_; ++j) {
        if (moved[j] != (part == &free_)) continue;
        part->columns.push_back(j);
        add_once(part->bodies, j / 3);
      }
      for (std::size_t c = 0; c < system.constraints().size(); ++c) {
        for (std::size_t row = system.first_row(c); row < system.first_row(c + 1); ++row) {
          if (is_in(*part, row)) add_once(part->constraints, c);
        }
      }
    }
    coupling_.clear();
    for_each_element(sides_, [&](std::size_t row, bool second, std::size_t k, std::size_t column) {
      if (is_prescribed_[row] || moved[column] || !may_differ[row * n_ + column]) return;
      const auto found = std::find(prescribed_.columns.begin(), prescribed_.columns.end(), column);
      coupling_.push_back({static_cast<Number>(place_in_part_[row]),
                           static_cast<Number>(found - prescribed_.columns.begin()),
                           number_of(place_in_part_[row], second, k)});
    });
  }

  /// Finds the order of pivots of both parts. @param a  all of A, row by row, of a size that compares
  /// @param rows  of A, in their units. @returns false where they are not independent
  bool start(const std::vector<R>& a, const std::vector<bool>& may_differ, const std::vector<ConstraintRow<R>>& rows) {
    return start(prescribed_, a, may_differ, rows) && start(free_, a, may_differ, rows);
  }

  /// Takes a row of A, by its number in its part.
  static void put(std::size_t row, const ConstraintRow<R>& from, R* numbers) {
    R* of_row = numbers + row * row_numbers;
    of_row[0] = from.value;
    of_row[1] = from.time_rate;
    for (std::size_t k = 0; k < 3; ++k) {
      of_row[first_derivative + k] = from.first[k];
      of_row[first_derivative + 3 + k] = from.second[k];
    }
  }
  /// Of a row: Φ or z.
  static const R& value(std::size_t row, const R* numbers) { return numbers[row * row_numbers]; }
  /// Φt
  static const R& time_rate(std::size_t row, const R* numbers) { return numbers[row * row_numbers + 1]; }

  /// Calls visit(row, column, value) for each element of K, counted in the parts.
  template <class Visit>
  void for_each_coupling(const R* numbers, const Visit& visit) const {
    for (const Coupling& each : coupling_) visit(each.row, each.column, numbers[each.place]);
  }

  /// Solves A x = b. V: R, or several right-hand sides at once.
  /// @param b  of the constraints' rows, then of the functions;  @param work  three times as many
  template <class V>
  void solve(const Numbers& numbers, const V* b, V* x, V* work) const {
    V* const right = work;
    V* const found = work + n_;
    V* const rest = work + 2 * n_;
    for (std::size_t i = 0; i < prescribed_.size(); ++i) right[i] = b[prescribed_.rows[i]];
    prescribed_.lu.solve(numbers.prescribed, right, found, rest);
    for (std::size_t i = 0; i < prescribed_.size(); ++i) x[prescribed_.columns[i]] = found[i];
    for (std::size_t i = 0; i < free_.size(); ++i) right[i] = b[free_.rows[i]];
    for_each_coupling(numbers.free,
                      [&](auto row, auto column, const R& k) { right[row] -= k * x[prescribed_.columns[column]]; });
    free_.lu.solve(numbers.free, right, found, rest);
    for (std::size_t i = 0; i < free_.size(); ++i) x[free_.columns[i]] = found[i];
  }
  /// Solves Aᵀ x = b.
  template <class V>
  void solve_transposed(const Numbers& numbers, const V* b, V* x, V* work) const {
    V* const right = work;
    V* const found = work + n_;
    V* const rest = work + 2 * n_;
    for (std::size_t i = 0; i < free_.size(); ++i) right[i] = b[free_.columns[i]];
    free_.lu.solve_transposed(numbers.free, right, found, rest);
    for (std::size_t i = 0; i < free_.size(); ++i) x[free_.rows[i]] = found[i];
    for (std::size_t i = 0; i < prescribed_.size(); ++i) right[i] = b[prescribed_.columns[i]];
    for_each_coupling(numbers.free,
                      [&](auto row, auto column, const R& k) { right[column] -= k * x[free_.rows[row]]; });
    prescribed_.lu.solve_transposed(numbers.prescribed, right, found, rest);
    for (std::size_t i = 0; i < prescribed_.size(); ++i) x[prescribed_.rows[i]] = found[i];
  }

  /// How much smaller than when they were chosen the pivots have become: 1 for a fresh chart, 0 where it ends.
  R wear(const Numbers& numbers) const {
    R most(1);
    const auto look_at = [&most](const Part& part, const R* values) {
      for (std::size_t k = 0; k < part.size(); ++k)
        most = std::max<R>(most, size_of(part.lu.inverse_pivot(k, values)) / part.first_inverse_pivots[k]);
    };
    look_at(prescribed_, numbers.prescribed);
    look_at(free_, numbers.free);
    return 1 / most;
  }

 private:
  /// An element of K.
  struct Coupling {
    Number row, column, place;
  };
  /// A row among the numbers: value, time rate, derivatives of the first body, of the second, which factors replace.
  static constexpr std::size_t row_numbers = 8;
  static constexpr std::size_t first_derivative = 2;

  static R size_of(const R& x) { return x < 0 ? R(-x) : x; }

  static Number number_of(std::size_t row_in_part, bool second, std::size_t k) {
    return static_cast<Number>(row_in_part * row_numbers + first_derivative + (second ? 3 : 0) + k);
  }

  bool start(Part& part, const std::vector<R>& a, const std::vector<bool>& may_differ,
             const std::vector<ConstraintRow<R>>& rows) const {
    const std::size_t n = part.size();
    std::vector<R> elements(n * n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) elements[i * n + j] = a[part.rows[i] * n_ + part.columns[j]];
    }
    std::vector<Number> places(n * n, ListedLu<R>::none);
    for_each_element(sides_, [&](std::size_t row, bool second, std::size_t k, std::size_t column) {
      if (!is_in(part, row) || !may_differ[row * n_ + column]) return;
      const auto found = std::find(part.columns.begin(), part.columns.end(), column);
      if (found == part.columns.end()) return;
      const std::size_t i = place_in_part_[row];
      places[i * n + static_cast<std::size_t>(found - part.columns.begin())] = number_of(i, second, k);
    });
    if (!part.lu.find_order(n, std::move(elements), places, n * row_numbers)) return false;
    std::vector<R> numbers(part.lu.storage(), R(0));
    for (std::size_t i = 0; i < n; ++i) put(i, rows[part.rows[i]], numbers.data());
    part.lu.factorise(numbers.data());
    part.first_inverse_pivots.resize(n);
    for (std::size_t k = 0; k < n; ++k)
      part.first_inverse_pivots[k] = size_of(part.lu.inverse_pivot(k, numbers.data()));
    return true;
  }

  std::size_t n_ = 0;
  std::vector<RowSides> sides_;
  Part prescribed_, free_;
  std::vector<unsigned char> is_prescribed_;  ///< of every row of A: 1 or 0
  std::vector<std::size_t> place_in_part_;    ///< likewise
  std::vector<Coupling> coupling_;            ///< K
};

}  // namespace lubjoint

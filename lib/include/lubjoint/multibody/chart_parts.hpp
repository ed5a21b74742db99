/// The Jacobian of a chart, of which the time alone prescribes a part.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "lubjoint/multibody/listed_lu.hpp"
#include "lubjoint/multibody/planar_body.hpp"

namespace lubjoint {

/// Bodies of a row of A; each may be the ground.
struct RowSides {
  std::size_t first;   ///< i
  std::size_t second;  ///< j
};

/// A = [Φ_v; C_v] of constraints and functions of a chart, by the velocities v of bodies (in the plane q̇) of which the
/// time alone prescribes some, such as those of a crank that is driven, and by the others, which are free:
///   A = [P 0; K F],
/// P of constraints of prescribed velocities alone. It is factorised in the order that was found when it was divided.
/// Its numbers at a place, and its factors, are the caller's, as many for each part as its lu.storage() says.
/// @tparam Width  velocities of a body: 3 in the plane, or 6. Of six, the last three are of turns, which don't add: all
///                are prescribed, or none.
template <class R, std::size_t Width>
class ChartParts {
  using Number = typename ListedLu<R>::Number;

 public:
  using Matrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  ///< A, or one of its size

  /// The prescribed velocities, or the free ones, with their rows of A.
  struct Part {
    std::vector<std::size_t> rows;         ///< of constraints, then of the functions, which are all free
    std::vector<std::size_t> columns;      ///< numbers of the velocities, as many, in rising order
    std::vector<std::size_t> components;   ///< of their bodies' velocities, which they are: of x, y, ...
    std::vector<std::size_t> constraints;  ///< that have a row here
    std::vector<std::size_t> bodies;       ///< that have a velocity here, in rising order
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

  /// Divides A, and finds the order of pivots of both parts: prescribed are the velocities that no function moves, if
  /// constraints of these alone are as many.
  /// @param sides  of every row of A;  @param constraints  the constraint of each of its first rows, in rising order
  /// @param rows  of A where it is divided;  @param units  in which the velocities are comparable
  /// @param at_odd_places  at_odd_places(look) calls look(rows) at places without any symmetry, where what vanishes
  /// does
  ///                       so everywhere
  /// @returns false where the rows are not independent
  template <class Row, class AtOddPlaces>
  bool find(std::vector<RowSides> sides, const std::vector<std::size_t>& constraints, const std::vector<Row>& rows,
            const std::vector<R>& units, const AtOddPlaces& at_odd_places) {
    n_ = rows.size();
    sides_ = std::move(sides);
    may_differ_.assign(n_ * n_, false);
    std::vector<bool> moved(n_, false);
    at_odd_places([&](const std::vector<Row>& odd) {
      const Matrix there = matrix(odd);
      for (std::size_t i = 0; i < n_; ++i) {
        const R rounding = R(1e-13) * there.row(index(i)).cwiseAbs().maxCoeff();  // what turned axes leave of a zero
        for (std::size_t j = 0; j < n_; ++j)
          may_differ_[i * n_ + j] = may_differ_[i * n_ + j] || size_of(there(index(i), index(j))) > rounding;
      }
      add_moved(there, constraints.size(), moved);
    });
    divide(constraints, may_differ_, std::move(moved));
    return find_order(rows, units);
  }

  /// Finds the order of pivots anew, of rows that are divided as they are. @returns as above
  template <class Row>
  bool find_order(const std::vector<Row>& rows, const std::vector<R>& units) {
    Matrix a = matrix(rows);
    for (std::size_t i = 0; i < n_; ++i) {
      auto row = a.row(index(i));
      for (std::size_t j = 0; j < n_; ++j) row(index(j)) *= units[j];
      const R size = row.cwiseAbs().maxCoeff();
      if (!(size > 0)) return false;
      row /= size;
    }
    return start(prescribed_, a, rows) && start(free_, a, rows);
  }

  /// All of A, of the rows where it was divided or of others.
  template <class Row>
  Matrix matrix(const std::vector<Row>& rows) const {
    Matrix a = Matrix::Zero(index(n_), index(n_));
    for_each_element([&](std::size_t row, bool second, std::size_t k, std::size_t column) {
      a(index(row), index(column)) += (second ? rows[row].second : rows[row].first)[k];
    });
    return a;
  }

  /// Takes a row of A, by its number in its part.
  template <class Row>
  static void put(std::size_t row, const Row& from, R* numbers) {
    R* of_row = numbers + row * row_numbers;
    of_row[0] = from.value;
    of_row[1] = from.time_rate;
    for (std::size_t k = 0; k < Width; ++k) {
      of_row[first_derivative + k] = from.first[k];
      of_row[first_derivative + Width + k] = from.second[k];
    }
  }
  /// Of a row: Φ or z.
  static const R& value(std::size_t row, const R* numbers) { return numbers[row * row_numbers]; }
  /// Φ_t
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
  static constexpr std::size_t row_numbers = 2 + 2 * Width;
  static constexpr std::size_t first_derivative = 2;

  static R size_of(const R& x) {
    using std::abs;
    return abs(x);
  }
  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

  static Number number_of(std::size_t row_in_part, bool second, std::size_t k) {
    return static_cast<Number>(row_in_part * row_numbers + first_derivative + (second ? Width : 0) + k);
  }

  /// Calls visit(row, second, k, column) for the k-th derivative of each row by each of its bodies.
  template <class Visit>
  void for_each_element(const Visit& visit) const {
    for (std::size_t row = 0; row < sides_.size(); ++row) {
      for (const bool second : {false, true}) {
        const std::size_t body = second ? sides_[row].second : sides_[row].first;
        if (body == ground_body) continue;
        for (std::size_t k = 0; k < Width; ++k) visit(row, second, k, Width * body + k);
      }
    }
  }

  /// Adds the velocities that some function moves at a place, or all if that can't be told.
  static void add_moved(const Matrix& a, std::size_t constraints, std::vector<bool>& moved) {
    const Eigen::Index n = a.rows();
    const Eigen::Index f = n - index(constraints);
    const Eigen::FullPivLU<Matrix> lu(a);
    const bool regular = lu.isInvertible();
    Matrix v = regular ? Matrix(lu.solve(Matrix::Identity(n, n).rightCols(f))) : Matrix::Ones(n, f);
    for (Eigen::Index k = 0; k < f; ++k) v.col(k) /= v.col(k).cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < moved.size(); ++i) {
      // What rounding leaves of a zero; a velocity that is moved by less is then no part of square constraints.
      if (v.row(index(i)).cwiseAbs().maxCoeff() > R(1e-10)) moved[i] = true;
    }
    for (std::size_t body = 0; Width == 6 && body < moved.size() / Width; ++body) {
      const auto turns = moved.begin() + static_cast<std::ptrdiff_t>(Width * body + 3);
      if (std::find(turns, turns + 3, true) != turns + 3) std::fill(turns, turns + 3, true);
    }
  }

  void divide(const std::vector<std::size_t>& constraints, const std::vector<bool>& may_differ,
              std::vector<bool> moved) {
    const auto is_of_prescribed = [&](std::size_t row) {
      for (std::size_t j = 0; j < n_; ++j) {
        if (may_differ[row * n_ + j] && moved[j]) return false;
      }
      return row < constraints.size();
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
        if (i < constraints.size()) add_once(part->constraints, constraints[i]);
      }
      for (std::size_t j = 0; j < n_; ++j) {
        if (moved[j] != (part == &free_)) continue;
        part->columns.push_back(j);
        part->components.push_back(j % Width);
        add_once(part->bodies, j / Width);
      }
    }
    coupling_.clear();
    for_each_element([&](std::size_t row, bool second, std::size_t k, std::size_t column) {
      if (is_prescribed_[row] || moved[column] || !may_differ[row * n_ + column]) return;
      const auto found = std::find(prescribed_.columns.begin(), prescribed_.columns.end(), column);
      coupling_.push_back({static_cast<Number>(place_in_part_[row]),
                           static_cast<Number>(found - prescribed_.columns.begin()),
                           number_of(place_in_part_[row], second, k)});
    });
  }

  /// Finds the order of pivots of a part. @param a  all of A, of a size that compares;  @param rows  in their units
  template <class Row>
  bool start(Part& part, const Matrix& a, const std::vector<Row>& rows) const {
    const std::size_t n = part.size();
    std::vector<R> elements(n * n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) elements[i * n + j] = a(index(part.rows[i]), index(part.columns[j]));
    }
    std::vector<Number> places(n * n, ListedLu<R>::none);
    for_each_element([&](std::size_t row, bool second, std::size_t k, std::size_t column) {
      if (!is_in(part, row) || !may_differ_[row * n_ + column]) return;
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
  std::vector<bool> may_differ_;  ///< of each element of A: is it other than 0 anywhere?
  Part prescribed_, free_;
  std::vector<unsigned char> is_prescribed_;  ///< of every row of A: 1 or 0
  std::vector<std::size_t> place_in_part_;    ///< likewise
  std::vector<Coupling> coupling_;            ///< K
};

}  // namespace lubjoint

/// Functions of the coordinates that the constraints leave free, and how all coordinates follow from them.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "lubjoint/multibody/planar_system.hpp"

namespace lubjoint {

/// As many functions z(q) as there are degrees of freedom: the eccentricities of lubricated joints as far as they are
/// independent, which stay of the size of a clearance while the bodies move by a thousand of them; then coordinates of
/// bodies. With the constraints they are a square system
///   Φ(q, t) = 0,  C(q) = z,
/// whose Jacobian's pivots, their order and the list of operations are found once for a chart: at other positions it is
/// factorised by going through the list. Only what can differ from zero is in it.
template <class R>
class CoordinateChart {
 public:
  /// @param units  in which the coordinates of the bodies are comparable: one for every coordinate
  CoordinateChart(const PlanarSystem<R>& system, std::vector<R> units)
      : system_(system), units_(std::move(units)), m_(system.constraint_rows()), n_(system.coordinates()) {
    for (const JointElement<R>& joint : system_.joints()) {
      candidates_.push_back({0, joint.bearing_at.body, joint.journal_at.body, candidates_.size()});
      candidates_.push_back({1, joint.bearing_at.body, joint.journal_at.body, candidates_.size()});
      pins_.push_back({joint.bearing_at, joint.journal_at});
    }
    for (std::size_t i = 0; i < n_; ++i) candidates_.push_back({i % 3, i / 3, ground_body, candidates_.size()});
  }

  std::size_t freedoms() const { return n_ - m_; }  ///< number of functions

  /// Is function k one of a joint's eccentricity? Then [m], else in the unit of coordinate_of(k).
  bool is_of_joint(std::size_t k) const { return chosen_[k] < 2 * pins_.size(); }
  /// The joint of function k.
  std::size_t joint_of(std::size_t k) const { return chosen_[k] / 2; }
  /// The coordinate that function k is.
  std::size_t coordinate_of(std::size_t k) const { return chosen_[k] - 2 * pins_.size(); }

  /// The functions' rows at the frames of a workspace: z and its derivatives; γ of z̈ = C q̈ − γ.
  template <class T>
  void evaluate(const T* y, const SystemWorkspace<T>& w, std::vector<ConstraintRow<T>>& rows) const {
    rows.resize(freedoms());
    std::array<ConstraintRow<T>, 2> both;
    std::size_t done = std::numeric_limits<std::size_t>::max();
    for (std::size_t k = 0; k < freedoms(); ++k) {
      const Candidate& c = candidates_[chosen_[k]];
      if (is_of_joint(k)) {
        const std::size_t pin = joint_of(k);
        if (pin != done) {
          pins_[pin].evaluate(system_.frame(c.first, w), system_.frame(c.second, w), R(0), both.data());
          done = pin;
        }
        rows[k] = both[c.part];
      } else {
        rows[k] = {y[coordinate_of(k)], T(0), T(0), {T(0), T(0), T(0)}, {T(0), T(0), T(0)}};
        rows[k].first[c.part] = T(1);
      }
    }
  }

  /// Chooses at a state that fulfils the constraints. @returns false where they are not independent
  bool choose(const R& t, const R* y, SystemWorkspace<R>& w) {
    system_.evaluate_kinematics(t, y, w);
    using Matrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;
    const auto index = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
    Matrix phi = Matrix::Zero(index(m_), index(n_));
    for (std::size_t i = 0; i < m_; ++i) {
      add_row(w.rows[i], system_.first_body_of_row(i), system_.second_body_of_row(i),
              [&](std::size_t column, const R& value) { phi(index(i), index(column)) += value * units_[column]; });
      const R size = phi.row(index(i)).norm();
      if (!(size > 0)) return false;
      phi.row(index(i)) /= size;
    }
    Matrix free = Matrix::Identity(index(n_), index(n_));
    if (m_ > 0) {
      const Eigen::FullPivLU<Matrix> lu(phi);
      if (lu.rank() < index(m_)) return false;
      free = lu.kernel();
      // An orthonormal basis of the same space.
      free = Matrix(Eigen::HouseholderQR<Matrix>(free).householderQ() * Matrix::Identity(index(n_), free.cols()));
    }
    std::vector<std::size_t> best;
    // All candidates on the free directions, each in its unit.
    chosen_.clear();
    std::vector<Eigen::Matrix<R, Eigen::Dynamic, 1>> shadows(candidates_.size());
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      Eigen::Matrix<R, 1, Eigen::Dynamic> row = Eigen::Matrix<R, 1, Eigen::Dynamic>::Zero(index(n_));
      add_row(row_of(candidates_[c], y, w), candidates_[c].first, candidates_[c].second,
              [&](std::size_t column, const R& value) { row(index(column)) += value * units_[column]; });
      const R size = row.norm();
      shadows[c] = (row * free).transpose() / (size > 0 ? size : R(1));
    }
    std::vector<Eigen::Matrix<R, Eigen::Dynamic, 1>> basis;
    for (const bool of_joints : {true, false}) {
      const std::size_t begin = of_joints ? 0 : 2 * pins_.size();
      const std::size_t end = of_joints ? 2 * pins_.size() : candidates_.size();
      while (basis.size() < freedoms()) {
        std::size_t largest = end;
        R size(0);
        for (std::size_t c = begin; c < end; ++c) {
          const R left = shadows[c].norm();
          if (left > size) {
            size = left;
            largest = c;
          }
        }
        if (largest == end || !(size > R(of_joints ? 0.02 : 1e-6))) break;
        chosen_.push_back(largest);
        const Eigen::Matrix<R, Eigen::Dynamic, 1> direction = shadows[largest] / size;
        for (auto& each : shadows) each -= direction.dot(each) * direction;
        basis.push_back(direction);
      }
    }
    if (chosen_.size() < freedoms()) return false;
    std::sort(chosen_.begin(), chosen_.end());
    sides_.clear();
    for (std::size_t i = 0; i < m_; ++i)
      sides_.push_back({system_.first_body_of_row(i), system_.second_body_of_row(i)});
    for (const std::size_t c : chosen_) sides_.push_back({candidates_[c].first, candidates_[c].second});
    find_pattern();
    evaluate(y, w, work_rows_);
    if (!find_order(w.rows, work_rows_)) return false;
    factorise(w.rows, work_rows_);
    chosen_pivots_.resize(n_);
    using std::abs;
    for (std::size_t k = 0; k < n_; ++k) chosen_pivots_[k] = abs(lu_[diagonal_[k]]);
    return true;
  }

  const std::vector<std::size_t>& chosen() const { return chosen_; }  ///< numbers of the functions: compares charts

  /// Factors at the rows of an evaluated workspace and of the functions.
  void factorise(const std::vector<ConstraintRow<R>>& constraints, const std::vector<ConstraintRow<R>>& functions) {
    std::fill(lu_.begin(), lu_.end(), R(0));
    for (const Entry& each : entries_) {
      const ConstraintRow<R>& row = each.row < m_ ? constraints[each.row] : functions[each.row - m_];
      lu_[each.target] += (each.second ? row.second : row.first)[each.column];
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
    for (std::size_t k = 0; k < n_; ++k) least = std::min<R>(least, abs(lu_[diagonal_[k]]) / chosen_pivots_[k]);
    return least;
  }

  /// Solves for all coordinates. b: of the constraints' rows, then of the functions. V: R, or its derivatives.
  template <class V>
  void solve(const V* b, V* x) const {
    V* work = scratch<V>();
    for (std::size_t k = 0; k < n_; ++k) work[k] = b[pivot_rows_[k]];
    for (const Element& each : lower_) work[each.row] -= lu_[each.place] * work[each.column];
    std::size_t next = 0;
    for (std::size_t k = n_; k-- > 0;) {
      for (; next < upper_.size() && upper_[next].row == k; ++next)
        work[k] -= lu_[upper_[next].place] * work[upper_[next].column];
      work[k] /= lu_[diagonal_[k]];
      x[pivot_columns_[k]] = work[k];
    }
  }

 private:
  struct Candidate {
    std::size_t part;  // 0, 1: of a joint; 0, 1, 2: of a body
    std::size_t first;
    std::size_t second;
    std::size_t number;
  };
  struct Sides {
    std::size_t first;
    std::size_t second;
  };
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

  template <class V>
  V* scratch() const {
    if constexpr (std::is_same_v<V, R>) {
      solution_.resize(n_);
      return solution_.data();
    } else {
      static thread_local std::vector<V> work;
      work.resize(n_);
      return work.data();
    }
  }

  template <class Put>
  static void add_row(const ConstraintRow<R>& row, std::size_t first, std::size_t second, const Put& put) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (first != ground_body) put(3 * first + k, row.first[k]);
      if (second != ground_body) put(3 * second + k, row.second[k]);
    }
  }

  ConstraintRow<R> row_of(const Candidate& c, const R* y, const SystemWorkspace<R>& w) const {
    if (c.number < 2 * pins_.size()) {
      std::array<ConstraintRow<R>, 2> both;
      pins_[c.number / 2].evaluate(system_.frame(c.first, w), system_.frame(c.second, w), R(0), both.data());
      return both[c.part];
    }
    ConstraintRow<R> row{y[3 * c.first + c.part], R(0), R(0), {R(0), R(0), R(0)}, {R(0), R(0), R(0)}};
    row.first[c.part] = R(1);
    return row;
  }

  std::size_t at(std::size_t row, std::size_t column) const { return row * n_ + column; }

  template <class Put>
  void for_each_entry(const Put& put) const {
    for (std::size_t row = 0; row < n_; ++row) {
      for (const bool second : {false, true}) {
        const std::size_t body = second ? sides_[row].second : sides_[row].first;
        if (body == ground_body) continue;
        for (std::size_t k = 0; k < 3; ++k) put(row, second, k, 3 * body + k);
      }
    }
  }

  std::vector<R> scattered(const std::vector<ConstraintRow<R>>& constraints,
                           const std::vector<ConstraintRow<R>>& functions) const {
    std::vector<R> a(n_ * n_, R(0));
    for_each_entry([&](std::size_t row, bool second, std::size_t k, std::size_t column) {
      const ConstraintRow<R>& from = row < m_ ? constraints[row] : functions[row - m_];
      a[at(row, column)] += (second ? from.second : from.first)[k];
    });
    return a;
  }

  /// Elements that are zero wherever the bodies are: those that are zero at two places without any symmetry.
  void find_pattern() {
    pattern_.assign(n_ * n_, false);
    SystemWorkspace<R> w = system_.template workspace<R>();
    std::vector<R> y(2 * n_);
    std::vector<ConstraintRow<R>> functions;
    for (const double seed : {0.37, 1.91}) {
      for (std::size_t i = 0; i < y.size(); ++i) y[i] = R(std::sin(seed + 1.7 * static_cast<double>(i * i + i)));
      system_.evaluate_kinematics(R(0), y.data(), w);
      evaluate(y.data(), w, functions);
      const std::vector<R> a = scattered(w.rows, functions);
      for (std::size_t i = 0; i < a.size(); ++i) pattern_[i] = pattern_[i] || a[i] != 0;
    }
  }

  /// Pivots that are at least a fifth of the largest that is left and leave the fewest new elements.
  bool find_order(const std::vector<ConstraintRow<R>>& constraints, const std::vector<ConstraintRow<R>>& functions) {
    using std::abs;
    std::vector<R> a = scattered(constraints, functions);
    std::vector<bool> pattern = pattern_;
    for (std::size_t i = 0; i < n_; ++i) {
      R size(0);
      for (std::size_t j = 0; j < n_; ++j) size = std::max<R>(size, abs(a[at(i, j)] * units_[j]));
      if (!(size > 0)) return false;
      for (std::size_t j = 0; j < n_; ++j) a[at(i, j)] *= units_[j] / size;
    }
    std::vector<bool> row_taken(n_, false), column_taken(n_, false);
    pivot_rows_.clear();
    pivot_columns_.clear();
    for (std::size_t step = 0; step < n_; ++step) {
      R largest(0);
      for (std::size_t i = 0; i < n_; ++i) {
        for (std::size_t j = 0; j < n_; ++j) {
          if (!row_taken[i] && !column_taken[j]) largest = std::max<R>(largest, abs(a[at(i, j)]));
        }
      }
      if (!(largest > R(1e-9))) return false;
      std::size_t best = std::numeric_limits<std::size_t>::max(), best_row = 0, best_column = 0;
      R best_size(0);
      for (std::size_t i = 0; i < n_; ++i) {
        if (row_taken[i]) continue;
        for (std::size_t j = 0; j < n_; ++j) {
          const R size = abs(a[at(i, j)]);
          if (column_taken[j] || !(size >= largest / 5)) continue;
          std::size_t in_row = 0, in_column = 0;
          for (std::size_t k = 0; k < n_; ++k) {
            in_row += !column_taken[k] && pattern[at(i, k)];
            in_column += !row_taken[k] && pattern[at(k, j)];
          }
          const std::size_t fill = (in_row - 1) * (in_column - 1);
          if (fill < best || (fill == best && size > best_size)) {
            best = fill;
            best_row = i;
            best_column = j;
            best_size = size;
          }
        }
      }
      row_taken[best_row] = true;
      column_taken[best_column] = true;
      pivot_rows_.push_back(best_row);
      pivot_columns_.push_back(best_column);
      for (std::size_t i = 0; i < n_; ++i) {
        if (row_taken[i] || !pattern[at(i, best_column)]) continue;
        const R factor = a[at(i, best_column)] / a[at(best_row, best_column)];
        for (std::size_t j = 0; j < n_; ++j) {
          if (column_taken[j] || !pattern[at(best_row, j)]) continue;
          a[at(i, j)] -= factor * a[at(best_row, j)];
          pattern[at(i, j)] = true;
        }
      }
    }
    list_operations();
    return true;
  }

  /// Of the elimination in the order of the pivots.
  void list_operations() {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> place(n_ * n_, none), order(n_), row_order(n_);
    std::size_t count = 0;
    for (std::size_t k = 0; k < n_; ++k) {
      order[pivot_columns_[k]] = k;
      row_order[pivot_rows_[k]] = k;
    }
    const auto taken = [&](std::size_t i, std::size_t j) -> std::size_t& { return place[i * n_ + j]; };
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < n_; ++j) {
        if (pattern_[at(pivot_rows_[i], pivot_columns_[j])]) taken(i, j) = count++;
      }
    }
    operations_.clear();
    for (std::size_t k = 0; k < n_; ++k) {
      for (std::size_t i = k + 1; i < n_; ++i) {
        if (taken(i, k) == none) continue;
        operations_.push_back({true, taken(i, k), 0, taken(k, k)});
        for (std::size_t j = k + 1; j < n_; ++j) {
          if (taken(k, j) == none) continue;
          if (taken(i, j) == none) taken(i, j) = count++;
          operations_.push_back({false, taken(i, j), taken(i, k), taken(k, j)});
        }
      }
    }
    lu_.assign(count, R(0));
    diagonal_.resize(n_);
    lower_.clear();
    upper_.clear();
    for (std::size_t k = 0; k < n_; ++k) {
      diagonal_[k] = taken(k, k);
      for (std::size_t j = 0; j < k; ++j) {
        if (taken(k, j) != none) lower_.push_back({k, j, taken(k, j)});
      }
    }
    for (std::size_t k = n_; k-- > 0;) {
      for (std::size_t j = k + 1; j < n_; ++j) {
        if (taken(k, j) != none) upper_.push_back({k, j, taken(k, j)});
      }
    }
    entries_.clear();
    for_each_entry([&](std::size_t row, bool second, std::size_t k, std::size_t column) {
      if (pattern_[at(row, column)]) entries_.push_back({row, second, k, taken(row_order[row], order[column])});
    });
  }

  const PlanarSystem<R>& system_;
  std::vector<R> units_;
  std::size_t m_, n_;
  std::vector<Revolute<R>> pins_;  // of the joints: a pin's Φ is the eccentricity
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> chosen_;
  std::vector<Sides> sides_;
  std::vector<bool> pattern_;  ///< of the Jacobian: what may differ from zero
  std::vector<std::size_t> pivot_rows_, pivot_columns_;
  std::vector<R> lu_;
  std::vector<Entry> entries_;
  std::vector<Operation> operations_;
  std::vector<Element> lower_, upper_;
  std::vector<std::size_t> diagonal_;
  std::vector<R> chosen_pivots_;
  std::vector<ConstraintRow<R>> work_rows_;
  mutable std::vector<R> solution_;
};

}  // namespace lubjoint

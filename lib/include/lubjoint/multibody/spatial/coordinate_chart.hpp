/// Functions of places in space that the constraints leave free, and how all velocities follow from theirs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "lubjoint/multibody/function_choice.hpp"
#include "lubjoint/multibody/listed_lu.hpp"
#include "lubjoint/multibody/spatial/chart_functions.hpp"
#include "lubjoint/multibody/spatial/system.hpp"

namespace lubjoint {

/// As many functions z = C(r, p) as there are degrees of freedom: first the eccentricities of lubricated joints by axes
/// of their bearings, as far as they are independent, which stay of the size of a clearance and are what films see;
/// then positions of mass centres, and turns of bodies since the chart's choice about axes fixed to them, of which the
/// first is that about which the body turns. With the constraints they are a square system
///   Φ(r, p, t) = 0,  C(r, p) = z
/// whose Jacobian A = [Φ_v; C_v] by (ṙ, ω′) is factorised in the order that was found when the chart was chosen. Rows
/// of Φ that the system leaves out are not in it. A chart is worn out where a pivot, or a turn's ρ², has become small:
/// another order of pivots then takes over, or, where it is the functions that wear out, another choice.
template <class R>
class SpatialCoordinateChart {
 public:
  /// @param system  whose rows to leave out are known, kept by reference
  /// @param units  in which displacements of bodies and small turns are comparable: six a body
  SpatialCoordinateChart(const SpatialSystem<R>& system, std::vector<R> units)
      : system_(&system), units_(std::move(units)), m_(system.kept().size()), n_(system.velocities()) {
    for (const SpatialJointElement<R>& joint : system.joints()) {
      for (std::size_t part = 0; part < 2; ++part)
        candidates_.push_back({part, joint.bearing_at.body, joint.journal_at.body});
    }
    for (std::size_t i = 0; i < n_; ++i) candidates_.push_back({i % 6, i / 6, ground_body});
    axes_.resize(system.bodies().size());
    from_.resize(system.bodies().size());
    for (const std::size_t row : system.kept())
      sides_.push_back({system.first_body_of_row(row), system.second_body_of_row(row)});
    find_pattern();
  }

  std::size_t freedoms() const { return n_ - m_; }  ///< number of functions

  /// Numbers of the functions: compares charts. Turns since another orientation are other functions.
  const std::vector<std::size_t>& chosen() const { return numbers_of_chosen_; }
  /// Is function k one of a joint's eccentricity? Then [m].
  bool is_of_joint(std::size_t k) const { return chosen_[k] < of_joints(); }
  /// The joint of function k.
  std::size_t joint_of(std::size_t k) const { return chosen_[k] / 2; }
  /// Of a function that is no eccentricity, the number of the velocity that it is most like: ṙ or ω′ of a body.
  std::size_t velocity_of(std::size_t k) const { return chosen_[k] - of_joints(); }
  /// Is function k a turn? Then [rad], and of any revolution.
  bool is_turn(std::size_t k) const { return !is_of_joint(k) && candidates_[chosen_[k]].part >= 3; }

  /// The functions' rows at the frames of a workspace, freedoms() of them: z and its derivatives; γ_C of
  /// C_v (r̈, ω̇′) = z̈ + γ_C. @throws JournalAcross
  template <class T>
  void evaluate(const SpatialWorkspace<T>& w, SpatialRow<T>* rows) const {
    std::array<SpatialRow<T>, 2> both;
    std::size_t done = std::numeric_limits<std::size_t>::max();
    for (std::size_t k = 0; k < freedoms(); ++k) {
      const Candidate& c = candidates_[chosen_[k]];
      if (is_of_joint(k)) {
        if (const std::size_t joint = joint_of(k); joint != done) {
          fill_joint(joint, w, both);
          done = joint;
        }
        rows[k] = both[c.part];
      } else {
        fill_of_body(c, w, rows[k]);
      }
    }
  }

  /// The same on plain numbers, one after the other to keep(k, row), which the compiler spares what it does not read.
  template <class Keep>
  void for_each_function(const SpatialWorkspace<R>& w, const Keep& keep) const {
    for (std::size_t k = 0; k < freedoms(); ++k) {
      const Candidate& c = candidates_[chosen_[k]];
      if (!is_of_joint(k)) {
        in_one_piece<R>([&] {
          SpatialRow<R> row;
          fill_of_body(c, w, row);
          keep(k, row);
        });
        continue;
      }
      const bool both = c.part == 0 && k + 1 < freedoms() && chosen_[k + 1] == chosen_[k] + 1;
      in_one_piece<R>([&] {
        std::array<SpatialRow<R>, 2> rows;
        fill_joint(joint_of(k), w, rows);
        keep(k, rows[c.part]);
        if (both) keep(k + 1, rows[1]);
      });
      if (both) ++k;
    }
  }

  /// Numbers of the bodies of function k, as of a constraint's row.
  std::pair<std::size_t, std::size_t> bodies_of(std::size_t k) const {
    return {candidates_[chosen_[k]].first, candidates_[chosen_[k]].second};
  }

  /// Chooses at a state that fulfils the constraints: another order for the functions that there are, where they are
  /// still as good as at first; else functions. @returns false where the constraints are not independent
  bool choose(const R& t, const R* y, SpatialWorkspace<R>& w) {
    system_->evaluate_kinematics(t, y, w);
    if (!chosen_.empty() && find_order(w) && are_as_good_as_at_first()) return true;
    if (!choose_functions(w) || !find_order(w)) return false;
    first_sizes_ = sizes_of_functions();
    return true;
  }

  static constexpr std::size_t slots = 4;  ///< how many factors it keeps

  /// Works with the factors of this slot from here on.
  void use(std::size_t slot) { slot_ = slot; }
  /// Puts copies of one slot's factors into another.
  void copy_factors(std::size_t from, std::size_t to) { numbers_[to] = numbers_[from]; }

  /// Takes the value alone of a row: the factors stay.
  void put_value(std::size_t row, const R& value) { numbers()[row * row_numbers] = value; }
  /// Takes a row of A, of the constraints that are kept or, from number m on, of the functions, at new places.
  void put(std::size_t row, const SpatialRow<R>& from) {
    R* numbers = this->numbers() + row * row_numbers;
    numbers[0] = from.value;
    numbers[1] = from.time_rate;
    std::copy(from.first.begin(), from.first.end(), numbers + first_derivative);
    std::copy(from.second.begin(), from.second.end(), numbers + first_derivative + 6);
    if (row >= m_ && is_turn(row - m_))  // 1/ρ²
      turns_[row - m_] = from.first[3] * from.first[3] + from.first[4] * from.first[4] + from.first[5] * from.first[5];
  }
  const R& value(std::size_t row) const { return numbers()[row * row_numbers]; }          ///< of a row: Φ or z
  const R& time_rate(std::size_t row) const { return numbers()[row * row_numbers + 1]; }  ///< Φ_t

  /// Factors of the rows that were put.
  void factorise() { lu_.factorise(numbers()); }

  /// Solves A x = b. V: R, or several right-hand sides at once.
  /// @param b  of the constraints' rows, then of the functions;  @param work  as many
  template <class V>
  void solve(const V* b, V* x, V* work) const {
    lu_.solve(numbers(), b, x, work);
  }
  /// Solves Aᵀ x = b.
  template <class V>
  void solve_transposed(const V* b, V* x, V* work) const {
    lu_.solve_transposed(numbers(), b, x, work);
  }

  /// How much smaller than when they were chosen the pivots have become, or ρ² of a turn: 1 for a fresh chart, 0 where
  /// it ends.
  R wear() const {
    R most(1);
    for (std::size_t k = 0; k < n_; ++k)
      most = std::max<R>(most, size_of(lu_.inverse_pivot(k, numbers())) / first_inverse_pivots_[k]);
    for (const R& inverse_square : turns_) most = std::max<R>(most, inverse_square);
    return 1 / most;
  }

 private:
  using Number = typename ListedLu<R>::Number;
  struct Candidate {
    std::size_t part;  // 0, 1: of a joint; 0, 1, 2: a position of a body; 3, 4, 5: its turns
    std::size_t first;
    std::size_t second;
  };
  /// A row among the numbers: value, time rate, derivatives of the first body, of the second, which factors replace.
  static constexpr std::size_t row_numbers = 14;
  static constexpr std::size_t first_derivative = 2;

  R* numbers() { return numbers_[slot_].data(); }
  const R* numbers() const { return numbers_[slot_].data(); }
  static R size_of(const R& x) { return x < 0 ? R(-x) : x; }
  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }
  std::size_t of_joints() const { return 2 * system_->joints().size(); }

  template <class T>
  void fill_joint(std::size_t joint, const SpatialWorkspace<T>& w, std::array<SpatialRow<T>, 2>& rows) const {
    const SpatialJointElement<R>& at = system_->joints()[joint];
    const SpatialFrame<T>& bearing = system_->frame(at.bearing_at.body, w);
    const SpatialFrame<T>& journal = system_->frame(at.journal_at.body, w);
    fill_eccentricity(bearing, journal, at.kinematics(bearing, journal), rows);
  }
  template <class T>
  void fill_of_body(const Candidate& c, const SpatialWorkspace<T>& w, SpatialRow<T>& row) const {
    const SpatialFrame<T>& frame = w.frames[c.first];
    if (c.part >= 3) {
      fill_turn(frame, Vector3<R>(axes_[c.first].col(index(c.part - 3))), from_[c.first], row);
      return;
    }
    row = {frame.position(index(c.part)), T(0), T(0), {}, {}};
    row.first[c.part] = T(1);
  }

  template <class Put>
  static void for_each_side(const SpatialRow<R>& row, std::size_t first, std::size_t second, const Put& put) {
    for (std::size_t k = 0; k < 6; ++k) {
      if (first != ground_body) put(6 * first + k, row.first[k]);
      if (second != ground_body) put(6 * second + k, row.second[k]);
    }
  }

  SpatialRow<R> row_of(std::size_t candidate, const SpatialWorkspace<R>& w) const {
    const Candidate& c = candidates_[candidate];
    if (candidate < of_joints()) {
      std::array<SpatialRow<R>, 2> both;
      fill_joint(candidate / 2, w, both);
      return both[c.part];
    }
    SpatialRow<R> row;
    fill_of_body(c, w, row);
    return row;
  }

  /// Axes of turns since here: the first about which the body turns now.
  void start_turns(const SpatialWorkspace<R>& w) {
    for (std::size_t b = 0; b < axes_.size(); ++b) {
      const Vector3<R>& spin = w.frames[b].body_spin;
      from_[b] = normalised(w.frames[b].parameters);
      axes_[b].setIdentity();
      const R size = spin.norm();
      if (!(size > 0)) continue;
      Eigen::Index least;
      spin.cwiseAbs().minCoeff(&least);
      const Vector3<R> a = spin / size;
      const Vector3<R> across = direction(cross(a, Vector3<R>(Vector3<R>::Unit(least))));
      axes_[b] << a, across, cross(a, across);
    }
  }

  /// Turns beside the first end where the body has turned by half a revolution: they count for less.
  R lasting(const Candidate& c, const SpatialWorkspace<R>& w) const {
    return R(c.part > 3 && !is_zero(w.frames[c.first].body_spin) ? 0.25 : 1);
  }

  /// Eccentricities first, then positions and turns.
  bool choose_functions(const SpatialWorkspace<R>& w) {
    using Matrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;
    start_turns(w);
    const auto put = [&](Matrix& to, std::size_t i) {
      return
          [&to, i, this](std::size_t column, const R& value) { to(index(i), index(column)) += value * units_[column]; };
    };
    Matrix constraints = Matrix::Zero(index(m_), index(n_));
    for (std::size_t i = 0; i < m_; ++i)
      for_each_side(w.rows[system_->kept()[i]], sides_[i].first, sides_[i].second, put(constraints, i));
    Matrix functions = Matrix::Zero(index(candidates_.size()), index(n_));
    for (std::size_t c = 0; c < candidates_.size(); ++c)
      for_each_side(row_of(c, w), candidates_[c].first, candidates_[c].second, put(functions, c));
    chosen_ = independent_functions<R>(std::move(constraints), std::move(functions), of_joints(),
                                       [&](std::size_t c) { return lasting(candidates_[c], w); });
    if (chosen_.size() < freedoms()) return false;
    ++choices_;
    sides_.resize(m_);
    numbers_of_chosen_.clear();
    turns_.assign(freedoms(), R(0));
    for (std::size_t k = 0; k < freedoms(); ++k) {
      sides_.push_back(bodies_of(k));
      numbers_of_chosen_.push_back(chosen_[k] + (is_turn(k) ? choices_ * candidates_.size() : 0));
    }
    return true;
  }

  /// The order of pivots for the functions that are chosen, and factors in it.
  bool find_order(const SpatialWorkspace<R>& w) {
    std::vector<SpatialRow<R>> rows(n_);
    for (std::size_t i = 0; i < m_; ++i) rows[i] = w.rows[system_->kept()[i]];
    evaluate(w, rows.data() + m_);
    std::vector<R> a(n_ * n_, R(0));
    std::vector<Number> places(n_ * n_, ListedLu<R>::none);
    for (std::size_t row = 0; row < n_; ++row) {
      const auto number = [row](std::size_t k) {
        return static_cast<Number>(row * row_numbers + first_derivative + k);
      };
      const auto put_side = [&](std::size_t body, const std::array<R, 6>& columns, std::size_t side) {
        for (std::size_t k = 0; k < 6 && body != ground_body; ++k) {
          if (!may_differ(row, side + k)) continue;
          a[row * n_ + 6 * body + k] = columns[k];
          places[row * n_ + 6 * body + k] = number(side + k);
        }
      };
      put_side(sides_[row].first, rows[row].first, 0);
      put_side(sides_[row].second, rows[row].second, 6);
      R size(0);
      for (std::size_t j = 0; j < n_; ++j) size = std::max<R>(size, size_of(a[row * n_ + j] * units_[j]));
      if (!(size > 0)) return false;
      for (std::size_t j = 0; j < n_; ++j) a[row * n_ + j] *= units_[j] / size;
    }
    if (!lu_.find_order(n_, std::move(a), places, n_ * row_numbers)) return false;
    numbers_.fill(std::vector<R>(lu_.storage(), R(0)));
    slot_ = 0;
    for (std::size_t row = 0; row < n_; ++row) put(row, rows[row]);
    factorise();
    first_inverse_pivots_.resize(n_);
    for (std::size_t k = 0; k < n_; ++k) first_inverse_pivots_[k] = size_of(lu_.inverse_pivot(k, numbers()));
    return true;
  }

  /// How far bodies move, in their units, when one function alone changes.
  std::vector<R> sizes_of_functions() const {
    std::vector<R> sizes, right(n_), x(n_), work(n_);
    for (std::size_t k = 0; k < freedoms(); ++k) {
      std::fill(right.begin(), right.end(), R(0));
      right[m_ + k] = R(1);
      solve(right.data(), x.data(), work.data());
      R size(0);
      for (std::size_t i = 0; i < n_; ++i) size = std::max<R>(size, size_of(x[i]) / units_[i]);
      sizes.push_back(size);
    }
    return sizes;
  }
  bool are_as_good_as_at_first() const {
    const std::vector<R> sizes = sizes_of_functions();
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      if (!(sizes[k] < 4 * first_sizes_[k]) || turns_[k] > R(2)) return false;
    }
    return true;
  }

  /// Elements of the constraints' rows that may differ from zero: those that do at two places without any symmetry.
  void find_pattern() {
    pattern_.assign(12 * m_, false);
    SpatialWorkspace<R> w = system_->template workspace<R>();
    std::vector<R> y(system_->states());
    for (const double seed : {0.37, 1.91}) {
      for (std::size_t i = 0; i < y.size(); ++i) y[i] = R(std::sin(seed + 1.7 * static_cast<double>(i * i + i)));
      for (std::size_t b = 0; b < system_->bodies().size(); ++b) {
        R* p = &y[spatial_coordinates * b + 3];
        const EulerParameters<R> unit = normalised(EulerParameters<R>(p[0], p[1], p[2], p[3]));
        std::copy(unit.data(), unit.data() + 4, p);
      }
      system_->evaluate_kinematics(R(0), y.data(), w);
      for (std::size_t i = 0; i < m_; ++i) {
        const SpatialRow<R>& row = w.rows[system_->kept()[i]];
        for (std::size_t k = 0; k < 6; ++k) {
          pattern_[12 * i + k] = pattern_[12 * i + k] || row.first[k] != 0;
          pattern_[12 * i + 6 + k] = pattern_[12 * i + 6 + k] || row.second[k] != 0;
        }
      }
    }
  }
  /// May an element of a row differ from zero? @param k  from 0 of the first body, from 6 of the second
  bool may_differ(std::size_t row, std::size_t k) const {
    if (row < m_) return pattern_[12 * row + k];
    const Candidate& c = candidates_[chosen_[row - m_]];
    if (is_of_joint(row - m_)) return true;
    return c.part < 3 ? k == c.part : k >= 3 && k < 6;
  }

  const SpatialSystem<R>* system_;
  std::vector<R> units_;
  std::size_t m_, n_;
  std::vector<Candidate> candidates_;
  std::vector<Matrix3<R>> axes_;          ///< of each body's turns, in its frame, as columns
  std::vector<EulerParameters<R>> from_;  ///< p₀ of each body
  std::vector<std::size_t> chosen_;       ///< candidates
  std::vector<std::size_t> numbers_of_chosen_;
  std::size_t choices_ = 0;                                 ///< of functions so far
  std::vector<std::pair<std::size_t, std::size_t>> sides_;  ///< bodies of every row of A
  std::vector<bool> pattern_;                               ///< of the constraints' rows
  ListedLu<R> lu_;
  std::array<std::vector<R>, slots> numbers_;  ///< of each slot: the rows and, behind them, fill
  std::size_t slot_ = 0;                       ///< in use
  std::vector<R> first_inverse_pivots_;
  std::vector<R> first_sizes_;  ///< of functions, when they were chosen
  std::vector<R> turns_;        ///< 1/ρ² of functions that are turns
};

}  // namespace lubjoint

/// Functions of the coordinates that the constraints leave free, and how all coordinates follow from them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "lubjoint/multibody/chart_parts.hpp"
#include "lubjoint/multibody/function_choice.hpp"
#include "lubjoint/multibody/planar_system.hpp"

namespace lubjoint {

/// As many functions z = C(q) as there are degrees of freedom: the eccentricities of lubricated joints as far as they
/// are independent, which stay of the size of a clearance while the bodies move by a thousand of them; then coordinates
/// of bodies. With the constraints they are a square system
///   Φ(q, t) = 0,  C(q) = z
/// whose Jacobian A = [Φq; C] is factorised in the order that was found when the chart was chosen. A chart is worn out
/// where a pivot has become small; another choice then takes over.
///
/// Coordinates that the time alone prescribes, such as those of a crank that is driven, are found apart: see
/// ChartParts.
template <class R>
class CoordinateChart {
 public:
  /// @param units  in which the coordinates of the bodies are comparable: one for every coordinate
  CoordinateChart(const PlanarSystem<R>& system, std::vector<R> units)
      : system_(&system), units_(std::move(units)), m_(system.constraint_rows()), n_(system.coordinates()) {
    for (const JointElement<R>& joint : system.joints()) {
      candidates_.push_back({0, joint.bearing_at.body, joint.journal_at.body});
      candidates_.push_back({1, joint.bearing_at.body, joint.journal_at.body});
      pins_.push_back({joint.bearing_at, joint.journal_at});
    }
    for (std::size_t i = 0; i < n_; ++i) candidates_.push_back({i % 3, i / 3, ground_body});
  }

  std::size_t freedoms() const { return n_ - m_; }  ///< number of functions

  /// Numbers of the functions: compares charts.
  const std::vector<std::size_t>& chosen() const { return chosen_; }
  /// Is function k one of a joint's eccentricity? Then [m], else in the unit of coordinate_of(k).
  bool is_of_joint(std::size_t k) const { return chosen_[k] < 2 * pins_.size(); }
  /// The joint of function k.
  std::size_t joint_of(std::size_t k) const { return chosen_[k] / 2; }
  /// The coordinate that function k is.
  std::size_t coordinate_of(std::size_t k) const { return chosen_[k] - 2 * pins_.size(); }

  using Parts = ChartParts<R, 3>;                ///< A, and what is solved with it
  const Parts& parts() const { return parts_; }  ///< likewise
  /// How far the chart is from its end, by its factors at a place: see ChartParts.
  R wear(const typename Parts::Numbers& numbers, const SystemWorkspace<R>&) const { return parts_.wear(numbers); }
  /// The value of function k that is nearest to another: there is but one.
  static const R& nearest(std::size_t, const R& value, const R&) { return value; }
  /// Value of function k less what it should be.
  static R miss(std::size_t, const R& value, const R& wanted) { return value - wanted; }

  /// Evaluates the functions at the frames of a workspace and hands each of their rows to keep(k, row): z and its
  /// derivatives; γ_C of C q̈ = z̈ + γ_C. The compiler spares what keep does not read.
  template <class T, class Keep>
  void for_each_function(const SystemWorkspace<T>& w, const Keep& keep) const {
    for (std::size_t k = 0; k < freedoms();) {
      const Candidate& c = candidates_[chosen_[k]];
      if (!is_of_joint(k)) {
        keep(k++, row_of_coordinate(c, w));
        continue;
      }
      const std::size_t pin = joint_of(k);
      std::array<ConstraintRow<T>, 2> both;
      pins_[pin].evaluate(system_->frame(c.first, w), system_->frame(c.second, w), R(0), both.data());
      if (c.part == 0) keep(k++, both[0]);
      if (k < freedoms() && chosen_[k] == 2 * pin + 1) keep(k++, both[1]);
    }
  }
  /// The same into rows, freedoms() of them.
  template <class T>
  void evaluate(const SystemWorkspace<T>& w, ConstraintRow<T>* rows) const {
    for_each_function(w, [rows](std::size_t k, const ConstraintRow<T>& row) { rows[k] = row; });
  }

  /// Numbers of the bodies of function k, as of a constraint's row.
  std::pair<std::size_t, std::size_t> bodies_of(std::size_t k) const {
    return {candidates_[chosen_[k]].first, candidates_[chosen_[k]].second};
  }

  /// Chooses at a state that fulfils the constraints. @returns false where they are not independent
  bool choose(const R& t, const R* y, SystemWorkspace<R>& w) {
    system_->evaluate_kinematics(t, y, w);
    if (!choose_functions(w)) return false;
    std::vector<RowSides> sides;
    std::vector<std::size_t> constraints;
    for (std::size_t i = 0; i < m_; ++i)
      sides.push_back({system_->first_body_of_row(i), system_->second_body_of_row(i)});
    for (std::size_t k = 0; k < freedoms(); ++k) sides.push_back({bodies_of(k).first, bodies_of(k).second});
    for (std::size_t c = 0; c < system_->constraints().size(); ++c)
      constraints.insert(constraints.end(), system_->first_row(c + 1) - system_->first_row(c), c);
    return parts_.find(std::move(sides), constraints, all_rows(w), units_,
                       [this](const auto& look) { this->at_odd_places(look); });
  }

 private:
  struct Candidate {
    std::size_t part;  // 0, 1: of a joint; 0, 1, 2: of a body
    std::size_t first;
    std::size_t second;
  };

  template <class Put>
  static void for_each_side(const ConstraintRow<R>& row, std::size_t first, std::size_t second, const Put& put) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (first != ground_body) put(3 * first + k, row.first[k]);
      if (second != ground_body) put(3 * second + k, row.second[k]);
    }
  }

  template <class T>
  static ConstraintRow<T> row_of_coordinate(const Candidate& c, const SystemWorkspace<T>& w) {
    const PlanarFrame<T>& frame = w.frames[c.first];
    ConstraintRow<T> row{c.part == 2 ? frame.angle : frame.position(static_cast<Eigen::Index>(c.part)),
                         T(0),
                         T(0),
                         {T(0), T(0), T(0)},
                         {T(0), T(0), T(0)}};
    row.first[c.part] = T(1);
    return row;
  }
  ConstraintRow<R> row_of(std::size_t candidate, const SystemWorkspace<R>& w) const {
    const Candidate& c = candidates_[candidate];
    if (candidate >= 2 * pins_.size()) return row_of_coordinate(c, w);
    std::array<ConstraintRow<R>, 2> both;
    pins_[candidate / 2].evaluate(system_->frame(c.first, w), system_->frame(c.second, w), R(0), both.data());
    return both[c.part];
  }

  /// Eccentricities first, then coordinates.
  bool choose_functions(const SystemWorkspace<R>& w) {
    using Matrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;
    const auto index = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
    const auto put = [&](Matrix& to, std::size_t i) {
      return [&to, i, index, this](std::size_t column, const R& value) {
        to(index(i), index(column)) += value * units_[column];
      };
    };
    Matrix constraints = Matrix::Zero(index(m_), index(n_));
    for (std::size_t i = 0; i < m_; ++i)
      for_each_side(w.rows[i], system_->first_body_of_row(i), system_->second_body_of_row(i), put(constraints, i));
    Matrix functions = Matrix::Zero(index(candidates_.size()), index(n_));
    for (std::size_t c = 0; c < candidates_.size(); ++c)
      for_each_side(row_of(c, w), candidates_[c].first, candidates_[c].second, put(functions, c));
    chosen_ = independent_functions<R>(std::move(constraints), std::move(functions), 2 * pins_.size(),
                                       [](std::size_t) { return R(1); });
    return chosen_.size() == freedoms();
  }

  std::vector<ConstraintRow<R>> all_rows(const SystemWorkspace<R>& w) const {
    std::vector<ConstraintRow<R>> rows = w.rows;
    rows.resize(n_);
    evaluate(w, rows.data() + m_);
    return rows;
  }

  /// Calls look(rows of A) at two places without any symmetry.
  template <class Look>
  void at_odd_places(const Look& look) const {
    SystemWorkspace<R> w = system_->template workspace<R>();
    std::vector<R> y(2 * n_);
    for (const double seed : {0.37, 1.91}) {
      for (std::size_t i = 0; i < y.size(); ++i) y[i] = R(std::sin(seed + 1.7 * static_cast<double>(i * i + i)));
      system_->evaluate_kinematics(R(0), y.data(), w);
      look(all_rows(w));
    }
  }

  const PlanarSystem<R>* system_;
  std::vector<R> units_;
  std::size_t m_, n_;
  std::vector<Revolute<R>> pins_;  ///< of the joints: a pin's Φ is the eccentricity
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> chosen_;
  Parts parts_;
};

}  // namespace lubjoint

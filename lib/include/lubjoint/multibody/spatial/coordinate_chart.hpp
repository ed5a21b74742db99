/// Functions of places in space that the constraints leave free, and how all velocities follow from theirs.
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
#include "lubjoint/multibody/spatial/body_directions.hpp"
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
///
/// What the time alone prescribes, such as the place of a crank that is driven, is found apart: see ChartParts.
template <class R>
class SpatialCoordinateChart {
 public:
  /// @param system  whose rows to leave out are known, kept by reference
  /// @param units  in which displacements of bodies and small turns are comparable: six a body
  SpatialCoordinateChart(const SpatialSystem<R>& system, std::vector<R> units)
      : system_(&system),
        units_(std::move(units)),
        m_(system.kept().size()),
        n_(system.velocities()),
        directions_(system.bodies().size()) {
    for (const SpatialJointElement<R>& joint : system.joints()) {
      for (std::size_t part = 0; part < 2; ++part)
        candidates_.push_back({part, joint.bearing_at.body, joint.journal_at.body});
    }
    for (std::size_t i = 0; i < n_; ++i) candidates_.push_back({i % 6, i / 6, ground_body});
    axes_.resize(system.bodies().size());
    from_.resize(system.bodies().size());
    for (const NamedSpatialConstraint<R>& each : system.constraints()) directions_.take(each);
    for (const std::size_t row : system.kept()) {
      constraint_sides_.push_back({system.first_body_of_row(row), system.second_body_of_row(row)});
      constraints_.push_back(system.constraint_of(row));
    }
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

  /// The same, one after the other to keep(k, row), which the compiler spares what it does not read.
  /// @param joints_are_placed  does the workspace have the kinematics of its joints, from its frames?
  template <class T, class Keep>
  void for_each_function(const SpatialWorkspace<T>& w, const Keep& keep, bool joints_are_placed = false) const {
    for (std::size_t k = 0; k < freedoms(); ++k) {
      const Candidate& c = candidates_[chosen_[k]];
      if (!is_of_joint(k)) {
        in_one_piece<T>([&] {
          SpatialRow<T> row;
          fill_of_body(c, w, row);
          keep(k, row);
        });
        continue;
      }
      const bool both = c.part == 0 && k + 1 < freedoms() && chosen_[k + 1] == chosen_[k] + 1;
      in_one_piece<T>([&] {
        std::array<SpatialRow<T>, 2> rows;
        fill_joint(joint_of(k), w, rows, joints_are_placed);
        keep(k, rows[c.part]);
        if (both) keep(k + 1, rows[1]);
      });
      if (both) ++k;
    }
  }

  const BodyDirections<R>& directions() const { return directions_; }  ///< that columns of A are counted along
  /// Numbers of the bodies of function k, as of a constraint's row.
  std::pair<std::size_t, std::size_t> bodies_of(std::size_t k) const {
    return {candidates_[chosen_[k]].first, candidates_[chosen_[k]].second};
  }

  using Parts = ChartParts<R, 6>;                ///< A, and what is solved with it
  const Parts& parts() const { return parts_; }  ///< likewise
  /// How far the chart is from its end, at the frames of a workspace and the factors there: 1 for a fresh chart, 0
  /// where pivots vanish, or ρ² of a turn.
  R wear(const typename Parts::Numbers& numbers, const SpatialWorkspace<R>& w) const {
    R least = parts_.wear(numbers);
    for (std::size_t k = 0; k < freedoms(); ++k) {
      if (is_turn(k)) least = std::min<R>(least, turn_square(k, w));
    }
    return least;
  }
  /// The value of function k that is nearest to another: a turn is of any revolution.
  R nearest(std::size_t k, const R& value, const R& other) const {
    const R missed = miss(k, value, other);
    return missed == value - other ? value : R(other + missed);
  }
  /// Value of function k less what it should be; of a turn, in the revolution that is nearest.
  R miss(std::size_t k, const R& value, const R& wanted) const {
    using std::round;
    const R difference = value - wanted;
    if (!is_turn(k) || size_of(difference) < R(3)) return difference;
    const R turn = 2 * pi<R>();
    return R(value - (wanted + turn * round(R(difference / turn))));  // the sum is the same for all values near it
  }

  /// Chooses at a state that fulfils the constraints: another order for the functions that there are, where they are
  /// still as good as at first; else functions. @returns false where the constraints are not independent
  bool choose(const R& t, const R* y, SpatialWorkspace<R>& w) {
    system_->evaluate_kinematics(t, y, w);
    if (!chosen_.empty() && find_parts(y, w) && are_as_good_as_at_first(w)) return true;
    if (!choose_functions(w) || !find_parts(y, w)) return false;
    first_sizes_ = sizes_of_functions(w);
    return true;
  }

 private:
  struct Candidate {
    std::size_t part;  // 0, 1: of a joint; 0, 1, 2: a position of a body; 3, 4, 5: its turns
    std::size_t first;
    std::size_t second;
  };
  static R size_of(const R& x) {
    using std::abs;
    return abs(x);
  }
  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }
  std::size_t of_joints() const { return 2 * system_->joints().size(); }

  template <class T>
  void fill_joint(std::size_t joint, const SpatialWorkspace<T>& w, std::array<SpatialRow<T>, 2>& rows,
                  bool is_placed = false) const {
    const SpatialJointElement<R>& at = system_->joints()[joint];
    const SpatialFrame<T>& bearing = system_->frame(at.bearing_at.body, w);
    const SpatialFrame<T>& journal = system_->frame(at.journal_at.body, w);
    if (is_placed) {
      fill_eccentricity(bearing, journal, w.joints[joint].kinematics, rows);
    } else {
      fill_eccentricity(bearing, journal, at.kinematics(bearing, journal), rows);
    }
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
      for_each_side(w.rows[system_->kept()[i]], constraint_sides_[i].first, constraint_sides_[i].second,
                    put(constraints, i));
    Matrix functions = Matrix::Zero(index(candidates_.size()), index(n_));
    for (std::size_t c = 0; c < candidates_.size(); ++c)
      for_each_side(row_of(c, w), candidates_[c].first, candidates_[c].second, put(functions, c));
    chosen_ = independent_functions<R>(std::move(constraints), std::move(functions), of_joints(),
                                       [&](std::size_t c) { return lasting(candidates_[c], w); });
    if (chosen_.size() < freedoms()) return false;
    ++choices_;
    numbers_of_chosen_.clear();
    for (std::size_t k = 0; k < freedoms(); ++k)
      numbers_of_chosen_.push_back(chosen_[k] + (is_turn(k) ? choices_ * candidates_.size() : 0));
    return true;
  }

  std::vector<SpatialRow<R>> all_rows(const SpatialWorkspace<R>& w) const {
    std::vector<SpatialRow<R>> rows(n_);
    for (std::size_t i = 0; i < m_; ++i) rows[i] = w.rows[system_->kept()[i]];
    evaluate(w, rows.data() + m_);
    for (std::size_t i = 0; i < n_; ++i) {
      const auto [first, second] =
          i < m_ ? std::pair(constraint_sides_[i].first, constraint_sides_[i].second) : bodies_of(i - m_);
      rows[i] = directions_.of(rows[i], first, second);
    }
    return rows;
  }

  bool find_parts(const R* y, const SpatialWorkspace<R>& w) {
    if (divided_for_ == numbers_of_chosen_) return parts_.find_order(all_rows(w), units_);
    divided_for_ = numbers_of_chosen_;
    std::vector<RowSides> sides = constraint_sides_;
    for (std::size_t k = 0; k < freedoms(); ++k) sides.push_back({bodies_of(k).first, bodies_of(k).second});
    return parts_.find(std::move(sides), constraints_, all_rows(w), units_,
                       [&](const auto& look) { at_odd_places(y, look); });
  }

  /// Calls look(rows of A) at two places without any symmetry, not so far from a state that journals lie across.
  template <class Look>
  void at_odd_places(const R* y, const Look& look) const {
    SpatialWorkspace<R> w = system_->template workspace<R>();
    std::vector<R> odd(y, y + system_->states());
    R length(0);
    for (std::size_t b = 0; b < system_->bodies().size(); ++b) {
      for (std::size_t k = 0; k < 3; ++k) length = std::max<R>(length, size_of(y[spatial_coordinates * b + k]));
    }
    if (!(length > 0)) length = R(1);
    for (const double seed : {0.37, 1.91}) {
      const auto number = [seed](std::size_t i) { return R(std::sin(seed + 1.7 * static_cast<double>(i * i + i))); };
      for (std::size_t b = 0; b < system_->bodies().size(); ++b) {
        const std::size_t first = spatial_coordinates * b;
        for (std::size_t k = 0; k < 3; ++k) odd[first + k] = y[first + k] + length * number(first + k);
        const R* p = y + first + 3;
        const R angle(0.15);  // relative turns below 1 rad
        const Vector3<R> by(angle * number(first + 3), angle * number(first + 4), angle * number(first + 5));
        const EulerParameters<R> given(p[0], p[1], p[2], p[3]);
        const EulerParameters<R> turned = normalised<R>(EulerParameters<R>(given + euler_rate<R>(given, by)));
        std::copy(turned.data(), turned.data() + 4, odd.begin() + static_cast<std::ptrdiff_t>(first + 3));
      }
      system_->evaluate_kinematics(R(0), odd.data(), w);
      look(all_rows(w));
    }
  }

  /// ρ² of a function that is a turn.
  R turn_square(std::size_t k, const SpatialWorkspace<R>& w) const {
    const Candidate& c = candidates_[chosen_[k]];
    const EulerParameters<R> q = detail::turn_since(from_[c.first], w.frames[c.first].parameters);
    const R along = dot(Vector3<R>(axes_[c.first].col(index(c.part - 3))), Vector3<R>(q(1), q(2), q(3)));
    return R(q(0) * q(0) + along * along);
  }

  /// How far bodies move, in their units, when one function alone changes.
  std::vector<R> sizes_of_functions(const SpatialWorkspace<R>& w) const {
    using Matrix = typename Parts::Matrix;
    const Matrix v = Matrix(parts_.matrix(all_rows(w)))
                         .partialPivLu()
                         .solve(Matrix::Identity(index(n_), index(n_)).rightCols(index(freedoms())));
    std::vector<R> sizes(freedoms(), R(0));
    for (std::size_t k = 0; k < freedoms(); ++k) {
      for (std::size_t i = 0; i < n_; ++i) sizes[k] = std::max<R>(sizes[k], size_of(v(index(i), index(k))) / units_[i]);
    }
    return sizes;
  }
  bool are_as_good_as_at_first(const SpatialWorkspace<R>& w) const {
    const std::vector<R> sizes = sizes_of_functions(w);
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      if (!(sizes[k] < 4 * first_sizes_[k]) || (is_turn(k) && turn_square(k, w) < R(0.5))) return false;
    }
    return true;
  }

  const SpatialSystem<R>* system_;
  std::vector<R> units_;
  std::size_t m_, n_;
  BodyDirections<R> directions_;
  std::vector<Candidate> candidates_;
  std::vector<Matrix3<R>> axes_;          ///< of each body's turns, in its frame, as columns
  std::vector<EulerParameters<R>> from_;  ///< p₀ of each body
  std::vector<std::size_t> chosen_;       ///< candidates
  std::vector<std::size_t> numbers_of_chosen_;
  std::vector<std::size_t> divided_for_;    ///< the functions that parts_ has been divided for
  std::size_t choices_ = 0;                 ///< of functions so far
  std::vector<RowSides> constraint_sides_;  ///< of the rows of constraints
  std::vector<std::size_t> constraints_;    ///< of each of these, its constraint
  Parts parts_;
  std::vector<R> first_sizes_;  ///< of functions, when they were chosen
};

}  // namespace lubjoint

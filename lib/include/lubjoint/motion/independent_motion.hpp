/// Places and velocities of all bodies from those of the coordinates that the constraints leave free.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

#include "lubjoint/multibody/coordinate_chart.hpp"
#include "lubjoint/ode/step_interpolant.hpp"

namespace lubjoint {

/// (q, q̇) of (z, ż), z = C(q) the functions of a chart. With A = [Φq; C]:
///   q from Φ(q, t) = 0, C(q) = z by Newton's method, to rounding;  A q̇ = [−Φt; ż];  A V = [0; I].
/// Coordinates that were found are remembered: a search starts from those of the same time, moved by V, or from the
/// latest ones, moved by their velocities and accelerations, which whoever has them leaves in accelerations_ and w_.
/// @tparam Group  columns of V in one solution
template <class R, int Group>
class IndependentMotion {
 public:
  using Full = std::vector<R>;  ///< (q, q̇, more)

  const CoordinateChart<R>& chart() const { return chart_; }  ///< the present one
  std::size_t freedoms() const { return n_ - m_; }            ///< number of z

  /// Chooses functions at a state that fulfils the constraints, near which the next search starts.
  /// @throws SingularConstraints where there is no choice
  void choose(const R& t, const Full& y) {
    if (!chart_.choose(t, y.data(), w_)) throw SingularConstraints("the constraints are not independent");
    std::copy(y.begin(), y.end(), y_.begin());
    // Rounding of a place is that of the coordinates around it.
    R length(0);
    for (std::size_t i = 0; i < n_; ++i) {
      if (i % 3 != 2) length = std::max<R>(length, size_of(y[i]));
    }
    inverse_length_ = length > 0 ? R(1 / length) : R(1);
    forget();
  }

  /// (z, ż) and their rates of a state and its rates, both whole.
  void see(const Full& y, const Full& rate, std::vector<R>& x, std::vector<R>& x_rate) {
    forget();
    const std::size_t f = freedoms();
    system_.place(y.data(), w_);
    chart_.evaluate(y.data(), w_, functions_.data());
    x.resize(2 * f);
    x_rate.resize(2 * f);
    for (std::size_t k = 0; k < f; ++k) {
      x[k] = functions_[k].value;
      x[f + k] = x_rate[k] = along(functions_[k], k, y.data() + n_);
      x_rate[f + k] = along(functions_[k], k, rate.data() + n_) - functions_[k].gamma;
    }
  }

  /// Moves (q, q̇) of a state near it to (z, ż) inside a step, as nothing but the two say. @throws SingularConstraints
  void correct(const R& t, const StepInterpolant<std::vector<R>>& step, Full& y) {
    forget();
    step.state_at(t, freedoms(), inside_);
    std::copy_n(y.begin(), n_, y_.begin());
    place_frames();
    search(t, inside_);
    find_velocities(inside_);
    std::copy_n(y_.begin(), 2 * n_, y.begin());
  }

 protected:
  using Columns = Eigen::Array<R, Group, 1>;  ///< so many columns of V at a coordinate
  static constexpr std::size_t group = Group;

  /// @param units  in which the coordinates are comparable;  @param states  of the whole state
  IndependentMotion(const PlanarSystem<R>& system, const std::vector<R>& units, std::size_t states)
      : system_(system),
        n_(system.coordinates()),
        m_(system.constraint_rows()),
        chart_(system, units),
        w_(system.template workspace<R>()),
        y_(states),
        speeds_(freedoms()),
        accelerations_(freedoms()),
        gammas_(n_),
        functions_(freedoms()),
        residual_(n_),
        step_(n_),
        work_(n_),
        column_residual_(n_),
        column_work_(n_),
        right_(freedoms()) {
    const Place empty{{},
                      false,
                      std::vector<R>(n_),
                      std::vector<Columns>(n_ * groups()),
                      std::vector<std::array<R, 2>>(system_.bodies().size()),
                      std::vector<R>(freedoms())};
    places_.fill(empty);
  }
  IndependentMotion(const IndependentMotion&) = default;

  /// Coordinates that were found at a time: the stages of a step ask again and again for the same times.
  struct Place {
    R t{};
    bool known = false;
    std::vector<R> q;
    std::vector<Columns> columns;         ///< V
    std::vector<std::array<R, 2>> turns;  ///< cosine and sine of each body's angle
    std::vector<R> z;
  };

  void forget() {
    for (Place& each : places_) each.known = false;
    here_ = false;
    accelerated_ = false;
  }
  /// Column k of V is the k % group-th part of these.
  const Columns* column(std::size_t k) const { return places_[latest_].columns.data() + (k / group) * n_; }

  static R size_of(const R& x) { return x < 0 ? R(-x) : x; }
  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }
  std::size_t groups() const { return (freedoms() + group - 1) / group; }

  /// C v of function k and a vector by coordinates.
  template <class T, class V>
  T along(const ConstraintRow<T>& row, std::size_t k, const V* v) const {
    T sum(0);
    const auto [first, second] = chart_.bodies_of(k);
    for (std::size_t c = 0; c < 3; ++c) {
      if (first != ground_body) sum += row.first[c] * v[3 * first + c];
      if (second != ground_body) sum += row.second[c] * v[3 * second + c];
    }
    return sum;
  }

  /// Evaluates the constraints at the frames and hands each of their rows to keep(number, row), which the compiler
  /// spares what it does not read.
  template <class Keep>
  void for_each_row(const R& t, const Keep& keep) {
    const auto& constraints = system_.constraints();
    for (std::size_t c = 0; c < constraints.size(); ++c) {
      const std::size_t row = system_.first_row(c);
      const PlanarFrame<R>& first = system_.frame(system_.first_body_of_row(row), w_);
      const PlanarFrame<R>& second = system_.frame(system_.second_body_of_row(row), w_);
      std::visit(
          [&]<class Constraint>(const Constraint& constraint) {
            std::array<ConstraintRow<R>, Constraint::rows> from;
            constraint.evaluate(first, second, t, from.data());
            for (std::size_t i = 0; i < Constraint::rows; ++i) keep(row + i, from[i]);
          },
          constraints[c].constraint);
    }
  }

  /// Rows and factors at the places of the frames.
  void factorise_here(const R& t) {
    for_each_row(t, [this](std::size_t number, const ConstraintRow<R>& row) { chart_.put(number, row); });
    chart_.evaluate(y_.data(), w_, functions_.data());
    for (std::size_t k = 0; k < freedoms(); ++k) chart_.put(m_ + k, functions_[k]);
    chart_.factorise();
  }

  /// Solves for the change of the coordinates. @returns its largest part in the size of its coordinate
  template <class Small>
  R newton_step(const Small& x) {
    for (std::size_t row = 0; row < n_; ++row) residual_[row] = chart_.value(row);
    for (std::size_t k = 0; k < freedoms(); ++k) residual_[m_ + k] -= x[k];
    chart_.solve(residual_.data(), step_.data(), work_.data());
    R size(0);
    for (std::size_t b = 0; b < n_; b += 3) {
      const R unit = size_of(y_[b + 2]);
      size = std::max<R>(size, std::max<R>(size_of(step_[b]), size_of(step_[b + 1])) * inverse_length_);
      size = std::max<R>(size, unit > 1 ? R(size_of(step_[b + 2]) / unit) : size_of(step_[b + 2]));
    }
    return size;
  }

  /// q near those of the same time, or of the latest place.
  template <class Small>
  void guess(std::size_t at, const R& t, const Small& x) {
    const std::size_t f = freedoms();
    const Place& from = places_[at < places_.size() ? at : latest_];
    if (!from.known) return;  // y_ is what was taken
    std::copy(from.q.begin(), from.q.end(), y_.begin());
    for (std::size_t k = 0; k < f; ++k) right_[k] = x[k] - from.z[k];
    if (from.t != t && accelerated_) {
      const R dt = t - from.t;
      for (std::size_t i = 0; i < n_; ++i) y_[i] += dt * (y_[n_ + i] + dt / 2 * w_.accelerations[i]);
      for (std::size_t k = 0; k < f; ++k) right_[k] -= dt * (speeds_[k] + dt / 2 * accelerations_[k]);
    }
    add_along(from, right_.data(), y_.data());
  }

  /// x += V dz
  void add_along(const Place& place, const R* dz, R* x) const {
    for (std::size_t g = 0; g < groups(); ++g) {
      Columns part = Columns::Zero();
      for (std::size_t k = g * group; k < std::min<std::size_t>(freedoms(), (g + 1) * group); ++k)
        part(index(k - g * group)) = dz[k];
      const Columns* v = place.columns.data() + g * n_;
      for (std::size_t i = 0; i < n_; ++i) x[i] += (v[i] * part).sum();
    }
  }

  /// y_ = (q, q̇) of x to rounding, with the rows there, the chart's factors and V.
  template <class Small>
  void follow(const R& t, const Small& x) {
    const std::size_t f = freedoms();
    const auto same = [f](const std::vector<R>& z, const R* x_part) {
      for (std::size_t k = 0; k < f; ++k) {
        if (z[k] != x_part[k]) return false;
      }
      return true;
    };
    const bool placed = here_ && t == places_[latest_].t && same(places_[latest_].z, x.data());
    if (placed && same(speeds_, x.data() + f)) return;
    here_ = false;
    if (!placed) find_places(t, x);
    accelerated_ = false;
    find_velocities(x);
    for (std::size_t k = 0; k < f; ++k) speeds_[k] = x[f + k];
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      w_.frames[b].velocity = Vector2<R>(y_[n_ + 3 * b], y_[n_ + 3 * b + 1]);
      w_.frames[b].spin = y_[n_ + 3 * b + 2];
    }
    for_each_row(t, [this](std::size_t number, const ConstraintRow<R>& row) { gammas_[number] = row.gamma; });
    chart_.evaluate(y_.data(), w_, functions_.data());
    for (std::size_t k = 0; k < f; ++k) gammas_[m_ + k] = functions_[k].gamma;
    here_ = true;
  }

  template <class Small>
  void find_velocities(const Small& x) {
    for (std::size_t row = 0; row < m_; ++row) residual_[row] = -chart_.time_rate(row);
    for (std::size_t k = 0; k < freedoms(); ++k) residual_[m_ + k] = x[freedoms() + k];
    chart_.solve(residual_.data(), y_.data() + n_, work_.data());
  }

  template <class Small>
  void find_places(const R& t, const Small& x) {
    const std::size_t f = freedoms();
    std::size_t at = 0;
    while (at < places_.size() && !(places_[at].known && places_[at].t == t)) ++at;
    guess(at, t, x);
    if (at == places_.size() || !turn_frames(places_[at])) place_frames();
    if (at == places_.size()) at = next_ = (next_ + 1) % places_.size();
    Place& place = places_[at];
    search(t, x);  // the place stays as it is if there is none
    // V, a column each function.
    for (std::size_t row = 0; row < m_; ++row) column_residual_[row].setZero();
    for (std::size_t g = 0; g < groups(); ++g) {
      for (std::size_t k = 0; k < f; ++k) {
        column_residual_[m_ + k].setZero();
        if (k / group == g) column_residual_[m_ + k](index(k % group)) = R(1);
      }
      chart_.solve(column_residual_.data(), place.columns.data() + g * n_, column_work_.data());
    }
    place.t = t;
    place.known = true;
    std::copy(y_.begin(), y_.begin() + static_cast<std::ptrdiff_t>(n_), place.q.begin());
    for (std::size_t k = 0; k < f; ++k) place.z[k] = x[k];
    for (std::size_t b = 0; b < place.turns.size(); ++b) place.turns[b] = {w_.frames[b].cosine, w_.frames[b].sine};
    latest_ = at;
  }

  /// By Newton's method from the frames, with factors at the end.
  template <class Small>
  void search(const R& t, const Small& x) {
    const R rounding = 4 * std::numeric_limits<R>::epsilon();
    R before = std::numeric_limits<R>::infinity();
    for (int iteration = 0;; ++iteration) {
      factorise_here(t);
      const R size = newton_step(x);
      if (size <= rounding || (iteration > 0 && size >= before && size < 1000 * rounding)) break;
      if (!(size < 1) || iteration == most_iterations)
        throw SingularConstraints("no places near the last ones fulfil the constraints");
      before = size;
      for (std::size_t i = 0; i < n_; ++i) y_[i] -= step_[i];
      if (size < R(last_step)) {
        move_frames();
        factorise_here(t);
        break;
      }
      place_frames();
    }
  }

  void place_frames() {
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      w_.frames[b] = PlanarFrame<R>(
          PlanarMotion<R>{Vector2<R>(y_[3 * b], y_[3 * b + 1]), y_[3 * b + 2], Vector2<R>(R(0), R(0)), R(0)});
    }
  }

  /// From a place of the same time, where all have turned little: by the series of cosine and sine, whose next terms
  /// are below rounding. A stage asks a dozen times, and each adds half a unit of rounding; the next step starts
  /// afresh.
  bool turn_frames(const Place& from) {
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      const R angle = y_[3 * b + 2] - from.q[3 * b + 2];
      if (!(size_of(angle) < R(1e-3))) return false;
      const R square = angle * angle;
      const R sine = angle * (1 - square / 6 * (1 - square / 20));
      const R versed = square / 2 * (1 - square / 12);
      const auto [c, s] = from.turns[b];
      PlanarFrame<R>& frame = w_.frames[b];
      frame.position = Vector2<R>(y_[3 * b], y_[3 * b + 1]);
      frame.angle = y_[3 * b + 2];
      frame.cosine = c - (c * versed + s * sine);
      frame.sine = s - (s * versed - c * sine);
    }
    return true;
  }

  /// By the last Newton step: the square of its angle is below rounding.
  void move_frames() {
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      PlanarFrame<R>& frame = w_.frames[b];
      frame.position = Vector2<R>(y_[3 * b], y_[3 * b + 1]);
      frame.angle = y_[3 * b + 2];
      const R turned = -step_[3 * b + 2];
      const R cosine = frame.cosine - turned * frame.sine;
      frame.sine += turned * frame.cosine;
      frame.cosine = cosine;
    }
  }

  const PlanarSystem<R>& system_;
  std::size_t n_, m_;
  CoordinateChart<R> chart_;
  SystemWorkspace<R> w_;
  Full y_;                   ///< (q, q̇) of the last evaluation
  R inverse_length_ = R(1);  ///< of the largest coordinate of a mass centre when the chart was chosen [1/m]
  std::array<Place, 4> places_;
  std::size_t next_ = 0;          ///< the one to be given up next
  std::size_t latest_ = 0;        ///< that of the last evaluation
  bool here_ = false;             ///< is y_ that of latest_ and speeds_?
  bool accelerated_ = false;      ///< and are the accelerations?
  std::vector<R> speeds_;         ///< ż
  std::vector<R> accelerations_;  ///< z̈
  std::vector<R> gammas_;         ///< of all rows
  std::vector<ConstraintRow<R>> functions_;

  // Work, kept so that no evaluation allocates.
  std::vector<R> residual_, step_, work_;
  std::vector<Columns> column_residual_, column_work_;
  std::vector<R> right_, inside_;

 private:
  static constexpr int most_iterations = 12;
  /// Of a Newton step in the size of the mechanism: what it leaves is of its square, below rounding.
  static constexpr double last_step = 1e-9;
};

}  // namespace lubjoint

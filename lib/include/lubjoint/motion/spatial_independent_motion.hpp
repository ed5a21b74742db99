/// Places and velocities of all bodies in space from those of the functions that the constraints leave free.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "lubjoint/multibody/spatial/coordinate_chart.hpp"
#include "lubjoint/ode/step_interpolant.hpp"

namespace lubjoint {

/// p of a body that is turned further by θ′, a rotation vector in its frame, and |p| = 1: exact to the seventh power of
/// |θ′|, without trigonometry.
///   p ∝ p + ½Lᵀθ′ τ,   τ = tan(½|θ′|)/(½|θ′|) = 1 + |θ′|²/12 + |θ′|⁴/120 + …
template <class R>
EulerParameters<R> turned(const EulerParameters<R>& p, const Vector3<R>& by) {
  using std::abs;
  using std::sqrt;
  const R square = dot(by, by);
  const EulerParameters<R> next = p + euler_rate(p, scaled(R(1 + square / 12 * (1 + square / 10)), by));
  const R size = next(0) * next(0) + next(1) * next(1) + next(2) * next(2) + next(3) * next(3);
  // Nearly 1 at the end of a search: there the series of 1/√size, whose next term is below rounding.
  const R off = size - 1;
  const R inverse = off * off * abs(off) < std::numeric_limits<R>::epsilon() ? R(1 - off / 2 * (1 - R(0.75) * off))
                                                                             : R(1 / sqrt(size));
  return EulerParameters<R>(R(next(0) * inverse), R(next(1) * inverse), R(next(2) * inverse), R(next(3) * inverse));
}

/// (r, p; ṙ, ω′) of (z, ż), z = C(r, p) the functions of a chart. With A = [Φ_v; C_v] on v = (ṙ, ω′):
///   (r, p) from Φ(r, p, t) = 0, C(r, p) = z by Newton's method, to rounding, p changed by turns;
///   A v = [−Φ_t; ż];  A V = [0; I].
/// Places that were found are remembered: a search starts from those of the same time, moved by V, or from the latest
/// ones, moved by their velocities and accelerations, which whoever has them leaves in accelerations_ and w_.
/// @tparam Group  columns of V in one solution
template <class R, int Group>
class SpatialIndependentMotion {
 public:
  using Full = std::vector<R>;  ///< (r, p; ṙ, ω′; more)

  const SpatialCoordinateChart<R>& chart() const { return chart_; }  ///< the present one
  R wear() const { return chart_.wear(); }                           ///< of the chart: see CoordinateChart
  std::size_t freedoms() const { return n_ - m_; }                   ///< number of z

  /// Chooses functions at a state that fulfils the constraints, near which the next search starts.
  /// @throws SingularConstraints where there is no choice
  void choose(const R& t, const Full& y) {
    if (!chart_.choose(t, y.data(), w_)) throw SingularConstraints("the constraints are not independent");
    start_from(y);
    // Rounding of a place is that of the coordinates around it.
    R length(0);
    for (std::size_t b = 0; b < bodies_; ++b) {
      for (std::size_t k = 0; k < 3; ++k) length = std::max<R>(length, size_of(y[7 * b + k]));
    }
    inverse_length_ = length > 0 ? R(1 / length) : R(1);
  }

  /// (z, ż) and their rates of a state and its rates, both whole. Turns are of the revolution that is nearest to what
  /// was seen before.
  void see(const Full& y, const Full& rate, std::vector<R>& x, std::vector<R>& x_rate) {
    forget();
    const std::size_t f = freedoms();
    system_.place(y.data(), w_);
    chart_.evaluate(w_, functions_.data());
    x.resize(2 * f, R(0));
    x_rate.resize(2 * f);
    for (std::size_t k = 0; k < f; ++k) {
      x[k] = chart_.is_turn(k) ? R(x[k] + off(k, functions_[k].value, x[k])) : functions_[k].value;
      x[f + k] = x_rate[k] = along(functions_[k], k, y.data() + places_end_);
      x_rate[f + k] = along(functions_[k], k, rate.data() + places_end_) - functions_[k].gamma;
    }
  }

  /// Moves places and velocities of a state near it to (z, ż) inside a step, as nothing but the two say.
  /// @throws SingularConstraints
  void correct(const R& t, const StepInterpolant<std::vector<R>>& step, Full& y) {
    start_from(y);
    step.state_at(t, freedoms(), inside_);
    place_frames();
    search(t, inside_, std::numeric_limits<R>::infinity());
    find_velocities(inside_);
    std::copy_n(y_.begin(), places_end_ + n_, y.begin());
  }

 protected:
  using Columns = Eigen::Array<R, Group, 1>;  ///< so many columns of V at a velocity
  static constexpr std::size_t group = Group;

  /// @param units  in which displacements and small turns are comparable;  @param states  of the whole state
  /// @param keeps_rows  do the constraints' rows of the last evaluation stay in w_?
  SpatialIndependentMotion(const SpatialSystem<R>& system, const std::vector<R>& units, std::size_t states,
                           bool keeps_rows)
      : system_(system),
        bodies_(system.bodies().size()),
        places_end_(system.places()),
        n_(system.velocities()),
        m_(system.kept().size()),
        keeps_rows_(keeps_rows),
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
    const Place empty{
        {}, false, std::vector<R>(places_end_), std::vector<Columns>(n_ * groups()), std::vector<R>(freedoms())};
    places_.fill(empty);
    for (std::size_t row = 0; row < system.constraint_rows(); ++row) number_of_row_.push_back(none);
    for (std::size_t i = 0; i < m_; ++i) number_of_row_[system.kept()[i]] = i;
  }
  SpatialIndependentMotion(const SpatialIndependentMotion&) = default;

  /// Places that were found at a time: the stages of a step ask again and again for the same times.
  struct Place {
    R t{};
    bool known = false;
    std::vector<R> q;              ///< (r, p)
    std::vector<Columns> columns;  ///< V
    std::vector<R> z;
  };

  /// The next search starts from the places of a state, with |p| = 1, also if one of them fails.
  void start_from(const Full& y) {
    std::copy(y.begin(), y.end(), y_.begin());
    normalise();
    taken_.assign(y_.begin(), y_.begin() + static_cast<std::ptrdiff_t>(places_end_));
    forget();
  }
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

  /// C_v x of function k and a vector x by velocities.
  template <class T, class V>
  T along(const SpatialRow<T>& row, std::size_t k, const V* x) const {
    T sum(0);
    const auto [first, second] = chart_.bodies_of(k);
    for (std::size_t c = 0; c < 6; ++c) {
      if (first != ground_body) sum += row.first[c] * x[6 * first + c];
      if (second != ground_body) sum += row.second[c] * x[6 * second + c];
    }
    return sum;
  }

  /// Evaluates the constraints at the frames and hands each of the rows that are kept to keep(number, row), which the
  /// compiler spares what it does not read.
  template <class Keep>
  void for_each_row(const R& t, const Keep& keep) {
    const auto& constraints = system_.constraints();
    for (std::size_t c = 0; c < constraints.size(); ++c) {
      const std::size_t row = system_.first_row(c);
      const SpatialFrame<R>& first = system_.frame(system_.first_body_of_row(row), w_);
      const SpatialFrame<R>& second = system_.frame(system_.second_body_of_row(row), w_);
      std::visit(
          [&]<class Constraint>(const Constraint& constraint) {
            for_each_row_of(constraint, first, second, t, [&](std::size_t i, const SpatialRow<R>& from) {
              if (number_of_row_[row + i] != none) keep(number_of_row_[row + i], from);
            });
          },
          constraints[c].constraint);
    }
  }

  /// Values of the rows at the places of the frames; the factors stay.
  void evaluate_here(const R& t) {
    for_each_row(t, [this](std::size_t number, const SpatialRow<R>& row) { chart_.put_value(number, row.value); });
    chart_.for_each_function(w_,
                             [this](std::size_t k, const SpatialRow<R>& row) { chart_.put_value(m_ + k, row.value); });
  }
  /// Rows and factors at the places of the frames.
  void factorise_here(const R& t) {
    for_each_row(t, [this](std::size_t number, const SpatialRow<R>& row) { chart_.put(number, row); });
    chart_.for_each_function(w_, [this](std::size_t k, const SpatialRow<R>& row) { chart_.put(m_ + k, row); });
    chart_.factorise();
  }

  /// Solves for the displacement to be taken back. @returns its largest part in the size of its coordinate
  template <class Small>
  R newton_step(const Small& x) {
    for (std::size_t row = 0; row < n_; ++row) residual_[row] = chart_.value(row);
    for (std::size_t k = 0; k < freedoms(); ++k) residual_[m_ + k] = off(k, residual_[m_ + k], x[k]);
    chart_.solve(residual_.data(), step_.data(), work_.data());
    return size_of_step();
  }
  R size_of_step() const {
    R size(0);
    for (std::size_t i = 0; i < n_; ++i) {
      const R of_this = i % 6 < 3 ? R(size_of(step_[i]) * inverse_length_) : size_of(step_[i]);
      if (!(of_this <= size)) size = of_this;
      if (std::isnan(static_cast<double>(size))) break;
    }
    return size;
  }
  /// z of function k less what it should be; of a turn, by the revolution that is nearest.
  R off(std::size_t k, const R& value, const R& wanted) const {
    using std::round;
    const R difference = value - wanted;
    if (!chart_.is_turn(k) || size_of(difference) < R(3)) return difference;
    const R turn = 2 * pi<R>();
    return R(difference - turn * round(R(difference / turn)));
  }

  /// Places near those of the same time, or of the latest place. @returns how far from them, if there are any
  template <class Small>
  R guess(std::size_t at, const R& t, const Small& x) {
    const std::size_t f = freedoms();
    const Place& from = places_[at < places_.size() ? at : latest_];
    const std::vector<R>& q = from.known ? from.q : taken_;
    std::copy(q.begin(), q.end(), y_.begin());
    if (!from.known) return std::numeric_limits<R>::infinity();
    for (std::size_t k = 0; k < f; ++k) right_[k] = x[k] - from.z[k];
    std::fill(step_.begin(), step_.end(), R(0));
    if (from.t != t && accelerated_) {
      const R dt = t - from.t;
      for (std::size_t i = 0; i < n_; ++i) step_[i] = dt * (y_[places_end_ + i] + dt / 2 * w_.accelerations[i]);
      for (std::size_t k = 0; k < f; ++k) right_[k] -= dt * (speeds_[k] + dt / 2 * accelerations_[k]);
    }
    for (std::size_t k = 0; k < f; ++k) right_[k] = off(k, right_[k], R(0));
    add_along(from, right_.data(), step_.data());
    displace(R(1));
    return size_of_step();
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

  /// y_ = (r, p; ṙ, ω′) of x to rounding, with the rows there, the chart's factors and V.
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
    for (std::size_t b = 0; b < bodies_; ++b) {
      SpatialFrame<R>& frame = w_.frames[b];
      const R* v = y_.data() + places_end_ + 6 * b;
      frame.velocity = Vector3<R>(v[0], v[1], v[2]);
      frame.body_spin = Vector3<R>(v[3], v[4], v[5]);
      frame.spin = product(frame.rotation, frame.body_spin);
    }
    if (keeps_rows_) {
      system_.evaluate_constraints(t, w_, system_.every_body);
      for (std::size_t i = 0; i < m_; ++i) gammas_[i] = w_.rows[system_.kept()[i]].gamma;
    } else {
      for_each_row(t, [this](std::size_t number, const SpatialRow<R>& row) { gammas_[number] = row.gamma; });
    }
    chart_.evaluate(w_, functions_.data());
    for (std::size_t k = 0; k < f; ++k) gammas_[m_ + k] = functions_[k].gamma;
    here_ = true;
  }

  template <class Small>
  void find_velocities(const Small& x) {
    for (std::size_t row = 0; row < m_; ++row) residual_[row] = -chart_.time_rate(row);
    for (std::size_t k = 0; k < freedoms(); ++k) residual_[m_ + k] = x[freedoms() + k];
    chart_.solve(residual_.data(), y_.data() + places_end_, work_.data());
  }

  template <class Small>
  void find_places(const R& t, const Small& x) {
    const std::size_t f = freedoms();
    std::size_t at = 0;
    while (at < places_.size() && !(places_[at].known && places_[at].t == t)) ++at;
    const R moved = guess(at, t, x);
    place_frames();
    if (at == places_.size()) {
      at = next_ = (next_ + 1) % places_.size();
      if (at != latest_ && places_[latest_].known) chart_.copy_factors(latest_, at);
    }
    Place& place = places_[at];
    if (place.known) taken_ = place.q;  // should the search fail
    place.known = false;
    chart_.use(at);
    search(t, x, moved);
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
    std::copy_n(y_.begin(), places_end_, place.q.begin());
    for (std::size_t k = 0; k < f; ++k) place.z[k] = x[k];
    latest_ = at;
  }

  /// By Newton's method from the frames, with factors at the end. Its first steps take the factors that there are.
  /// @param moved  how far from where those were made, as newton_step's sizes; infinity: there are none
  template <class Small>
  void search(const R& t, const Small& x, R moved) {
    const R rounding = 4 * std::numeric_limits<R>::epsilon();
    R before = std::numeric_limits<R>::infinity();
    for (int iteration = 0;; ++iteration) {
      const bool afresh = !(moved < R(near)) || iteration > 3;
      if (afresh) {
        factorise_here(t);
        moved = R(0);
      } else {
        evaluate_here(t);
      }
      const R size = newton_step(x);
      if (size <= rounding || (iteration > 0 && size >= before && size < 1000 * rounding)) {
        if (!afresh) factorise_here(t);
        break;
      }
      if (!(size < 1) || iteration == most_iterations)
        throw SingularConstraints("no places near the last ones fulfil the constraints");
      before = size;
      displace(R(-1));
      place_frames();
      moved += size;
      if (moved * size < std::numeric_limits<R>::epsilon() / 256) {  // what is left is a few times that
        factorise_here(t);
        break;
      }
    }
  }

  /// Places of y_ by step_, or by its opposite; |p| = 1.
  void displace(const R& sign) {
    for (std::size_t b = 0; b < bodies_; ++b) {
      R* q = y_.data() + 7 * b;
      const R* by = step_.data() + 6 * b;
      for (std::size_t k = 0; k < 3; ++k) q[k] += sign * by[k];
      const EulerParameters<R> p =
          turned(EulerParameters<R>(q[3], q[4], q[5], q[6]), Vector3<R>(sign * by[3], sign * by[4], sign * by[5]));
      std::copy_n(p.data(), 4, q + 3);
    }
  }
  void normalise() {
    std::fill(step_.begin(), step_.end(), R(0));
    displace(R(1));
  }

  void place_frames() {
    for (std::size_t b = 0; b < bodies_; ++b) {
      SpatialFrame<R>& frame = w_.frames[b];
      const R* q = y_.data() + 7 * b;
      frame.position = Vector3<R>(q[0], q[1], q[2]);
      frame.parameters = EulerParameters<R>(q[3], q[4], q[5], q[6]);
      frame.rotation = rotation_matrix(frame.parameters);
    }
  }

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  const SpatialSystem<R>& system_;
  std::size_t bodies_, places_end_;  ///< number of (r, p), behind which velocities begin
  std::size_t n_, m_;
  bool keeps_rows_;
  SpatialCoordinateChart<R> chart_;
  SpatialWorkspace<R> w_;
  Full y_;                   ///< (r, p; ṙ, ω′) of the last evaluation
  R inverse_length_ = R(1);  ///< of the largest coordinate of a mass centre when the chart was chosen [1/m]
  std::array<Place, SpatialCoordinateChart<R>::slots> places_;
  std::size_t next_ = 0;          ///< the one to be given up next
  std::size_t latest_ = 0;        ///< that of the last evaluation
  bool here_ = false;             ///< is y_ that of latest_ and speeds_?
  bool accelerated_ = false;      ///< and are the accelerations?
  std::vector<R> speeds_;         ///< ż
  std::vector<R> accelerations_;  ///< z̈
  std::vector<R> gammas_;         ///< of all rows
  std::vector<SpatialRow<R>> functions_;

  // Work, kept so that no evaluation allocates.
  std::vector<R> residual_, step_, work_;
  std::vector<Columns> column_residual_, column_work_;
  std::vector<R> right_, inside_, taken_;

 private:
  static constexpr int most_iterations = 12;
  /// Further from where factors were made they serve no more: each step would gain less than three digits.
  static constexpr double near = 1e-3;

  std::vector<std::size_t> number_of_row_;  ///< of each of the system's rows in A, or none
};

}  // namespace lubjoint

/// Places and velocities of all bodies from those of the coordinates that the constraints leave free.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

#include "lubjoint/motion/found_places.hpp"
#include "lubjoint/multibody/coordinate_chart.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/ode/step_interpolant.hpp"

namespace lubjoint {

/// (q, q̇) of (z, ż), z = C(q) the functions of a chart. With A = [Φq; C]:
///   q from Φ(q, t) = 0, C(q) = z by Newton's method, to rounding;  A V = [0; I],  A d = [−Φt; 0];  q̇ = V ż + d.
/// What the time alone prescribes is found once for every time. The others that were found are remembered with their
/// factors: a search starts from those of the same time, moved by V and corrected once by their factors, or from the
/// latest ones, moved by their velocities and accelerations, which whoever has them leaves in accelerations_ and w_.
/// @tparam Freedoms  number of z, or run_time_size
template <class R, std::size_t Freedoms>
class IndependentMotion {
 public:
  using Full = std::vector<R>;  ///< (q, q̇, more)

  const CoordinateChart<R>& chart() const { return chart_; }  ///< the present one
  /// Of the chart at the last place: see CoordinateChart.
  R wear() const { return chart_.parts().wear(numbers()); }
  /// Number of z.
  std::size_t freedoms() const {
    if constexpr (Freedoms != run_time_size) {
      return Freedoms;
    } else {
      return n_ - m_;
    }
  }

  /// Chooses functions at a state that fulfils the constraints, near which the next search starts.
  /// @throws SingularConstraints where there is no choice
  void choose(const R& t, const Full& y) {
    if (!chart_.choose(t, y.data(), w_)) throw SingularConstraints("the constraints are not independent");
    places_.resize(prescribed(), free(), groups());
    right_columns_.assign(free().size() * groups(), Columns::Zero());
    for (std::size_t k = 0; k < freedoms(); ++k)
      right_columns_[(k / group) * free().size() + first_function() + k](index(k % group)) = R(1);
    start_from(y);
    // Rounding of a place is that of the coordinates around it.
    R length(0);
    for (std::size_t i = 0; i < n_; ++i) {
      if (i % 3 != 2) length = std::max<R>(length, size_of(y[i]));
    }
    inverse_length_ = length > 0 ? R(1 / length) : R(1);
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
    start_from(y);
    step.state_at(t, freedoms(), inside_);
    Place& place = places_.latest();
    Moment& moment = places_.moment_of(place);
    place_frames();
    prescribe(t, moment);
    search(t, inside_, place, moment);
    find_velocities(place, inside_);
    std::copy_n(y_.begin(), 2 * n_, y.begin());
  }

 protected:
  using Part = typename ChartParts<R>::Part;
  /// Columns in one solution: V's, d, and the Newton step that is left.
  static constexpr std::size_t group = Freedoms == run_time_size ? 4 : Freedoms + 2;
  using Columns = Eigen::Array<R, static_cast<int>(group), 1>;  ///< so many columns at a coordinate

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
        work_(3 * n_),
        places_(system.bodies().size(), freedoms()),
        column_work_(n_),
        right_(freedoms()) {}
  IndependentMotion(const IndependentMotion&) = default;

  using Moment = typename FoundPlaces<R, Columns>::Moment;
  using Place = typename FoundPlaces<R, Columns>::Place;

  /// The next search starts from the coordinates of a state, also if one of them fails.
  void start_from(const Full& y) {
    std::copy(y.begin(), y.end(), y_.begin());
    taken_.assign(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(n_));
    forget();
  }
  void forget() {
    places_.forget();
    here_ = false;
    accelerated_ = false;
  }
  const Part& prescribed() const { return chart_.parts().prescribed(); }
  const Part& free() const { return chart_.parts().free(); }
  const Place& latest() const { return places_.latest(); }  ///< that of the last evaluation
  const Moment& moment() const { return places_.moment_of(latest()); }
  typename ChartParts<R>::Numbers numbers() const { return {moment().numbers.data(), latest().numbers.data()}; }
  /// Column k of V, d after them, at the i-th free coordinate.
  const R& column(const Place& place, std::size_t k, std::size_t i) const {
    if constexpr (Freedoms != run_time_size) {
      return place.columns[i](index(k));
    } else {
      return place.columns[(k / group) * free().size() + i](index(k % group));
    }
  }

  static R size_of(const R& x) {
    using std::abs;
    return abs(x);
  }
  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }
  std::size_t groups() const { return (freedoms() + 2 + group - 1) / group; }
  std::size_t first_function() const { return free().size() - freedoms(); }  ///< among the free rows

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

  /// x += V dz
  void add_along(const Place& place, const R* dz, R* x) const {
    for (std::size_t i = 0; i < free().size(); ++i) {
      R& at = x[free().columns[i]];
      R sum = at;
      for (std::size_t k = 0; k < freedoms(); ++k) sum += column(place, k, i) * dz[k];
      at = sum;
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
    const bool placed = here_ && t == latest().t && same(latest().z, x.data());
    if (placed && same(speeds_, x.data() + f)) return;
    here_ = false;
    if (!placed) find_places(t, x);
    accelerated_ = false;
    find_velocities(latest(), x);
    for (std::size_t k = 0; k < f; ++k) speeds_[k] = x[f + k];
    move_frames_on(free());
    find_gammas(t, free());
    const std::vector<R>& prescribed = moment().accelerations;
    chart_.parts().for_each_coupling(
        latest().numbers.data(), [&](auto row, auto column, const R& k) { gammas_[row] -= k * prescribed[column]; });
    here_ = true;
  }

  /// q̈ at the place of the last follow if z̈ = 0.
  void accelerate_unmoved(R* a) {
    for (std::size_t i = 0; i < prescribed().size(); ++i) a[prescribed().columns[i]] = moment().accelerations[i];
    free().lu.solve(latest().numbers.data(), gammas_.data(), step_.data(), work_.data());
    for (std::size_t i = 0; i < free().size(); ++i) a[free().columns[i]] = step_[i];
  }

  const PlanarSystem<R>& system_;
  std::size_t n_, m_;
  CoordinateChart<R> chart_;
  SystemWorkspace<R> w_;
  Full y_;                        ///< (q, q̇) of the last evaluation
  bool here_ = false;             ///< is y_ that of the latest place and of speeds_?
  bool accelerated_ = false;      ///< and are the accelerations?
  std::vector<R> speeds_;         ///< ż
  std::vector<R> accelerations_;  ///< z̈
  std::vector<R> gammas_;         ///< of the free rows, less what the prescribed accelerations are to them
  std::vector<ConstraintRow<R>> functions_;
  std::vector<R> residual_, step_, work_;  ///< work, kept so that no evaluation allocates

 private:
  static constexpr int most_iterations = 12;
  /// Of a step with the factors of another place at the same time: they are as far from right as it is long.
  static constexpr double longest_chord = 1e-4;
  static constexpr R rounding = 4 * std::numeric_limits<R>::epsilon();
  /// A step that leaves the factors before it right to their own rounding.
  static constexpr R settled = 16 * rounding;

  /// Evaluates the constraints of a part at the frames and hands each of its rows to keep(its number in the part, row),
  /// which the compiler spares what it does not read.
  template <class Keep>
  void for_each_row(const R& t, const Part& part, const Keep& keep) {
    const ChartParts<R>& parts = chart_.parts();
    const auto& constraints = system_.constraints();
    for (const std::size_t c : part.constraints) {
      const std::size_t row = system_.first_row(c);
      const PlanarFrame<R>& first = system_.frame(system_.first_body_of_row(row), w_);
      const PlanarFrame<R>& second = system_.frame(system_.second_body_of_row(row), w_);
      std::visit(
          [&]<class Constraint>(const Constraint& constraint) {
            std::array<ConstraintRow<R>, Constraint::rows> from;
            constraint.evaluate(first, second, t, from.data());
            for (std::size_t i = 0; i < Constraint::rows; ++i) {
              if (parts.is_in(part, row + i)) keep(parts.place_in_part(row + i), from[i]);
            }
          },
          constraints[c].constraint);
    }
    if (&part == &prescribed()) return;
    const std::size_t first = first_function();
    chart_.for_each_function(y_.data(), w_, [&](std::size_t k, const ConstraintRow<R>& row) { keep(first + k, row); });
  }

  /// Φ and C − z at the frames.
  template <class Small>
  [[gnu::flatten]] void find_residual(const R& t, const Small& x) {
    for_each_row(t, free(), [this](std::size_t number, const ConstraintRow<R>& row) { residual_[number] = row.value; });
    for (std::size_t k = 0; k < freedoms(); ++k) residual_[first_function() + k] -= x[k];
  }

  /// Rows and factors at the frames.
  [[gnu::flatten]] void factorise_here(const R& t, const Part& part, R* numbers) {
    for_each_row(t, part, [numbers](std::size_t number, const ConstraintRow<R>& row) {
      ChartParts<R>::put(number, row, numbers);
    });
    part.lu.factorise(numbers);
  }

  [[gnu::flatten]] void find_gammas(const R& t, const Part& part) {
    for_each_row(t, part, [this](std::size_t number, const ConstraintRow<R>& row) { gammas_[number] = row.gamma; });
  }

  template <class Small>
  void find_velocities(const Place& place, const Small& x) {
    const std::size_t f = freedoms();
    const Moment& at = places_.moment_of(place);
    for (std::size_t i = 0; i < prescribed().size(); ++i) y_[n_ + prescribed().columns[i]] = at.rates[i];
    for (std::size_t i = 0; i < free().size(); ++i) {
      R rate = column(place, f, i);
      for (std::size_t k = 0; k < f; ++k) rate += column(place, k, i) * x[f + k];
      y_[n_ + free().columns[i]] = rate;
    }
  }

  /// The largest element of a change of a part's coordinates, in the size of its coordinate.
  template <class Step>
  R size_of_step(const Part& part, const Step& step) const {
    R size(0);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::size_t coordinate = part.columns[i];
      R of_this = size_of(step(i));
      if (coordinate % 3 != 2) {
        of_this *= inverse_length_;
      } else if (const R angle = size_of(y_[coordinate]); angle > 1) {
        of_this /= angle;
      }
      if (!(of_this <= size)) size = of_this;
      if (std::isnan(static_cast<double>(size))) break;
    }
    return size;
  }

  /// q near those of the same time, or of the latest place.
  template <class Small>
  void guess(const Place& from, const R& t, const Small& x) {
    const std::vector<R>& q = from.known ? from.q : taken_;
    std::copy(q.begin(), q.end(), y_.begin());
    if (!from.known) return;
    const std::size_t f = freedoms();
    for (std::size_t k = 0; k < f; ++k) right_[k] = x[k] - from.z[k];
    if (from.t != t && accelerated_) {
      const R dt = t - from.t;
      for (std::size_t i = 0; i < n_; ++i) y_[i] += dt * (y_[n_ + i] + dt / 2 * w_.accelerations[i]);
      for (std::size_t k = 0; k < f; ++k) right_[k] -= dt * (speeds_[k] + dt / 2 * accelerations_[k]);
    }
    add_along(from, right_.data(), y_.data());
  }

  template <class Small>
  void find_places(const R& t, const Small& x) {
    Place* same = places_.at(t);
    Place& place = places_.spare();  // the others stay as they are if none is found
    if (same == nullptr) {
      guess(places_.latest(), t, x);
      place_frames();
      Moment& moment = places_.moment_of(place);
      prescribe(t, moment);
      search(t, x, place, moment);
    } else {
      guess(*same, t, x);
      const Moment& moment = places_.moment_of(*same);
      for (std::size_t i = 0; i < moment.frames.size(); ++i) w_.frames[prescribed().bodies[i]] = moment.frames[i];
      if (turn_frames(*same)) {
        step_by_factors(t, x, *same);
      } else {
        place_frames(free());
      }
      search(t, x, place, moment);
    }
    std::copy(y_.begin(), y_.begin() + static_cast<std::ptrdiff_t>(n_), place.q.begin());
    for (std::size_t k = 0; k < freedoms(); ++k) place.z[k] = x[k];
    for (const std::size_t b : free().bodies) place.turns[b] = {w_.frames[b].cosine, w_.frames[b].sine};
    places_.take_spare(t, same);
  }

  /// The prescribed coordinates from the frames, by Newton's method; their rates and accelerations.
  void prescribe(const R& t, Moment& moment) {
    const Part& part = prescribed();
    if (part.size() == 0) return;
    R* numbers = moment.numbers.data();
    const auto solve = [&](const std::vector<R>& right, std::vector<R>& found) {
      part.lu.solve(numbers, right.data(), found.data(), work_.data());
    };
    newton(part, [&] {
      factorise_here(t, part, numbers);
      for (std::size_t i = 0; i < part.size(); ++i) residual_[i] = ChartParts<R>::value(i, numbers);
      solve(residual_, step_);
      return [this](std::size_t i) { return step_[i]; };
    });
    for (std::size_t i = 0; i < part.size(); ++i) residual_[i] = -ChartParts<R>::time_rate(i, numbers);
    solve(residual_, moment.rates);
    for (std::size_t i = 0; i < part.size(); ++i) y_[n_ + part.columns[i]] = moment.rates[i];
    move_frames_on(part);
    find_gammas(t, part);
    solve(gammas_, moment.accelerations);
    for (std::size_t i = 0; i < part.bodies.size(); ++i) moment.frames[i] = w_.frames[part.bodies[i]];
  }

  /// One step of Newton's method with the factors of a place near by, from which the frames were turned.
  template <class Small>
  void step_by_factors(const R& t, const Small& x, const Place& from) {
    find_residual(t, x);
    free().lu.solve(from.numbers.data(), residual_.data(), step_.data(), work_.data());
    const R size = size_of_step(free(), [this](std::size_t i) { return step_[i]; });
    if (size <= rounding || !(size < R(longest_chord))) return;
    for (std::size_t i = 0; i < free().size(); ++i) y_[free().columns[i]] -= step_[i];
    if (!turn_frames(from)) place_frames(free());
  }

  /// The free coordinates from the frames, by Newton's method, with rows, factors, V and d.
  template <class Small>
  void search(const R& t, const Small& x, Place& place, const Moment& moment) {
    const std::size_t left = freedoms() + 1;  // the column of what is left
    newton(free(), [&] {
      factorise_here(t, free(), place.numbers.data());
      take_right_columns(x, place, moment);
      solve_group(left / group, place);
      return [&](std::size_t i) { return column(place, left, i); };
    });
    for (std::size_t g = 0; g < groups(); ++g) {
      if (g != left / group) solve_group(g, place);
    }
  }

  /// Moves the coordinates of a part, and its frames with them, by what each call of next_step returns, until the
  /// factors that it has left are right to rounding.
  template <class NextStep>
  void newton(const Part& part, const NextStep& next_step) {
    R before = std::numeric_limits<R>::infinity();
    for (int iteration = 0;; ++iteration) {
      const auto step = next_step();
      const R size = size_of_step(part, step);
      const bool stands = iteration > 0 && size >= before && size < 1000 * rounding;
      if (!(size <= rounding) && !stands) {
        if (!(size < 1) || iteration == most_iterations)
          throw SingularConstraints("no places near the last ones fulfil the constraints");
        for (std::size_t i = 0; i < part.size(); ++i) y_[part.columns[i]] -= step(i);
        turn_frames(part);
      }
      if (size <= settled || stands) return;
      before = size;
    }
  }

  template <class Small>
  void take_right_columns(const Small& x, const Place& place, const Moment& moment) {
    const std::size_t n = free().size();
    const std::size_t f = freedoms();
    const R* numbers = place.numbers.data();
    const auto drift = [this, n, f](std::size_t row) -> R& {
      return right_columns_[(f / group) * n + row](index(f % group));
    };
    const auto left = [this, n, f](std::size_t row) -> R& {
      return right_columns_[((f + 1) / group) * n + row](index((f + 1) % group));
    };
    for (std::size_t row = 0; row < n; ++row) {
      drift(row) = -ChartParts<R>::time_rate(row, numbers);
      left(row) = ChartParts<R>::value(row, numbers);
    }
    for (std::size_t k = 0; k < f; ++k) left(n - f + k) -= x[k];
    chart_.parts().for_each_coupling(
        numbers, [&](auto row, auto column, const R& k) { drift(row) -= k * moment.rates[column]; });
  }

  void solve_group(std::size_t g, Place& place) {
    const std::size_t first = g * free().size();
    free().lu.solve(place.numbers.data(), right_columns_.data() + first, place.columns.data() + first,
                    column_work_.data());
  }

  void place_frame(std::size_t b) {
    w_.frames[b] = PlanarFrame<R>(
        PlanarMotion<R>{Vector2<R>(y_[3 * b], y_[3 * b + 1]), y_[3 * b + 2], Vector2<R>(R(0), R(0)), R(0)});
  }
  void place_frames() {
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) place_frame(b);
  }
  void place_frames(const Part& part) {
    for (const std::size_t b : part.bodies) place_frame(b);
  }

  /// Where all have turned little since a place of the same time, from its cosines and sines. A stage asks a dozen
  /// times, and each adds half a unit of rounding; the next step starts afresh.
  bool turn_frames(const Place& from) {
    for (const std::size_t b : free().bodies) {
      const auto [cosine, sine] = from.turns[b];
      if (!turn_frame(w_.frames[b], y_.data() + 3 * b, y_[3 * b + 2] - from.q[3 * b + 2], cosine, sine)) return false;
    }
    return true;
  }
  /// From where they are to where the coordinates have moved.
  void turn_frames(const Part& part) {
    for (const std::size_t b : part.bodies) {
      PlanarFrame<R>& frame = w_.frames[b];
      if (!turn_frame(frame, y_.data() + 3 * b, y_[3 * b + 2] - frame.angle, frame.cosine, frame.sine)) place_frame(b);
    }
  }
  /// Gives the frames of a part's bodies their velocities.
  void move_frames_on(const Part& part) {
    for (const std::size_t b : part.bodies) {
      w_.frames[b].velocity = Vector2<R>(y_[n_ + 3 * b], y_[n_ + 3 * b + 1]);
      w_.frames[b].spin = y_[n_ + 3 * b + 2];
    }
  }

  R inverse_length_ = R(1);  ///< of the largest coordinate of a mass centre when the chart was chosen [1/m]
  FoundPlaces<R, Columns> places_;

  // Work, kept so that no evaluation allocates.
  std::vector<Columns> right_columns_, column_work_;
  std::vector<R> right_, inside_, taken_;
};

}  // namespace lubjoint

/// Places and velocities of all bodies from those of the coordinates that the constraints leave free.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "lubjoint/motion/found_places.hpp"
#include "lubjoint/multibody/envelope_cholesky.hpp"
#include "lubjoint/number/in_one_piece.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/ode/step_interpolant.hpp"

namespace lubjoint {

/// (q, v) of (z, ż): places q and velocities v of all bodies (in the plane v = q̇, in space (ṙ, ω′)), z = C(q) the
/// functions of a chart. With A = [Φ_v; C_v]:
///   q from Φ(q, t) = 0, C(q) = z by Newton's method, to rounding;  A V = [0; I],  A d = [−Φ_t; 0];  v = V ż + d.
/// What the time alone prescribes is found once for every time. The others that were found are remembered with their
/// factors: a search starts from those of the same time, moved by V and, where the second order of that may show,
/// corrected once by their factors, or from the latest ones, moved by their velocities and accelerations, which whoever
/// has them leaves in accelerations_ and w_.
/// @tparam In  InPlane or InSpace;  @tparam Freedoms  number of z, or run_time_size
template <class In, std::size_t Freedoms>
class IndependentMotion {
 public:
  using R = typename In::R;            ///< the number
  using System = typename In::System;  ///< the bodies
  using Chart = typename In::Chart;    ///< functions of their places
  using Full = std::vector<R>;         ///< (q, v, more)

  const Chart& chart() const { return chart_; }  ///< the present one
  /// Of the chart at the last place: see there.
  R wear() const { return chart_.wear(numbers(), w_); }
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
      const std::size_t k = i % In::velocities;
      if (k < dimensions) length = std::max<R>(length, size_of(y[In::coordinates * (i / In::velocities) + k]));
    }
    inverse_length_ = length > 0 ? R(1 / length) : R(1);
  }

  /// Where a search or the forces at its places fail, all that was found is forgotten, which would lead there again:
  /// the next search then starts from the places of this state, the last that is known to be right.
  void go_on_from(const Full& y) { std::copy_n(y.begin(), places_end_, taken_.begin()); }

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
      x[k] = chart_.nearest(k, functions_[k].value, x[k]);
      x[f + k] = x_rate[k] = along(functions_[k], k, y.data() + places_end_);
      x_rate[f + k] = along(functions_[k], k, rate.data() + places_end_) - functions_[k].gamma;
    }
  }

  /// Moves (q, v) of a state near it to (z, ż) inside a step, as nothing but the two say. @throws SingularConstraints
  void correct(const R& t, const StepInterpolant<std::vector<R>>& step, Full& y) {
    start_from(y);
    step.state_at(t, freedoms(), inside_);
    Place& place = places_.latest();
    Moment& moment = places_.moment_of(place);
    place_frames();
    prescribe(t, moment);
    search(t, inside_, place, moment);
    find_velocities(place, inside_);
    std::copy_n(y_.begin(), places_end_ + n_, y.begin());
  }

 protected:
  using Parts = typename Chart::Parts;  ///< rows and velocities, those that the time prescribes apart
  using Part = typename Parts::Part;    ///< one of the two
  /// Columns in one solution: V's, d, and the Newton step that is left.
  static constexpr std::size_t group = Freedoms == run_time_size ? 4 : Freedoms + 2;
  using Columns = Eigen::Array<R, static_cast<int>(group), 1>;  ///< so many columns at a velocity

  /// @param units  in which displacements are comparable;  @param states  of the whole state
  IndependentMotion(const System& system, const std::vector<R>& units, std::size_t states)
      : system_(system),
        places_end_(In::coordinates * system.bodies().size()),
        n_(In::velocities * system.bodies().size()),
        m_(In::constraint_rows(system)),
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
  IndependentMotion(const IndependentMotion&) = default;  ///< with what it has found

  using Moment = typename FoundPlaces<In, Columns>::Moment;  ///< what a time prescribes
  using Place = typename FoundPlaces<In, Columns>::Place;    ///< places that were found

  /// The next search starts from the places of a state, also if one of them fails.
  void start_from(const Full& y) {
    std::copy(y.begin(), y.end(), y_.begin());
    In::normalise(system_.bodies().size(), y_.data());
    taken_.assign(y_.begin(), y_.begin() + static_cast<std::ptrdiff_t>(places_end_));
    forget();
  }
  /// Nothing is known of any place.
  void forget() {
    places_.forget();
    here_ = false;
    accelerated_ = false;
  }
  const Part& prescribed() const { return chart_.parts().prescribed(); }  ///< by the time
  const Part& free() const { return chart_.parts().free(); }              ///< all else
  const Place& latest() const { return places_.latest(); }                ///< that of the last evaluation
  const Moment& moment() const { return places_.moment_of(latest()); }    ///< that of its time
  /// The numbers of both parts' rows there, with their factors.
  typename Parts::Numbers numbers() const { return {moment().numbers.data(), latest().numbers.data()}; }
  /// Column k of V, d after them, at the i-th free velocity.
  const R& column(const Place& place, std::size_t k, std::size_t i) const {
    if constexpr (Freedoms != run_time_size) {
      return place.columns[i](index(k));
    } else {
      return place.columns[(k / group) * free().size() + i](index(k % group));
    }
  }

  /// |x|
  static R size_of(const R& x) {
    using std::abs;
    return abs(x);
  }
  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }  ///< as Eigen counts
  /// Groups of columns that V, d and the Newton step take.
  std::size_t groups() const { return (freedoms() + 2 + group - 1) / group; }
  std::size_t first_function() const { return free().size() - freedoms(); }  ///< among the free rows

  /// C_v x of function k and a vector by velocities.
  template <class Row, class V>
  auto along(const Row& row, std::size_t k, const V* x) const {
    std::decay_t<decltype(row.value)> sum(0);
    const auto [first, second] = chart_.bodies_of(k);
    for (std::size_t c = 0; c < In::velocities; ++c) {
      if (first != ground_body) sum += row.first[c] * x[In::velocities * first + c];
      if (second != ground_body) sum += row.second[c] * x[In::velocities * second + c];
    }
    return sum;
  }

  /// x += V dz, by velocities
  void add_along(const Place& place, const R* dz, R* x) const {
    for (std::size_t i = 0; i < free().size(); ++i) {
      const std::size_t c = free().columns[i];
      R* const of_body = x + c - c % In::velocities;
      for (std::size_t k = 0; k < freedoms(); ++k) {
        directions().add(c, R(column(place, k, i) * dz[k]),
                         [of_body](std::size_t row, const R& more) { of_body[row] += more; });
      }
    }
  }
  /// That displacements are counted along.
  decltype(auto) directions() const { return In::directions(chart_); }

  /// y_ = (q, v) of x to rounding, with the rows there, the chart's factors and V.
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
    if (!placed) {
      forget_if_it_fails([&] { find_places(t, x); });
    }
    accelerated_ = false;
    find_velocities(latest(), x);
    for (std::size_t k = 0; k < f; ++k) speeds_[k] = x[f + k];
    move_frames_on(free());
    In::place_joints(system_, w_);
    find_gammas(t, free());
    const std::vector<R>& prescribed = moment().accelerations;
    chart_.parts().for_each_coupling(
        latest().numbers.data(), [&](auto row, auto column, const R& k) { gammas_[row] -= k * prescribed[column]; });
    here_ = true;
  }

  /// Does what may find no places, or no forces there: see go_on_from.
  template <class Act>
  void forget_if_it_fails(const Act& act) {
    try {
      act();
    } catch (const std::domain_error&) {
      forget();
      throw;
    }
  }

  /// v̇ at the place of the last follow if z̈ = 0.
  void accelerate_unmoved(R* a) {
    for (std::size_t i = 0; i < prescribed().size(); ++i) a[prescribed().columns[i]] = moment().accelerations[i];
    free().lu.solve(latest().numbers.data(), gammas_.data(), step_.data(), work_.data());
    for (std::size_t i = 0; i < free().size(); ++i) a[free().columns[i]] = step_[i];
    directions().to_inertial(a);
  }

  const System& system_;                  ///< the mechanism
  std::size_t places_end_;                ///< number of q, behind which velocities begin
  std::size_t n_;                         ///< velocities
  std::size_t m_;                         ///< rows of constraints in A
  Chart chart_;                           ///< the functions in use
  typename In::template Workspace<R> w_;  ///< frames, forces and rows at the last evaluation
  Full y_;                                ///< (q, v) of the last evaluation
  bool here_ = false;                     ///< is y_ that of the latest place and of speeds_?
  bool accelerated_ = false;              ///< and are the accelerations?
  bool forced_ = false;                   ///< by forces that are in w_, too?
  std::vector<R> speeds_;                 ///< ż
  std::vector<R> accelerations_;          ///< z̈
  std::vector<R> gammas_;                 ///< of the free rows, less what the prescribed accelerations are to them
  std::vector<typename In::template Row<R>> functions_;  ///< the chart's, as rows
  std::vector<R> residual_;                              ///< work, kept so that no evaluation allocates
  std::vector<R> step_;                                  ///< likewise
  std::vector<R> work_;                                  ///< likewise

 private:
  static constexpr std::size_t dimensions = In::velocities == 3 ? 2 : 3;  ///< of r
  static constexpr int most_iterations = 12;
  /// Of a step with the factors of another place at the same time: they are as far from right as it is long.
  static constexpr double longest_chord = 1e-4;
  static R rounding() { return 4 * std::numeric_limits<R>::epsilon(); }
  /// A step that leaves the factors before it right to their own rounding.
  static R settled() { return 16 * rounding(); }

  /// Evaluates the constraints of a part at the frames and hands each of its rows to keep(its number in the part, row),
  /// which the compiler spares what it does not read.
  /// @param joints_are_placed  has In::place_joints been called for the frames?
  template <class Keep>
  void for_each_row(const R& t, const Part& part, bool joints_are_placed, const Keep& keep) {
    const Parts& parts = chart_.parts();
    in_one_piece<R>([&] {
      for (const std::size_t c : part.constraints) {
        In::for_each_row(system_, c, t, w_, [&](std::size_t row, const auto& from) {
          if (!parts.is_in(part, row)) return;
          const std::size_t of_system = In::system_row(system_, row);
          keep(parts.place_in_part(row),
               directions().of(from, system_.first_body_of_row(of_system), system_.second_body_of_row(of_system)));
        });
      }
      if (&part == &parts.prescribed()) return;
      const std::size_t first = first_function();
      In::for_each_function(chart_, w_, joints_are_placed, [&](std::size_t k, const auto& row) {
        const auto [body_i, body_j] = chart_.bodies_of(k);
        keep(first + k, directions().of(row, body_i, body_j));
      });
    });
  }

  /// Φ and C − z at the frames.
  template <class Small>
  void find_residual(const R& t, const Small& x) {
    for_each_row(t, free(), false, [this](std::size_t number, const auto& row) { residual_[number] = row.value; });
    for (std::size_t k = 0; k < freedoms(); ++k) {
      R& residual = residual_[first_function() + k];
      residual = chart_.miss(k, residual, x[k]);
    }
  }

  /// Rows and factors at the frames.
  void factorise_here(const R& t, const Part& part, R* numbers) {
    for_each_row(t, part, false, [numbers](std::size_t number, const auto& row) { Parts::put(number, row, numbers); });
    part.lu.factorise(numbers);
  }

  void find_gammas(const R& t, const Part& part) {
    for_each_row(t, part, true, [this](std::size_t number, const auto& row) { gammas_[number] = row.gamma; });
  }

  template <class Small>
  void find_velocities(const Place& place, const Small& x) {
    const std::size_t f = freedoms();
    const Moment& at = places_.moment_of(place);
    for (std::size_t i = 0; i < prescribed().size(); ++i) y_[places_end_ + prescribed().columns[i]] = at.rates[i];
    for (std::size_t i = 0; i < free().size(); ++i) {
      R rate = column(place, f, i);
      for (std::size_t k = 0; k < f; ++k) rate += column(place, k, i) * x[f + k];
      y_[places_end_ + free().columns[i]] = rate;
    }
    directions().to_inertial(y_.data() + places_end_);
  }

  /// The largest of a part's displacements, in the size of its coordinate.
  template <class Step>
  R size_of_step(const Part& part, const Step& step) const {
    R size(0);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const R of_this = In::relative_size(part, i, step(i), y_.data(), inverse_length_);
      if (!(of_this <= size)) size = of_this;
      if (std::isnan(static_cast<double>(size))) break;
    }
    return size;
  }

  /// Factors of v and of ½v̇ dt in what velocity i is moved by in dt. A body that keeps its spin ω goes on a circle:
  ///   Δr = dt (sin φ/φ ṙ + ½dt (2(1 − cos φ)/φ²) r̈),  φ = |ω|dt,
  /// and what the time alone prescribes is mostly such a body. Up to φ = 1, by series.
  std::array<R, 2> on_a_circle(std::size_t i, const R& dt) const {
    if (i % In::velocities >= dimensions) return {R(1), R(1)};
    const R* spin = y_.data() + places_end_ + (i - i % In::velocities) + dimensions;
    R square(0);
    for (std::size_t k = 0; k < In::velocities - dimensions; ++k) square += spin[k] * spin[k];
    square *= dt * dt;
    if (!(square < 1)) return {R(1), R(1)};
    return {R(1 - square / 6 * (1 - square / 20 * (1 - square / 42 * (1 - square / 72)))),
            R(1 - square / 12 * (1 - square / 30 * (1 - square / 56 * (1 - square / 90))))};
  }

  /// q near those of the same time, or of the latest place.
  template <class Small>
  void guess(const Place& from, const R& t, const Small& x) {
    const std::vector<R>& q = from.known ? from.q : taken_;
    std::copy(q.begin(), q.end(), y_.begin());
    if (!from.known) return;
    const std::size_t f = freedoms();
    for (std::size_t k = 0; k < f; ++k) right_[k] = x[k] - from.z[k];
    const auto along = [&](std::size_t i) {
      R sum(0);
      for (std::size_t k = 0; k < f; ++k) sum += column(from, k, i) * right_[k];
      return sum;
    };
    if (from.t != t && accelerated_) {
      const R dt = t - from.t;
      const auto moved = [&](std::size_t i) { return R(dt * (y_[places_end_ + i] + dt / 2 * w_.accelerations[i])); };
      const auto moved_on_a_circle = [&](std::size_t i) {
        const auto [of_rate, of_acceleration] = on_a_circle(i, dt);
        return R(dt * (of_rate * y_[places_end_ + i] + dt / 2 * of_acceleration * w_.accelerations[i]));
      };
      for (std::size_t k = 0; k < f; ++k)
        right_[k] = chart_.miss(k, R(right_[k] - dt * (speeds_[k] + dt / 2 * accelerations_[k])), R(0));
      In::displace(
          chart_, prescribed(),
          [&](std::size_t i) { return directions().component(prescribed().columns[i], moved_on_a_circle); }, y_.data());
      In::displace(
          chart_, free(), [&](std::size_t i) { return R(directions().component(free().columns[i], moved) + along(i)); },
          y_.data());
    } else {
      for (std::size_t k = 0; k < f; ++k) right_[k] = chart_.miss(k, right_[k], R(0));
      for (std::size_t i = 0; i < free().size(); ++i) step_[i] = along(i);
      In::displace(
          chart_, free(), [this](std::size_t i) { return step_[i]; }, y_.data());
    }
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
      const R size = size_of_step(free(), [this](std::size_t i) { return step_[i]; });
      if (move_frames_from(*same)) {
        if (size * size > settled() / 4) step_by_factors(t, x, *same);
      } else {
        place_frames(free());
      }
      search(t, x, place, moment);
    }
    std::copy(y_.begin(), y_.begin() + static_cast<std::ptrdiff_t>(places_end_), place.q.begin());
    for (std::size_t k = 0; k < freedoms(); ++k) place.z[k] = x[k];
    for (const std::size_t b : free().bodies) place.orientations[b] = In::orientation(w_.frames[b]);
    places_.take_spare(t, same);
  }

  /// The prescribed places from the frames, by Newton's method; their rates and accelerations.
  void prescribe(const R& t, Moment& moment) {
    const Part& part = prescribed();
    if (part.size() == 0) return;
    R* numbers = moment.numbers.data();
    const auto solve = [&](const std::vector<R>& right, std::vector<R>& found) {
      part.lu.solve(numbers, right.data(), found.data(), work_.data());
    };
    newton(part, [&] {
      factorise_here(t, part, numbers);
      for (std::size_t i = 0; i < part.size(); ++i) residual_[i] = Parts::value(i, numbers);
      solve(residual_, step_);
      return [this](std::size_t i) { return step_[i]; };
    });
    for (std::size_t i = 0; i < part.size(); ++i) residual_[i] = -Parts::time_rate(i, numbers);
    solve(residual_, moment.rates);
    directions().for_each_turned([this](std::size_t b) {  // of which others may be free, and are not known yet
      std::fill_n(y_.begin() + static_cast<std::ptrdiff_t>(places_end_ + In::velocities * b), dimensions, R(0));
    });
    for (std::size_t i = 0; i < part.size(); ++i) y_[places_end_ + part.columns[i]] = moment.rates[i];
    directions().to_inertial(y_.data() + places_end_);
    move_frames_on(part);
    find_gammas(t, part);
    solve(gammas_, moment.accelerations);
    for (std::size_t i = 0; i < part.bodies.size(); ++i) moment.frames[i] = w_.frames[part.bodies[i]];
  }

  /// One step of Newton's method with the factors of a place near by, from which the frames were moved.
  template <class Small>
  void step_by_factors(const R& t, const Small& x, const Place& from) {
    find_residual(t, x);
    free().lu.solve(from.numbers.data(), residual_.data(), step_.data(), work_.data());
    const R size = size_of_step(free(), [this](std::size_t i) { return step_[i]; });
    if (size <= rounding() || !(size < R(longest_chord))) return;
    In::displace(
        chart_, free(), [this](std::size_t i) { return R(-step_[i]); }, y_.data());
    if (!move_frames_from(from)) place_frames(free());
  }

  /// The free places from the frames, by Newton's method, with rows, factors, V and d.
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

  /// Moves the places of a part, and its frames with them, by what each call of next_step returns, until the factors
  /// that it has left are right to rounding, or as right as rounding lets them be: a step squares what the one before
  /// it has left.
  template <class NextStep>
  void newton(const Part& part, const NextStep& next_step) {
    using std::sqrt;
    const R near = sqrt(std::numeric_limits<R>::epsilon()) / 2;
    // What is prescribed is found once a time, and so to the last unit that rounding leaves.
    const R moves_from = &part == &prescribed() ? R(0) : rounding();
    R before = std::numeric_limits<R>::infinity();
    for (int iteration = 0;; ++iteration) {
      const auto step = next_step();
      const R size = size_of_step(part, step);
      if (!(size <= moves_from)) {
        if (!(size < 1) || iteration == most_iterations)
          throw SingularConstraints("no places near the last ones fulfil the constraints");
        In::displace(
            chart_, part, [&step](std::size_t i) { return R(-step(i)); }, y_.data());
        for (const std::size_t b : part.bodies) In::move(w_.frames[b], place_of(b));
      }
      if (size <= settled() || (before < near && size < near)) return;
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
      drift(row) = -Parts::time_rate(row, numbers);
      left(row) = Parts::value(row, numbers);
    }
    for (std::size_t k = 0; k < f; ++k) left(n - f + k) = chart_.miss(k, left(n - f + k), x[k]);
    chart_.parts().for_each_coupling(
        numbers, [&](auto row, auto column, const R& k) { drift(row) -= k * moment.rates[column]; });
  }

  void solve_group(std::size_t g, Place& place) {
    const std::size_t first = g * free().size();
    free().lu.solve(place.numbers.data(), right_columns_.data() + first, place.columns.data() + first,
                    column_work_.data());
  }

  const R* place_of(std::size_t b) const { return y_.data() + In::coordinates * b; }
  void place_frames() {
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) In::place(w_.frames[b], place_of(b));
  }
  void place_frames(const Part& part) {
    for (const std::size_t b : part.bodies) In::place(w_.frames[b], place_of(b));
  }
  /// From a place of the same time, where all have turned little since. A stage asks a dozen times, and each adds half
  /// a unit of rounding; the next step starts afresh.
  bool move_frames_from(const Place& from) {
    for (const std::size_t b : free().bodies) {
      if (!In::move_from(from.q.data() + In::coordinates * b, from.orientations[b], w_.frames[b], place_of(b)))
        return false;
    }
    return true;
  }
  /// Gives the frames of a part's bodies their velocities.
  void move_frames_on(const Part& part) {
    for (const std::size_t b : part.bodies)
      In::give_velocities(w_.frames[b], y_.data() + places_end_ + In::velocities * b);
  }

  R inverse_length_ = R(1);  ///< of the largest coordinate of a mass centre when the chart was chosen [1/m]
  FoundPlaces<In, Columns> places_;

  // Work, kept so that no evaluation allocates.
  std::vector<Columns> right_columns_, column_work_;
  std::vector<R> right_, inside_, taken_;
};

}  // namespace lubjoint

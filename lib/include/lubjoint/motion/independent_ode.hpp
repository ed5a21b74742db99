/// Equations of motion in coordinates that the constraints leave free.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/multibody/coordinate_chart.hpp"

namespace lubjoint {

/// (z, ż) and, with a ledger, the work of each term, for the functions z = C(q) of a chart. With A = [Φq; C]:
///   q from Φ(q, t) = 0, C(q) = z by Newton's method, to rounding;  A q̇ = [−Φt; ż];  A V = [0; I];  A a = [γ; γ_C];
///   VᵀMV z̈ = Vᵀ(g − M a);  q̈ = a + V z̈;  Aᵀ[λ; 0] = g − M q̈.
/// Derivatives are exact: q, q̇, z̈ and λ by implicit differentiation, with the factors at hand.
/// @tparam N  number of states: twice the freedoms, and no ledger; or run_time_size
template <class R, std::size_t N>
class IndependentOde final : public OdeSystem<R, N> {
 public:
  using State = StateOf<R, N>;        ///< (z, ż, work)
  using Full = std::vector<R>;        ///< (q, q̇, work)
  using Jacobian = JacobianOf<R, N>;  ///< of State
  /// Derivatives in one pass.
  static constexpr int width = N == run_time_size ? 4 : static_cast<int>(N);
  using Seeded = Dual<R, width>;  ///< a number with them

  /// @param ode  whose equations these are, with what its joints remember; kept by reference
  /// @param units  in which the coordinates are comparable, such as their tolerances
  IndependentOde(MultibodyOde<R>& ode, const std::vector<R>& units)
      : ode_(ode),
        system_(ode.system()),
        n_(system_.coordinates()),
        m_(system_.constraint_rows()),
        chart_(system_, units),
        w_(system_.template workspace<R>()),
        dual_(system_.template workspace<Seeded>()),
        y_(ode.dimension()),
        speeds_(freedoms()),
        gammas_(n_),
        functions_(freedoms()),
        residual_(n_),
        step_(n_),
        forces_(n_),
        work_(n_),
        column_residual_(n_),
        column_work_(n_),
        reduced_(freedoms() * freedoms()),
        right_(freedoms()),
        accelerations_(freedoms()),
        seeded_(ode.dimension()),
        seeded_functions_(freedoms()),
        right_slopes_(n_),
        slopes_(n_),
        slopes_work_(n_),
        q_slopes_(n_),
        reduced_slopes_(freedoms()) {
    for (std::size_t i = 0; i < n_; ++i) {
      const PlanarBody<R>& body = system_.bodies()[i / 3];
      masses_.push_back(i % 3 == 2 ? body.inertia : body.mass);
    }
    const Place empty{{}, false, std::vector<R>(n_), std::vector<Columns>(n_ * groups()),
                      std::vector<std::array<R, 2>>(system_.bodies().size()), std::vector<R>(freedoms())};
    places_.fill(empty);
  }

  const CoordinateChart<R>& chart() const { return chart_; }                            ///< the present one
  std::size_t freedoms() const { return n_ - m_; }                                      ///< number of z
  std::size_t dimension() const { return 2 * freedoms() + ode_.dimension() - 2 * n_; }  ///< number of states

  /// Chooses functions at a state that fulfils the constraints, near which the next search starts. @throws SingularConstraints where there is no choice
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

  /// (z, ż, work) of a whole state, from whose coordinates the next search starts.
  void take(const Full& y, State& x) {
    std::copy(y.begin(), y.end(), y_.begin());
    forget();
    system_.place(y_.data(), w_);
    chart_.evaluate(y_.data(), w_, functions_.data());
    const std::size_t f = freedoms();
    if constexpr (N == run_time_size) x.resize(dimension());
    for (std::size_t k = 0; k < f; ++k) {
      x[k] = functions_[k].value;
      x[f + k] = along(functions_[k], k, y_.data() + n_);
    }
    for (std::size_t i = 2 * n_; i < y.size(); ++i) x[2 * f + i - 2 * n_] = y[i];
  }

  /// The whole state. @throws SingularConstraints where no places near the last ones fulfil the constraints
  void expand(const R& t, const State& x, Full& y) {
    follow(t, x);
    for (std::size_t i = 2 * n_; i < y_.size(); ++i) y_[i] = x[2 * freedoms() + i - 2 * n_];
    y = y_;
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
    State& x = corrected_;
    if constexpr (N == run_time_size) x.resize(dimension());
    std::copy(inside_.begin(), inside_.end(), x.begin());
    std::copy_n(y.begin(), n_, y_.begin());
    place_frames();
    search(t, x);
    find_velocities(x);
    std::copy_n(y_.begin(), 2 * n_, y.begin());
  }

  /// Rates of the whole state of the last expansion, from those of (z, ż, work).
  void expand_rate(const State& x_rate, Full& y_rate) {
    const std::size_t f = freedoms();
    for (std::size_t row = 0; row < n_; ++row) residual_[row] = gammas_[row];
    for (std::size_t k = 0; k < f; ++k) residual_[m_ + k] += x_rate[f + k];
    chart_.solve(residual_.data(), y_rate.data() + n_, work_.data());
    for (std::size_t i = 2 * n_; i < y_rate.size(); ++i) y_rate[i] = x_rate[2 * f + i - 2 * n_];
  }
  /// The rates of (z, ż, work) in those of the whole state of the last expansion.
  void take_rate(const Full& y_rate, State& x_rate) {
    const std::size_t f = freedoms();
    if constexpr (N == run_time_size) x_rate.resize(dimension());
    for (std::size_t k = 0; k < f; ++k) {
      x_rate[k] = along(functions_[k], k, y_.data() + n_);
      x_rate[f + k] = along(functions_[k], k, y_rate.data() + n_) - functions_[k].gamma;
    }
    for (std::size_t i = 2 * n_; i < y_rate.size(); ++i) x_rate[2 * f + i - 2 * n_] = y_rate[i];
  }

  void rate(const State& x, State& dxdt, const R& t) override {
    ode_.count_from(ode_.evaluations() + 1);
    follow(t, x);
    accelerate(t);
    const std::size_t f = freedoms();
    for (std::size_t k = 0; k < f; ++k) {
      dxdt[k] = x[f + k];
      dxdt[f + k] = accelerations_[k];
    }
    if constexpr (N == run_time_size) {
      if (ode_.with_ledger()) {
        find_multipliers();
        system_.evaluate_constraints(t, w_);
        ode_.fill_powers(t, y_, w_, &dxdt[2 * f]);
      }
    }
  }

  void jacobian(const State& x, Jacobian& j, const R& t) override {
    follow(t, x);
    accelerate(t);
    find_multipliers();
    const std::size_t f = freedoms();
    const std::size_t states = x.size();
    if constexpr (N == run_time_size) j.setZero(index(states), index(states));
    for (std::size_t start = 0; start < 2 * f; start += width) {
      const std::size_t end = std::min<std::size_t>(2 * f, start + width);
      const auto column_of = [&](std::size_t i, std::size_t k) { return column(k)[i](index(k % group)); };
      for (std::size_t i = 0; i < n_; ++i) {
        q_slopes_[i].setZero();
        for (std::size_t k = start; k < std::min(end, f); ++k) q_slopes_[i](index(k - start)) = column_of(i, k);
      }
      const auto z_rate_slope = [&](std::size_t k) {
        Slopes slope = Slopes::Zero();
        if (f + k >= start && f + k < end) slope(index(f + k - start)) = R(1);
        return slope;
      };
      fill(t, z_rate_slope);
      const auto put = [&](std::size_t row, const Slopes& slopes) {
        j.block(index(row), index(start), 1, index(end - start)) = slopes.head(index(end - start)).transpose();
      };
      for (std::size_t k = 0; k < f; ++k) {
        put(k, z_rate_slope(k));
        put(f + k, reduced_slopes_[k]);
      }
      for (std::size_t i = 2 * f; i < states; ++i) put(i, powers_[i - 2 * f].derivatives());
    }
  }

  void time_slope(const State& x, State& slope, const R& t) override {
    follow(t, x);
    accelerate(t);
    find_multipliers();
    const std::size_t f = freedoms();
    for (std::size_t row = 0; row < m_; ++row) residual_[row] = -chart_.time_rate(row);
    std::fill(residual_.begin() + static_cast<std::ptrdiff_t>(m_), residual_.end(), R(0));
    chart_.solve(residual_.data(), step_.data(), work_.data());
    for (std::size_t i = 0; i < n_; ++i) {
      q_slopes_[i].setZero();
      q_slopes_[i](0) = step_[i];
    }
    fill(Seeded::variable(t, 0), [](std::size_t) -> Slopes { return Slopes::Zero(); });
    for (std::size_t k = 0; k < f; ++k) {
      slope[k] = R(0);
      slope[f + k] = reduced_slopes_[k](0);
    }
    for (std::size_t i = 2 * f; i < x.size(); ++i) slope[i] = powers_[i - 2 * f].derivatives()(0);
  }

 private:
  using Slopes = typename Seeded::Derivatives;
  /// Columns of V in one solution.
  static constexpr int group = N == run_time_size ? 4 : static_cast<int>(N / 2);
  using Columns = Eigen::Array<R, group, 1>;

  static constexpr int most_iterations = 12;
  /// Of a Newton step in the size of the mechanism: what it leaves is of its square, below rounding.
  static constexpr double last_step = 1e-9;

  void forget() {
    for (Place& each : places_) each.known = false;
    here_ = false;
    accelerated_ = false;
  }
  /// Column k of V is the k % group-th part of these.
  const Columns* column(std::size_t k) const { return places_[latest_].columns.data() + (k / group) * n_; }

  /// Coordinates that were found at a time: the stages of a step ask again and again for the same times.
  struct Place {
    R t{};
    bool known = false;
    std::vector<R> q;
    std::vector<Columns> columns;  ///< V
    std::vector<std::array<R, 2>> turns;  ///< cosine and sine of each body's angle
    std::vector<R> z;
  };

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

  /// Evaluates the constraints at the frames and hands each of their rows to keep(number, row), which the compiler spares
  /// what it does not read.
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
  R newton_step(const State& x) {
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
  void guess(std::size_t at, const R& t, const State& x) {
    const std::size_t f = freedoms();
    const Place& from = places_[at < places_.size() ? at : latest_];
    if (!from.known || (from.t != t && !accelerated_)) return;  // y_ is what was taken, or the latest
    std::copy(from.q.begin(), from.q.end(), y_.begin());
    for (std::size_t k = 0; k < f; ++k) right_[k] = x[k] - from.z[k];
    if (from.t != t) {
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
  void follow(const R& t, const State& x) {
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

  void find_velocities(const State& x) {
    for (std::size_t row = 0; row < m_; ++row) residual_[row] = -chart_.time_rate(row);
    for (std::size_t k = 0; k < freedoms(); ++k) residual_[m_ + k] = x[freedoms() + k];
    chart_.solve(residual_.data(), y_.data() + n_, work_.data());
  }

  void find_places(const R& t, const State& x) {
    const std::size_t f = freedoms();
    std::size_t at = 0;
    while (at < places_.size() && !(places_[at].known && places_[at].t == t)) ++at;
    guess(at, t, x);
    if (at == places_.size() || !turn_frames(places_[at])) place_frames();
    if (at == places_.size()) at = next_ = (next_ + 1) % places_.size();
    Place& place = places_[at];
    place.known = false;
    search(t, x);
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
  void search(const R& t, const State& x) {
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

  /// From a place of the same time, where all have turned little: by the series of cosine and sine, whose next terms are
  /// below rounding. A stage asks a dozen times, and each adds half a unit of rounding; the next step starts afresh.
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

  /// z̈ and q̈ at the place of the last follow.
  void accelerate(const R& t) {
    if (accelerated_ && ode_.memory().empty()) return;
    const std::size_t f = freedoms();
    system_.apply_forces(ode_.memory(), w_);
    if (!w_.slides.empty()) {  // their forces hold journals on lines: by the whole equations
      system_.evaluate(t, y_.data(), ode_.memory(), w_);
      for (std::size_t k = 0; k < f; ++k)
        accelerations_[k] = along(functions_[k], k, w_.accelerations.data()) - functions_[k].gamma;
    } else {
      if (system_.has_elements()) system_.apply_elements(t, w_);
      R* a = w_.accelerations.data();
      for (std::size_t row = 0; row < n_; ++row) residual_[row] = gammas_[row];
      chart_.solve(residual_.data(), a, work_.data());
      for (std::size_t i = 0; i < n_; ++i) forces_[i] = w_.forces[i] - masses_[i] * a[i];
      factorise_reduced();
      project(forces_.data(), accelerations_.data());
      solve_reduced(accelerations_.data());
      add_along(places_[latest_], accelerations_.data(), a);
    }
    accelerated_ = true;
  }

  /// LDLᵀ of VᵀMV, 1/D in the diagonal.
  void factorise_reduced() {
    const std::size_t f = freedoms();
    const Columns* all = places_[latest_].columns.data();
    for (std::size_t g = 0; g < groups(); ++g) {
      for (std::size_t h = 0; h <= g; ++h) {
        Eigen::Array<R, group, group> block = Eigen::Array<R, group, group>::Zero();
        for (std::size_t i = 0; i < n_; ++i) {
          const Columns weighted = masses_[i] * all[g * n_ + i];
          for (Eigen::Index l = 0; l < group; ++l) block.col(l) += weighted * all[h * n_ + i](l);
        }
        for (std::size_t k = g * group; k < std::min<std::size_t>(f, (g + 1) * group); ++k) {
          for (std::size_t l = h * group; l < std::min<std::size_t>(k + 1, (h + 1) * group); ++l)
            reduced_[k * f + l] = block(index(k - g * group), index(l - h * group));
        }
      }
    }
    for (std::size_t k = 0; k < f; ++k) {
      R* row = reduced_.data() + k * f;
      const R whole = row[k];
      for (std::size_t l = 0; l < k; ++l) {
        const R* earlier = reduced_.data() + l * f;
        for (std::size_t i = 0; i < l; ++i) row[l] -= row[i] * earlier[i];  // L_ki D_i, not yet divided
      }
      for (std::size_t l = 0; l < k; ++l) {
        const R times_d = row[l];
        row[l] *= reduced_[l * f + l];
        row[k] -= times_d * row[l];
      }
      if (!(row[k] > whole * 64 * std::numeric_limits<R>::epsilon()))
        throw SingularConstraints("the mass that the free coordinates move is singular here");
      row[k] = 1 / row[k];
    }
  }

  template <class V>
  void solve_reduced(V* b) const {
    const std::size_t f = freedoms();
    for (std::size_t k = 1; k < f; ++k) {
      for (std::size_t l = 0; l < k; ++l) b[k] -= reduced_[k * f + l] * b[l];
    }
    for (std::size_t k = f; k-- > 0;) {
      b[k] *= reduced_[k * f + k];
      for (std::size_t l = k + 1; l < f; ++l) b[k] -= reduced_[l * f + k] * b[l];
    }
  }

  /// Vᵀ x
  template <class V>
  void project(const V* x, V* out) const {
    if constexpr (std::is_same_v<V, R>) {
      const Columns* v = places_[latest_].columns.data();
      for (std::size_t g = 0; g < groups(); ++g) {
        Columns sum = Columns::Zero();
        for (std::size_t i = 0; i < n_; ++i) sum += v[g * n_ + i] * x[i];
        for (std::size_t k = g * group; k < std::min<std::size_t>(freedoms(), (g + 1) * group); ++k)
          out[k] = sum(index(k - g * group));
      }
      return;
    }
    for (std::size_t k = 0; k < freedoms(); ++k) {
      const Columns* v = column(k);
      V sum = v[0](index(k % group)) * x[0];
      for (std::size_t i = 1; i < n_; ++i) sum += v[i](index(k % group)) * x[i];
      out[k] = sum;
    }
  }

  /// λ at the place of the last accelerate.
  void find_multipliers() {
    if (!w_.slides.empty()) return;  // the whole equations have found them
    for (std::size_t i = 0; i < n_; ++i) residual_[i] = w_.forces[i] - masses_[i] * w_.accelerations[i];
    chart_.solve_transposed(residual_.data(), step_.data(), work_.data());
    std::copy(step_.begin(), step_.begin() + static_cast<std::ptrdiff_t>(m_), w_.multipliers.begin());
  }

  /// Derivatives of z̈, into reduced_slopes_, and of the powers, from those of q at fixed ż, which are in q_slopes_, and
  /// of ż. At the place of the last accelerate, with its multipliers.
  template <class Time, class RateSlope>
  void fill(const Time& t, const RateSlope& z_rate_slope) {
    const std::size_t f = freedoms();
    // q̇: d(A) q̇ + A dq̇ = [−dΦt; dż].
    for (std::size_t i = 0; i < n_; ++i) {
      seeded_[i] = Seeded(y_[i], q_slopes_[i]);
      seeded_[n_ + i] = Seeded(y_[n_ + i]);
    }
    system_.evaluate_kinematics(t, seeded_.data(), dual_);
    chart_.evaluate(seeded_.data(), dual_, seeded_functions_.data());
    for (std::size_t row = 0; row < m_; ++row) right_slopes_[row] = -system_.constraint_rate(row, dual_).derivatives();
    for (std::size_t k = 0; k < f; ++k)
      right_slopes_[m_ + k] =
          z_rate_slope(k) - along(seeded_functions_[k], k, seeded_.data() + n_).derivatives();
    chart_.solve(right_slopes_.data(), slopes_.data(), slopes_work_.data());
    for (std::size_t i = 0; i < n_; ++i) seeded_[n_ + i].derivatives() = slopes_[i];
    if (!w_.slides.empty()) {
      system_.evaluate(t, seeded_.data(), ode_.memory(), dual_);
      chart_.evaluate(seeded_.data(), dual_, seeded_functions_.data());
      for (std::size_t k = 0; k < f; ++k)
        reduced_slopes_[k] =
            (along(seeded_functions_[k], k, dual_.accelerations.data()) - seeded_functions_[k].gamma).derivatives();
    } else {
      system_.place(seeded_.data(), dual_);
      system_.apply_forces(ode_.memory(), dual_);
      if (system_.has_elements()) system_.apply_elements(t, dual_);
      system_.evaluate_constraints(t, dual_);
      chart_.evaluate(seeded_.data(), dual_, seeded_functions_.data());
      differentiate_accelerations();
    }
    if (ode_.with_ledger()) {
      powers_.resize(ode_.works());
      ode_.fill_powers(t, seeded_, dual_, powers_.data());
    }
  }

  /// With q̈ and λ held, A dq̈ = [dγ − dΦq q̈; dz̈ + dγ_C − dC q̈] and Vᵀ(M dq̈ + dΦqᵀ λ − dg) = 0.
  void differentiate_accelerations() {
    const std::size_t f = freedoms();
    for (std::size_t i = 0; i < n_; ++i) slopes_[i] = dual_.forces[i].derivatives();
    const auto side = [&](std::size_t row, std::size_t body, const std::array<Seeded, 3>& columns) {
      if (body == ground_body) return;
      for (std::size_t c = 0; c < 3; ++c) {
        right_slopes_[row] -= w_.accelerations[3 * body + c] * columns[c].derivatives();
        if (row < m_) slopes_[3 * body + c] -= w_.multipliers[row] * columns[c].derivatives();
      }
    };
    for (std::size_t row = 0; row < m_; ++row) {
      right_slopes_[row] = dual_.rows[row].gamma.derivatives();
      side(row, system_.first_body_of_row(row), dual_.rows[row].first);
      side(row, system_.second_body_of_row(row), dual_.rows[row].second);
    }
    for (std::size_t k = 0; k < f; ++k) {
      right_slopes_[m_ + k] = seeded_functions_[k].gamma.derivatives();
      const auto [first, second] = chart_.bodies_of(k);
      side(m_ + k, first, seeded_functions_[k].first);
      side(m_ + k, second, seeded_functions_[k].second);
    }
    chart_.solve(right_slopes_.data(), q_slopes_.data(), slopes_work_.data());  // of q̈ without dz̈
    for (std::size_t i = 0; i < n_; ++i) slopes_[i] -= masses_[i] * q_slopes_[i];
    project(slopes_.data(), reduced_slopes_.data());
    solve_reduced(reduced_slopes_.data());
    if (!ode_.with_ledger()) return;
    for (std::size_t k = 0; k < f; ++k) {
      const Columns* v = column(k);
      for (std::size_t i = 0; i < n_; ++i) {
        const Slopes part = v[i](index(k % group)) * reduced_slopes_[k];
        q_slopes_[i] += part;
        slopes_[i] -= masses_[i] * part;
      }
    }
    chart_.solve_transposed(slopes_.data(), right_slopes_.data(), slopes_work_.data());
    for (std::size_t i = 0; i < n_; ++i) dual_.accelerations[i] = Seeded(w_.accelerations[i], q_slopes_[i]);
    for (std::size_t row = 0; row < m_; ++row) dual_.multipliers[row] = Seeded(w_.multipliers[row], right_slopes_[row]);
  }

  MultibodyOde<R>& ode_;
  const PlanarSystem<R>& system_;
  std::size_t n_, m_;
  CoordinateChart<R> chart_;
  SystemWorkspace<R> w_;
  SystemWorkspace<Seeded> dual_;
  Full y_;                   ///< (q, q̇) of the last evaluation
  R inverse_length_ = R(1);  ///< of the largest coordinate of a mass centre when the chart was chosen [1/m]
  std::array<Place, 4> places_;
  std::size_t next_ = 0;      ///< the one to be given up next
  std::size_t latest_ = 0;    ///< that of the last evaluation
  bool here_ = false;         ///< is y_ that of latest_ and speeds_?
  bool accelerated_ = false;  ///< and are the accelerations?
  std::vector<R> masses_;     ///< of every coordinate
  std::vector<R> speeds_;     ///< ż
  std::vector<R> gammas_;     ///< of all rows
  std::vector<ConstraintRow<R>> functions_;

  // Work, kept so that no evaluation allocates.
  std::vector<R> residual_, step_, forces_, work_;
  std::vector<Columns> column_residual_, column_work_;
  std::vector<R> reduced_;  ///< factors of VᵀMV
  std::vector<R> right_, accelerations_;
  std::vector<Seeded> seeded_;
  std::vector<ConstraintRow<Seeded>> seeded_functions_;
  std::vector<Slopes> right_slopes_, slopes_, slopes_work_, q_slopes_, reduced_slopes_;
  std::vector<Seeded> powers_;
  std::vector<R> inside_;
  State corrected_{};
};

}  // namespace lubjoint

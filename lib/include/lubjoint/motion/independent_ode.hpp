/// Equations of motion in coordinates that the constraints leave free.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/multibody/coordinate_chart.hpp"
#include "lubjoint/ode/exact_jacobian.hpp"

namespace lubjoint {

/// (z, ż) and, with a ledger, the work of each term, for the functions z(q) of a chart. q follows by Newton's method on
/// Φ = 0 and C(q) = z, q̇ by a linear solve, both to rounding; z̈ = C q̈ − γ_C with the accelerations of the system.
/// Derivatives are exact: those of q and q̇ by implicit differentiation.
/// @tparam N  number of states, or run_time_size
template <class R, std::size_t N>
class IndependentOde final : public OdeSystem<R, N> {
 public:
  using State = StateOf<R, N>;        ///< (z, ż, work)
  using Full = std::vector<R>;        ///< (q, q̇, work)
  using Jacobian = JacobianOf<R, N>;  ///< of State
  /// A number with the derivatives of one pass.
  using Seeded = typename MultibodyOde<R>::Seeded;

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
        residual_(n_),
        step_(n_),
        sizes_(n_, R(1)) {}

  const CoordinateChart<R>& chart() const { return chart_; }                            ///< the present one
  std::size_t freedoms() const { return n_ - m_; }                                      ///< number of z
  std::size_t dimension() const { return 2 * freedoms() + ode_.dimension() - 2 * n_; }  ///< number of states

  /// Chooses functions at a state that fulfils the constraints. @throws std::domain_error where there is no choice
  void choose(const R& t, const Full& y) {
    if (!chart_.choose(t, y.data(), w_)) throw std::domain_error("the constraints are not independent");
    using std::abs;
    R length(0);
    for (std::size_t i = 0; i < n_; ++i) {
      if (i % 3 != 2) length = std::max<R>(length, abs(y[i]));
    }
    for (std::size_t i = 0; i < n_; ++i) sizes_[i] = i % 3 == 2 ? R(1) : length;
    for (Remembered& each : memory_) each.known = false;
  }

  /// (z, ż, work) of a whole state, whose coordinates are where the next search starts.
  void take(const R& t, const Full& y, State& x) {
    std::copy(y.begin(), y.end(), y_.begin());
    system_.place(y_.data(), w_);
    chart_.evaluate(y_.data(), w_, functions_);
    const std::size_t f = freedoms();
    if constexpr (N == run_time_size) x.resize(dimension());
    for (std::size_t k = 0; k < f; ++k) {
      x[k] = functions_[k].value;
      x[f + k] = rate_of(functions_[k], chart_sides(k));
    }
    for (std::size_t i = 2 * n_; i < y.size(); ++i) x[2 * f + i - 2 * n_] = y[i];
    (void)t;
  }

  /// The whole state. @throws std::domain_error where no positions near the last ones fulfil the constraints
  void expand(const R& t, const State& x, Full& y) {
    follow(t, x);
    for (std::size_t i = 2 * n_; i < y_.size(); ++i) y_[i] = x[2 * freedoms() + i - 2 * n_];
    y = y_;
  }

  /// Rates of the whole state of the last expansion, from those of (z, ż, work).
  void expand_rate(const State& x_rate, Full& y_rate) {
    const std::size_t f = freedoms();
    for (std::size_t row = 0; row < m_; ++row) residual_[row] = w_.rows[row].gamma;
    for (std::size_t k = 0; k < f; ++k) residual_[m_ + k] = x_rate[f + k] + functions_[k].gamma;
    chart_.solve(residual_.data(), step_.data());
    for (std::size_t i = 0; i < n_; ++i) y_rate[n_ + i] = step_[i];
    for (std::size_t i = 2 * n_; i < y_rate.size(); ++i) y_rate[i] = x_rate[2 * f + i - 2 * n_];
  }
  /// The rates of (z, ż, work) in those of the whole state.
  void take_rate(const Full& y_rate, State& x_rate) {
    const std::size_t f = freedoms();
    if constexpr (N == run_time_size) x_rate.resize(dimension());
    for (std::size_t k = 0; k < f; ++k) {
      x_rate[k] = rate_of(functions_[k], chart_sides(k));
      x_rate[f + k] = along(functions_[k], chart_sides(k), y_rate.data() + n_) - functions_[k].gamma;
    }
    for (std::size_t i = 2 * n_; i < y_rate.size(); ++i) x_rate[2 * f + i - 2 * n_] = y_rate[i];
  }

  void rate(const State& x, State& dxdt, const R& t) override {
    ode_.count_evaluation();
    follow(t, x);
    accelerate(t);
    const std::size_t f = freedoms();
    for (std::size_t k = 0; k < f; ++k) {
      dxdt[k] = x[f + k];
      dxdt[f + k] = along(functions_[k], chart_sides(k), w_.accelerations.data()) - functions_[k].gamma;
    }
    if (ode_.with_ledger()) ode_.fill_powers(t, y_, w_, &dxdt[2 * f]);
  }

  void jacobian(const State& x, Jacobian& j, const R& t) override {
    follow(t, x);
    if constexpr (N == run_time_size) {
      derivatives_.fill([&](const auto& s, auto& dsdt) { fill(t, s, dsdt); }, x, 2 * freedoms(), j);
    } else {
      static_assert(N <= 6);
      seeded_x_.resize(N);
      seeded_rate_.resize(N);
      for (std::size_t i = 0; i < N; ++i) seeded_x_[i] = Seeded::variable(x[i], static_cast<Eigen::Index>(i));
      fill(t, seeded_x_, seeded_rate_);
      for (std::size_t i = 0; i < N; ++i)
        j.row(static_cast<Eigen::Index>(i)) =
            seeded_rate_[i].derivatives().template head<static_cast<Eigen::Index>(N)>().transpose();
    }
  }

  void time_slope(const State& x, State& slope, const R& t) override {
    follow(t, x);
    std::vector<Seeded> at(x.begin(), x.end()), rate(x.size());
    fill(Seeded::variable(t, 0), at, rate);
    for (std::size_t i = 0; i < x.size(); ++i) slope[i] = rate[i].derivatives()(0);
  }

 private:
  struct ChartSides {
    std::size_t first, second;
  };
  ChartSides chart_sides(std::size_t k) const {
    if (chart_.is_of_joint(k)) {
      const JointElement<R>& joint = system_.joints()[chart_.joint_of(k)];
      return {joint.bearing_at.body, joint.journal_at.body};
    }
    return {chart_.coordinate_of(k) / 3, ground_body};
  }

  /// C v of a row and a vector by coordinates.
  template <class T, class V>
  static T along(const ConstraintRow<T>& row, const ChartSides& sides, const V* v) {
    T sum(0);
    for (std::size_t k = 0; k < 3; ++k) {
      if (sides.first != ground_body) sum += row.first[k] * v[3 * sides.first + k];
      if (sides.second != ground_body) sum += row.second[k] * v[3 * sides.second + k];
    }
    return sum;
  }
  R rate_of(const ConstraintRow<R>& row, const ChartSides& sides) const { return along(row, sides, y_.data() + n_); }

  void evaluate(const R& t) {
    system_.evaluate_kinematics(t, y_.data(), w_);
    chart_.evaluate(y_.data(), w_, functions_);
  }

  /// y = (q, q̇) of x to rounding, with the rows there and the chart's factors.
  void follow(const R& t, const State& x) {
    using std::abs;
    const std::size_t f = freedoms();
    Remembered& start = place_of(t);
    if (start.known) std::copy(start.q.begin(), start.q.end(), y_.begin());
    const R rounding = 4 * std::numeric_limits<R>::epsilon();
    R before = std::numeric_limits<R>::infinity();
    for (int iteration = 0;; ++iteration) {
      evaluate(t);
      for (std::size_t row = 0; row < m_; ++row) residual_[row] = w_.rows[row].value;
      for (std::size_t k = 0; k < f; ++k) residual_[m_ + k] = functions_[k].value - x[k];
      chart_.factorise(w_.rows, functions_);
      chart_.solve(residual_.data(), step_.data());
      R size(0);
      for (std::size_t i = 0; i < n_; ++i) size = std::max<R>(size, abs(step_[i]) / sizes_[i]);
      if (size <= rounding || (iteration > 0 && size >= before && size < 1000 * rounding)) break;
      if (!(size < 1) || iteration == most_iterations)
        throw std::domain_error("no positions near the last ones fulfil the constraints");
      before = size;
      for (std::size_t i = 0; i < n_; ++i) y_[i] -= step_[i];
      if (size < R(1e-9)) {  // its square is below rounding
        evaluate(t);
        chart_.factorise(w_.rows, functions_);
        break;
      }
    }
    start.t = t;
    start.known = true;
    start.q.assign(y_.begin(), y_.begin() + static_cast<std::ptrdiff_t>(n_));
    for (std::size_t row = 0; row < m_; ++row) residual_[row] = -w_.rows[row].time_rate;
    for (std::size_t k = 0; k < f; ++k) residual_[m_ + k] = x[f + k];
    chart_.solve(residual_.data(), y_.data() + n_);
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {  // places stay
      w_.frames[b].velocity = Vector2<R>(y_[n_ + 3 * b], y_[n_ + 3 * b + 1]);
      w_.frames[b].spin = y_[n_ + 3 * b + 2];
    }
    system_.evaluate_constraints(t, w_);
    chart_.evaluate(y_.data(), w_, functions_);
  }

  /// q̈ and λ at the place of the last follow.
  void accelerate(const R& t) {
    system_.apply_forces(ode_.memory(), w_);
    if (!w_.slides.empty()) {
      system_.evaluate(t, y_.data(), ode_.memory(), w_);
      return;
    }
    if (system_.has_elements()) system_.apply_elements(t, w_);
    if (m_ > 0) {
      system_.factorise(w_);
      system_.solve(w_);
    } else {
      system_.evaluate(t, y_.data(), ode_.memory(), w_);
    }
  }

  /// Rates with derivatives, at the place of the last follow.
  template <class Time>
  void fill(const Time& t, const std::vector<Seeded>& x, std::vector<Seeded>& dxdt) {
    const std::size_t f = freedoms();
    using Derivatives = std::decay_t<decltype(std::declval<Seeded>().derivatives())>;
    std::vector<Derivatives> right(n_), change(n_);
    seeded_.assign(y_.begin(), y_.end());
    // One Newton step each, on the derivatives alone: the values fulfil both already.
    system_.evaluate_kinematics(t, seeded_.data(), dual_);
    for (std::size_t row = 0; row < m_; ++row) right[row] = dual_.rows[row].value.derivatives();
    for (std::size_t k = 0; k < f; ++k) right[m_ + k] = -x[k].derivatives();
    chart_.solve(right.data(), change.data());
    for (std::size_t i = 0; i < n_; ++i) seeded_[i] = Seeded(y_[i], Derivatives(-change[i]));
    system_.evaluate_kinematics(t, seeded_.data(), dual_);
    chart_.evaluate(seeded_.data(), dual_, seeded_functions_);
    for (std::size_t row = 0; row < m_; ++row) right[row] = system_.constraint_rate(row, dual_).derivatives();
    for (std::size_t k = 0; k < f; ++k) {
      const Seeded rate = along(seeded_functions_[k], chart_sides(k), seeded_.data() + n_);
      right[m_ + k] = rate.derivatives() - x[f + k].derivatives();
    }
    chart_.solve(right.data(), change.data());
    for (std::size_t i = 0; i < n_; ++i) seeded_[n_ + i] = Seeded(y_[n_ + i], Derivatives(-change[i]));
    system_.evaluate(t, seeded_.data(), ode_.memory(), dual_);
    chart_.evaluate(seeded_.data(), dual_, seeded_functions_);
    for (std::size_t k = 0; k < f; ++k) {
      dxdt[k] = x[f + k];
      dxdt[f + k] =
          along(seeded_functions_[k], chart_sides(k), dual_.accelerations.data()) - seeded_functions_[k].gamma;
    }
    if (ode_.with_ledger()) ode_.fill_powers(t, seeded_, dual_, &dxdt[2 * f]);
  }

  static constexpr int most_iterations = 12;

  /// Coordinates that were found at a time: the stages of a step ask again and again for the same times.
  struct Remembered {
    R t{};
    bool known = false;
    std::vector<R> q;
  };
  Remembered& place_of(const R& t) {
    for (Remembered& each : memory_) {
      if (each.known && each.t == t) return each;
    }
    next_ = (next_ + 1) % memory_.size();
    memory_[next_].known = false;
    return memory_[next_];
  }

  MultibodyOde<R>& ode_;
  const PlanarSystem<R>& system_;
  std::size_t n_, m_;
  CoordinateChart<R> chart_;
  SystemWorkspace<R> w_;
  SystemWorkspace<Seeded> dual_;
  Full y_;
  std::vector<R> residual_, step_, sizes_;
  std::vector<ConstraintRow<R>> functions_;
  std::vector<ConstraintRow<Seeded>> seeded_functions_;
  std::vector<Seeded> seeded_, seeded_x_, seeded_rate_;
  std::array<Remembered, 4> memory_;
  std::size_t next_ = 0;
  RunTimeJacobian<MultibodyOde<R>::jacobian_group, R> derivatives_;
};

}  // namespace lubjoint

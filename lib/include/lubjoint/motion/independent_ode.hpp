/// Equations of motion in coordinates that the constraints leave free.
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>
#include <vector>

#include "lubjoint/motion/independent_motion.hpp"
#include "lubjoint/motion/multibody_ode.hpp"
#include "lubjoint/motion/reduced_mass.hpp"

namespace lubjoint {

/// (z, ż) and, with a ledger, the work of each term, for the functions z = C(q) of a chart. With A = [Φq; C]:
///   A V = [0; I],  A a = [γ; γ_C],  VᵀMV z̈ = Vᵀ(g − M a);  q̈ = a + V z̈;  Aᵀ[λ; 0] = g − M q̈.
/// Derivatives are exact: q, q̇, z̈ and λ by implicit differentiation, with the factors at hand.
/// @tparam N  number of states: twice the freedoms, and no ledger; or run_time_size
template <class R, std::size_t N>
class IndependentOde final : public OdeSystem<R, N>, public IndependentMotion<R, N / 2> {
  using Motion = IndependentMotion<R, N / 2>;

 public:
  using State = StateOf<R, N>;        ///< (z, ż, work)
  using Full = std::vector<R>;        ///< (q, q̇, work)
  using Jacobian = JacobianOf<R, N>;  ///< of State
  /// Derivatives in one pass.
  static constexpr int width = N == run_time_size ? 4 : static_cast<int>(N);
  using Seeded = Dual<R, width>;  ///< a number with them

  using Motion::freedoms;

  /// @param ode  whose equations these are, with what its joints remember; kept by reference
  /// @param units  in which the coordinates are comparable, such as their tolerances
  IndependentOde(MultibodyOde<R>& ode, const std::vector<R>& units)
      : Motion(ode.system(), units, ode.dimension()),
        ode_(ode),
        dual_(system_.template workspace<Seeded>()),
        reduced_(freedoms()),
        seeded_(ode.dimension()),
        seeded_functions_(freedoms()),
        right_slopes_(n_),
        slopes_(n_),
        slopes_work_(3 * n_),
        q_slopes_(n_),
        reduced_slopes_(freedoms()) {
    for (std::size_t i = 0; i < n_; ++i) {
      const PlanarBody<R>& body = system_.bodies()[i / 3];
      masses_.push_back(i % 3 == 2 ? body.inertia : body.mass);
    }
  }

  std::size_t dimension() const { return 2 * freedoms() + ode_.dimension() - 2 * n_; }  ///< number of states

  /// As IndependentMotion.
  void choose(const R& t, const Full& y) {
    Motion::choose(t, y);
    function_of_joint_.assign(system_.joints().size(), not_chosen);
    for (std::size_t k = 0; k + 1 < freedoms(); ++k) {
      if (chart_.is_of_joint(k) && chart_.is_of_joint(k + 1) && chart_.joint_of(k) == chart_.joint_of(k + 1))
        function_of_joint_[chart_.joint_of(k)] = k;
    }
  }

  /// (z, ż, work) of a whole state, from whose coordinates the next search starts.
  void take(const Full& y, State& x) {
    start_from(y);
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

  /// Rates of the whole state of the last expansion, from those of (z, ż, work).
  void expand_rate(const State& x_rate, Full& y_rate) {
    const std::size_t f = freedoms();
    accelerate_unmoved(y_rate.data() + n_);
    add_along(latest(), x_rate.data() + f, y_rate.data() + n_);
    for (std::size_t i = 2 * n_; i < y_rate.size(); ++i) y_rate[i] = x_rate[2 * f + i - 2 * n_];
  }
  /// The rates of (z, ż, work) in those of the whole state of the last expansion.
  void take_rate(const Full& y_rate, State& x_rate) {
    const std::size_t f = freedoms();
    if constexpr (N == run_time_size) x_rate.resize(dimension());
    chart_.evaluate(y_.data(), w_, functions_.data());
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
      for (Slopes& each : q_slopes_) each.setZero();
      for (std::size_t i = 0; i < free().size(); ++i) {
        Slopes& slopes = q_slopes_[free().columns[i]];
        for (std::size_t k = start; k < std::min(end, f); ++k) slopes(index(k - start)) = column(latest(), k, i);
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
    for (Slopes& each : q_slopes_) each.setZero();
    for (std::size_t i = 0; i < prescribed().size(); ++i) q_slopes_[prescribed().columns[i]](0) = moment().rates[i];
    for (std::size_t i = 0; i < free().size(); ++i) q_slopes_[free().columns[i]](0) = column(latest(), f, i);
    fill(Seeded::variable(t, 0), [](std::size_t) -> Slopes { return Slopes::Zero(); });
    for (std::size_t k = 0; k < f; ++k) {
      slope[k] = R(0);
      slope[f + k] = reduced_slopes_[k](0);
    }
    for (std::size_t i = 2 * f; i < x.size(); ++i) slope[i] = powers_[i - 2 * f].derivatives()(0);
  }

 private:
  using Slopes = typename Seeded::Derivatives;
  using Motion::accelerate_unmoved;
  using Motion::accelerated_;
  using Motion::accelerations_;
  using Motion::add_along;
  using Motion::along;
  using Motion::chart_;
  using Motion::column;
  using Motion::follow;
  using Motion::free;
  using Motion::functions_;
  using Motion::index;
  using Motion::latest;
  using Motion::m_;
  using Motion::moment;
  using Motion::n_;
  using Motion::numbers;
  using Motion::prescribed;
  using Motion::residual_;
  using Motion::speeds_;
  using Motion::start_from;
  using Motion::step_;
  using Motion::system_;
  using Motion::w_;
  using Motion::work_;
  using Motion::y_;
  using typename Motion::Columns;
  using typename Motion::Place;

  static constexpr std::size_t not_chosen = std::numeric_limits<std::size_t>::max();

  /// z̈ and q̈ at the place of the last follow.
  void accelerate(const R& t) {
    if (accelerated_ && ode_.memory().empty()) return;
    const std::size_t f = freedoms();
    // A film's eccentricity is a state itself: the difference of two positions would have their rounding, 1e-13 of a
    // clearance at each evaluation anew, and a stiff film would multiply it.
    system_.apply_forces(ode_.memory(), w_, [this](std::size_t joint, JointKinematics<R>& at) {
      const std::size_t k = function_of_joint_[joint];
      if (k == not_chosen) return;
      at.motion.eccentricity = Vector2<R>(latest().z[k], latest().z[k + 1]);
      at.motion.velocity = Vector2<R>(speeds_[k], speeds_[k + 1]);
    });
    if (!w_.slides.empty()) {  // their forces hold journals on lines: by the whole equations
      system_.evaluate(t, y_.data(), ode_.memory(), w_);
      chart_.evaluate(y_.data(), w_, functions_.data());
      for (std::size_t k = 0; k < f; ++k)
        accelerations_[k] = along(functions_[k], k, w_.accelerations.data()) - functions_[k].gamma;
    } else {
      if (system_.has_elements()) system_.apply_elements(t, w_);
      R* a = w_.accelerations.data();
      accelerate_unmoved(a);
      reduced_.factorise(
          free().size(), [this](std::size_t i) { return masses_[free().columns[i]]; }, latest().columns.data());
      project([this, a](std::size_t c) { return R(w_.forces[c] - masses_[c] * a[c]); }, accelerations_.data());
      reduced_.solve(accelerations_.data());
      add_along(latest(), accelerations_.data(), a);
    }
    accelerated_ = true;
  }

  /// Vᵀ x, x(c) that of coordinate c.
  template <class At, class V>
  void project(const At& x, V* out) const {
    const std::size_t f = freedoms();
    const Place& place = latest();
    const std::vector<std::size_t>& coordinates = free().columns;
    const V zero = x(coordinates[0]) - x(coordinates[0]);
    for (std::size_t k = 0; k < f; ++k) out[k] = zero;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      const V here = x(coordinates[i]);
      for (std::size_t k = 0; k < f; ++k) out[k] += column(place, k, i) * here;
    }
  }

  /// λ at the place of the last accelerate.
  void find_multipliers() {
    if (!w_.slides.empty()) return;  // the whole equations have found them
    for (std::size_t i = 0; i < n_; ++i) residual_[i] = w_.forces[i] - masses_[i] * w_.accelerations[i];
    chart_.parts().solve_transposed(numbers(), residual_.data(), step_.data(), work_.data());
    std::copy(step_.begin(), step_.begin() + static_cast<std::ptrdiff_t>(m_), w_.multipliers.begin());
  }

  /// Derivatives of z̈, into reduced_slopes_, and of the powers, from those of q at fixed ż, which are in q_slopes_, and
  /// of ż. At the place of the last accelerate, with its multipliers. What is prescribed depends on the time alone.
  template <class Time, class RateSlope>
  void fill(const Time& t, const RateSlope& z_rate_slope) {
    const std::size_t f = freedoms();
    const bool whole = !std::is_same_v<Time, R> || ode_.with_ledger();
    // q̇: d(A) q̇ + A dq̇ = [−dΦt; dż].
    for (std::size_t i = 0; i < n_; ++i) {
      seeded_[i] = Seeded(y_[i], q_slopes_[i]);
      seeded_[n_ + i] = Seeded(y_[n_ + i]);
    }
    place_seeded();
    evaluate_rows(t, whole);
    for_each_row(whole,
                 [&](std::size_t row) { right_slopes_[row] = -system_.constraint_rate(row, dual_).derivatives(); });
    for (std::size_t k = 0; k < f; ++k)
      right_slopes_[m_ + k] = z_rate_slope(k) - along(seeded_functions_[k], k, seeded_.data() + n_).derivatives();
    solve_slopes(whole, slopes_);
    for (std::size_t i = 0; i < n_; ++i) seeded_[n_ + i].derivatives() = slopes_[i];
    if (!w_.slides.empty()) {
      system_.evaluate(t, seeded_.data(), ode_.memory(), dual_);
      chart_.evaluate(seeded_.data(), dual_, seeded_functions_.data());
      for (std::size_t k = 0; k < f; ++k)
        reduced_slopes_[k] =
            (along(seeded_functions_[k], k, dual_.accelerations.data()) - seeded_functions_[k].gamma).derivatives();
    } else {
      place_seeded();
      system_.apply_forces(ode_.memory(), dual_);
      if (system_.has_elements()) system_.apply_elements(t, dual_);
      evaluate_rows(t, whole);
      differentiate_accelerations(whole);
    }
    if (ode_.with_ledger()) {
      powers_.resize(ode_.works());
      ode_.fill_powers(t, seeded_, dual_, powers_.data());
    }
  }

  /// Frames of seeded_, whose cosines and sines are those of w_'s.
  void place_seeded() {
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      const Seeded* q = seeded_.data() + 3 * b;
      const Seeded* v = q + n_;
      PlanarFrame<Seeded>& frame = dual_.frames[b];
      frame.position = Vector2<Seeded>(q[0], q[1]);
      frame.angle = q[2];
      frame.velocity = Vector2<Seeded>(v[0], v[1]);
      frame.spin = v[2];
      frame.cosine = Seeded(w_.frames[b].cosine, Slopes(-w_.frames[b].sine * q[2].derivatives()));
      frame.sine = Seeded(w_.frames[b].sine, Slopes(w_.frames[b].cosine * q[2].derivatives()));
    }
  }

  /// Rows at these: all, or those that are not prescribed.
  template <class Time>
  void evaluate_rows(const Time& t, bool whole) {
    if (whole) {
      system_.evaluate_constraints(t, dual_);
    } else {
      for (const std::size_t c : free().constraints) system_.evaluate_constraint(c, t, dual_);
    }
    chart_.evaluate(seeded_.data(), dual_, seeded_functions_.data());
  }

  /// Calls act(row) for those of constraints.
  template <class Act>
  void for_each_row(bool whole, const Act& act) const {
    if (whole) {
      for (std::size_t row = 0; row < m_; ++row) act(row);
    } else {
      for (std::size_t i = 0; i < free().size() - freedoms(); ++i) act(free().rows[i]);
    }
  }

  /// Solves A x = right_slopes_, of which the prescribed part is zero if not the whole is asked for.
  void solve_slopes(bool whole, std::vector<Slopes>& x) {
    if (whole) {
      chart_.parts().solve(numbers(), right_slopes_.data(), x.data(), slopes_work_.data());
      return;
    }
    const std::size_t n = free().size();
    Slopes* right = slopes_work_.data();
    Slopes* found = right + n_;
    for (std::size_t i = 0; i < n; ++i) right[i] = right_slopes_[free().rows[i]];
    free().lu.solve(latest().numbers.data(), right, found, found + n_);
    for (Slopes& each : x) each.setZero();
    for (std::size_t i = 0; i < n; ++i) x[free().columns[i]] = found[i];
  }

  /// With q̈ and λ held, A dq̈ = [dγ − dΦq q̈; dz̈ + dγ_C − dC q̈] and Vᵀ(M dq̈ + dΦqᵀ λ − dg) = 0.
  void differentiate_accelerations(bool whole) {
    const std::size_t f = freedoms();
    for (std::size_t i = 0; i < n_; ++i) slopes_[i] = dual_.forces[i].derivatives();
    const auto side = [&](std::size_t row, std::size_t body, const std::array<Seeded, 3>& columns) {
      if (body == ground_body) return;
      for (std::size_t c = 0; c < 3; ++c) {
        right_slopes_[row] -= w_.accelerations[3 * body + c] * columns[c].derivatives();
        if (row < m_) slopes_[3 * body + c] -= w_.multipliers[row] * columns[c].derivatives();
      }
    };
    for_each_row(whole, [&](std::size_t row) {
      right_slopes_[row] = dual_.rows[row].gamma.derivatives();
      side(row, system_.first_body_of_row(row), dual_.rows[row].first);
      side(row, system_.second_body_of_row(row), dual_.rows[row].second);
    });
    for (std::size_t k = 0; k < f; ++k) {
      right_slopes_[m_ + k] = seeded_functions_[k].gamma.derivatives();
      const auto [first, second] = chart_.bodies_of(k);
      side(m_ + k, first, seeded_functions_[k].first);
      side(m_ + k, second, seeded_functions_[k].second);
    }
    solve_slopes(whole, q_slopes_);  // of q̈ without dz̈
    for (std::size_t i = 0; i < n_; ++i) slopes_[i] -= masses_[i] * q_slopes_[i];
    project([this](std::size_t c) -> const Slopes& { return slopes_[c]; }, reduced_slopes_.data());
    reduced_.solve(reduced_slopes_.data());
    if (!ode_.with_ledger()) return;
    for (std::size_t i = 0; i < free().size(); ++i) {
      const std::size_t c = free().columns[i];
      for (std::size_t k = 0; k < f; ++k) {
        const Slopes part = column(latest(), k, i) * reduced_slopes_[k];
        q_slopes_[c] += part;
        slopes_[c] -= masses_[c] * part;
      }
    }
    chart_.parts().solve_transposed(numbers(), slopes_.data(), right_slopes_.data(), slopes_work_.data());
    for (std::size_t i = 0; i < n_; ++i) dual_.accelerations[i] = Seeded(w_.accelerations[i], q_slopes_[i]);
    for (std::size_t row = 0; row < m_; ++row) dual_.multipliers[row] = Seeded(w_.multipliers[row], right_slopes_[row]);
  }

  MultibodyOde<R>& ode_;
  SystemWorkspace<Seeded> dual_;
  std::vector<std::size_t> function_of_joint_;  ///< the first of the two that are its eccentricity, or not_chosen
  std::vector<R> masses_;                       ///< of every coordinate

  // Work, kept so that no evaluation allocates.
  ReducedMass<R, N / 2, Columns> reduced_;  ///< VᵀMV
  std::vector<Seeded> seeded_;
  std::vector<ConstraintRow<Seeded>> seeded_functions_;
  std::vector<Slopes> right_slopes_, slopes_, slopes_work_, q_slopes_, reduced_slopes_;
  std::vector<Seeded> powers_;
};

}  // namespace lubjoint

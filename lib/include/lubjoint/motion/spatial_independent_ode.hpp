/// Equations of motion in space in coordinates that the constraints leave free.
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>
#include <vector>

#include "lubjoint/motion/independent_integrator.hpp"
#include "lubjoint/motion/spatial_independent_motion.hpp"
#include "lubjoint/motion/spatial_ode.hpp"
#include "lubjoint/motion/spatial_prescribed_motion.hpp"
#include "lubjoint/multibody/small_ldlt.hpp"

namespace lubjoint {

/// (z, ż) and, with a ledger, the work of each term, for the functions z = C(r, p) of a chart. With A = [Φ_v; C_v] on
/// v = (ṙ, ω′), M = diag(m, J′) and forces g that have the gyroscopic −ω̃′J′ω′ in them:
///   A v = [−Φ_t; ż],  A V = [0; I],  A a = [γ; γ_C],  VᵀMV z̈ = Vᵀ(g − M a);  v̇ = a + V z̈;  Aᵀ[λ; 0] = g − M v̇.
/// Derivatives are exact: places, velocities, z̈ and λ by implicit differentiation, with the factors at hand; those of
/// p are ½Lᵀ times a turn.
/// @tparam N  number of states: twice the freedoms, and no ledger; or run_time_size
template <class R, std::size_t N>
class SpatialIndependentOde final
    : public OdeSystem<R, N>,
      public SpatialIndependentMotion<R, N == run_time_size ? 4 : static_cast<int>(N / 2)> {
  using Motion = SpatialIndependentMotion<R, N == run_time_size ? 4 : static_cast<int>(N / 2)>;

 public:
  using State = StateOf<R, N>;        ///< (z, ż, work)
  using Full = std::vector<R>;        ///< (r, p; ṙ, ω′; work)
  using Jacobian = JacobianOf<R, N>;  ///< of State
  /// Derivatives in one pass.
  static constexpr int width = N == run_time_size ? 4 : static_cast<int>(N);
  using Seeded = Dual<R, width>;  ///< a number with them

  using Motion::freedoms;

  /// @param ode  whose equations these are, with what its joints remember; kept by reference
  /// @param units  in which displacements and small turns are comparable, six a body
  SpatialIndependentOde(SpatialOde<R>& ode, const std::vector<R>& units)
      : Motion(ode.system(), units, ode.dimension(), ode.with_ledger()),
        ode_(ode),
        dual_(system_.template workspace<Seeded>()),
        forces_(n_),
        weighted_(n_ * groups()),
        reduced_(freedoms() * freedoms()),
        seeded_(ode.mechanical_states()),
        seeded_functions_(freedoms()),
        right_slopes_(n_),
        slopes_(n_),
        slopes_work_(n_),
        v_slopes_(n_),
        reduced_slopes_(freedoms()) {}

  std::size_t dimension() const { return 2 * freedoms() + ode_.dimension() - ode_.mechanical_states(); }  ///< of states

  /// As SpatialIndependentMotion.
  void choose(const R& t, const Full& y) {
    Motion::choose(t, y);
    function_of_joint_.assign(system_.joints().size(), not_chosen);
    for (std::size_t k = 0; k + 1 < freedoms(); ++k) {
      if (chart_.is_of_joint(k) && chart_.is_of_joint(k + 1) && chart_.joint_of(k) == chart_.joint_of(k + 1))
        function_of_joint_[chart_.joint_of(k)] = k;
    }
  }

  /// (z, ż, work) of a whole state, from whose places the next search starts.
  void take(const Full& y, State& x) {
    start_from(y);
    system_.place(y_.data(), w_);
    chart_.evaluate(w_, functions_.data());
    const std::size_t f = freedoms();
    if constexpr (N == run_time_size) x.resize(dimension());
    for (std::size_t k = 0; k < f; ++k) {
      x[k] = functions_[k].value;
      x[f + k] = along(functions_[k], k, y_.data() + places_end_);
    }
    for (std::size_t i = works_begin(); i < y.size(); ++i) x[2 * f + i - works_begin()] = y[i];
  }

  /// The whole state. @throws SingularConstraints where no places near the last ones fulfil the constraints
  void expand(const R& t, const State& x, Full& y) {
    follow(t, x);
    for (std::size_t i = works_begin(); i < y_.size(); ++i) y_[i] = x[2 * freedoms() + i - works_begin()];
    y = y_;
  }

  /// Rates of the whole state of the last expansion, from those of (z, ż, work): those of velocities and works.
  void expand_rate(const State& x_rate, Full& y_rate) {
    const std::size_t f = freedoms();
    for (std::size_t row = 0; row < n_; ++row) residual_[row] = gammas_[row];
    for (std::size_t k = 0; k < f; ++k) residual_[m_ + k] += x_rate[f + k];
    chart_.solve(residual_.data(), y_rate.data() + places_end_, work_.data());
    for (std::size_t i = works_begin(); i < y_rate.size(); ++i) y_rate[i] = x_rate[2 * f + i - works_begin()];
  }
  /// The rates of (z, ż, work) in those of the whole state of the last expansion.
  void take_rate(const Full& y_rate, State& x_rate) {
    const std::size_t f = freedoms();
    if constexpr (N == run_time_size) x_rate.resize(dimension());
    for (std::size_t k = 0; k < f; ++k) {
      x_rate[k] = along(functions_[k], k, y_.data() + places_end_);
      x_rate[f + k] = along(functions_[k], k, y_rate.data() + places_end_) - functions_[k].gamma;
    }
    for (std::size_t i = works_begin(); i < y_rate.size(); ++i) x_rate[2 * f + i - works_begin()] = y_rate[i];
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
        ode_.fill_powers(t, w_, &dxdt[2 * f]);
      }
    }
  }

  /// λ of all rows of Φ at a state; 0 of those that are left out.
  const std::vector<R>& multipliers(const State& x, const R& t) {
    follow(t, x);
    accelerate(t);
    find_multipliers();
    return w_.multipliers;
  }

  void jacobian(const State& x, Jacobian& j, const R& t) override {
    multipliers(x, t);
    const std::size_t f = freedoms();
    const std::size_t states = x.size();
    if constexpr (N == run_time_size) j.setZero(index(states), index(states));
    for (std::size_t start = 0; start < 2 * f; start += width) {
      const std::size_t end = std::min<std::size_t>(2 * f, start + width);
      for (std::size_t i = 0; i < n_; ++i) {
        v_slopes_[i].setZero();
        for (std::size_t k = start; k < std::min(end, f); ++k)
          v_slopes_[i](index(k - start)) = column(k)[i](index(k % group));
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
    multipliers(x, t);
    const std::size_t f = freedoms();
    for (std::size_t row = 0; row < m_; ++row) residual_[row] = -chart_.time_rate(row);
    std::fill(residual_.begin() + static_cast<std::ptrdiff_t>(m_), residual_.end(), R(0));
    chart_.solve(residual_.data(), step_.data(), work_.data());
    for (std::size_t i = 0; i < n_; ++i) {
      v_slopes_[i].setZero();
      v_slopes_[i](0) = step_[i];
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
  using Motion::accelerated_;
  using Motion::accelerations_;
  using Motion::add_along;
  using Motion::along;
  using Motion::bodies_;
  using Motion::chart_;
  using Motion::column;
  using Motion::follow;
  using Motion::functions_;
  using Motion::gammas_;
  using Motion::group;
  using Motion::groups;
  using Motion::index;
  using Motion::latest_;
  using Motion::m_;
  using Motion::n_;
  using Motion::places_;
  using Motion::places_end_;
  using Motion::residual_;
  using Motion::speeds_;
  using Motion::start_from;
  using Motion::step_;
  using Motion::system_;
  using Motion::w_;
  using Motion::work_;
  using Motion::y_;
  using typename Motion::Columns;

  static constexpr std::size_t not_chosen = std::numeric_limits<std::size_t>::max();

  /// Where works begin in a whole state.
  std::size_t works_begin() const { return ode_.mechanical_states(); }

  /// z̈, and r̈ and ω̇′, at the place of the last follow.
  void accelerate(const R& t) {
    const std::vector<JointMemory<R>>& memory = std::as_const(ode_).memory();
    if (accelerated_ && memory.empty()) return;
    // A film's eccentricity is a state itself: the difference of two positions would have their rounding, 1e-13 of a
    // clearance at each evaluation anew, and a stiff film would multiply it.
    system_.apply_forces(t, memory, w_, system_.every_body, [this](std::size_t joint, SpatialJointKinematics<R>& at) {
      const std::size_t k = function_of_joint_[joint];
      if (k == not_chosen) return;
      at.motion.eccentricity = Vector2<R>(places_[latest_].z[k], places_[latest_].z[k + 1]);
      at.motion.velocity = Vector2<R>(speeds_[k], speeds_[k + 1]);
    });
    R* a = w_.accelerations.data();
    chart_.solve(gammas_.data(), a, work_.data());
    weigh(a, forces_.data());
    for (std::size_t i = 0; i < n_; ++i) forces_[i] = w_.forces[i] - forces_[i];
    factorise_reduced();
    project(forces_.data(), accelerations_.data());
    solve_ldlt(freedoms(), reduced_.data(), accelerations_.data());
    add_along(places_[latest_], accelerations_.data(), a);
    accelerated_ = true;
  }

  /// M x. V: R, or several numbers.
  template <class V>
  void weigh(const V* x, V* out) const {
    for (std::size_t b = 0; b < bodies_; ++b) {
      const SpatialBody<R>& body = system_.bodies()[b];
      const V* v = x + 6 * b;
      for (std::size_t k = 0; k < 3; ++k) {
        out[6 * b + k] = body.mass * v[k];
        out[6 * b + 3 + k] =
            body.inertia(index(k), 0) * v[3] + body.inertia(index(k), 1) * v[4] + body.inertia(index(k), 2) * v[5];
      }
    }
  }

  /// LDLᵀ of VᵀMV, 1/D in the diagonal.
  void factorise_reduced() {
    const std::size_t f = freedoms();
    const Columns* all = places_[latest_].columns.data();
    for (std::size_t g = 0; g < groups(); ++g) weigh(all + g * n_, weighted_.data() + g * n_);
    for (std::size_t g = 0; g < groups(); ++g) {
      for (std::size_t h = 0; h <= g; ++h) {
        Eigen::Array<R, group, group> block = Eigen::Array<R, group, group>::Zero();
        for (std::size_t i = 0; i < n_; ++i) {
          for (std::size_t l = 0; l < group; ++l)
            block.col(index(l)) += weighted_[g * n_ + i] * all[h * n_ + i](index(l));
        }
        for (std::size_t k = g * group; k < std::min<std::size_t>(f, (g + 1) * group); ++k) {
          for (std::size_t l = h * group; l < std::min<std::size_t>(k + 1, (h + 1) * group); ++l)
            reduced_[k * f + l] = block(index(k - g * group), index(l - h * group));
        }
      }
    }
    factorise_ldlt(f, reduced_.data());
  }

  /// Vᵀ x
  template <class V>
  void project(const V* x, V* out) const {
    for (std::size_t k = 0; k < freedoms(); ++k) {
      const Columns* v = column(k);
      V sum = v[0](index(k % group)) * x[0];
      for (std::size_t i = 1; i < n_; ++i) sum += v[i](index(k % group)) * x[i];
      out[k] = sum;
    }
  }

  /// λ at the place of the last accelerate; those of rows that are left out stay 0.
  void find_multipliers() {
    weigh(w_.accelerations.data(), residual_.data());
    for (std::size_t i = 0; i < n_; ++i) residual_[i] = w_.forces[i] - residual_[i];
    chart_.solve_transposed(residual_.data(), step_.data(), work_.data());
    for (std::size_t i = 0; i < m_; ++i) w_.multipliers[system_.kept()[i]] = step_[i];
  }

  /// Places, with the derivatives that displacements and turns in v_slopes_ give them, and velocities without.
  void seed_places() {
    for (std::size_t b = 0; b < bodies_; ++b) {
      const R* q = y_.data() + 7 * b;
      const Slopes* d = v_slopes_.data() + 6 * b;
      Seeded* seeded = seeded_.data() + 7 * b;
      for (std::size_t k = 0; k < 3; ++k) seeded[k] = Seeded(q[k], d[k]);
      const R half(0.5);  // ½Lᵀ, as euler_rate
      seeded[3] = Seeded(q[3], Slopes(-half * (q[4] * d[3] + q[5] * d[4] + q[6] * d[5])));
      seeded[4] = Seeded(q[4], Slopes(half * (q[3] * d[3] + q[5] * d[5] - q[6] * d[4])));
      seeded[5] = Seeded(q[5], Slopes(half * (q[3] * d[4] + q[6] * d[3] - q[4] * d[5])));
      seeded[6] = Seeded(q[6], Slopes(half * (q[3] * d[5] + q[4] * d[4] - q[5] * d[3])));
    }
    for (std::size_t i = 0; i < n_; ++i) seeded_[places_end_ + i] = Seeded(y_[places_end_ + i]);
  }

  /// Derivatives of z̈, into reduced_slopes_, and of the powers, from those of places at fixed ż, which are in
  /// v_slopes_, and of ż. At the place of the last accelerate, with its multipliers.
  template <class Time, class RateSlope>
  void fill(const Time& t, const RateSlope& z_rate_slope) {
    const std::size_t f = freedoms();
    // v: d(A) v + A dv = [−dΦ_t; dż].
    seed_places();
    system_.evaluate_kinematics(t, seeded_.data(), dual_);
    chart_.evaluate(dual_, seeded_functions_.data());
    for (std::size_t i = 0; i < m_; ++i)
      right_slopes_[i] = -system_.constraint_rate(system_.kept()[i], dual_).derivatives();
    for (std::size_t k = 0; k < f; ++k)
      right_slopes_[m_ + k] =
          z_rate_slope(k) - along(seeded_functions_[k], k, seeded_.data() + places_end_).derivatives();
    chart_.solve(right_slopes_.data(), slopes_.data(), slopes_work_.data());
    for (std::size_t i = 0; i < n_; ++i) seeded_[places_end_ + i].derivatives() = slopes_[i];
    system_.evaluate_kinematics(t, seeded_.data(), dual_);
    system_.apply_forces(t, std::as_const(ode_).memory(), dual_, system_.every_body);
    chart_.evaluate(dual_, seeded_functions_.data());
    differentiate_accelerations();
    if (ode_.with_ledger()) {
      powers_.resize(ode_.works());
      ode_.fill_powers(t, dual_, powers_.data());
    }
  }

  /// With v̇ and λ held, A dv̇ = [dγ − dΦ_v v̇; dz̈ + dγ_C − dC_v v̇] and Vᵀ(M dv̇ + dΦ_vᵀ λ − dg) = 0.
  void differentiate_accelerations() {
    const std::size_t f = freedoms();
    for (std::size_t i = 0; i < n_; ++i) slopes_[i] = dual_.forces[i].derivatives();
    const auto side = [&](std::size_t row, std::size_t body, const std::array<Seeded, 6>& columns, const R& lambda) {
      if (body == ground_body) return;
      for (std::size_t c = 0; c < 6; ++c) {
        right_slopes_[row] -= w_.accelerations[6 * body + c] * columns[c].derivatives();
        if (row < m_) slopes_[6 * body + c] -= lambda * columns[c].derivatives();
      }
    };
    for (std::size_t i = 0; i < m_; ++i) {
      const std::size_t row = system_.kept()[i];
      right_slopes_[i] = dual_.rows[row].gamma.derivatives();
      side(i, system_.first_body_of_row(row), dual_.rows[row].first, w_.multipliers[row]);
      side(i, system_.second_body_of_row(row), dual_.rows[row].second, w_.multipliers[row]);
    }
    for (std::size_t k = 0; k < f; ++k) {
      right_slopes_[m_ + k] = seeded_functions_[k].gamma.derivatives();
      const auto [first, second] = chart_.bodies_of(k);
      side(m_ + k, first, seeded_functions_[k].first, R(0));
      side(m_ + k, second, seeded_functions_[k].second, R(0));
    }
    chart_.solve(right_slopes_.data(), v_slopes_.data(), slopes_work_.data());  // of v̇ without dz̈
    weigh(v_slopes_.data(), right_slopes_.data());
    for (std::size_t i = 0; i < n_; ++i) slopes_[i] -= right_slopes_[i];
    project(slopes_.data(), reduced_slopes_.data());
    solve_ldlt(f, reduced_.data(), reduced_slopes_.data());
    if (!ode_.with_ledger()) return;
    for (std::size_t k = 0; k < f; ++k) {
      const Columns* v = column(k);
      const Columns* weighted = weighted_.data() + (k / group) * n_;
      for (std::size_t i = 0; i < n_; ++i) {
        v_slopes_[i] += v[i](index(k % group)) * reduced_slopes_[k];
        slopes_[i] -= weighted[i](index(k % group)) * reduced_slopes_[k];
      }
    }
    chart_.solve_transposed(slopes_.data(), right_slopes_.data(), slopes_work_.data());
    for (std::size_t i = 0; i < n_; ++i) dual_.accelerations[i] = Seeded(w_.accelerations[i], v_slopes_[i]);
    for (std::size_t i = 0; i < m_; ++i) {
      const std::size_t row = system_.kept()[i];
      dual_.multipliers[row] = Seeded(w_.multipliers[row], right_slopes_[i]);
    }
  }

  SpatialOde<R>& ode_;
  SpatialWorkspace<Seeded> dual_;
  std::vector<std::size_t> function_of_joint_;  ///< the first of the two that are its eccentricity, or not_chosen

  // Work, kept so that no evaluation allocates.
  std::vector<R> forces_;
  std::vector<Columns> weighted_;  ///< MV
  std::vector<R> reduced_;         ///< factors of VᵀMV
  std::vector<Seeded> seeded_;
  std::vector<SpatialRow<Seeded>> seeded_functions_;
  std::vector<Slopes> right_slopes_, slopes_, slopes_work_, v_slopes_, reduced_slopes_;
  std::vector<Seeded> powers_;
};

/// What steps in independent coordinates ask of equations in space: tolerances of turns are those of angles, which
/// Euler parameters follow by half.
template <class R, std::size_t N>
struct IndependentStates<SpatialIndependentOde<R, N>> {
  using Equations = SpatialOde<R>;  ///< in all coordinates
  /// In which displacements and small turns are comparable. @param tolerance  of all states
  static std::vector<R> units(const SpatialOde<R>& ode, const std::vector<R>& tolerance) {
    std::vector<R> units;
    for (std::size_t i = 0; i < ode.system().velocities(); ++i) units.push_back(of_velocity(ode, i, false, tolerance));
    return units;
  }
  /// Tolerance of a function that is no eccentricity, or of its rate.
  static R tolerance(const SpatialOde<R>& ode, const SpatialCoordinateChart<R>& chart, std::size_t k, bool of_rate,
                     const std::vector<R>& of_all) {
    return of_velocity(ode, chart.velocity_of(k), of_rate, of_all);
  }

 private:
  static R of_velocity(const SpatialOde<R>& ode, std::size_t i, bool of_rate, const std::vector<R>& tolerance) {
    if (of_rate) return tolerance[ode.system().places() + i];
    const std::size_t first = spatial_coordinates * (i / 6);
    return i % 6 < 3 ? tolerance[first + i % 6] : R(2 * tolerance[first + 3]);
  }
};

}  // namespace lubjoint

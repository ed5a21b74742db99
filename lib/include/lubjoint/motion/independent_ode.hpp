/// Equations of motion in coordinates that the constraints leave free.
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>
#include <vector>

#include "lubjoint/motion/independent_motion.hpp"
#include "lubjoint/motion/multibody_ode.hpp"

namespace lubjoint {

/// (z, ż) and, with a ledger, the work of each term, for the functions z = C(q) of a chart. With A = [Φq; C]:
///   A q̇ = [−Φt; ż],  A V = [0; I],  A a = [γ; γ_C],  VᵀMV z̈ = Vᵀ(g − M a);  q̈ = a + V z̈;  Aᵀ[λ; 0] = g − M q̈.
/// Derivatives are exact: q, q̇, z̈ and λ by implicit differentiation, with the factors at hand.
/// @tparam N  number of states: twice the freedoms, and no ledger; or run_time_size
template <class R, std::size_t N>
class IndependentOde final : public OdeSystem<R, N>,
                             public IndependentMotion<R, N == run_time_size ? 4 : static_cast<int>(N / 2)> {
  using Motion = IndependentMotion<R, N == run_time_size ? 4 : static_cast<int>(N / 2)>;

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
        forces_(n_),
        reduced_(freedoms() * freedoms()),
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
  using Motion::accelerated_;
  using Motion::accelerations_;
  using Motion::add_along;
  using Motion::along;
  using Motion::chart_;
  using Motion::column;
  using Motion::follow;
  using Motion::forget;
  using Motion::functions_;
  using Motion::gammas_;
  using Motion::group;
  using Motion::groups;
  using Motion::index;
  using Motion::latest_;
  using Motion::m_;
  using Motion::n_;
  using Motion::places_;
  using Motion::residual_;
  using Motion::speeds_;
  using Motion::step_;
  using Motion::system_;
  using Motion::w_;
  using Motion::work_;
  using Motion::y_;
  using typename Motion::Columns;

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
      at.motion.eccentricity = Vector2<R>(places_[latest_].z[k], places_[latest_].z[k + 1]);
      at.motion.velocity = Vector2<R>(speeds_[k], speeds_[k + 1]);
    });
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
          for (std::size_t l = 0; l < group; ++l) block.col(index(l)) += weighted * all[h * n_ + i](index(l));
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
      right_slopes_[m_ + k] = z_rate_slope(k) - along(seeded_functions_[k], k, seeded_.data() + n_).derivatives();
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
  SystemWorkspace<Seeded> dual_;
  std::vector<std::size_t> function_of_joint_;  ///< the first of the two that are its eccentricity, or not_chosen
  std::vector<R> masses_;                       ///< of every coordinate

  // Work, kept so that no evaluation allocates.
  std::vector<R> forces_;
  std::vector<R> reduced_;  ///< factors of VᵀMV
  std::vector<Seeded> seeded_;
  std::vector<ConstraintRow<Seeded>> seeded_functions_;
  std::vector<Slopes> right_slopes_, slopes_, slopes_work_, q_slopes_, reduced_slopes_;
  std::vector<Seeded> powers_;
};

}  // namespace lubjoint

/// Equations of motion in coordinates that the constraints leave free.
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>
#include <vector>

#include "lubjoint/motion/independent_motion.hpp"
#include "lubjoint/motion/reduced_mass.hpp"
#include "lubjoint/number/dual.hpp"

namespace lubjoint {

/// (z, ż) and, with a ledger, the work of each term, for the functions z = C(q) of a chart. With A = [Φ_v; C_v] by the
/// velocities v of all bodies (in the plane q̇, in space (ṙ, ω′)), their mass M and forces g, in which gyroscopic
/// moments are:
///   A V = [0; I],  A a = [γ; γ_C],  VᵀMV z̈ = Vᵀ(g − M a);  v̇ = a + V z̈;  Aᵀ[λ; 0] = g − M v̇.
/// Derivatives are exact: q, v, z̈ and λ by implicit differentiation, with the factors at hand.
/// @tparam In  InPlane or InSpace;  @tparam N  number of states: twice the freedoms, and no ledger; or run_time_size
template <class In, std::size_t N>
class IndependentOde final : public OdeSystem<typename In::R, N>, public IndependentMotion<In, N / 2> {
  using Motion = IndependentMotion<In, N / 2>;

 public:
  using R = typename In::R;                  ///< the number
  using Equations = typename In::Equations;  ///< in all coordinates
  using State = StateOf<R, N>;               ///< (z, ż, work)
  using Full = std::vector<R>;               ///< (q, v, work)
  using Jacobian = JacobianOf<R, N>;         ///< of State
  /// Derivatives in one pass.
  static constexpr int width = N == run_time_size ? 4 : static_cast<int>(N);
  using Seeded = Dual<R, width>;  ///< a number with them

  using Motion::freedoms;

  /// @param ode  whose equations these are, with what its joints remember; kept by reference
  /// @param units  in which displacements are comparable, such as tolerances of coordinates
  IndependentOde(Equations& ode, const std::vector<R>& units)
      : Motion(ode.system(), units, ode.dimension()),
        ode_(ode),
        dual_(system_.template workspace<Seeded>()),
        mass_(ode.system()),
        reduced_(freedoms()),
        seeded_(ode.dimension()),
        seeded_functions_(freedoms()),
        right_slopes_(n_),
        slopes_(n_),
        slopes_work_(3 * n_),
        v_slopes_(n_),
        reduced_slopes_(freedoms()),
        motion_slopes_(freedoms()),
        force_slopes_(2 * ode.system().joints().size()) {
    In::hold_tables(ode, w_);
    In::hold_tables(ode, dual_);
  }

  std::size_t dimension() const { return 2 * freedoms() + ode_.dimension() - works_begin(); }  ///< number of states

  /// As IndependentMotion.
  void choose(const R& t, const Full& y) {
    Motion::choose(t, y);
    function_of_joint_.assign(system_.joints().size(), not_chosen);
    for (std::size_t k = 0; k + 1 < freedoms(); ++k) {
      if (chart_.is_of_joint(k) && chart_.is_of_joint(k + 1) && chart_.joint_of(k) == chart_.joint_of(k + 1))
        function_of_joint_[chart_.joint_of(k)] = k;
    }
    all_eccentricities_ = !function_of_joint_.empty() && std::find(function_of_joint_.begin(), function_of_joint_.end(),
                                                                   not_chosen) == function_of_joint_.end();
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

  /// Rates of the whole state of the last expansion, from those of (z, ż, work): of its velocities and works.
  void expand_rate(const State& x_rate, Full& y_rate) {
    const std::size_t f = freedoms();
    accelerate_unmoved(y_rate.data() + places_end_);
    add_along(latest(), x_rate.data() + f, y_rate.data() + places_end_);
    for (std::size_t i = works_begin(); i < y_rate.size(); ++i) y_rate[i] = x_rate[2 * f + i - works_begin()];
  }
  /// Takes the rates of (z, ż, work) at the place of the last expansion from whoever knows them without forces: the
  /// next search starts with them.
  void go_on_with(const State& x_rate) {
    if (accelerated_) return;
    const std::size_t f = freedoms();
    for (std::size_t k = 0; k < f; ++k) accelerations_[k] = x_rate[f + k];
    accelerate_unmoved(w_.accelerations.data());
    add_along(latest(), accelerations_.data(), w_.accelerations.data());
    accelerated_ = true;
    forced_ = false;
  }
  /// The rates of (z, ż, work) in those of the whole state of the last expansion.
  void take_rate(const Full& y_rate, State& x_rate) {
    const std::size_t f = freedoms();
    if constexpr (N == run_time_size) x_rate.resize(dimension());
    chart_.evaluate(w_, functions_.data());
    for (std::size_t k = 0; k < f; ++k) {
      x_rate[k] = along(functions_[k], k, y_.data() + places_end_);
      x_rate[f + k] = along(functions_[k], k, y_rate.data() + places_end_) - functions_[k].gamma;
    }
    for (std::size_t i = works_begin(); i < y_rate.size(); ++i) x_rate[2 * f + i - works_begin()] = y_rate[i];
  }

  /// ẋ of x = (z, ż, work).
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
        In::evaluate_constraints(system_, t, w_);
        In::fill_powers(ode_, t, y_, w_, &dxdt[2 * f]);
      }
    }
  }

  /// e·ė of each joint whose film kinks where it closes and opens.
  void kinks(const State& x, const R& t, std::vector<R>& values) override {
    values.clear();
    const std::size_t f = freedoms();
    for (std::size_t j = 0; j < system_.joints().size(); ++j) {
      if (!system_.joints()[j].kinks()) continue;
      const std::size_t k = function_of_joint_[j];
      if (k == not_chosen) {
        expand(t, x, full_);
        return ode_.kinks(full_, t, values);
      }
      values.push_back(x[k] * x[f + k] + x[k + 1] * x[f + k + 1]);
    }
  }

  /// λ of all rows of Φ at a state; 0 of those that are left out.
  const std::vector<R>& multipliers(const State& x, const R& t) {
    follow(t, x);
    accelerate(t);
    find_multipliers();
    return w_.multipliers;
  }

  /// ∂ẋ/∂x, exact: by implicit differentiation of the free rows.
  void jacobian(const State& x, Jacobian& j, const R& t) override {
    multipliers(x, t);
    const std::size_t f = freedoms();
    const std::size_t states = x.size();
    if constexpr (N == run_time_size) j.setZero(index(states), index(states));
    for (std::size_t start = 0; start < 2 * f; start += width) {
      const std::size_t end = std::min<std::size_t>(2 * f, start + width);
      for (Slopes& each : v_slopes_) each.setZero();
      for (std::size_t i = 0; i < free().size(); ++i) {
        Slopes& slopes = v_slopes_[free().columns[i]];
        for (std::size_t k = start; k < std::min(end, f); ++k) slopes(index(k - start)) = column(latest(), k, i);
      }
      directions().to_inertial(v_slopes_.data());
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

  /// (VᵀMV)⁻¹ ∂F/∂(e, ė) of the joints, with F the force on a journal. V and the bodies' spins are held. A rate that is
  /// asked for next at the same place is known.
  void force_part(const State& x, Jacobian& j, const R& t) override {
    follow(t, x);
    accelerate(t, true);
    const std::size_t f = freedoms();
    if (In::slides(w_))
      return jacobian(x, j, t);  // all of it: what holds a journal on its line is no force of its place
    j.block(index(f), 0, index(f), index(2 * f)).setZero();
    for (std::size_t joint = 0; joint < function_of_joint_.size(); ++joint) {
      const std::size_t k = function_of_joint_[joint];
      for (auto& each : motion_slopes_) each.setZero();
      motion_slopes_[k] = force_slopes_[2 * joint];
      motion_slopes_[k + 1] = force_slopes_[2 * joint + 1];
      reduced_.solve(motion_slopes_.data());
      for (std::size_t i = 0; i < f; ++i) {
        for (std::size_t of = 0; of < 4; ++of)
          j(index(f + i), index(of / 2 * f + k + of % 2)) += motion_slopes_[i](index(of));
      }
    }
  }
  /// Where all joints, and there are some, have their eccentricities among the functions.
  bool has_force_part() const override { return all_eccentricities_; }

  /// ∂ẋ/∂t at fixed x, exact likewise.
  void time_slope(const State& x, State& slope, const R& t) override {
    multipliers(x, t);
    const std::size_t f = freedoms();
    for (Slopes& each : v_slopes_) each.setZero();
    for (std::size_t i = 0; i < prescribed().size(); ++i) v_slopes_[prescribed().columns[i]](0) = moment().rates[i];
    for (std::size_t i = 0; i < free().size(); ++i) v_slopes_[free().columns[i]](0) = column(latest(), f, i);
    directions().to_inertial(v_slopes_.data());
    fill(Seeded::variable(t, 0), [](std::size_t) -> Slopes { return Slopes::Zero(); });
    for (std::size_t k = 0; k < f; ++k) {
      slope[k] = R(0);
      slope[f + k] = reduced_slopes_[k](0);
    }
    for (std::size_t i = 2 * f; i < x.size(); ++i) slope[i] = powers_[i - 2 * f].derivatives()(0);
  }

 private:
  using Slopes = typename Seeded::Derivatives;
  using OfMotion = Dual<R, 4>;  ///< with derivatives by (e, ė)
  using Motion::accelerate_unmoved;
  using Motion::accelerated_;
  using Motion::accelerations_;
  using Motion::add_along;
  using Motion::along;
  using Motion::chart_;
  using Motion::column;
  using Motion::directions;
  using Motion::follow;
  using Motion::forced_;
  using Motion::free;
  using Motion::functions_;
  using Motion::index;
  using Motion::latest;
  using Motion::m_;
  using Motion::moment;
  using Motion::n_;
  using Motion::numbers;
  using Motion::places_end_;
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

  /// Where works begin in a whole state.
  std::size_t works_begin() const { return places_end_ + n_; }
  const typename In::Memory& memory() const { return std::as_const(ode_).memory(); }  ///< of the joints

  /// z̈ and v̇ at the place of the last follow. @param with_slopes  also the forces' slopes, into force_slopes_
  void accelerate(const R& t, bool with_slopes = false) {
    if (accelerated_ && forced_ && memory().empty() && !with_slopes) return;
    const std::size_t f = freedoms();
    // A film's eccentricity is a state itself: the difference of two positions would have their rounding, 1e-13 of a
    // clearance at each evaluation anew, and a stiff film would multiply it.
    Motion::forget_if_it_fails([&] {
      In::apply_forces(system_, t, memory(), w_, [&](std::size_t joint, auto& at) -> const JointForce<R>* {
        const std::size_t k = function_of_joint_[joint];
        if (k == not_chosen) return nullptr;
        at.motion.eccentricity = Vector2<R>(latest().z[k], latest().z[k + 1]);
        at.motion.velocity = Vector2<R>(speeds_[k], speeds_[k + 1]);
        return with_slopes ? force_with_slopes(joint, at.motion) : nullptr;
      });
    });
    R* a = w_.accelerations.data();
    if (In::slides(w_)) {  // their forces hold journals on lines: by the whole equations
      system_.evaluate(t, y_.data(), memory(), w_);
      chart_.evaluate(w_, functions_.data());
      for (std::size_t k = 0; k < f; ++k) accelerations_[k] = along(functions_[k], k, a) - functions_[k].gamma;
    } else {
      accelerate_unmoved(a);
      const std::vector<std::size_t>& velocities = free().columns;
      reduced_.factorise(
          free().size(),
          [&](std::size_t i, const Columns* v) {
            return mass_.template row<Columns>(velocities[i], [&](std::size_t c) -> const Columns& {
              return v[i + c - velocities[i]];  // velocities of a body that M couples are neighbours
            });
          },
          latest().columns.data());
      project(
          [this, a](std::size_t c) {
            return R(w_.forces[c] - mass_.template row<R>(c, [a](std::size_t k) -> const R& { return a[k]; }));
          },
          accelerations_.data());
      reduced_.solve(accelerations_.data());
      add_along(latest(), accelerations_.data(), a);
    }
    accelerated_ = forced_ = true;
  }

  /// The force of a joint, and its slopes into force_slopes_; nullptr where its journal slides.
  const JointForce<R>* force_with_slopes(std::size_t joint, const JournalMotion<R>& at) {
    const JointMemory<R> of_joint = memory().empty() ? JointMemory<R>() : memory()[joint];
    if (of_joint.side == FilmSide::sliding) return nullptr;
    const auto variable = [](const Vector2<R>& v, int first) {
      return Vector2<OfMotion>(OfMotion::variable(v.x(), first), OfMotion::variable(v.y(), first + 1));
    };
    const JournalMotion<OfMotion> motion{variable(at.eccentricity, 0), variable(at.velocity, 2),
                                         OfMotion(at.bearing_spin), OfMotion(at.journal_spin)};
    const JointForce<OfMotion> force = system_.joint_in_plane(joint).force_in_motion(motion, of_joint);
    const Vector2<OfMotion> total = force.total();
    force_slopes_[2 * joint] = total.x().derivatives();
    force_slopes_[2 * joint + 1] = total.y().derivatives();
    const auto values = [](const Vector2<OfMotion>& v) { return Vector2<R>(v.x().value(), v.y().value()); };
    known_force_.film = values(force.film);
    known_force_.contact = {values(force.contact.force), force.contact.couple.value()};
    return &known_force_;
  }

  /// Vᵀ x, x(c) that of velocity c.
  template <class At, class V>
  void project(const At& x, V* out) const {
    const std::size_t f = freedoms();
    const Place& place = latest();
    const std::vector<std::size_t>& velocities = free().columns;
    const V zero = x(velocities[0]) - x(velocities[0]);
    for (std::size_t k = 0; k < f; ++k) out[k] = zero;
    for (std::size_t i = 0; i < velocities.size(); ++i) {
      const V here = directions().component(velocities[i], x);
      for (std::size_t k = 0; k < f; ++k) out[k] += column(place, k, i) * here;
    }
  }

  /// λ at the place of the last accelerate; those of rows that are left out stay 0.
  void find_multipliers() {
    if (In::slides(w_)) return;  // the whole equations have found them
    const auto a = [this](std::size_t k) -> const R& { return w_.accelerations[k]; };
    for (std::size_t i = 0; i < n_; ++i) residual_[i] = w_.forces[i] - mass_.template row<R>(i, a);
    directions().from_inertial(residual_.data());
    chart_.parts().solve_transposed(numbers(), residual_.data(), step_.data(), work_.data());
    for (std::size_t i = 0; i < m_; ++i) w_.multipliers[In::system_row(system_, i)] = step_[i];
  }

  /// Derivatives of z̈, into reduced_slopes_, and of the powers, from those of displacements at fixed ż, which are in
  /// v_slopes_, and of ż. At the place of the last accelerate, with its multipliers. What is prescribed depends on the
  /// time alone.
  template <class Time, class RateSlope>
  void fill(const Time& t, const RateSlope& z_rate_slope) {
    const std::size_t f = freedoms();
    const bool whole = !std::is_same_v<Time, R> || ode_.with_ledger();
    // v: d(A) v + A dv = [−dΦ_t; dż].
    Seeded* v = seeded_.data() + places_end_;
    for (std::size_t i = 0; i < n_; ++i) v[i] = Seeded(y_[places_end_ + i]);
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      const std::size_t first = In::coordinates * b;
      In::seed(w_.frames[b], y_.data() + first, v_slopes_.data() + In::velocities * b, seeded_.data() + first,
               dual_.frames[b]);
    }
    move_seeded();
    visit_rows(t, whole, false, [](auto& to, const auto& from) {
      to.time_rate = from.time_rate;
      to.first = from.first;
      to.second = from.second;
    });
    for_each_row(whole, [&](std::size_t row) {
      right_slopes_[row] = -system_.constraint_rate(In::system_row(system_, row), dual_).derivatives();
    });
    for (std::size_t k = 0; k < f; ++k)
      right_slopes_[m_ + k] = z_rate_slope(k) - along(seeded_functions_[k], k, v).derivatives();
    solve_slopes(whole, slopes_);
    for (std::size_t i = 0; i < n_; ++i) v[i].derivatives() = slopes_[i];
    if (In::slides(w_)) {
      In::take_places(dual_.frames, seeded_.data());
      system_.evaluate(t, seeded_.data(), memory(), dual_);
      chart_.evaluate(dual_, seeded_functions_.data());
      for (std::size_t k = 0; k < f; ++k)
        reduced_slopes_[k] =
            (along(seeded_functions_[k], k, dual_.accelerations.data()) - seeded_functions_[k].gamma).derivatives();
    } else {
      move_seeded();
      In::place_joints(system_, dual_);
      visit_rows(t, whole, true, [](auto& to, const auto& from) { to.gamma = from.gamma; });
      In::apply_forces(system_, t, memory(), dual_,
                       [](std::size_t, const auto&) -> const JointForce<Seeded>* { return nullptr; });
      differentiate_accelerations(whole);
    }
    if (ode_.with_ledger()) {
      powers_.resize(ode_.works());
      In::fill_powers(ode_, t, seeded_, dual_, powers_.data());
    }
  }

  /// Gives the frames of seeded_ its velocities.
  void move_seeded() {
    const Seeded* v = seeded_.data() + places_end_;
    for (std::size_t b = 0; b < system_.bodies().size(); ++b)
      In::give_velocities(dual_.frames[b], v + In::velocities * b);
  }

  /// Rows at these, all, or those that are not prescribed: take(to, from) takes what is asked for from each, which the
  /// compiler spares what it does not read. γ is of velocities, and all else of places alone.
  template <class Time, class Take>
  void visit_rows(const Time& t, bool whole, bool joints_are_placed, const Take& take) {
    const auto visit = [&](std::size_t c) {
      In::for_each_row(system_, c, t, dual_, [&](std::size_t row, const auto& from) {
        if (whole || chart_.parts().is_in(free(), row)) take(dual_.rows[In::system_row(system_, row)], from);
      });
    };
    if (whole) {
      for (std::size_t c = 0; c < system_.constraints().size(); ++c) visit(c);
    } else {
      for (const std::size_t c : free().constraints) visit(c);
    }
    In::for_each_function(chart_, dual_, joints_are_placed,
                          [&](std::size_t k, const auto& row) { take(seeded_functions_[k], row); });
  }

  /// Calls act(row of A) for those of constraints.
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
      directions().to_inertial(x.data());
      return;
    }
    const std::size_t n = free().size();
    Slopes* right = slopes_work_.data();
    Slopes* found = right + n_;
    for (std::size_t i = 0; i < n; ++i) right[i] = right_slopes_[free().rows[i]];
    free().lu.solve(latest().numbers.data(), right, found, found + n_);
    for (Slopes& each : x) each.setZero();
    for (std::size_t i = 0; i < n; ++i) x[free().columns[i]] = found[i];
    directions().to_inertial(x.data());
  }

  /// With v̇ and λ held, A dv̇ = [dγ − dΦ_v v̇; dz̈ + dγ_C − dC_v v̇] and Vᵀ(M dv̇ + dΦ_vᵀ λ − dg) = 0.
  void differentiate_accelerations(bool whole) {
    const std::size_t f = freedoms();
    for (std::size_t i = 0; i < n_; ++i) slopes_[i] = dual_.forces[i].derivatives();
    const auto side = [&](std::size_t row, std::size_t body, const auto& columns, const R& lambda) {
      if (body == ground_body) return;
      const std::size_t first = In::velocities * body;
      for (std::size_t c = 0; c < In::velocities; ++c) {
        right_slopes_[row] -= w_.accelerations[first + c] * columns[c].derivatives();
        if (row < m_) slopes_[first + c] -= lambda * columns[c].derivatives();
      }
    };
    for_each_row(whole, [&](std::size_t row) {
      const std::size_t number = In::system_row(system_, row);
      const auto& from = dual_.rows[number];
      right_slopes_[row] = from.gamma.derivatives();
      side(row, system_.first_body_of_row(number), from.first, w_.multipliers[number]);
      side(row, system_.second_body_of_row(number), from.second, w_.multipliers[number]);
    });
    for (std::size_t k = 0; k < f; ++k) {
      right_slopes_[m_ + k] = seeded_functions_[k].gamma.derivatives();
      const auto [first, second] = chart_.bodies_of(k);
      side(m_ + k, first, seeded_functions_[k].first, R(0));
      side(m_ + k, second, seeded_functions_[k].second, R(0));
    }
    solve_slopes(whole, v_slopes_);  // of v̇ without dz̈
    const auto dv = [this](std::size_t i) -> const Slopes& { return v_slopes_[i]; };
    for (std::size_t i = 0; i < n_; ++i) slopes_[i] -= mass_.template row<Slopes>(i, dv);
    project([this](std::size_t c) -> const Slopes& { return slopes_[c]; }, reduced_slopes_.data());
    reduced_.solve(reduced_slopes_.data());
    if (!ode_.with_ledger()) return;
    for (Slopes& each : right_slopes_) each.setZero();
    for (std::size_t i = 0; i < free().size(); ++i) {
      const std::size_t c = free().columns[i];
      for (std::size_t k = 0; k < f; ++k) right_slopes_[c] += column(latest(), k, i) * reduced_slopes_[k];
    }
    directions().to_inertial(right_slopes_.data());
    for (std::size_t i = 0; i < n_; ++i) v_slopes_[i] += right_slopes_[i];
    const auto of_freedoms = [this](std::size_t i) -> const Slopes& { return right_slopes_[i]; };
    for (std::size_t i = 0; i < n_; ++i) slopes_[i] -= mass_.template row<Slopes>(i, of_freedoms);
    directions().from_inertial(slopes_.data());
    chart_.parts().solve_transposed(numbers(), slopes_.data(), right_slopes_.data(), slopes_work_.data());
    for (std::size_t i = 0; i < n_; ++i) dual_.accelerations[i] = Seeded(w_.accelerations[i], v_slopes_[i]);
    for (std::size_t row = 0; row < m_; ++row) {
      const std::size_t number = In::system_row(system_, row);
      dual_.multipliers[number] = Seeded(w_.multipliers[number], right_slopes_[row]);
    }
  }

  Equations& ode_;
  typename In::template Workspace<Seeded> dual_;
  std::vector<std::size_t> function_of_joint_;  ///< the first of the two that are its eccentricity, or not_chosen
  bool all_eccentricities_ = false;             ///< are those of all joints, of which there are some, functions?
  typename In::Mass mass_;                      ///< M

  // Work, kept so that no evaluation allocates.
  ReducedMass<R, N / 2, Columns> reduced_;  ///< VᵀMV
  std::vector<Seeded> seeded_;
  std::vector<typename In::template Row<Seeded>> seeded_functions_;
  std::vector<Slopes> right_slopes_, slopes_, slopes_work_, v_slopes_, reduced_slopes_;
  std::vector<typename OfMotion::Derivatives> motion_slopes_, force_slopes_;
  JointForce<R> known_force_{};  ///< film and contact
  std::vector<Seeded> powers_;
  Full full_;  ///< of a look for kinks
};

}  // namespace lubjoint

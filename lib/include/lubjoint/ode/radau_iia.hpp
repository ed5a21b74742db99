/// Radau IIA, of order 5 and of order 9, as an Odeint stepper.
#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_step_result.hpp>
#include <boost/numeric/odeint/stepper/stepper_categories.hpp>
#include <boost/numeric/odeint/util/unwrap_reference.hpp>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "lubjoint/ode/error_scale.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/ode/radau_stages.hpp"
#include "lubjoint/ode/radau_tableau.hpp"
#include "lubjoint/ode/shifted_solver.hpp"

namespace lubjoint {

/// Radau IIA of s stages, order 2s − 1, L-stable, with step-size control: a controlled stepper in Odeint's sense, so
/// that it runs in Odeint's integrate functions. The system is a pair (f, jacobian) as for Odeint's rosenbrock4:
///   f(x, dxdt, t) and jacobian(x, J, t), J an Eigen::Matrix<R, N, N>; time derivatives are not needed,
/// or one that also has has_force_part() and force_part(x, J, t) as of OdeSystem. RadauStages solves for the stages.
/// The embedded estimate is of order s: as in Hairer and Wanner's code the tolerance of the estimate is 0.1
/// τ^{(s+1)/(2s)}, which makes the error of the solution of the order of τ. Source: Hairer and Wanner, Solving Ordinary
/// Differential Equations II, section IV.8; the same, Stiff differential equations solved by Radau methods, J. Comput.
/// Appl. Math. 111 (1999) 93–111.
///
/// A trial state at which f throws std::domain_error, or that is not finite, is a failed step: it is halved. At the end
/// of a step f is not asked again: its last stage is there but for the last iteration's change, and the rate that
/// begins the next step is the collocation polynomial's. What Newton's iterations have left of it only the estimate
/// sees, and filtered; a seventh of the evaluations of order 5 goes with it.
/// @tparam R  double, long double, or a Boost.Multiprecision number
/// @tparam N  number of states; run_time_size: as many as the tolerances that it is made with, in std::vector
/// @tparam Stages  3 or 5
/// @tparam Linear  how the Jacobian is kept and its systems are solved
template <class R, std::size_t N, int Stages, class Linear = FullLinear<R, N>>
class RadauIIA {
 public:
  /// What Odeint asks of a stepper.
  /// @{
  using value_type = R;
  using state_type = StateOf<R, N>;
  using deriv_type = state_type;
  using time_type = R;
  using stepper_category = boost::numeric::odeint::controlled_stepper_tag;
  using order_type = unsigned short;
  /// @}
  using Vector = typename ErrorScale<R, N>::Vector;  ///< a state
  using Matrix = typename Linear::Jacobian;          ///< a Jacobian

  static constexpr order_type order() { return 2 * Stages - 1; }  ///< of the solution

  /// @param absolute_tolerance  one for each state, in the state's own unit
  /// @param integrals  how many of the last states are integrals that nothing depends on: they control no step.
  ///                   None where N is given
  RadauIIA(const R& relative_tolerance, const state_type& absolute_tolerance, std::size_t integrals = 0)
      : relative_(relative_part(relative_tolerance)),
        scale_(scaled(absolute_tolerance, relative_tolerance), relative_, integrals),
        stages_(absolute_tolerance.size()) {
    using std::pow;
    for (Vector* v : {&f_, &right_, &slope_}) v->setZero(scale_.states());
    for (AllStages* each : {&z_old_, &z_longer_}) {
      for (Vector& v : *each) v.setZero(scale_.states());
    }
    newton_tolerance_ = std::max<R>(std::numeric_limits<R>::epsilon() / relative_,
                                    std::min<R>(R(0.03), pow(relative_, R(Stages - 1) / R(Stages + 1))));
  }

  /// Leaves the relative tolerance out of the test of a step: for states whose size says nothing of the digits that
  /// matter, such as a coordinate of 0.1 m in which a clearance of 0.1 mm is at stake.
  void use_absolute_tolerance_only() { scale_.leave_relative_out(); }

  /// Replaces the state after a step by one close to it, and keeps step length and history.
  void replace_state(const state_type& x) {
    x_ = x;
    rate_is_current_ = false;
    jacobian_is_new_ = false;
  }

  /// One trial step. On success x, t are advanced and dt is the next step's length; on failure dt is reduced.
  template <class System>
  boost::numeric::odeint::controlled_step_result try_step(System system, state_type& x, time_type& t, time_type& dt) {
    namespace odeint = boost::numeric::odeint;
    using Unwrapped = typename odeint::unwrap_reference<System>::type;
    Unwrapped& parts = system;
    if (!started_ || x != x_ || t != t_) begin_at(x, t);
    try {
      if (!rate_is_current_) stages_.evaluate(parts.first, x_, t_, f_);
      rate_is_current_ = true;
      const bool is_guessed = start_stages(dt);
      if (!jacobian_is_usable_) {
        if (!stages_.take_jacobian(parts, x_, t_, dt, is_guessed) || !f_.allFinite()) return fail(dt, R(0.5));
        jacobian_is_usable_ = true;
        jacobian_is_new_ = true;
      }
      R error(0);
      bool is_in_vain = false;
      const auto is_too_long = [&](const R& left) {
        if (first_step_ || last_failed_) return false;  // their estimates are made twice
        error = norm(first_estimate(dt));
        return is_in_vain = error > 1 + most_of_increment() * left;
      };
      if (!stages_.solve(parts, x_, t_, dt, scale_, newton_tolerance_, is_too_long)) {
        if (is_in_vain) return reject(dt, error);
        // An older Jacobian may be to blame: the same step again with a new one. Or the guess that it was evaluated at.
        const bool try_new_jacobian = !jacobian_is_new_;
        jacobian_is_usable_ = jacobian_is_new_ && !stages_.jacobian_is_ahead();
        return try_new_jacobian ? fail(dt, R(1)) : diverge(dt);
      }
      error = estimate(parts.first, dt);
      if (!std::isfinite(static_cast<double>(error))) return fail(dt, R(0.5));
      return finish(x, t, dt, std::max<R>(error, R(1e-10)));
    } catch (const std::domain_error&) {
      return diverge(dt);
    }
  }

  /// State inside the last accepted step, by the collocation polynomial (order s, exact at both ends).
  void state_at(const time_type& t, state_type& x) const {
    const auto shares = tableau_.interpolating((t - (t_ - h_old_)) / h_old_);
    x = x_old_;
    add(shares, z_old_, R(1), x);
  }

  /// Derivative of the collocation polynomial at the end of the last accepted step. It is f there but for what Newton's
  /// iterations have left, which f multiplies by the eigenvalues of a stiff system, and this by 1/h.
  /// @returns false, and does nothing, before a step
  bool end_rate(state_type& rate) const {
    if (!has_old_step_) return false;
    std::fill(rate.begin(), rate.end(), R(0));
    add(tableau_.end_slopes, z_old_, R(1 / h_old_), rate);
    return true;
  }

  /// State and rate in the middle of the last accepted step as a step to there has them: of the method's order. Later
  /// steps are the same with it and without.
  /// @returns false where Newton's iterations do not converge, or before a step
  template <class System>
  bool middle(System system, state_type& x, state_type& rate) {
    const StepperCounts counts = stages_.counts();
    const R half = h_old_ / 2;
    const bool found = in_last_step(system, R(t_ - half), [&] {
      x = rate = stages_.displaced(x_, stages_.increments().back());
      std::fill(rate.begin(), rate.end(), R(0));
      add(tableau_.end_slopes, stages_.increments(), R(1 / half), rate);
    });
    stages_.counts() = counts;
    return found;
  }

  /// Lets the last accepted step end at a time inside it: with the stages of the shorter step. @returns likewise
  template <class System>
  bool end_at(System system, const time_type& t, state_type& x) {
    const R start = t_ - h_old_;
    if (!in_last_step(system, t, [&] { x = stages_.displaced(x_, stages_.increments().back()); })) return false;
    std::swap(z_old_, stages_.increments());
    h_old_ = t - start;
    x_ = x;
    t_ = t;
    scale_.take(x_);
    take_end_rate();
    jacobian_is_new_ = false;
    return true;
  }

  /// Forget the last step: to be called after the state was changed by hand.
  void reset() { started_ = false; }

  const StepperCounts& counts() const { return stages_.counts(); }  ///< so far

 private:
  using Equations = RadauStages<R, N, Stages, Linear>;
  using AllStages = typename Equations::AllStages;
  using Tableau = RadauTableau<R, Stages>;

  // In a film a hundredth of a clearance thick it is not the error that limits a step, but how far the stages may go
  // before the one Jacobian has nothing to do with them: Newton's iterations get slow, then diverge. A step
  // aims at a rate of convergence at which they cost least for the time they bring (h over their number, with h in
  // proportion to the rate, is largest at 1/e), may take as many as that needs, and comes slowly back to a length at
  // which they have diverged. Measured: a half of the evaluations at 1e-5 where a slider-crank's film is thinnest, none
  // more on the others that ship; a journal thrown at its wall takes up to 3.7 times the steps. Of order 9 and with one
  // Jacobian for all stages steps are as long as this lets them be, and every iteration brings the more digits the
  // shorter they are: with 0.1 slider-cranks take a tenth to a third fewer evaluations at 1e-9 than with 0.3.
  R aimed_newton_rate() const { return Stages == 3 || stages_.has_own_parts() ? R(0.3) : R(0.1); }
  static constexpr double growth_after_divergence = 1.1;
  /// Growth of the step that isn't worth new factors, once the Jacobian is kept.
  static constexpr double keep_step_below = 1.2;

  static constexpr double most_growth = 8;  ///< of a step to the next

  static R safety() { return R(0.9); }                       ///< of a step's length
  static R estimate_root() { return R(1) / R(Stages + 1); }  ///< the estimate is of order h^{s+1}
  /// What the estimate changes by with increments of stages, in their sizes, where nothing is stiff: no more elsewhere.
  R most_of_increment() const {
    using std::sqrt;
    return tableau_.error_weights.norm() * sqrt(R(Stages)) / tableau_.gamma;
  }

  static R relative_part(const R& relative_tolerance) {
    using std::pow;
    if (!(relative_tolerance > 0 && relative_tolerance < 1)) {
      throw std::invalid_argument("relative tolerance of Radau IIA: allowed is a number in (0, 1)");
    }
    return R(0.1) * pow(relative_tolerance, R(Stages + 1) / R(2 * Stages));
  }
  state_type scaled(state_type absolute, const R& relative_tolerance) const {
    for (R& each : absolute) {
      if (!(each > 0)) throw std::invalid_argument("absolute tolerance of Radau IIA: allowed is a number above 0");
      each = each / relative_tolerance * relative_;
    }
    return absolute;
  }

  void begin_at(const state_type& x, const R& t) {
    x_ = x;
    t_ = t;
    guess_ = x;
    stages_.reset(x);
    started_ = true;
    rate_is_current_ = false;
    jacobian_is_usable_ = false;
    first_step_ = true;
    last_failed_ = false;
    has_old_step_ = false;
    h_longer_ = 0;
    longest_ = std::numeric_limits<R>::max();
    scale_.take(x_);
  }

  boost::numeric::odeint::controlled_step_result fail(R& dt, const R& factor) {
    dt *= factor;
    last_failed_ = true;
    ++stages_.counts().rejected;
    return boost::numeric::odeint::fail;
  }

  boost::numeric::odeint::controlled_step_result diverge(R& dt) {
    longest_ = dt / 2;
    return fail(dt, R(0.5));
  }

  /// x += factor Σ_j w_j z_j
  static void add(const typename Tableau::Vector& w, const AllStages& z, const R& factor, state_type& x) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      R increment(0);
      for (std::size_t j = 0; j < z.size(); ++j)
        increment += w(static_cast<Eigen::Index>(j)) * z[j](static_cast<Eigen::Index>(i));
      x[i] += factor * increment;
    }
  }

  /// The rate that begins the next step.
  void take_end_rate() {
    f_.setZero();
    for (std::size_t j = 0; j < z_old_.size(); ++j) f_ += tableau_.end_slopes(static_cast<Eigen::Index>(j)) * z_old_[j];
    f_ /= h_old_;
    rate_is_current_ = true;
  }

  /// Solves the last accepted step anew to a time inside it; where that succeeds, use() finds the increments of
  /// the stages, from the step's start in x_. All else is as it was.
  template <class System, class Use>
  bool in_last_step(System& system, const R& t, const Use& use) {
    if (!started_ || !has_old_step_ || !stages_.jacobian_is_known()) return false;
    typename boost::numeric::odeint::unwrap_reference<System>::type& parts = system;
    const R end = t_;
    const R h = t - (t_ - h_old_);
    guess_stages(R(end - h_old_), x_old_, h);
    std::swap(x_, x_old_);
    t_ = end - h_old_;
    bool found = false;
    try {
      found = stages_.solve(parts, x_, t_, h, scale_, newton_tolerance_, [](const R&) { return false; });
      if (found) use();
    } catch (const std::domain_error&) {
      found = false;
    }
    std::swap(x_, x_old_);
    t_ = end;
    return found;
  }

  /// First guess of the stages: the polynomial of a longer step from here whose error was too large, or the last
  /// step's, continued. From the first of the two a step takes 2 iterations where it took 6 from nothing: at equal
  /// error slider-cranks take 8 to 20 % fewer evaluations of order 5 at 1e-5, and 7 to 24 % of order 9 at 1e-9.
  /// @returns false without a guess: the state at the start then
  bool start_stages(const R& h) {
    if (h_longer_ > 0) {
      Eigen::Index stage = 0;
      for (Vector& z : stages_.increments()) {
        const auto shares = tableau_.interpolating(R(tableau_.c(stage++) * h / h_longer_));
        z.setZero();
        for (std::size_t j = 0; j < z_longer_.size(); ++j) z += shares(static_cast<Eigen::Index>(j)) * z_longer_[j];
      }
      return true;
    }
    if (!has_old_step_ || last_failed_ || h > R(2 * most_growth) * h_old_) {  // far beyond a step that was cut short
      for (Vector& z : stages_.increments()) z.setZero();
      return false;
    }
    guess_stages(t_, x_, h);
    return true;
  }

  /// Those of a step of length h from x at t.
  void guess_stages(const R& t, const state_type& x, const R& h) {
    Eigen::Index stage = 0;
    for (Vector& z : stages_.increments()) {
      state_at(t + tableau_.c(stage++) * h, guess_);
      for (std::size_t k = 0; k < guess_.size(); ++k) z(static_cast<Eigen::Index>(k)) = guess_[k] - x[k];
    }
  }

  /// The embedded error estimate, filtered by the real factorisation. Kept until the next one.
  const Vector& first_estimate(const R& h) {
    slope_.setZero();
    for (std::size_t j = 0; j < z_old_.size(); ++j)
      slope_ += tableau_.error_weights(static_cast<Eigen::Index>(j)) * stages_.increments()[j];
    slope_ /= h;
    right_ = f_ + slope_;
    return stages_.filtered(right_);
  }
  /// The size of an error.
  R norm(const Vector& error) const {
    using std::sqrt;
    return sqrt(scale_.square(error) / static_cast<R>(scale_.controlled()));
  }
  /// That of the estimate; where it is too large at the start or after a failure, of a second one.
  template <class F>
  R estimate(F& f, const R& h) {
    const Vector& first = first_estimate(h);
    const R estimated = norm(first);
    if (!(estimated >= 1 && (first_step_ || last_failed_))) return estimated;
    stages_.evaluate(f, stages_.displaced(x_, first), t_, right_);
    right_ += slope_;
    return norm(stages_.filtered(right_));
  }

  /// How many times as long as the next one a step of this error was.
  R shrinkage(const R& error) const {
    using std::pow;
    const R effort = safety() * (2 * Equations::most_iterations + 1) /
                     static_cast<R>(stages_.iterations() + 2 * Equations::most_iterations);
    return std::clamp<R>(pow(error, estimate_root()) / std::min<R>(safety(), effort), R(1 / most_growth), R(5));
  }

  boost::numeric::odeint::controlled_step_result reject(R& dt, const R& error) {
    const R next = first_step_ ? R(0.1) : R(1 / shrinkage(error));
    jacobian_is_usable_ = jacobian_is_new_ || stages_.has_own_parts();
    std::swap(z_longer_, stages_.increments());
    h_longer_ = dt;
    return fail(dt, std::min<R>(next, R(0.9)));
  }

  boost::numeric::odeint::controlled_step_result finish(state_type& x, R& t, R& dt, const R& error) {
    using std::pow;
    if (error >= 1) return reject(dt, error);
    R shrink = shrinkage(error);
    if (!first_step_) {  // Gustafsson's predictive controller
      const R predicted = (h_accepted_ / dt) * pow(error * error / error_accepted_, estimate_root()) / safety();
      shrink = std::max<R>(shrink, std::clamp<R>(predicted, R(1 / most_growth), R(5)));
    }
    error_accepted_ = std::max<R>(error, R(0.01));
    h_accepted_ = dt;

    x = stages_.displaced(x_, stages_.increments().back());
    std::swap(x_old_, x_);
    std::swap(z_old_, stages_.increments());
    h_old_ = dt;
    has_old_step_ = true;
    x_ = x;
    t_ += dt;
    t = t_;
    scale_.take(x_);
    take_end_rate();
    jacobian_is_usable_ = stages_.jacobian_lasts(jacobian_is_new_);
    jacobian_is_new_ = false;
    R next = dt / shrink;
    if (last_failed_) next = std::min<R>(next, dt);
    if (longest_ < std::numeric_limits<R>::max() / 2) longest_ *= R(growth_after_divergence);
    next = std::min<R>(next, std::max<R>(longest_, dt));
    const R& newton_rate = stages_.rate_of_convergence();
    if (newton_rate > 0) next = std::min<R>(next, dt * std::max<R>(R(0.5), aimed_newton_rate() / newton_rate));
    // With parts of their own the stages' factors are new at each step.
    if (!(!stages_.has_own_parts() && jacobian_is_usable_ && next >= dt && next <= R(keep_step_below) * dt)) dt = next;
    first_step_ = false;
    last_failed_ = false;
    h_longer_ = 0;
    ++stages_.counts().accepted;
    return boost::numeric::odeint::success;
  }

  const Tableau& tableau_ = Tableau::instance();
  R relative_;
  ErrorScale<R, N> scale_;
  R newton_tolerance_ = 0;
  Equations stages_;

  bool started_ = false;
  bool first_step_ = true;
  bool last_failed_ = false;
  bool has_old_step_ = false;
  bool rate_is_current_ = false;
  bool jacobian_is_usable_ = false;
  bool jacobian_is_new_ = false;  ///< evaluated for this step
  state_type x_{};
  R t_ = 0;
  Vector f_;       ///< the rate there
  R longest_ = 0;  ///< beyond this length Newton's iterations have lately diverged
  R h_accepted_ = 0;
  R error_accepted_ = 0;
  state_type x_old_{};
  AllStages z_old_;
  R h_old_ = 0;
  AllStages z_longer_;  ///< of a step from here whose error was too large
  R h_longer_ = 0;      ///< its length, or 0: there is none

  // Work of a step, kept so that none allocates.
  state_type guess_{};
  Vector right_, slope_;
};

/// Of order 5.
template <class R, std::size_t N, class Linear = FullLinear<R, N>>
using RadauIIA5 = RadauIIA<R, N, 3, Linear>;

/// Of order 9.
template <class R, std::size_t N, class Linear = FullLinear<R, N>>
using RadauIIA9 = RadauIIA<R, N, 5, Linear>;

}  // namespace lubjoint

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

#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/ode/radau_tableau.hpp"
#include "lubjoint/ode/shifted_solver.hpp"

namespace lubjoint {

/// Radau IIA of s stages, order 2s − 1, L-stable, with step-size control: a controlled stepper in Odeint's sense, so
/// that it runs in Odeint's integrate functions. The system is a pair (f, jacobian) as for Odeint's rosenbrock4:
///   f(x, dxdt, t) and jacobian(x, J, t), J an Eigen::Matrix<R, N, N>; time derivatives are not needed.
/// Simplified Newton iterations on the transformed stages, one real and (s − 1)/2 complex factorisations a step. The
/// embedded estimate is of order s: as in Hairer and Wanner's code the tolerance of the estimate is
/// 0.1 τ^{(s+1)/(2s)}, which makes the error of the solution of the order of τ.
/// Source: Hairer and Wanner, Solving Ordinary Differential Equations II, section IV.8; the same, Stiff differential
/// equations solved by Radau methods, J. Comput. Appl. Math. 111 (1999) 93–111.
///
/// A trial state at which f throws std::domain_error, or that is not finite, is a failed step: it is halved.
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
  /// Of Eigen's matrices.
  static constexpr int dimension = N == run_time_size ? Eigen::Dynamic : static_cast<int>(N);
  using Vector = Eigen::Matrix<R, dimension, 1>;  ///< a state
  using Matrix = typename Linear::Jacobian;       ///< a Jacobian

  static constexpr order_type order() { return 2 * Stages - 1; }  ///< of the solution

  /// @param absolute_tolerance  one for each state, in the state's own unit
  /// @param integrals  how many of the last states are integrals that nothing depends on: they control no step.
  ///                   None where N is given
  RadauIIA(const R& relative_tolerance, const state_type& absolute_tolerance, std::size_t integrals = 0)
      : absolute_(absolute_tolerance), controlled_(static_cast<Index>(absolute_.size() - integrals)), solver_(size()) {
    using std::pow;
    if (!(relative_tolerance > 0 && relative_tolerance < 1)) {
      throw std::invalid_argument("relative tolerance of Radau IIA: allowed is a number in (0, 1)");
    }
    relative_ = R(0.1) * pow(relative_tolerance, R(Stages + 1) / R(2 * Stages));
    relative_part_ = relative_;
    for (std::size_t i = 0; i < absolute_.size(); ++i) {
      if (!(absolute_tolerance[i] > 0)) {
        throw std::invalid_argument("absolute tolerance of Radau IIA: allowed is a number above 0");
      }
      absolute_[i] = absolute_tolerance[i] / relative_tolerance * relative_;
    }
    // Work of every size at once: no step allocates, and a copy copies numbers.
    Linear::prepare(jacobian_, size());
    for (Vector* v : {&scale_, &f_, &f_end_, &right_, &solution_}) v->setZero(size());
    for (AllStages* each : {&z_, &z_old_, &w_, &g_, &change_}) {
      for (Vector& v : *each) v.setZero(size());
    }
    newton_tolerance_ = std::max<R>(std::numeric_limits<R>::epsilon() / relative_,
                                    std::min<R>(R(0.03), pow(relative_, R(Stages - 1) / R(Stages + 1))));
  }

  /// Leaves the relative tolerance out of the test of a step: for states whose size says nothing of the digits that
  /// matter, such as a coordinate of 0.1 m in which a clearance of 0.1 mm is at stake.
  void use_absolute_tolerance_only() { relative_part_ = R(0); }

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
      if (!rate_is_current_) evaluate(parts.first, x_, t_, f_);
      rate_is_current_ = true;
      start_stages(dt);
      if (!jacobian_is_usable_) {
        evaluate_jacobian(parts.second, dt);
        if (!jacobian_.allFinite() || !f_.allFinite()) return fail(dt, R(0.5));
        jacobian_is_usable_ = true;
        jacobian_is_known_ = true;
        jacobian_is_new_ = true;
        factorised_for_ = 0;
      }
      if (factorised_for_ != dt) factorise(dt);
      if (!iterate(parts.first, dt)) {
        // An older Jacobian may be to blame: the same step again with a new one. Or the guess that it was evaluated at.
        const bool try_new_jacobian = !jacobian_is_new_;
        jacobian_is_usable_ = jacobian_is_new_ && !jacobian_is_ahead_;
        return try_new_jacobian ? fail(dt, R(1)) : diverge(dt);
      }
      R error = estimate(parts.first, dt);
      if (!std::isfinite(static_cast<double>(error))) return fail(dt, R(0.5));
      if (error < 1) {  // the end of the step is a trial state too; its rate begins the next step
        evaluate(parts.first, displaced(z_.back()), t_ + dt, f_end_);
        if (!f_end_.allFinite()) return fail(dt, R(0.5));
      }
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
  void end_rate(state_type& rate) const {
    if (!has_old_step_) return;
    std::fill(rate.begin(), rate.end(), R(0));
    add(tableau_.end_slopes, z_old_, R(1 / h_old_), rate);
  }

  /// State and rate in the middle of the last accepted step as a step to there has them: of the method's order. Later
  /// steps are the same with it and without.
  /// @returns false where Newton's iterations do not converge, or before a step
  template <class System>
  bool middle(System system, state_type& x, state_type& rate) {
    const StepperCounts counts = counts_;
    const R half = h_old_ / 2;
    const bool found = in_last_step(system, R(t_ - half), [&] {
      x = rate = displaced(z_.back());
      std::fill(rate.begin(), rate.end(), R(0));
      add(tableau_.end_slopes, z_, R(1 / half), rate);
    });
    counts_ = counts;
    return found;
  }

  /// Lets the last accepted step end at a time inside it: with the stages of the shorter step. @returns likewise
  template <class System>
  bool end_at(System system, const time_type& t, state_type& x) {
    const R start = t_ - h_old_;
    typename boost::numeric::odeint::unwrap_reference<System>::type& parts = system;
    bool found = false;
    const bool solved = in_last_step(system, t, [&] {
      evaluate(parts.first, displaced(z_.back()), t, f_end_);
      found = f_end_.allFinite();
      x = trial_;
    });
    if (!solved || !found) return false;
    std::swap(z_old_, z_);
    h_old_ = t - start;
    x_ = x;
    t_ = t;
    set_scale();
    std::swap(f_, f_end_);
    rate_is_current_ = true;
    jacobian_is_new_ = false;
    return true;
  }

  /// Forget the last step: to be called after the state was changed by hand.
  void reset() { started_ = false; }

  const StepperCounts& counts() const { return counts_; }  ///< so far

 private:
  static constexpr auto stages = static_cast<std::size_t>(Stages);
  static constexpr std::size_t middle_stage = stages / 2;  ///< at 0.645 or 0.584 of the step
  /// The order in which f is evaluated: a system may still know where the Jacobian was.
  static constexpr auto middle_first = [] {
    std::array<std::size_t, stages> order{};
    for (std::size_t i = 0; i < stages; ++i) order[i] = i;
    std::swap(order[0], order[middle_stage]);
    return order;
  }();
  using AllStages = std::array<Vector, stages>;
  using Tableau = RadauTableau<R, Stages>;
  using Index = Eigen::Index;

  // In a film a hundredth of a clearance thick it is not the error that limits a step, but how far the stages may go
  // before the one Jacobian has nothing to do with them: Newton's iterations get slow, then diverge. A step
  // aims at a rate of convergence at which they cost least for the time they bring (h over their number, with h in
  // proportion to the rate, is largest at 1/e), may take as many as that needs, and comes slowly back to a length at
  // which they have diverged. Measured: a half of the evaluations at 1e-5 where a slider-crank's film is thinnest, none
  // more on the others that ship; a journal thrown at its wall takes up to 3.7 times the steps. Of order 9 steps are as
  // long as this lets them be, and every iteration brings the more digits the shorter they are: with 0.1 slider-cranks
  // take a tenth to a third fewer evaluations at 1e-9 than with 0.3.
  static constexpr int max_newton_iterations = 15;
  static constexpr double aimed_newton_rate = Stages == 3 ? 0.3 : 0.1;
  static constexpr double growth_after_divergence = 1.1;
  /// Newton's iterations that shrink faster than this need no new Jacobian for the next step.
  static constexpr double keep_jacobian_below = 1e-3;
  /// Growth of the step that isn't worth new factors, once the Jacobian is kept.
  static constexpr double keep_step_below = 1.2;

  template <class F>
  void evaluate(F& f, const state_type& x, const R& t, Vector& out) {
    f(x, rate_, t);
    for (std::size_t i = 0; i < rate_.size(); ++i) out(static_cast<Index>(i)) = rate_[i];
  }

  Index size() const { return static_cast<Index>(absolute_.size()); }

  const state_type& displaced(const Vector& z) {
    for (std::size_t i = 0; i < trial_.size(); ++i) trial_[i] = x_[i] + z(static_cast<Index>(i));
    return trial_;
  }

  void begin_at(const state_type& x, const R& t) {
    x_ = x;
    t_ = t;
    rate_ = trial_ = x;
    started_ = true;
    rate_is_current_ = false;
    jacobian_is_usable_ = false;
    jacobian_is_known_ = false;
    first_step_ = true;
    last_failed_ = false;
    has_old_step_ = false;
    longest_ = std::numeric_limits<R>::max();
    set_scale();
  }

  void set_scale() {
    using std::abs;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      scale_(static_cast<Index>(i)) = absolute_[i] + relative_part_ * abs(x_[i]);
    }
  }

  Index controlled() const { return N == run_time_size ? controlled_ : size(); }

  R square_scaled(const Vector& v) const {
    if constexpr (N == run_time_size) {
      return v.head(controlled_).cwiseQuotient(scale_.head(controlled_)).squaredNorm();
    } else {
      return v.cwiseQuotient(scale_).squaredNorm();
    }
  }

  boost::numeric::odeint::controlled_step_result fail(R& dt, const R& factor) {
    dt *= factor;
    last_failed_ = true;
    ++counts_.rejected;
    return boost::numeric::odeint::fail;
  }

  boost::numeric::odeint::controlled_step_result diverge(R& dt) {
    longest_ = dt / 2;
    return fail(dt, R(0.5));
  }

  void factorise(const R& dt) {
    typename Tableau::Pairs alpha = tableau_.alpha;
    typename Tableau::Pairs beta = tableau_.beta;
    for (std::size_t i = 0; i < alpha.size(); ++i) {
      alpha[i] /= dt;
      beta[i] /= dt;
    }
    solver_.factorise(jacobian_, tableau_.gamma / dt, alpha, beta);
    factorised_for_ = dt;
    ++counts_.factorisations;
  }

  /// Σ_j w_j v_j over the stages.
  template <class Weights, std::size_t... J>
  static auto sum(const Weights& w, const AllStages& v, std::index_sequence<J...>) {
    return (... + (w(static_cast<Index>(J)) * v[J]));
  }
  /// out_i = Σ_j m_ij in_j, over the stages.
  template <class Weights>
  static void combine(const Weights& m, const AllStages& in, AllStages& out) {
    Index i = 0;
    for (Vector& each : out) {
      each.noalias() = sum(m.row(i), in, std::make_index_sequence<stages>());
      ++i;
    }
  }
  /// x += factor Σ_j w_j z_j
  static void add(const typename Tableau::Vector& w, const AllStages& z, const R& factor, state_type& x) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      R increment(0);
      for (std::size_t j = 0; j < stages; ++j) increment += w(static_cast<Index>(j)) * z[j](static_cast<Index>(i));
      x[i] += factor * increment;
    }
  }

  /// Solves the last accepted step anew to a time inside it; where that succeeds, use() finds the stages in z_, from
  /// the step's start in x_. All else is as it was.
  template <class System, class Use>
  bool in_last_step(System& system, const R& t, const Use& use) {
    if (!started_ || !has_old_step_ || !jacobian_is_known_) return false;
    typename boost::numeric::odeint::unwrap_reference<System>::type& parts = system;
    const R end = t_;
    const R h = t - (t_ - h_old_);
    guess_stages(R(end - h_old_), x_old_, h);
    std::swap(x_, x_old_);
    t_ = end - h_old_;
    bool found = false;
    try {
      factorise(h);
      found = iterate(parts.first, h);
      if (found) use();
    } catch (const std::domain_error&) {
      found = false;
    }
    std::swap(x_, x_old_);
    t_ = end;
    return found;
  }

  /// ∂f/∂y at the guess of the middle stage: from there it is half as far to the ends of the step as from its start,
  /// and Newton's iterations shrink twice as fast. Without a guess, or where it is beyond a wall, at the start.
  template <class F>
  void evaluate_jacobian(F& f, const R& h) {
    ++counts_.jacobians;
    jacobian_is_ahead_ = has_old_step_ && !last_failed_;
    if (jacobian_is_ahead_) {
      try {
        f(displaced(z_[middle_stage]), jacobian_, t_ + tableau_.c(static_cast<Index>(middle_stage)) * h);
        if (jacobian_.allFinite()) return;
      } catch (const std::domain_error&) {
      }
    }
    jacobian_is_ahead_ = false;
    f(x_, jacobian_, t_);
  }

  /// Simplified Newton iterations for the stage increments, from those in z_; false if they do not converge.
  template <class F>
  bool iterate(F& f, const R& h) {
    using std::pow;
    using std::sqrt;
    const auto& tab = tableau_;
    combine(tab.t_inverse, z_, w_);
    R old_size = 0;
    R convergence = 1;
    newton_rate_ = 0;
    for (iterations_ = 1; iterations_ <= max_newton_iterations; ++iterations_) {
      ++counts_.newton_iterations;
      for (const std::size_t stage : middle_first) {
        evaluate(f, displaced(z_[stage]), t_ + tab.c(static_cast<Index>(stage)) * h, change_[stage]);
        if (!change_[stage].allFinite()) return false;
      }
      combine(tab.t_inverse, change_, g_);
      right_ = g_[0] - (tab.gamma / h) * w_[0];
      solver_.solve(right_, change_[0]);
      for (std::size_t pair = 0; pair < tab.alpha.size(); ++pair) {
        const std::size_t first = 2 * pair + 1;
        const R alpha = tab.alpha[pair] / h;
        const R beta = tab.beta[pair] / h;
        change_[first] = g_[first] - alpha * w_[first] + beta * w_[first + 1];
        change_[first + 1] = g_[first + 1] - beta * w_[first] - alpha * w_[first + 1];
        solver_.solve_in_place(pair, change_[first], change_[first + 1]);
      }
      R square(0);
      for (std::size_t i = 0; i < stages; ++i) {
        w_[i] += change_[i];
        square += square_scaled(change_[i]);
      }
      const R change = sqrt(square / static_cast<R>(Stages * controlled()));
      if (!std::isfinite(static_cast<double>(change))) return false;
      combine(tab.t, w_, z_);
      if (iterations_ > 1) {
        const R theta = change / old_size;
        newton_rate_ = iterations_ == 2 ? theta : R(sqrt(theta * newton_rate_));
        if (newton_rate_ >= R(0.99)) return false;
        convergence = newton_rate_ / (1 - newton_rate_);
        const R remaining = convergence * change *
                            pow(newton_rate_, static_cast<R>(max_newton_iterations - 1 - iterations_)) /
                            newton_tolerance_;
        if (iterations_ < max_newton_iterations && remaining >= 1 && convergence * change > newton_tolerance_) {
          return false;
        }
      }
      if (convergence * change <= newton_tolerance_ || change == 0) return true;
      old_size = std::max<R>(change, std::numeric_limits<R>::min());
    }
    return false;
  }

  /// First guess of the stages: the last step's collocation polynomial, continued.
  void start_stages(const R& h) {
    if (!has_old_step_ || last_failed_) {
      for (Vector& z : z_) z.setZero();
      return;
    }
    guess_stages(t_, x_, h);
  }

  /// Those of a step of length h from x at t.
  void guess_stages(const R& t, const state_type& x, const R& h) {
    Index stage = 0;
    for (Vector& z : z_) {
      state_at(t + tableau_.c(stage++) * h, trial_);
      for (std::size_t k = 0; k < trial_.size(); ++k) z(static_cast<Index>(k)) = trial_[k] - x[k];
    }
  }

  /// Scaled norm of the embedded error estimate, filtered by the real factorisation.
  template <class F>
  R estimate(F& f, const R& h) {
    using std::sqrt;
    const auto& w = tableau_.error_weights;
    Vector& combination = g_[0];
    combination = sum(w, z_, std::make_index_sequence<stages>()) / h;
    right_ = f_ + combination;
    const auto norm = [this] {
      solver_.solve(right_, solution_);
      return R(sqrt(square_scaled(solution_) / static_cast<R>(controlled())));
    };
    R estimated = norm();
    if (estimated >= 1 && (first_step_ || last_failed_)) {
      evaluate(f, displaced(solution_), t_, right_);
      right_ += combination;
      estimated = norm();
    }
    return estimated;
  }

  boost::numeric::odeint::controlled_step_result finish(state_type& x, R& t, R& dt, const R& error) {
    using std::pow;
    const R estimate_root = R(1) / (Stages + 1);  // the estimate is of order h^{s+1}
    const R safety = R(0.9);
    const R effort = safety * (2 * max_newton_iterations + 1) / static_cast<R>(iterations_ + 2 * max_newton_iterations);
    const R limit = std::min<R>(safety, effort);
    R shrink = std::clamp<R>(pow(error, estimate_root) / limit, R(0.125), R(5));
    if (error >= 1) {
      const R next = first_step_ ? R(0.1) : R(1 / shrink);
      jacobian_is_usable_ = jacobian_is_new_;
      return fail(dt, std::min<R>(next, R(0.9)));
    }
    if (!first_step_) {  // Gustafsson's predictive controller
      const R predicted = (h_accepted_ / dt) * pow(error * error / error_accepted_, estimate_root) / safety;
      shrink = std::max<R>(shrink, std::clamp<R>(predicted, R(0.125), R(5)));
    }
    error_accepted_ = std::max<R>(error, R(0.01));
    h_accepted_ = dt;

    std::swap(x_old_, x_);
    std::swap(z_old_, z_);
    h_old_ = dt;
    has_old_step_ = true;
    x_ = trial_;  // the end of the step, from its last evaluation
    t_ += dt;
    x = x_;
    t = t_;
    set_scale();
    std::swap(f_, f_end_);
    rate_is_current_ = true;
    jacobian_is_usable_ = newton_rate_ < R(keep_jacobian_below);
    jacobian_is_new_ = false;
    R next = dt / shrink;
    if (last_failed_) next = std::min<R>(next, dt);
    if (longest_ < std::numeric_limits<R>::max() / 2) longest_ *= R(growth_after_divergence);
    next = std::min<R>(next, std::max<R>(longest_, dt));
    if (newton_rate_ > 0) next = std::min<R>(next, dt * std::max<R>(R(0.5), R(aimed_newton_rate) / newton_rate_));
    if (!(jacobian_is_usable_ && next >= dt && next <= R(keep_step_below) * dt)) dt = next;
    first_step_ = false;
    last_failed_ = false;
    ++counts_.accepted;
    return boost::numeric::odeint::success;
  }

  const Tableau& tableau_ = Tableau::instance();
  R relative_ = 0;
  R relative_part_ = 0;  ///< of it, what the size of a state adds to its tolerance
  state_type absolute_{};
  Index controlled_;  ///< number of states that control the steps
  R newton_tolerance_ = 0;

  bool started_ = false;
  bool first_step_ = true;
  bool last_failed_ = false;
  bool has_old_step_ = false;
  bool rate_is_current_ = false;
  bool jacobian_is_known_ = false;
  bool jacobian_is_usable_ = false;
  bool jacobian_is_new_ = false;    ///< evaluated for this step
  bool jacobian_is_ahead_ = false;  ///< at a guess, not at a state
  int iterations_ = 0;
  state_type x_{};
  R t_ = 0;
  Vector scale_;
  Vector f_;
  Vector f_end_;  ///< at the end of the trial step
  Matrix jacobian_;
  R factorised_for_ = 0;
  R longest_ = 0;  ///< beyond this length Newton's iterations have lately diverged
  typename Linear::template Solver<static_cast<std::size_t>(Tableau::pairs)> solver_;
  AllStages z_;
  R newton_rate_ = 0;
  R h_accepted_ = 0;
  R error_accepted_ = 0;
  state_type x_old_{};
  AllStages z_old_;
  R h_old_ = 0;
  StepperCounts counts_;

  // Work of a step, kept so that none allocates.
  state_type rate_{};
  state_type trial_{};
  AllStages w_, g_, change_;
  Vector right_, solution_;
};

/// Of order 5.
template <class R, std::size_t N, class Linear = FullLinear<R, N>>
using RadauIIA5 = RadauIIA<R, N, 3, Linear>;

/// Of order 9.
template <class R, std::size_t N, class Linear = FullLinear<R, N>>
using RadauIIA9 = RadauIIA<R, N, 5, Linear>;

}  // namespace lubjoint

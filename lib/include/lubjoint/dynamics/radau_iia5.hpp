/// Radau IIA of order 5 as an Odeint stepper.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_step_result.hpp>
#include <boost/numeric/odeint/stepper/stepper_categories.hpp>
#include <boost/numeric/odeint/util/unwrap_reference.hpp>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "lubjoint/dynamics/complex_shift_solver.hpp"
#include "lubjoint/dynamics/radau_tableau.hpp"

namespace lubjoint {

/// In place of a number of states: it is known when the program runs.
inline constexpr std::size_t run_time_size = 0;

/// What a run of a stepper has cost.
struct StepperCounts {
  std::size_t accepted = 0;
  std::size_t rejected = 0;
  std::size_t factorisations = 0;
  std::size_t newton_iterations = 0;
};

/// Three-stage Radau IIA, order 5, L-stable, with step-size control: a controlled stepper in Odeint's sense, so that
/// it runs in Odeint's integrate functions. The system is a pair (f, jacobian) as for Odeint's rosenbrock4:
///   f(x, dxdt, t) and jacobian(x, J, t), J an Eigen::Matrix<R, N, N>; time derivatives are not needed.
/// Simplified Newton iterations on the transformed stages, one real and one complex factorisation a step. The solution
/// is of order 5, the embedded estimate of order 3: as in Hairer and Wanner's code the tolerance of the estimate is
/// 0.1 τ^{2/3}, which makes the error of the solution of the order of τ.
/// Source: Hairer and Wanner, Solving Ordinary Differential Equations II, section IV.8.
///
/// A trial state at which f throws std::domain_error, or that is not finite, is a failed step: it is halved.
/// @tparam R  double, long double, or a Boost.Multiprecision number
/// @tparam N  number of states; run_time_size: as many as the tolerances that it is made with, in std::vector
template <class R, std::size_t N>
class RadauIIA5 {
 public:
  using value_type = R;
  using state_type = std::conditional_t<N == run_time_size, std::vector<R>, std::array<R, N>>;
  using deriv_type = state_type;
  using time_type = R;
  using stepper_category = boost::numeric::odeint::controlled_stepper_tag;
  using order_type = unsigned short;
  static constexpr int dimension = N == run_time_size ? Eigen::Dynamic : static_cast<int>(N);
  using Vector = Eigen::Matrix<R, dimension, 1>;
  using Matrix = Eigen::Matrix<R, dimension, dimension>;

  static constexpr order_type order() { return 5; }

  /// @param absolute_tolerance  one for each state, in the state's own unit
  RadauIIA5(const R& relative_tolerance, const state_type& absolute_tolerance) : absolute_(absolute_tolerance) {
    using std::pow;
    if (!(relative_tolerance > 0 && relative_tolerance < 1)) {
      throw std::invalid_argument("relative tolerance of radau_iia5: allowed is a number in (0, 1)");
    }
    relative_ = R(0.1) * pow(relative_tolerance, R(2) / 3);
    relative_part_ = relative_;
    for (std::size_t i = 0; i < absolute_.size(); ++i) {
      if (!(absolute_tolerance[i] > 0)) {
        throw std::invalid_argument("absolute tolerance of radau_iia5: allowed is a number above 0");
      }
      absolute_[i] = absolute_tolerance[i] / relative_tolerance * relative_;
    }
    using std::sqrt;
    newton_tolerance_ =
        std::max<R>(10 * std::numeric_limits<R>::epsilon() / relative_, std::min<R>(R(0.03), sqrt(relative_)));
  }

  /// Leaves the relative tolerance out of the test of a step: for states whose size says nothing of the digits that
  /// matter, such as a coordinate of 0.1 m in which a clearance of 0.1 mm is at stake.
  void use_absolute_tolerance_only() { relative_part_ = R(0); }

  /// Replaces the state after a step by one close to it, and keeps step length and history.
  void replace_state(const state_type& x) {
    x_ = x;
    jacobian_is_current_ = false;
  }

  /// One trial step. On success x, t are advanced and dt is the next step's length; on failure dt is reduced.
  template <class System>
  boost::numeric::odeint::controlled_step_result try_step(System system, state_type& x, time_type& t, time_type& dt) {
    namespace odeint = boost::numeric::odeint;
    using Unwrapped = typename odeint::unwrap_reference<System>::type;
    Unwrapped& parts = system;
    if (!started_ || x != x_ || t != t_) begin_at(x, t);
    try {
      if (!jacobian_is_current_) {
        if (!rate_is_current_) evaluate(parts.first, x_, t_, f_);
        rate_is_current_ = true;
        parts.second(x_, jacobian_, t_);
        if (!jacobian_.allFinite() || !f_.allFinite()) return fail(dt, R(0.5));
        jacobian_is_current_ = true;
        factorised_for_ = 0;
      }
      if (factorised_for_ != dt) factorise(dt);
      R newton_rate = 0;
      if (!solve_stages(parts.first, dt, newton_rate)) return fail(dt, R(0.5));
      R error = estimate(parts.first, dt);
      if (!std::isfinite(static_cast<double>(error))) return fail(dt, R(0.5));
      if (error < 1) {  // the end of the step is a trial state too; its rate begins the next step
        evaluate(parts.first, displaced(z_[2]), t_ + dt, f_end_);
        if (!f_end_.allFinite()) return fail(dt, R(0.5));
      }
      return finish(x, t, dt, std::max<R>(error, R(1e-10)));
    } catch (const std::domain_error&) {
      return fail(dt, R(0.5));
    }
  }

  /// State inside the last accepted step, by the collocation polynomial (order 3, exact at both ends).
  void state_at(const time_type& t, state_type& x) const {
    const R s = (t - (t_ - h_old_)) / h_old_;
    const auto& c = tableau_.c;
    // Lagrange basis on 0, c₁, c₂, 1 of the increments, which vanish at 0.
    const R l1 = s * (s - c(1)) * (s - 1) / (c(0) * (c(0) - c(1)) * (c(0) - 1));
    const R l2 = s * (s - c(0)) * (s - 1) / (c(1) * (c(1) - c(0)) * (c(1) - 1));
    const R l3 = s * (s - c(0)) * (s - c(1)) / ((1 - c(0)) * (1 - c(1)));
    x = x_old_;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      x[i] = x_old_[i] + l1 * z_old_[0](k) + l2 * z_old_[1](k) + l3 * z_old_[2](k);
    }
  }

  /// Forget the last step: to be called after the state was changed by hand.
  void reset() { started_ = false; }

  const StepperCounts& counts() const { return counts_; }

 private:
  using Stages = std::array<Vector, 3>;

  static constexpr int max_newton_iterations = 7;

  template <class F>
  void evaluate(F& f, const state_type& x, const R& t, Vector& out) {
    f(x, rate_, t);
    out.resize(size());
    for (std::size_t i = 0; i < x.size(); ++i) out(static_cast<Eigen::Index>(i)) = rate_[i];
  }

  Eigen::Index size() const { return static_cast<Eigen::Index>(absolute_.size()); }

  state_type displaced(const Vector& z) const {
    state_type x = x_;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += z(static_cast<Eigen::Index>(i));
    return x;
  }

  void begin_at(const state_type& x, const R& t) {
    x_ = x;
    t_ = t;
    rate_ = x;
    scale_.resize(size());
    jacobian_.resize(size(), size());
    started_ = true;
    rate_is_current_ = false;
    jacobian_is_current_ = false;
    first_step_ = true;
    last_failed_ = false;
    has_old_step_ = false;
    set_scale();
  }

  void set_scale() {
    using std::abs;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      scale_(static_cast<Eigen::Index>(i)) = absolute_[i] + relative_part_ * abs(x_[i]);
    }
  }

  R scaled_norm(const Vector& v) const {
    using std::sqrt;
    return sqrt(v.cwiseQuotient(scale_).squaredNorm() / static_cast<R>(size()));
  }

  boost::numeric::odeint::controlled_step_result fail(R& dt, const R& factor) {
    dt *= factor;
    last_failed_ = true;
    ++counts_.rejected;
    return boost::numeric::odeint::fail;
  }

  void factorise(const R& dt) {
    real_.compute(Matrix::Identity(size(), size()) * (tableau_.gamma / dt) - jacobian_);
    complex_.factorise(jacobian_, tableau_.alpha / dt, tableau_.beta / dt);
    factorised_for_ = dt;
    ++counts_.factorisations;
  }

  /// Simplified Newton iterations for the stage increments z_; false if they do not converge.
  template <class F>
  bool solve_stages(F& f, const R& h, R& rate) {
    using std::pow;
    using std::sqrt;
    const auto& tab = tableau_;
    start_stages(h);
    Stages w;
    for (int i = 0; i < 3; ++i) {
      w[i] = tab.t_inverse(i, 0) * z_[0] + tab.t_inverse(i, 1) * z_[1] + tab.t_inverse(i, 2) * z_[2];
    }
    R old_size = 0;
    R convergence = 1;
    for (iterations_ = 1; iterations_ <= max_newton_iterations; ++iterations_) {
      ++counts_.newton_iterations;
      Stages g;
      for (int i = 0; i < 3; ++i) {
        evaluate(f, displaced(z_[i]), t_ + tab.c(i) * h, g[i]);
        if (!g[i].allFinite()) return false;
      }
      Stages r;
      for (int i = 0; i < 3; ++i) {
        r[i] = tab.t_inverse(i, 0) * g[0] + tab.t_inverse(i, 1) * g[1] + tab.t_inverse(i, 2) * g[2];
      }
      const Vector real_right = r[0] - (tab.gamma / h) * w[0];
      Vector right_2 = r[1] - (tab.alpha / h) * w[1] + (tab.beta / h) * w[2];
      Vector right_3 = r[2] - (tab.beta / h) * w[1] - (tab.alpha / h) * w[2];
      const Vector d0 = real_.solve(real_right);
      complex_.solve_in_place(right_2, right_3);
      w[0] += d0;
      w[1] += right_2;
      w[2] += right_3;
      const R change =
          sqrt((square_scaled(d0) + square_scaled(right_2) + square_scaled(right_3)) / static_cast<R>(3 * size()));
      if (!std::isfinite(static_cast<double>(change))) return false;
      for (int i = 0; i < 3; ++i) z_[i] = tab.t(i, 0) * w[0] + tab.t(i, 1) * w[1] + tab.t(i, 2) * w[2];
      if (iterations_ > 1) {
        const R theta = change / old_size;
        rate = iterations_ == 2 ? theta : sqrt(theta * rate);
        if (rate >= R(0.99)) return false;
        convergence = rate / (1 - rate);
        const R remaining = convergence * change * pow(rate, static_cast<R>(max_newton_iterations - 1 - iterations_)) /
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

  R square_scaled(const Vector& v) const { return v.cwiseQuotient(scale_).squaredNorm(); }

  /// First guess of the stages: the last step's collocation polynomial, continued.
  void start_stages(const R& h) {
    if (!has_old_step_ || last_failed_) {
      for (auto& z : z_) z.setZero(size());
      return;
    }
    for (int i = 0; i < 3; ++i) {
      state_type x;
      state_at(t_ + tableau_.c(i) * h, x);
      z_[i].resize(size());
      for (std::size_t k = 0; k < x.size(); ++k) z_[i](static_cast<Eigen::Index>(k)) = x[k] - x_[k];
    }
  }

  /// Scaled norm of the embedded error estimate, filtered by the real factorisation.
  template <class F>
  R estimate(F& f, const R& h) {
    const auto& w = tableau_.error_weights;
    const Vector combination = (w(0) * z_[0] + w(1) * z_[1] + w(2) * z_[2]) / h;
    Vector error = real_.solve(f_ + combination);
    R estimated = scaled_norm(error);
    if (estimated >= 1 && (first_step_ || last_failed_)) {
      Vector f_displaced;
      evaluate(f, displaced(error), t_, f_displaced);
      error = real_.solve(f_displaced + combination);
      estimated = scaled_norm(error);
    }
    return estimated;
  }

  boost::numeric::odeint::controlled_step_result finish(state_type& x, R& t, R& dt, const R& error) {
    using std::pow;
    const R safety = R(0.9);
    const R effort = safety * (2 * max_newton_iterations + 1) / static_cast<R>(iterations_ + 2 * max_newton_iterations);
    const R limit = std::min<R>(safety, effort);
    R shrink = std::clamp<R>(pow(error, R(0.25)) / limit, R(0.125), R(5));
    if (error >= 1) {
      const R next = first_step_ ? R(0.1) : 1 / shrink;
      return fail(dt, std::min<R>(next, R(0.9)));
    }
    if (!first_step_) {  // Gustafsson's predictive controller
      const R predicted = (h_accepted_ / dt) * pow(error * error / error_accepted_, R(0.25)) / safety;
      shrink = std::max(shrink, std::clamp<R>(predicted, R(0.125), R(5)));
    }
    error_accepted_ = std::max<R>(error, R(0.01));
    h_accepted_ = dt;

    x_old_ = x_;
    z_old_ = z_;
    h_old_ = dt;
    has_old_step_ = true;
    x_ = displaced(z_[2]);
    t_ += dt;
    x = x_;
    t = t_;
    set_scale();
    f_ = f_end_;
    rate_is_current_ = true;
    jacobian_is_current_ = false;
    R next = dt / shrink;
    if (last_failed_) next = std::min(next, dt);
    dt = next;
    first_step_ = false;
    last_failed_ = false;
    ++counts_.accepted;
    return boost::numeric::odeint::success;
  }

  const RadauTableau<R>& tableau_ = RadauTableau<R>::instance();
  R relative_ = 0;
  R relative_part_ = 0;  ///< of it, what the size of a state adds to its tolerance
  state_type absolute_{};
  R newton_tolerance_ = 0;

  bool started_ = false;
  bool first_step_ = true;
  bool last_failed_ = false;
  bool has_old_step_ = false;
  bool rate_is_current_ = false;
  bool jacobian_is_current_ = false;
  state_type x_{};
  state_type rate_{};
  R t_ = 0;
  Vector scale_;
  Vector f_;
  Vector f_end_;  ///< at the end of the trial step
  Matrix jacobian_;
  R factorised_for_ = 0;
  Eigen::PartialPivLU<Matrix> real_;
  ComplexShiftSolver<R, dimension> complex_;
  Stages z_;
  int iterations_ = 0;
  R h_accepted_ = 0;
  R error_accepted_ = 0;
  state_type x_old_{};
  Stages z_old_;
  R h_old_ = 0;
  StepperCounts counts_;
};

/// RadauIIA5 as a dense-output stepper in Odeint's sense.
template <class R, std::size_t N>
class RadauIIA5Dense {
 public:
  using Stepper = RadauIIA5<R, N>;
  using value_type = R;
  using state_type = typename Stepper::state_type;
  using deriv_type = state_type;
  using time_type = R;
  using stepper_category = boost::numeric::odeint::dense_output_stepper_tag;

  explicit RadauIIA5Dense(const Stepper& stepper) : stepper_(stepper) {}

  void initialize(const state_type& x0, time_type t0, time_type dt0) {
    x_ = x0;
    t_ = t0;
    dt_ = dt0;
    stepper_.reset();
  }

  /// @throws std::runtime_error if no step, however short, succeeds
  template <class System>
  std::pair<time_type, time_type> do_step(System system) {
    using std::abs;
    x_old_ = x_;
    t_old_ = t_;
    while (stepper_.try_step(system, x_, t_, dt_) == boost::numeric::odeint::fail) {
      if (abs(dt_) <= 4 * std::numeric_limits<R>::epsilon() * abs(t_) || dt_ == 0) {
        throw std::runtime_error("radau_iia5: the step length has shrunk to rounding");
      }
    }
    return {t_old_, t_};
  }

  void calc_state(time_type t, state_type& x) const { stepper_.state_at(t, x); }
  const state_type& current_state() const { return x_; }
  time_type current_time() const { return t_; }
  const state_type& previous_state() const { return x_old_; }
  time_type previous_time() const { return t_old_; }
  time_type current_time_step() const { return dt_; }
  const StepperCounts& counts() const { return stepper_.counts(); }

 private:
  Stepper stepper_;
  state_type x_{};
  state_type x_old_{};
  time_type t_ = 0;
  time_type t_old_ = 0;
  time_type dt_ = 0;
};

}  // namespace lubjoint

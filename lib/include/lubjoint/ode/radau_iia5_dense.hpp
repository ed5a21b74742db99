/// Radau IIA of order 5 as a dense-output stepper in Odeint's sense.
#pragma once

#include <boost/numeric/odeint/stepper/stepper_categories.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "lubjoint/ode/radau_iia.hpp"

namespace lubjoint {

/// RadauIIA5 as a dense-output stepper in Odeint's sense.
template <class R, std::size_t N>
class RadauIIA5Dense {
 public:
  using Stepper = RadauIIA5<R, N>;  ///< that makes the steps

  /// What Odeint asks of a stepper.
  /// @{
  using value_type = R;
  using state_type = typename Stepper::state_type;
  using deriv_type = state_type;
  using time_type = R;
  using stepper_category = boost::numeric::odeint::dense_output_stepper_tag;
  /// @}

  /// Takes the tolerances of a stepper.
  explicit RadauIIA5Dense(const Stepper& stepper) : stepper_(stepper) {}

  /// Starts at x0, with a first step of dt0.
  void initialize(const state_type& x0, time_type t0, time_type dt0) {
    x_ = x0;
    t_ = t0;
    dt_ = dt0;
    stepper_.reset();
  }

  /// One step that succeeds; @returns its start and its end.
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

  void calc_state(time_type t, state_type& x) const { stepper_.state_at(t, x); }  ///< inside the last step
  const state_type& current_state() const { return x_; }                          ///< at the end of the last step
  time_type current_time() const { return t_; }                                   ///< end of the last step
  const state_type& previous_state() const { return x_old_; }                     ///< at its start
  time_type previous_time() const { return t_old_; }                              ///< its start
  time_type current_time_step() const { return dt_; }                             ///< of the next step
  const StepperCounts& counts() const { return stepper_.counts(); }               ///< so far

 private:
  Stepper stepper_;
  state_type x_{};
  state_type x_old_{};
  time_type t_ = 0;
  time_type t_old_ = 0;
  time_type dt_ = 0;
};

}  // namespace lubjoint

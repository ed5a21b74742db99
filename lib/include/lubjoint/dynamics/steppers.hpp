/// The integrators behind one shape: a trial step, and the state inside the last step.
#pragma once

#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <string_view>

#include "lubjoint/dynamics/radau_iia5.hpp"

namespace lubjoint {

/// Names of the integrators that a scene or an option may choose.
inline constexpr std::array<std::string_view, 3> integrator_names = {"radau_iia5", "dopri5", "fehlberg78"};

/// Radau IIA(5) for a system with rate(x, dxdt, t) and jacobian(x, J, t).
template <std::size_t N>
class ImplicitStepper {
 public:
  using State = std::array<double, N>;
  static constexpr bool has_dense_output = true;

  ImplicitStepper(double relative_tolerance, const State& absolute_tolerance)
      : stepper_(relative_tolerance, absolute_tolerance) {}

  template <class System>
  bool try_step(System& system, State& x, double& t, double& dt) {
    auto rate = [&system](const State& y, State& dydt, double s) { system.rate(y, dydt, s); };
    auto jacobian = [&system](const State& y, auto& j, double s) { system.jacobian(y, j, s); };
    return stepper_.try_step(std::make_pair(rate, jacobian), x, t, dt) == boost::numeric::odeint::success;
  }

  /// Inside the last accepted step; the collocation polynomial, order 3.
  template <class System>
  void state_at(System&, double t, State& x) const {
    stepper_.state_at(t, x);
  }

  void reset() { stepper_.reset(); }

 private:
  RadauIIA5<double, N> stepper_;
};

/// An explicit Runge–Kutta pair of Odeint's. Odeint takes a NaN error for success: the caller checks the state.
/// Odeint knows one absolute tolerance: the smallest of the states' is used.
template <class ErrorStepper>
class ExplicitStepper {
 public:
  using State = typename ErrorStepper::state_type;
  static constexpr bool has_dense_output = false;

  ExplicitStepper(double relative_tolerance, const State& absolute_tolerance)
      : stepper_(Checker(*std::min_element(absolute_tolerance.begin(), absolute_tolerance.end()), relative_tolerance,
                         1.0, 0.0)) {}

  template <class System>
  bool try_step(System& system, State& x, double& t, double& dt) {
    const State before = x;
    const double t_before = t;
    auto rate = [&system](const State& y, State& dydt, double s) { system.rate(y, dydt, s); };
    try {
      const bool accepted = stepper_.try_step(rate, x, t, dt) == boost::numeric::odeint::success;
      if (accepted) {
        x_old_ = before;
        t_old_ = t_before;
      }
      return accepted;
    } catch (const std::domain_error&) {  // a stage beyond the wall
      x = before;
      t = t_before;
      dt *= 0.5;
      reset();
      return false;
    }
  }

  /// Inside the last accepted step; one step of the method itself, to its full order.
  template <class System>
  void state_at(System& system, double t, State& x) const {
    auto rate = [&system](const State& y, State& dydt, double s) { system.rate(y, dydt, s); };
    ErrorStepper single;
    x = x_old_;
    if (t > t_old_) single.do_step(rate, x, t_old_, t - t_old_);
  }

  void reset() { reset_fsal(stepper_); }

 private:
  using Checker = boost::numeric::odeint::default_error_checker<double, typename ErrorStepper::algebra_type,
                                                                typename ErrorStepper::operations_type>;
  using Controlled = boost::numeric::odeint::controlled_runge_kutta<ErrorStepper, Checker>;

  template <class Stepper>
  static void reset_fsal(Stepper& stepper) {
    if constexpr (requires { stepper.reset(); }) stepper.reset();
  }

  Controlled stepper_;
  State x_old_{};
  double t_old_ = 0;
};

template <std::size_t N>
using Dopri5 = ExplicitStepper<boost::numeric::odeint::runge_kutta_dopri5<std::array<double, N>>>;

template <std::size_t N>
using Fehlberg78 = ExplicitStepper<boost::numeric::odeint::runge_kutta_fehlberg78<std::array<double, N>>>;

}  // namespace lubjoint

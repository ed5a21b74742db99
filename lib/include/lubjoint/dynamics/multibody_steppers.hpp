/// The integrators for a number of states that is known when the program runs, with a tolerance for each.
#pragma once

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <vector>

#include "lubjoint/dynamics/radau_iia5.hpp"

namespace lubjoint {

/// Radau IIA(5) with an exact Jacobian.
template <class R>
class RunTimeRadau {
 public:
  using State = std::vector<R>;
  static constexpr std::size_t looks_inside = 8;  ///< a step is long: events and peaks are looked for inside it

  RunTimeRadau(const R& tolerance, const State& tolerances) : stepper_(tolerance, tolerances) {
    stepper_.use_absolute_tolerance_only();
  }

  template <class System>
  bool try_step(System& system, State& x, R& t, R& dt) {
    auto rate = [&system](const State& y, State& dydt, const R& s) { system.rate(y, dydt, s); };
    auto jacobian = [&system](const State& y, auto& j, const R& s) { system.jacobian(y, j, s); };
    return stepper_.try_step(std::make_pair(rate, jacobian), x, t, dt) == boost::numeric::odeint::success;
  }
  void reset() { stepper_.reset(); }
  void replace_state(const State& x) { stepper_.replace_state(x); }

 private:
  RadauIIA5<R, run_time_size> stepper_;
};

/// Largest error of a step over its component's tolerance. NaN counts as an error, which Odeint's own does not.
template <class R>
class ComponentErrorChecker {
 public:
  ComponentErrorChecker() = default;
  explicit ComponentErrorChecker(std::vector<R> tolerances) : tolerances_(std::move(tolerances)) {}

  template <class Algebra, class State, class Rate, class Error, class Time>
  R error(Algebra&, const State&, const Rate&, Error& x_error, Time) const {
    using std::abs;
    R largest(0);
    for (std::size_t i = 0; i < tolerances_.size(); ++i) {
      const R each = abs(x_error[i]) / tolerances_[i];
      if (!(each < R(1e10))) return R(1e10);
      largest = std::max<R>(largest, each);
    }
    return largest;
  }

 private:
  std::vector<R> tolerances_;
};

/// An explicit Runge–Kutta pair of Odeint's.
template <class R, template <class...> class ErrorStepper>
class RunTimeExplicit {
 public:
  using State = std::vector<R>;
  static constexpr std::size_t looks_inside = 2;

  RunTimeExplicit(const R&, const State& tolerances) : stepper_(Checker(tolerances)) {}

  template <class System>
  bool try_step(System& system, State& x, R& t, R& dt) {
    const State before = x;
    const R t_before = t;
    auto rate = [&system](const State& y, State& dydt, const R& s) { system.rate(y, dydt, s); };
    try {
      return stepper_.try_step(rate, x, t, dt) == boost::numeric::odeint::success;
    } catch (const std::domain_error&) {  // a stage beyond the wall
      x = before;
      t = t_before;
      dt /= 2;
      reset();
      return false;
    }
  }
  void reset() {
    if constexpr (requires { stepper_.reset(); }) stepper_.reset();
  }
  void replace_state(const State&) { reset(); }

 private:
  using Checker = ComponentErrorChecker<R>;
  using Controlled = boost::numeric::odeint::controlled_runge_kutta<ErrorStepper<std::vector<R>, R>, Checker>;
  Controlled stepper_;
};

template <class... Types>
using OdeintDopri5 = boost::numeric::odeint::runge_kutta_dopri5<Types...>;
template <class... Types>
using OdeintFehlberg78 = boost::numeric::odeint::runge_kutta_fehlberg78<Types...>;

template <class R>
using RunTimeDopri5 = RunTimeExplicit<R, OdeintDopri5>;
template <class R>
using RunTimeFehlberg78 = RunTimeExplicit<R, OdeintFehlberg78>;

}  // namespace lubjoint

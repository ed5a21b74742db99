/// Odeint's explicit Runge–Kutta pairs behind the common interface.
#pragma once

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <stdexcept>

#include "lubjoint/ode/integrator.hpp"

namespace lubjoint {

/// Largest error of a step over its component's tolerance. NaN counts as an error, which Odeint's own does not.
template <class R, std::size_t N>
class ComponentErrorChecker {
 public:
  ComponentErrorChecker() = default;
  /// Checks against these tolerances.
  explicit ComponentErrorChecker(const StepTolerance<R, N>& tolerance) : tolerance_(tolerance) {}

  /// What Odeint asks for: above 1, the step is rejected.
  template <class Algebra, class State, class Rate, class Error, class Time>
  R error(Algebra&, const State& y, const Rate&, Error& y_error, Time) const {
    using std::abs;
    R largest(0);
    for (std::size_t i = 0; i < tolerance_.controlled(); ++i) {
      const R each = abs(y_error[i]) / (tolerance_.absolute[i] + tolerance_.relative * abs(y[i]));
      if (!(each < R(1e10))) return R(1e10);
      largest = std::max<R>(largest, each);
    }
    return largest;
  }

 private:
  StepTolerance<R, N> tolerance_;
};

/// An explicit Runge–Kutta pair of Odeint's, its error checked component by component.
template <class R, std::size_t N, template <class...> class ErrorStepper>
class ExplicitIntegrator final : public Integrator<R, N> {
 public:
  using System = OdeSystem<R, N>;  ///< what it integrates
  using State = StateOf<R, N>;     ///< of the system

  /// A stepper without memory.
  explicit ExplicitIntegrator(const StepTolerance<R, N>& tolerance)
      : tolerance_(tolerance), stepper_(Checker(tolerance)) {}

  bool try_step(System& system, State& y, R& t, R& dt) override {
    before_ = y;
    const R t_before = t;
    const auto rate = [&system](const State& x, State& dxdt, const R& s) { system.rate(x, dxdt, s); };
    try {
      const bool accepted = stepper_.try_step(rate, y, t, dt) == boost::numeric::odeint::success;
      ++(accepted ? counts_.accepted : counts_.rejected);
      return accepted;
    } catch (const std::domain_error&) {  // a stage beyond the wall
      y = before_;
      t = t_before;
      dt /= 2;
      reset();
      ++counts_.rejected;
      return false;
    }
  }
  void reset() override {
    if constexpr (requires { stepper_.reset(); }) stepper_.reset();
  }
  std::unique_ptr<Integrator<R, N>> fresh() const override { return std::make_unique<ExplicitIntegrator>(tolerance_); }
  std::size_t looks_inside() const override { return has_long_steps ? 8 : 2; }
  StepperCounts counts() const override { return counts_; }

 private:
  using Checker = ComponentErrorChecker<R, N>;
  /// Of an order as high a step is long, and an event may come and go inside it.
  static constexpr bool has_long_steps = ErrorStepper<State, R>::order_value > 5;
  using Controlled = boost::numeric::odeint::controlled_runge_kutta<ErrorStepper<State, R>, Checker>;

  StepTolerance<R, N> tolerance_;
  Controlled stepper_;
  State before_{};
  StepperCounts counts_;
};

/// Odeint's stepper, without its template parameters' defaults.
template <class... Types>
using OdeintDopri5 = boost::numeric::odeint::runge_kutta_dopri5<Types...>;
/// Odeint's stepper, likewise.
template <class... Types>
using OdeintFehlberg78 = boost::numeric::odeint::runge_kutta_fehlberg78<Types...>;

/// Dormand and Prince, order 5(4).
template <class R, std::size_t N>
using Dopri5Integrator = ExplicitIntegrator<R, N, OdeintDopri5>;
/// Fehlberg, order 8 with an estimate of order 7.
template <class R, std::size_t N>
using Fehlberg78Integrator = ExplicitIntegrator<R, N, OdeintFehlberg78>;

}  // namespace lubjoint

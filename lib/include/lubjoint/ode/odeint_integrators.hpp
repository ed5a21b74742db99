/// Odeint's extrapolation and multistep methods behind the common interface.
#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/adaptive_adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_adams_bashforth_moulton.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "lubjoint/ode/scaled_system.hpp"
#include "lubjoint/ode/short_start.hpp"

namespace lubjoint {

/// A controlled stepper of Odeint's that takes one tolerance for all states. The state before a trial step is kept: a
/// trial with a stage beyond the wall, or whose next step length is no number, is undone and halved.
/// After a start or restart no state changes by more than its tolerance in the first step. A force that fades as the
/// journal gives way (a film that ruptures when it opens) makes every column of an extrapolation alike when the step is
/// far too long: x₀ + ½ H f(x₀), whatever the number of midpoint steps, and the error estimate sees nothing.
/// Its states are vectors whatever N: Odeint's multistep method reads work of a std::array before it is written.
/// @tparam Make  makes the stepper from the tolerance
template <std::size_t N, class Make>
class ScaledIntegrator final : public Integrator<double, N> {
 public:
  using System = OdeSystem<double, N>;  ///< what it integrates
  using State = StateOf<double, N>;     ///< of the system

  /// A stepper without memory.
  explicit ScaledIntegrator(const StepTolerance<double, N>& tolerance)
      : tolerance_(tolerance), scaled_(tolerance), z_(tolerance.absolute.size()) {
    reset();
  }

  bool try_step(System& system, State& y, double& t, double& dt) override {
    const double t_before = t;
    scaled_.scale(y, z_);
    const auto rate = [&](const std::vector<double>& z, std::vector<double>& dzdt, double s) {
      scaled_.rate(system, z, dzdt, s);
    };
    if (std::exchange(starts_, false)) dt = std::min(dt, time_of_a_tolerance(system, tolerance_, y, t));
    const double tried = dt;
    try {
      const bool accepted = stepper_->try_step(rate, z_, t, dt) == boost::numeric::odeint::success;
      if (std::isfinite(dt) && dt > 0) {
        if (accepted) scaled_.unscale(z_, y);
        ++(accepted ? counts_.accepted : counts_.rejected);
        return accepted;
      }
    } catch (const std::domain_error&) {  // a stage beyond the wall
    }
    t = t_before;
    dt = tried / 2;
    reset();
    ++counts_.rejected;
    return false;
  }
  void reset() override {
    stepper_ = Make::made(tolerance_.nominal, tolerance_.relative);
    starts_ = true;
  }
  /// Both keep what they know: extrapolation remembers no state, only orders and step lengths, and rates of a multistep
  /// method that belong to a state as near as a projection leaves it are as good as those of the state itself.
  void replace_state(const State&) override {}
  std::unique_ptr<Integrator<double, N>> fresh() const override {
    return std::make_unique<ScaledIntegrator>(tolerance_);
  }
  std::size_t looks_inside() const override { return Make::looks_inside; }
  StepperCounts counts() const override { return counts_; }

 private:
  StepTolerance<double, N> tolerance_;
  ScaledSystem<double, N> scaled_;
  std::unique_ptr<typename Make::Stepper> stepper_;
  std::vector<double> z_;
  bool starts_ = true;
  StepperCounts counts_;
};

/// Makes Odeint's extrapolation stepper.
struct MakeBulirschStoer {
  using Stepper = boost::numeric::odeint::bulirsch_stoer<std::vector<double>>;  ///< Odeint's
  static constexpr std::size_t looks_inside = 8;                                ///< long steps of high order
  /// With one tolerance for all states.
  static std::unique_ptr<Stepper> made(double absolute, double relative) {
    return std::make_unique<Stepper>(absolute, relative, 1.0, 0.0);
  }
};

/// Makes Odeint's multistep stepper.
struct MakeAdams {
  /// Predictor and corrector of up to so many steps: orders beyond 8 gain nothing in double precision.
  static constexpr std::size_t steps = 8;
  /// Odeint's.
  using Stepper = boost::numeric::odeint::controlled_adams_bashforth_moulton<
      boost::numeric::odeint::adaptive_adams_bashforth_moulton<steps, std::vector<double>>>;
  static constexpr std::size_t looks_inside = 2;  ///< short steps
  /// With one tolerance for all states.
  static std::unique_ptr<Stepper> made(double absolute, double relative) {
    return std::make_unique<Stepper>(
        typename Stepper::step_adjuster_type(absolute, relative, std::numeric_limits<double>::max()));
  }
};

/// Extrapolation of the modified midpoint rule, order and step chosen together.
template <std::size_t N>
using BulirschStoerIntegrator = ScaledIntegrator<N, MakeBulirschStoer>;

/// Adams–Bashforth–Moulton with variable step and order.
template <std::size_t N>
using AdamsIntegrator = ScaledIntegrator<N, MakeAdams>;

}  // namespace lubjoint

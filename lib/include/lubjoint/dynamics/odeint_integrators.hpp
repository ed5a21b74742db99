/// Odeint's extrapolation and multistep methods behind the common interface.
#pragma once

#include <boost/numeric/odeint/stepper/adaptive_adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_adams_bashforth_moulton.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "lubjoint/dynamics/scaled_system.hpp"

namespace lubjoint {

/// A controlled stepper of Odeint's that takes one tolerance for all states. The state before a trial step is kept: a
/// trial with a stage beyond the wall, or whose next step length is no number, is undone and halved.
/// @tparam Controlled  made by Make, try_step(system, z, t, dt)
template <std::size_t N, class Controlled, class Make>
class ScaledIntegrator final : public Integrator<double, N> {
 public:
  using System = OdeSystem<double, N>;
  using State = StateOf<double, N>;

  explicit ScaledIntegrator(const StepTolerance<double, N>& tolerance)
      : tolerance_(tolerance), scaled_(tolerance), stepper_(Make()(tolerance)) {}

  bool try_step(System& system, State& y, double& t, double& dt) override {
    const double t_before = t;
    const double tried = dt;
    scaled_.scale(y, z_);
    const auto rate = [&](const State& z, State& dzdt, double s) { scaled_.rate(system, z, dzdt, s); };
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
  void reset() override { stepper_ = Make()(tolerance_); }
  std::unique_ptr<Integrator<double, N>> fresh() const override {
    return std::make_unique<ScaledIntegrator>(tolerance_);
  }
  std::size_t looks_inside() const override { return Make::looks_inside; }
  StepperCounts counts() const override { return counts_; }

 private:
  StepTolerance<double, N> tolerance_;
  ScaledSystem<double, N> scaled_;
  std::unique_ptr<Controlled> stepper_;
  State z_{};
  StepperCounts counts_;
};

template <std::size_t N>
using OdeintBulirschStoer = boost::numeric::odeint::bulirsch_stoer<StateOf<double, N>>;

template <std::size_t N>
struct MakeBulirschStoer {
  static constexpr std::size_t looks_inside = 8;  // long steps of high order
  auto operator()(const StepTolerance<double, N>& tolerance) const {
    return std::make_unique<OdeintBulirschStoer<N>>(tolerance.nominal, tolerance.relative, 1.0, 0.0);
  }
};

/// Extrapolation of the modified midpoint rule, order and step chosen together.
template <std::size_t N>
using BulirschStoerIntegrator = ScaledIntegrator<N, OdeintBulirschStoer<N>, MakeBulirschStoer<N>>;

/// Predictor and corrector of up to so many steps: orders beyond 8 gain nothing in double precision.
inline constexpr std::size_t adams_steps = 8;

template <std::size_t N>
using OdeintAdams = boost::numeric::odeint::controlled_adams_bashforth_moulton<
    boost::numeric::odeint::adaptive_adams_bashforth_moulton<adams_steps, StateOf<double, N>>>;

template <std::size_t N>
struct MakeAdams {
  static constexpr std::size_t looks_inside = 2;
  auto operator()(const StepTolerance<double, N>& tolerance) const {
    return std::make_unique<OdeintAdams<N>>(typename OdeintAdams<N>::step_adjuster_type(
        tolerance.nominal, tolerance.relative, std::numeric_limits<double>::max()));
  }
};

/// Adams–Bashforth–Moulton with variable step and order.
template <std::size_t N>
using AdamsIntegrator = ScaledIntegrator<N, OdeintAdams<N>, MakeAdams<N>>;

}  // namespace lubjoint

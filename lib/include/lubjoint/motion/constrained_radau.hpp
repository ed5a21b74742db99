/// Radau IIA(5) for long chains and trees in absolute coordinates.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "lubjoint/motion/constrained_motion_jacobian.hpp"
#include "lubjoint/ode/constrained_jacobian.hpp"
#include "lubjoint/ode/radau_iia.hpp"
#include "lubjoint/ode/short_start.hpp"

namespace lubjoint {

/// RadauIIA5 of a multibody system whose Jacobian and factors are as sparse as its constraints: a step of a chain costs
/// O(n). The steps are those of the full matrices but for rounding; the works of a ledger lag one Newton iteration.
/// For systems without half films.
template <class R>
class ConstrainedRadau final : public Integrator<R, run_time_size> {
 public:
  using System = OdeSystem<R, run_time_size>;         ///< what it integrates: the equations that it was made for
  using State = std::vector<R>;                       ///< (q, q̇, work)
  using Tolerance = StepTolerance<R, run_time_size>;  ///< of it

  /// A stepper without memory. @param ode  kept by reference
  ConstrainedRadau(const MultibodyOde<R>& ode, const Tolerance& tolerance)
      : ConstrainedRadau(ode, tolerance, std::make_shared<ConstrainedMotionJacobian<R>>(ode)) {}

  /// One step of the method, or a shorter dt to try.
  bool try_step(System& system, State& y, R& t, R& dt) override {
    auto rate = [&system](const State& x, State& dxdt, const R& s) { system.rate(x, dxdt, s); };
    auto jacobian = [this](const State& x, ConstrainedJacobian<R>& j, const R& s) { jacobian_->evaluate(s, x, j); };
    auto parts = std::make_pair(rate, jacobian);
    if (std::exchange(starts_, false)) dt = std::min(dt, short_start(system, tolerance_, y, t));
    return stepper_.try_step(std::ref(parts), y, t, dt) == boost::numeric::odeint::success;
  }
  void reset() override { stepper_.reset(); }
  /// The step's end, moved onto the constraints.
  void replace_state(const State& y) override { stepper_.replace_state(y); }
  std::unique_ptr<Integrator<R, run_time_size>> fresh() const override {
    auto another = std::unique_ptr<ConstrainedRadau>(new ConstrainedRadau(ode_, tolerance_, jacobian_));
    another->starts_ = starts_;
    return another;
  }
  /// The rate at the last step's end, from its stages.
  bool end_rate(State& rate) const override { return stepper_.end_rate(rate); }
  std::size_t looks_inside() const override { return 8; }  // its steps are long
  StepperCounts counts() const override { return stepper_.counts(); }

 private:
  ConstrainedRadau(const MultibodyOde<R>& ode, const Tolerance& tolerance,
                   std::shared_ptr<ConstrainedMotionJacobian<R>> jacobian)
      : ode_(ode),
        tolerance_(tolerance),
        jacobian_(std::move(jacobian)),
        stepper_(tolerance.nominal, tolerance.absolute, tolerance.integrals) {
    if (tolerance.relative == 0) stepper_.use_absolute_tolerance_only();
  }

  const MultibodyOde<R>& ode_;
  Tolerance tolerance_;
  std::shared_ptr<ConstrainedMotionJacobian<R>> jacobian_;
  bool starts_ = true;  ///< no step was tried in this motion
  RadauIIA5<R, run_time_size, ConstrainedLinear<R>> stepper_;
};

}  // namespace lubjoint

/// Radau IIA(5) behind the common interface.
#pragma once

#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/ode/radau_iia5.hpp"

namespace lubjoint {

/// RadauIIA5 as an Integrator.
template <class R, std::size_t N>
class RadauIntegrator final : public Integrator<R, N> {
 public:
  using System = OdeSystem<R, N>;  ///< what it integrates
  using State = StateOf<R, N>;     ///< of the system

  /// A stepper without memory.
  explicit RadauIntegrator(const StepTolerance<R, N>& tolerance)
      : tolerance_(tolerance), stepper_(tolerance.nominal, tolerance.absolute, tolerance.integrals) {
    if (tolerance.relative == 0) stepper_.use_absolute_tolerance_only();
  }

  bool try_step(System& system, State& y, R& t, R& dt) override {
    auto rate = [&system](const State& x, State& dxdt, const R& s) { system.rate(x, dxdt, s); };
    auto jacobian = [&system](const State& x, JacobianOf<R, N>& j, const R& s) { system.jacobian(x, j, s); };
    auto parts = std::make_pair(rate, jacobian);
    return stepper_.try_step(std::ref(parts), y, t, dt) == boost::numeric::odeint::success;
  }
  void reset() override { stepper_.reset(); }
  void replace_state(const State& y) override { stepper_.replace_state(y); }
  std::unique_ptr<Integrator<R, N>> fresh() const override { return std::make_unique<RadauIntegrator>(tolerance_); }
  void refine_end_rate(State& rate) const override { stepper_.end_rate(rate); }
  std::size_t looks_inside() const override { return 8; }  // its steps are long
  StepperCounts counts() const override { return stepper_.counts(); }

 private:
  StepTolerance<R, N> tolerance_;
  RadauIIA5<R, N> stepper_;
};

}  // namespace lubjoint

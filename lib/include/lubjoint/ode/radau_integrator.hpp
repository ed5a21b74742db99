/// Radau IIA behind the common interface.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/ode/radau_iia.hpp"
#include "lubjoint/ode/short_start.hpp"
#include "lubjoint/ode/step_interpolant.hpp"

namespace lubjoint {

/// RadauIIA as an Integrator. Of order 9 its steps end at the system's kinks, and are seen by their middle, too: a step
/// of the same order leads there, from the stages at hand.
template <class R, std::size_t N, int Stages>
class RadauIntegrator final : public Integrator<R, N> {
 public:
  using System = OdeSystem<R, N>;  ///< what it integrates
  using State = StateOf<R, N>;     ///< of the system

  /// A stepper without memory.
  explicit RadauIntegrator(const StepTolerance<R, N>& tolerance)
      : tolerance_(tolerance),
        stepper_(tolerance.nominal * R(share_of_tolerance), scaled(tolerance.absolute), tolerance.integrals) {
    if (tolerance.relative == 0) stepper_.use_absolute_tolerance_only();
  }

  bool try_step(System& system, State& y, R& t, R& dt) override {
    const auto parts = parts_of(system);
    if (std::exchange(starts_, false)) dt = std::min(dt, short_start(system, tolerance_, y, t));
    if constexpr (is_of_order_nine_) {
      const R start = t;
      if (!std::exchange(has_sides_, true)) system.kinks(y, t, sides_);
      if (stepper_.try_step(std::ref(parts), y, t, dt) != boost::numeric::odeint::success) return false;
      try {
        end_at_kink(system, start, y, t);
      } catch (const std::domain_error&) {  // no place to look for one: the step is as good as it is without
      }
      return true;
    } else {
      return stepper_.try_step(std::ref(parts), y, t, dt) == boost::numeric::odeint::success;
    }
  }
  void reset() override {
    stepper_.reset();
    has_sides_ = false;
  }
  void replace_state(const State& y) override { stepper_.replace_state(y); }
  std::unique_ptr<Integrator<R, N>> fresh() const override {
    auto another = std::make_unique<RadauIntegrator>(tolerance_);
    another->starts_ = starts_;
    return another;
  }
  bool end_rate(State& rate) const override { return stepper_.end_rate(rate); }
  void see_inside(System& system, StepInterpolant<State>& step) override {
    if constexpr (is_of_order_nine_)
      step.has_middle = stepper_.middle(parts_of(system), step.y_middle, step.rate_middle);
  }
  bool is_of_order_nine() const override { return is_of_order_nine_; }
  std::size_t looks_inside() const override { return is_of_order_nine_ ? 16 : 8; }  // its steps are long
  StepperCounts counts() const override { return stepper_.counts(); }

 private:
  static constexpr bool is_of_order_nine_ = Stages > 3;
  /// In a stiff film the ends of steps of order 9 have errors of their stages' order, 5, which die out in the next step
  /// and are not what the tolerance of an estimate is made for: with a hundredth of it, which takes a third more steps,
  /// extreme cases are as near to their references, for the steps that they take, as with other methods.
  static constexpr double share_of_tolerance = is_of_order_nine_ ? 0.01 : 1;
  /// Share of a step that is not worth one of its own.
  static constexpr double next_to_nothing = 1e-3;
  /// Halvings that find a kink. An error δ of its place leaves one of the order of δ³ in the state.
  static constexpr int most_halvings = 12;

  /// The system as RadauIIA takes it.
  static auto parts_of(System& system) {
    const auto rate = [&system](const State& x, State& dxdt, const R& s) { system.rate(x, dxdt, s); };
    const auto jacobian = [&system](const State& x, JacobianOf<R, N>& j, const R& s) { system.jacobian(x, j, s); };
    const auto of_forces = [&system](const State& x, JacobianOf<R, N>& j, const R& s) { system.force_part(x, j, s); };
    const auto has_some = [&system] { return system.has_force_part(); };
    struct Parts {
      decltype(rate) first;
      decltype(jacobian) second;
      decltype(of_forces) force_part;
      decltype(has_some) has_force_part;
    };
    return Parts{rate, jacobian, of_forces, has_some};
  }

  static State scaled(State absolute) {
    for (R& each : absolute) each *= R(share_of_tolerance);
    return absolute;
  }

  /// Lets the step end at the first kink inside it.
  void end_at_kink(System& system, const R& start, State& y, R& t) {
    if (sides_.empty()) return;
    system.kinks(y, t, ends_);
    R first = t;
    std::size_t kink = ends_.size();
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (!(ends_[i] * sides_[i] < 0)) continue;
      R low = start;
      R high = t;
      for (int halving = 0; halving < most_halvings; ++halving) {
        const R middle = (low + high) / 2;
        stepper_.state_at(middle, inside_);
        system.kinks(inside_, middle, looks_);
        (looks_[i] * sides_[i] > 0 ? low : high) = middle;
      }
      const R share = (high - start) / (t - start);
      if (high < first && share > R(next_to_nothing) && share < R(1 - next_to_nothing)) {
        first = high;
        kink = i;
      }
    }
    std::swap(sides_, ends_);
    if (kink == sides_.size()) return;
    const R beyond = sides_[kink];
    if (!stepper_.end_at(parts_of(system), first, inside_)) return;
    y = inside_;
    t = first;
    system.kinks(y, t, sides_);
    sides_[kink] = beyond;
  }

  StepTolerance<R, N> tolerance_;
  RadauIIA<R, N, Stages> stepper_;
  bool starts_ = true;  ///< no step was tried in this motion
  bool has_sides_ = false;
  std::vector<R> sides_;  ///< of the kinks at the last step's end
  std::vector<R> ends_, looks_;
  State inside_{};
};

}  // namespace lubjoint

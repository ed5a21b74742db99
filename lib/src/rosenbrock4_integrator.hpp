/// Odeint's rosenbrock4, corrected, behind the common interface.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "lubjoint/ode/scaled_system.hpp"
#include "lubjoint/ode/short_start.hpp"
#include "rosenbrock4.hpp"

namespace lubjoint::detail {

template <std::size_t N>
class Rosenbrock4Integrator final : public Integrator<double, N> {
 public:
  using System = OdeSystem<double, N>;
  using State = StateOf<double, N>;

  explicit Rosenbrock4Integrator(const StepTolerance<double, N>& tolerance)
      : tolerance_(tolerance), scaled_(tolerance), work_(tolerance.absolute), slope_(work_), z_(work_) {
    reset();
  }

  bool try_step(System& system, State& y, double& t, double& dt) override {
    const double t_before = t;
    if (std::exchange(starts_, false)) dt = std::min(dt, short_start(system, tolerance_, y, t));
    const double tried = dt;
    system_ = &system;
    scaled_.scale(y, z_);
    const RosenbrockProblem problem{this, &rate, &derivatives};
    try {
      const bool accepted = stepper_->try_step(problem, z_.data(), t, dt);
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
    // Its norm is a mean over all states; integrals count in it with an error of 0.
    const double share =
        std::sqrt(static_cast<double>(tolerance_.controlled()) / static_cast<double>(tolerance_.absolute.size()));
    stepper_ = std::make_unique<Rosenbrock4>(work_.size(), share * tolerance_.nominal, share * tolerance_.relative);
  }
  void replace_state(const State&) override {}  // it remembers no state, only step lengths and errors
  std::unique_ptr<Integrator<double, N>> fresh() const override {
    auto another = std::make_unique<Rosenbrock4Integrator>(tolerance_);
    another->starts_ = starts_;
    return another;
  }
  bool has_smooth_rates() const override { return false; }  // no better than its error times an eigenvalue
  std::size_t looks_inside() const override { return 4; }
  StepperCounts counts() const override { return counts_; }

 private:
  static void rate(void* self, const double* z, double* dzdt, double t) {
    auto& me = *static_cast<Rosenbrock4Integrator*>(self);
    State& at = me.load(z);
    me.scaled_.rate(*me.system_, at, me.slope_, t);
    std::copy(me.slope_.begin(), me.slope_.end(), dzdt);
  }
  static void derivatives(void* self, const double* z, double* jacobian, double* time_slope, double t) {
    auto& me = *static_cast<Rosenbrock4Integrator*>(self);
    const State& scale = me.scaled_.scales();
    const std::size_t n = scale.size();
    State& y = me.load(z);
    for (std::size_t i = 0; i < n; ++i) y[i] *= scale[i];
    me.system_->jacobian(y, me.jacobian_, t);
    me.system_->time_slope(y, me.slope_, t);
    ++me.counts_.jacobians;
    ++me.counts_.factorisations;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        jacobian[i * n + j] =
            me.jacobian_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * scale[j] / scale[i];
      }
      time_slope[i] = me.slope_[i] / scale[i];
    }
  }
  State& load(const double* z) {
    std::copy(z, z + work_.size(), work_.begin());
    return work_;
  }

  StepTolerance<double, N> tolerance_;
  ScaledSystem<double, N> scaled_;
  State work_, slope_, z_;
  JacobianOf<double, N> jacobian_;
  System* system_ = nullptr;
  std::unique_ptr<Rosenbrock4> stepper_;
  bool starts_ = true;  ///< no step was tried in this motion
  StepperCounts counts_;
};

}  // namespace lubjoint::detail

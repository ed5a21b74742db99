/// Steps in independent coordinates, for a run that knows all of them.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "lubjoint/motion/independent_ode.hpp"
#include "lubjoint/ode/integrator.hpp"

namespace lubjoint {

/// An integrator of (q, q̇, work) that makes its steps with another one in the independent coordinates of the present
/// chart. States at the ends of steps fulfil the constraints to rounding. A chart that wears out is replaced between
/// two steps; the method's memory ends with it.
template <class R>
class IndependentIntegrator final : public Integrator<R, run_time_size> {
 public:
  using Base = Integrator<R, run_time_size>;        ///< what it is, and what it steps with
  using System = OdeSystem<R, run_time_size>;       ///< in all coordinates
  using State = std::vector<R>;                     ///< (q, q̇, work)
  using Tolerance = StepTolerance<R, run_time_size>;  ///< of all states
  using Make = std::function<std::unique_ptr<Base>(const Tolerance&)>;  ///< makes the method

  /// @param ode  whose equations are integrated, kept by reference; @param tolerance  of all states
  IndependentIntegrator(MultibodyOde<R>& ode, Tolerance tolerance, Make make)
      : ode_(ode),
        tolerance_(std::move(tolerance)),
        make_(std::move(make)),
        small_(ode, {tolerance_.absolute.begin(),
                     tolerance_.absolute.begin() + static_cast<std::ptrdiff_t>(ode.system().coordinates())}),
        method_(make_(tolerance_)) {}

  bool try_step(System&, State& y, R& t, R& dt) override {
    const R before = t;
    try {
      if (!chosen_) choose(t, y);
      small_.take(y, z_);
      if (!method_->try_step(small_, z_, t, dt)) return false;
      small_.expand(t, z_, stepped_);
    } catch (const std::domain_error&) {
      t = before;
      dt /= 2;
      method_->reset();
      ++failed_;
      return false;
    }
    y = stepped_;
    if (small_.chart().wear() < R(worn_out)) chosen_ = false;
    return true;
  }
  void reset() override { method_->reset(); }
  std::unique_ptr<Base> fresh() const override {
    return std::make_unique<IndependentIntegrator>(ode_, tolerance_, make_);
  }
  void refine_end_rate(State& rate) const override {
    const std::size_t f = small_.freedoms();
    const std::size_t n = ode_.system().coordinates();
    z_rate_.resize(small_.dimension());
    for (std::size_t k = 0; k < f; ++k) {
      z_rate_[k] = rate[small_.chart().independent()[k]];
      z_rate_[f + k] = rate[n + small_.chart().independent()[k]];
    }
    std::copy(rate.begin() + static_cast<std::ptrdiff_t>(2 * n), rate.end(),
              z_rate_.begin() + static_cast<std::ptrdiff_t>(2 * f));
    method_->refine_end_rate(z_rate_);
    small_.expand_rate(z_rate_, rate);
    std::copy(z_rate_.begin() + static_cast<std::ptrdiff_t>(2 * f), z_rate_.end(),
              rate.begin() + static_cast<std::ptrdiff_t>(2 * n));
  }
  bool has_smooth_rates() const override { return method_->has_smooth_rates(); }
  std::size_t looks_inside() const override { return method_->looks_inside(); }
  StepperCounts counts() const override {
    StepperCounts sum = method_->counts();
    sum.accepted += earlier_.accepted;
    sum.rejected += earlier_.rejected + failed_;
    sum.jacobians += earlier_.jacobians;
    sum.factorisations += earlier_.factorisations;
    sum.newton_iterations += earlier_.newton_iterations;
    return sum;
  }
  std::size_t charts() const { return charts_; }  ///< chosen so far

 private:
  /// Share of their first size below which pivots ask for another choice.
  static constexpr double worn_out = 0.2;

  void choose(const R& t, const State& y) {
    small_.choose(t, y);
    ++charts_;
    chosen_ = true;
    const std::size_t n = ode_.system().coordinates();
    Tolerance tolerance = tolerance_;
    tolerance.absolute.clear();
    for (const std::size_t offset : {std::size_t(0), n}) {
      for (const std::size_t i : small_.chart().independent()) {
        tolerance.absolute.push_back(tolerance_.absolute[offset + i]);
      }
    }
    tolerance.absolute.insert(tolerance.absolute.end(),
                              tolerance_.absolute.begin() + static_cast<std::ptrdiff_t>(2 * n),
                              tolerance_.absolute.end());
    earlier_ = counts();
    failed_ = 0;
    method_ = make_(tolerance);
    method_->move_first_states(getenv("MV2") ? 2 * small_.freedoms() : small_.freedoms());
    if (charts_ == 1) earlier_ = {};
  }

  MultibodyOde<R>& ode_;
  Tolerance tolerance_;
  Make make_;
  mutable IndependentOde<R> small_;
  std::unique_ptr<Base> method_;
  State z_, stepped_;
  mutable State z_rate_;
  bool chosen_ = false;
  std::size_t charts_ = 0;
  std::size_t failed_ = 0;
  StepperCounts earlier_;
};

}  // namespace lubjoint

/// Steps in coordinates that the constraints leave free, for a run that knows all coordinates.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "lubjoint/motion/independent_ode.hpp"
#include "lubjoint/ode/integrator.hpp"

namespace lubjoint {

/// An integrator of (q, q̇, work) that makes its steps with another one in the functions of the present chart. States at
/// the ends of steps fulfil the constraints to rounding. A chart that wears out is replaced between two steps.
/// @tparam N  number of states in a chart's functions, or run_time_size
template <class R, std::size_t N>
class IndependentIntegrator final : public Integrator<R, run_time_size> {
 public:
  using Base = Integrator<R, run_time_size>;                              ///< what it is
  using Method = Integrator<R, N>;                                        ///< what it steps with
  using System = OdeSystem<R, run_time_size>;                             ///< in all coordinates
  using State = std::vector<R>;                                           ///< (q, q̇, work)
  using FullTolerance = StepTolerance<R, run_time_size>;                  ///< of all states
  using Tolerance = StepTolerance<R, N>;                                  ///< of the chart's
  using Make = std::function<std::unique_ptr<Method>(const Tolerance&)>;  ///< makes the method

  /// @param ode  whose equations are integrated, kept by reference;  @param tolerance  of all states
  /// @param tolerance_of_joint  of the eccentricity of each joint and of its rate [m, m/s]
  IndependentIntegrator(MultibodyOde<R>& ode, FullTolerance tolerance, std::vector<std::array<R, 2>> of_joints,
                        Make make)
      : ode_(ode),
        tolerance_(std::move(tolerance)),
        of_joints_(std::move(of_joints)),
        make_(std::move(make)),
        small_(ode, {tolerance_.absolute.begin(),
                     tolerance_.absolute.begin() + static_cast<std::ptrdiff_t>(ode.system().coordinates())}) {}

  bool try_step(System&, State& y, R& t, R& dt) override {
    const R before = t;
    try {
      if (!chosen_) choose(t, y);
      if (y != stepped_) small_.take(t, y, x_);  // else x_ is the method's own, which goes on from it
      const auto start = x_;
      if (!method_->try_step(small_, x_, t, dt)) {
        x_ = start;
        return false;
      }
      small_.expand(t, x_, stepped_);
    } catch (const std::domain_error&) {
      t = before;
      dt /= 2;
      stepped_.clear();
      if (method_) method_->reset();
      ++failed_;
      return false;
    }
    y = stepped_;
    if (small_.chart().wear() < R(worn_out)) chosen_ = false;
    return true;
  }
  void reset() override {
    if (method_) method_->reset();
  }
  std::unique_ptr<Base> fresh() const override {
    return std::make_unique<IndependentIntegrator>(ode_, tolerance_, of_joints_, make_);
  }
  void refine_end_rate(State& rate) const override {
    small_.take_rate(rate, x_rate_);
    method_->refine_end_rate(x_rate_);
    small_.expand_rate(x_rate_, rate);
  }
  bool has_smooth_rates() const override { return make_(Tolerance(some_tolerance()))->has_smooth_rates(); }
  std::size_t looks_inside() const override { return make_(Tolerance(some_tolerance()))->looks_inside(); }
  StepperCounts counts() const override {
    StepperCounts sum = method_ ? method_->counts() : StepperCounts{};
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

  Tolerance some_tolerance() const {
    Tolerance t{tolerance_.relative, {}, tolerance_.nominal, tolerance_.integrals};
    if constexpr (N == run_time_size) t.absolute.resize(small_.dimension());
    for (auto& each : t.absolute) each = R(1);
    return t;
  }

  void choose(const R& t, const State& y) {
    small_.choose(t, y);
    ++charts_;
    chosen_ = true;
    if (method_ && small_.chart().chosen() == chart_functions_) return;  // in another order: the method need not know
    chart_functions_ = small_.chart().chosen();
    const std::size_t n = ode_.system().coordinates();
    const std::size_t f = small_.freedoms();
    Tolerance tolerance = some_tolerance();
    for (std::size_t k = 0; k < f; ++k) {
      for (const std::size_t rate : {std::size_t(0), std::size_t(1)}) {
        tolerance.absolute[rate * f + k] = small_.chart().is_of_joint(k)
                                               ? of_joints_[small_.chart().joint_of(k)][rate]
                                               : tolerance_.absolute[rate * n + small_.chart().coordinate_of(k)];
      }
    }
    for (std::size_t i = 2 * n; i < tolerance_.absolute.size(); ++i)
      tolerance.absolute[2 * f + i - 2 * n] = tolerance_.absolute[i];
    earlier_ = counts();
    failed_ = 0;
    method_ = make_(tolerance);
    stepped_.clear();
  }

  MultibodyOde<R>& ode_;
  FullTolerance tolerance_;
  std::vector<std::array<R, 2>> of_joints_;
  Make make_;
  mutable IndependentOde<R, N> small_;
  std::unique_ptr<Method> method_;
  std::vector<std::size_t> chart_functions_;
  typename IndependentOde<R, N>::State x_{};
  State stepped_;
  mutable typename IndependentOde<R, N>::State x_rate_{};
  bool chosen_ = false;
  std::size_t charts_ = 0;
  std::size_t failed_ = 0;
  StepperCounts earlier_;
};

}  // namespace lubjoint

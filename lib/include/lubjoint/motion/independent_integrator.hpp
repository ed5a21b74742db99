/// Steps in coordinates that the constraints leave free, for a run that knows all coordinates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "lubjoint/motion/independent_ode.hpp"
#include "lubjoint/ode/integrator.hpp"
#include "lubjoint/ode/step_interpolant.hpp"

namespace lubjoint {

/// An integrator of all states that makes its steps with another one in the functions of the present chart. States at
/// the ends of steps fulfil the constraints to rounding. A chart that wears out is replaced between two steps.
/// @tparam In  InPlane or InSpace;  @tparam N  number of states in a chart's functions, or run_time_size
template <class In, std::size_t N>
class IndependentIntegrator final : public Integrator<typename In::R, run_time_size> {
 public:
  using R = typename In::R;                                               ///< the number
  using Small = IndependentOde<In, N>;                                    ///< the equations in a chart's functions
  using Base = Integrator<R, run_time_size>;                              ///< what it is
  using Method = Integrator<R, N>;                                        ///< what it steps with
  using System = OdeSystem<R, run_time_size>;                             ///< in all coordinates
  using State = std::vector<R>;                                           ///< places, velocities, work
  using Equations = typename In::Equations;                               ///< of all states
  using FullTolerance = StepTolerance<R, run_time_size>;                  ///< of all states
  using Tolerance = StepTolerance<R, N>;                                  ///< of the chart's
  using Make = std::function<std::unique_ptr<Method>(const Tolerance&)>;  ///< makes the method

  /// @param ode  whose equations are integrated, kept by reference;  @param tolerance  of all states
  /// @param of_joints  tolerance of each joint's eccentricity and of its rate [m, m/s]
  IndependentIntegrator(Equations& ode, FullTolerance tolerance, std::vector<std::array<R, 2>> of_joints, Make make)
      : tolerance_(std::move(tolerance)),
        of_joints_(std::move(of_joints)),
        make_(std::move(make)),
        ode_(ode),
        small_(ode, In::units(ode, tolerance_.absolute)) {
    Tolerance some = tolerance_of_chart();
    for (std::size_t i = 0; i < some.absolute.size(); ++i) some.absolute[i] = R(1);
    method_ = make_(some);
  }

  /// One step in the chart's functions; no step, and a shorter dt, where the bodies' places are not found.
  bool try_step(System&, State& y, R& t, R& dt) override {
    const R before = t;
    try {
      if (!chosen_) choose(t, y);
      if (y != stepped_) small_.take(y, x_);  // else x_ is the method's own, which goes on from it
      resolve_drivers(t, dt);
      start_ = y;
      x_start_ = x_;
      if (!method_->try_step(small_, x_, t, dt)) {
        x_ = x_start_;
        return false;
      }
      small_.expand(t, x_, stepped_);
      x_rate_ = x_;
      if (method_->end_rate(x_rate_)) small_.go_on_with(x_rate_);
      In::go_on_from(start_, R(t - before), ode_.system().bodies().size(), stepped_);
    } catch (const std::domain_error&) {
      t = before;
      dt /= 2;
      stepped_.clear();
      method_->reset();
      ++failed_;
      return false;
    }
    y = stepped_;
    small_.go_on_from(y);
    if (small_.wear() < R(worn_out)) chosen_ = false;
    return true;
  }
  void reset() override { method_->reset(); }
  std::unique_ptr<Base> fresh() const override { return std::unique_ptr<Base>(new IndependentIntegrator(*this)); }
  /// The rate at the last step's end, from its stages.
  bool end_rate(State& rate) const override {
    small_.take_rate(rate, x_rate_);
    const bool known = method_->end_rate(x_rate_);
    small_.expand_rate(x_rate_, rate);
    return known;
  }
  /// Between its ends z is the polynomial: q's would have errors of the size of the whole motion, in films a thousand
  /// times thinner.
  void see_inside(System&, StepInterpolant<State>& step) override {
    if (!chosen_at_) return;
    auto chart = std::make_shared<StepInterpolant<std::vector<R>>>();
    chart->t_old = step.t_old;
    chart->t_new = step.t_new;
    chart->smooth_rates = step.smooth_rates;
    // What the method has is free of the rounding of the bodies' places, which a short step would make velocities of.
    const auto take = [](const auto& x, std::vector<R>& end) { std::copy_n(x.begin(), end.size(), end.begin()); };
    chosen_at_->see(step.y_old, step.rate_old, chart->y_old, chart->rate_old);
    if (step.y_old == start_) take(x_start_, chart->y_old);
    chart->y_new = chart->y_old;  // near which angles are counted
    chosen_at_->see(step.y_new, step.rate_new, chart->y_new, chart->rate_new);
    if (step.y_new == stepped_) take(x_, chart->y_new);
    if (method_->is_of_order_nine() && step.y_old == start_) {
      chosen_at_->take(start_, inside_.y_old);  // the bodies' places are looked for from there
      method_->see_inside(*chosen_at_, inside_);
      if (inside_.has_middle) put_middle(step, *chart);
    }
    step.inside = [chart, expand = chosen_at_](const R& t, State& y) {
      try {
        expand->correct(t, *chart, y);
      } catch (const SingularConstraints&) {  // the polynomials' then
      }
    };
  }
  bool has_smooth_rates() const override { return method_->has_smooth_rates(); }
  bool is_of_order_nine() const override { return method_->is_of_order_nine(); }
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
  /// The middle that the method has seen, for the whole state and for the chart's functions.
  void put_middle(StepInterpolant<State>& step, StepInterpolant<std::vector<R>>& chart) {
    const R half = (step.t_new - step.t_old) / 2;
    try {
      chosen_at_->expand(R(step.t_old + half), inside_.y_middle, step.y_middle);
    } catch (const SingularConstraints&) {
      return;
    }
    In::go_on_from(start_, half, ode_.system().bodies().size(), step.y_middle);
    step.rate_middle = step.rate_new;  // places' rates are not looked at
    chosen_at_->expand_rate(inside_.rate_middle, step.rate_middle);
    chart.y_middle = chart.y_old;
    chart.rate_middle = chart.rate_old;
    std::copy_n(inside_.y_middle.begin(), chart.y_middle.size(), chart.y_middle.begin());
    std::copy_n(inside_.rate_middle.begin(), chart.rate_middle.size(), chart.rate_middle.begin());
    step.has_middle = chart.has_middle = true;
  }

  /// Share of their first size below which pivots ask for another choice.
  static constexpr double worn_out = 0.2;
  static constexpr int most_trials = 20;  ///< of a step's length; each is as good as right

  /// The same chart, and no memory of steps.
  IndependentIntegrator(const IndependentIntegrator& other)
      : tolerance_(other.tolerance_),
        of_joints_(other.of_joints_),
        make_(other.make_),
        ode_(other.ode_),
        small_(other.small_),
        method_(other.method_->fresh()),
        functions_(other.functions_),
        x_(other.x_),
        chosen_at_(other.chosen_at_),
        chosen_(other.chosen_) {}

  /// A prescribed motion is no state, and free motions may not feel it: a step is shortened until it can be followed to
  /// a tenth of the relative tolerance. What it does to the work of drivers then is within the tolerance.
  void resolve_drivers(const R& t, R& dt) const {
    using std::pow;
    R allowed = tolerance_.nominal / 10;
    // Of order 9, with an error of 2.2e-9 (ωh)¹⁰ where the quintic misses by 2.2e-5 (ωh)⁶.
    if (method_->is_of_order_nine()) allowed = R(2.2e-5) * pow(R(allowed / R(2.2e-9)), R(0.6));
    for (int trial = 0; trial < most_trials; ++trial) {
      const R miss = prescribed_miss(ode_.system().constraints(), t, dt);
      if (!(miss > allowed)) return;
      dt *= std::max<R>(R(0.2), R(0.9) * pow(allowed / miss, R(1) / 6));  // the miss is of order 6
    }
  }

  /// Of a chart's functions and of works; before a choice of the right size only.
  Tolerance tolerance_of_chart() const {
    Tolerance tolerance{tolerance_.relative, {}, tolerance_.nominal, tolerance_.integrals};
    if constexpr (N == run_time_size) tolerance.absolute.resize(small_.dimension());
    const std::size_t f = small_.freedoms();
    for (std::size_t k = 0; chosen_ && k < f; ++k) {
      for (const std::size_t rate : {std::size_t(0), std::size_t(1)}) {
        tolerance.absolute[rate * f + k] = small_.chart().is_of_joint(k)
                                               ? of_joints_[small_.chart().joint_of(k)][rate]
                                               : In::tolerance(ode_, small_.chart(), k, rate == 1, tolerance_.absolute);
      }
    }
    const std::size_t works = ode_.mechanical_states();
    for (std::size_t i = works; i < tolerance_.absolute.size(); ++i)
      tolerance.absolute[2 * f + i - works] = tolerance_.absolute[i];
    return tolerance;
  }

  void choose(const R& t, const State& y) {
    small_.choose(t, y);
    chosen_at_ = std::make_shared<Small>(small_);
    ++charts_;
    chosen_ = true;
    if (small_.chart().chosen() == functions_) return;  // in another order: the method need not know
    functions_ = small_.chart().chosen();
    earlier_ = counts();
    failed_ = 0;
    stepped_.clear();
    method_ = make_(tolerance_of_chart());
  }

  FullTolerance tolerance_;
  std::vector<std::array<R, 2>> of_joints_;
  Make make_;
  const Equations& ode_;
  mutable Small small_;
  std::unique_ptr<Method> method_;
  std::vector<std::size_t> functions_;  ///< of the chart that the method steps in
  typename Small::State x_{};
  std::shared_ptr<Small> chosen_at_;               ///< in the present chart, for looks between steps
  State stepped_;                                  ///< the end of the last step
  State start_;                                    ///< its start
  typename Small::State x_start_{};                ///< likewise
  StepInterpolant<typename Small::State> inside_;  ///< its middle, where the method sees one
  mutable typename Small::State x_rate_{};
  bool chosen_ = false;
  std::size_t charts_ = 0;
  std::size_t failed_ = 0;
  StepperCounts earlier_;
};

}  // namespace lubjoint

/// One integrator from the start to the end of a smooth problem: nothing but steps when it is timed.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "lubjoint/dynamics/integrators.hpp"
#include "lubjoint/dynamics/step_interpolant.hpp"
#include "oracle/reports/bench/bench_case.hpp"
#include "oracle/reports/bench/sundials_method.hpp"

namespace lubjoint::reports {

/// A problem of N states that a race is run on.
template <std::size_t N>
class RaceProblem : public OdeSystem<double, N> {
 public:
  using State = StateOf<double, N>;

  virtual State start() const = 0;
  virtual StepTolerance<double, N> tolerance(double relative) const = 0;
  virtual bool is_admissible(double t, const State& y) = 0;         ///< a film exists, every number is one
  virtual Vector2<double> looked_at(double t, const State& y) = 0;  ///< in clearances
  virtual std::size_t positions() const = 0;                        ///< of the states, the first ones
  virtual std::size_t evaluations() const = 0;
};

/// Races on a problem with a known answer.
template <std::size_t N>
class RaceCase final : public BenchCase {
 public:
  using Problem = RaceProblem<N>;
  using State = StateOf<double, N>;

  RaceCase(std::string formulation, std::unique_ptr<Problem> problem, double duration, std::vector<double> times,
           Reference reference)
      : formulation_(std::move(formulation)),
        problem_(std::move(problem)),
        duration_(duration),
        times_(std::move(times)),
        reference_(std::move(reference)) {}

  std::string formulation() const override { return formulation_; }

  std::vector<std::string> methods() const override { return raced_methods(); }

  MethodRun run(const std::string& method, double tolerance, const BenchLimits& limits) override {
    // Once with a look inside the steps, for the error; then for the time alone.
    std::vector<Vector2<double>> seen;
    MethodRun result = once(method, tolerance, limits, &seen);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      result.error = std::max(result.error, (seen[i] - reference_[i]).norm());
    }
    if (!result.finished) return result;
    std::vector<double> seconds;
    const auto begin = Clock::now();
    for (int i = 0; i < limits.repeats; ++i) {
      MethodRun timed = once(method, tolerance, limits, nullptr);
      if (!timed.finished) return timed;  // at the edge of its share of time: no time of it is known
      seconds.push_back(timed.seconds);
      result.rhs_evaluations = timed.rhs_evaluations;
      if (i >= 2 && std::chrono::duration<double>(Clock::now() - begin).count() > limits.seconds) break;
    }
    std::nth_element(seconds.begin(), seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2), seconds.end());
    result.seconds = seconds[seconds.size() / 2];
    return result;
  }

 private:
  using Clock = std::chrono::steady_clock;

  MethodRun once(const std::string& method, double tolerance, const BenchLimits& limits,
                 std::vector<Vector2<double>>* seen) {
    const std::size_t evaluations = problem_->evaluations();
    MethodRun result = is_sundials_method(method)
                           ? run_sundials_method(method, problem_->tolerance(tolerance), limits, seen)
                           : march(method, tolerance, limits, seen);
    result.rhs_evaluations = problem_->evaluations() - evaluations;
    return result;
  }

  MethodRun run_sundials_method(const std::string& method, const StepTolerance<double, N>& tolerance,
                                const BenchLimits& limits, std::vector<Vector2<double>>* seen) {
    State y = problem_->start();
    State dydt = y;
    const std::size_t n = y.size();
    SundialsProblem problem;
    problem.start.assign(y.begin(), y.end());
    problem.absolute_tolerance.assign(tolerance.absolute.begin(), tolerance.absolute.end());
    problem.relative_tolerance = tolerance.relative;
    problem.duration = duration_;
    problem.rate = [&](double t, const double* at, double* out) {
      std::copy(at, at + n, y.begin());
      problem_->rate(y, dydt, t);
      std::copy(dydt.begin(), dydt.end(), out);
    };
    if (seen) {
      problem.times = times_;
      problem.observe = [&](double t, const double* at) {
        std::copy(at, at + n, y.begin());
        seen->push_back(problem_->looked_at(t, y));
      };
    }
    return solve_with_sundials(method, problem, limits);
  }

  MethodRun march(const std::string& method, double tolerance, const BenchLimits& limits,
                  std::vector<Vector2<double>>* seen) {
    MethodRun result;
    State y = problem_->start();
    double t = 0;
    double dt = 1e-6 * duration_;
    StepInterpolant<State> step;
    State inside = y;
    if (seen) {
      step.rate_old = step.rate_new = y;
      problem_->rate(y, step.rate_new, t);
    }
    const double shortest = 8 * std::numeric_limits<double>::epsilon();
    const auto begin = Clock::now();
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    const auto integrator = make_integrator<N>(method, problem_->tolerance(tolerance));
    State y_old = y;
    while (duration_ - t > shortest * duration_) {
      const double t_old = t;
      y_old = y;
      dt = std::min(dt, duration_ - t);
      const bool stepped = integrator->try_step(*problem_, y, t, dt);
      if (!stepped || !problem_->is_admissible(t, y)) {
        if (stepped) {
          dt = 0.5 * (t - t_old);
          integrator->reset();
        }
        t = t_old;
        y = y_old;
        ++result.rejected;
        if (!(dt > shortest * std::max(t, 1e-3 * duration_))) {
          result.message = "no step, however short, gives a finite state";
          return result;
        }
      } else {
        ++result.steps;
        if (seen) look(*integrator, step, t_old, t, y_old, y, inside, *seen);
      }
      if ((result.steps + result.rejected) % 256 == 0 && elapsed() > limits.seconds) {
        result.message = "given up after its share of time";
        return result;
      }
    }
    result.seconds = elapsed();
    result.finished = true;
    result.jacobian_evaluations = integrator->counts().jacobians;
    result.factorisations = integrator->counts().factorisations;
    return result;
  }

  void look(const Integrator<double, N>& integrator, StepInterpolant<State>& step, double t_old, double t,
            const State& y_old, const State& y, State& inside, std::vector<Vector2<double>>& seen) {
    step.t_old = t_old;
    step.t_new = t;
    step.y_old = y_old;
    step.y_new = y;
    std::swap(step.rate_old, step.rate_new);
    problem_->rate(y, step.rate_new, t);
    integrator.refine_end_rate(step.rate_new);
    step.smooth_rates = integrator.has_smooth_rates();
    while (seen.size() < times_.size() && times_[seen.size()] <= t + 1e-13 * duration_) {
      const double at = times_[seen.size()];
      step.state_at(at, problem_->positions(), inside);
      seen.push_back(problem_->looked_at(at, inside));
    }
  }

  std::string formulation_;
  std::unique_ptr<Problem> problem_;
  double duration_;
  std::vector<double> times_;
  Reference reference_;
};

}  // namespace lubjoint::reports

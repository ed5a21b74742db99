/// One integrator from the start to the end of a smooth problem: nothing but steps when it is timed.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/ode/step_interpolant.hpp"
#include "oracle/measure/bench/bench_case.hpp"
#include "oracle/measure/bench/sundials_method.hpp"
#include "oracle/mechanisms/processor_time.hpp"

namespace lubjoint::reports {

/// A problem of N states that a race is run on.
template <std::size_t N>
class RaceProblem : public OdeSystem<double, N> {
 public:
  using State = StateOf<double, N>;

  virtual State start() const = 0;
  virtual StepTolerance<double, N> tolerance(double relative) const = 0;
  virtual bool is_admissible(double t, const State& y) = 0;          ///< a film exists, every number is one
  virtual void look(double t, const State& y, Reference& seen) = 0;  ///< adds what errors are measured in
  virtual std::size_t positions() const = 0;                         ///< of the states, the first ones
  virtual std::size_t evaluations() const = 0;
  /// The state inside a step.
  virtual void state_at(const StepInterpolant<State>& step, double t, State& inside) {
    step.state_at(t, positions(), inside);
  }
  /// Puts the end of a step where it belongs; true if that has changed it.
  virtual bool hold(State&) { return false; }
  /// Names of the library's integrators that are raced on it.
  virtual std::vector<std::string> own_methods() const { return {method_names().begin(), method_names().end()}; }
  /// The integrator of that name for this problem.
  virtual std::unique_ptr<Integrator<double, N>> integrator(const std::string& method, double relative) {
    if constexpr (N == 4 || N == run_time_size) return make_integrator<N>(method, tolerance(relative));
    throw std::logic_error("the library has no integrator by name for so many states");
  }
  virtual bool is_for_others() const { return true; }  ///< can another's solver be given it?
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

  std::vector<std::string> methods() const override {
    std::vector<std::string> names = problem_->own_methods();
    if (problem_->is_for_others()) {
      for (const std::string_view name : sundials_methods()) names.emplace_back(name);
    }
    return names;
  }

  MethodRun run(const std::string& method, double tolerance, const BenchLimits& limits) override {
    return measured_run(limits, reference_, [&](Reference* seen) { return once(method, tolerance, limits, seen); });
  }

  std::optional<PlainProblem> plain_problem(double tolerance) override {
    if (!problem_->is_for_others()) return std::nullopt;
    const StepTolerance<double, N> allowed = problem_->tolerance(tolerance);
    State y = problem_->start();
    const std::size_t n = y.size();
    PlainProblem plain;
    plain.start.assign(y.begin(), y.end());
    plain.absolute_tolerance.assign(allowed.absolute.begin(), allowed.absolute.end());
    plain.relative_tolerance = allowed.relative;
    plain.duration = duration_;
    plain.second_order = 2 * problem_->positions() == n;
    plain.rate = [this, n, y, dydt = y](double t, const double* at, double* out) mutable {
      std::copy(at, at + n, y.begin());
      problem_->rate(y, dydt, t);
      std::copy(dydt.begin(), dydt.end(), out);
    };
    plain.jacobian = [this, n, y, j = empty_jacobian(n)](double t, const double* at, double* out) mutable {
      std::copy(at, at + n, y.begin());
      problem_->jacobian(y, j, t);
      std::copy(j.data(), j.data() + n * n, out);  // column by column, as Eigen has it
    };
    return plain;
  }

 private:
  static JacobianOf<double, N> empty_jacobian(std::size_t n) {
    JacobianOf<double, N> j;
    if constexpr (N == run_time_size) j.resize(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    j.setZero();
    return j;
  }

  MethodRun once(const std::string& method, double tolerance, const BenchLimits& limits, Reference* seen) {
    const std::size_t evaluations = problem_->evaluations();
    MethodRun result = is_sundials_method(method) ? run_sundials_method(method, tolerance, limits, seen)
                                                  : march(method, tolerance, limits, seen);
    result.rhs_evaluations = problem_->evaluations() - evaluations;
    return result;
  }

  MethodRun run_sundials_method(const std::string& method, double tolerance, const BenchLimits& limits,
                                Reference* seen) {
    std::optional<PlainProblem> given = plain_problem(tolerance);
    if (!given) {
      throw std::invalid_argument(method + " is not given " + formulation() +
                                  " coordinates; allowed are the project's own methods");
    }
    PlainProblem& plain = *given;
    State y = problem_->start();
    if (seen) {
      plain.times = times_;
      plain.observe = [&](double t, const double* at) {
        std::copy(at, at + y.size(), y.begin());
        problem_->look(t, y, *seen);
      };
    }
    return solve_with_sundials(method, plain, limits);
  }

  MethodRun march(const std::string& method, double tolerance, const BenchLimits& limits, Reference* seen) {
    MethodRun result;
    std::size_t next = 0;  // of the times
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
    const double begin = mechanisms::processor_seconds();
    const auto elapsed = [&] { return mechanisms::processor_seconds() - begin; };
    const auto integrator = problem_->integrator(method, tolerance);
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
        if (problem_->hold(y)) integrator->replace_state(y);
        if (seen) look(*integrator, step, t_old, t, y_old, y, inside, next, *seen);
      }
      if ((result.steps + result.rejected) % 256 == 0 && elapsed() > limits.seconds) {
        result.message = out_of_time;
        return result;
      }
    }
    result.seconds = elapsed();
    result.finished = true;
    result.jacobian_evaluations = integrator->counts().jacobians;
    result.factorisations = integrator->counts().factorisations;
    return result;
  }

  void look(Integrator<double, N>& integrator, StepInterpolant<State>& step, double t_old, double t, const State& y_old,
            const State& y, State& inside, std::size_t& next, Reference& seen) {
    step.t_old = t_old;
    step.t_new = t;
    step.y_old = y_old;
    step.y_new = y;
    std::swap(step.rate_old, step.rate_new);
    problem_->rate(y, step.rate_new, t);
    integrator.end_rate(step.rate_new);
    step.smooth_rates = integrator.has_smooth_rates();
    step.has_middle = false;
    integrator.see_inside(*problem_, step);
    for (; next < times_.size() && times_[next] <= t + 1e-13 * duration_; ++next) {
      problem_->state_at(step, times_[next], inside);
      problem_->look(times_[next], inside, seen);
    }
  }

  std::string formulation_;
  std::unique_ptr<Problem> problem_;
  double duration_;
  std::vector<double> times_;
  Reference reference_;
};

}  // namespace lubjoint::reports

/// SUNDIALS on the same right-hand sides: what a user would otherwise pick. Optional when the program is built.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "oracle/reports/bench/bench_case.hpp"

namespace lubjoint::reports {

/// An initial value problem in plain numbers.
struct SundialsProblem {
  std::vector<double> start;
  std::vector<double> absolute_tolerance;
  double relative_tolerance = 0;
  double duration = 0;
  std::vector<double> times;                                          ///< to observe; none: when it is timed
  std::function<void(double t, const double* y, double* dydt)> rate;  ///< std::domain_error: the step is too long
  std::function<void(double t, const double* y)> observe;
};

/// cvode_bdf, cvode_adams and ida, each with its own defaults: dense Newton with its Jacobian by difference quotients
/// (Adams: fixed-point iteration). Empty if SUNDIALS was not built in.
std::vector<std::string_view> sundials_methods();

inline bool is_sundials_method(std::string_view name) { return name.starts_with("cvode") || name == "ida"; }

/// @throws std::invalid_argument for a method that is not there
MethodRun solve_with_sundials(std::string_view method, const SundialsProblem& problem, const BenchLimits& limits);

}  // namespace lubjoint::reports

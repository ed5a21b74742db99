/// SUNDIALS on the same right-hand sides: what a user would otherwise pick. Optional when the program is built.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oracle/measure/bench/bench_case.hpp"

namespace lubjoint::reports {

/// cvode_bdf, cvode_adams, cvode_adams_newton and ida. Each gets what Radau gets: a tolerance for each state, and
/// (Adams by fixed-point iteration aside) Newton's method with the exact Jacobian and dense linear systems, those of
/// equations of motion with more than four states at half their size. The rest are SUNDIALS' defaults. Empty if
/// SUNDIALS was not built in.
std::vector<std::string_view> sundials_methods();

inline bool is_sundials_method(std::string_view name) { return name.starts_with("cvode") || name == "ida"; }

/// @throws std::invalid_argument for a method that is not there
MethodRun solve_with_sundials(std::string_view method, const PlainProblem& problem, const BenchLimits& limits);

/// What Newton's method is given at (t, y), column by column: for CVODE ∂f/∂y; for IDA ∂F/∂y + c ∂F/∂ẏ of
/// F(t, y, ẏ) = ẏ − f(y, t).
/// @throws std::invalid_argument for a method that is not there
std::vector<double> sundials_jacobian(std::string_view method, const PlainProblem& problem, double t,
                                      const std::vector<double>& y, double c);

/// F(t, y, ẏ), as IDA is given it.
std::vector<double> sundials_residual(const PlainProblem& problem, double t, const std::vector<double>& y,
                                      const std::vector<double>& dydt);

/// "6.4.1"; empty if SUNDIALS was not built in.
std::string sundials_version();

}  // namespace lubjoint::reports

#include <stdexcept>

#include "oracle/measure/bench/sundials_method.hpp"

namespace lubjoint::reports {

namespace {

[[noreturn]] void refuse(std::string_view what) {
  throw std::invalid_argument(std::string(what) + ": SUNDIALS was not built in");
}

}  // namespace

std::vector<std::string_view> sundials_methods() { return {}; }
std::string sundials_version() { return {}; }

MethodRun solve_with_sundials(std::string_view method, const PlainProblem&, const BenchLimits&) { refuse(method); }

std::vector<double> sundials_jacobian(std::string_view method, const PlainProblem&, double, const std::vector<double>&,
                                      double) {
  refuse(method);
}

std::vector<double> sundials_residual(const PlainProblem&, double, const std::vector<double>&,
                                      const std::vector<double>&) {
  refuse("ida");
}

}  // namespace lubjoint::reports

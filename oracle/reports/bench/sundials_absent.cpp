#include <stdexcept>

#include "oracle/reports/bench/sundials_method.hpp"

namespace lubjoint::reports {

std::vector<std::string_view> sundials_methods() { return {}; }

MethodRun solve_with_sundials(std::string_view method, const SundialsProblem&, const BenchLimits&) {
  throw std::invalid_argument(std::string(method) + ": SUNDIALS was not built in");
}

}  // namespace lubjoint::reports

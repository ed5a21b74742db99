#include "oracle/quadrature/quadrature_error.hpp"

#include <cmath>

#include "lubjoint/text/message.hpp"

namespace lubjoint::oracle {

namespace {

// GSL_EDOM and GSL_ETOL, without GSL: who has no other rule than a fixed one links none of it.
constexpr int outside_domain = 1;
constexpr int before_tolerance = 14;

}  // namespace

void fail(int code, const Request& request, const std::string& reason) {
  Message message;
  message << request.rule << " on [" << request.from << ", " << request.to << "] to relative tolerance "
          << request.tolerance.relative << ", absolute " << request.tolerance.absolute << ": " << reason;
  throw QuadratureError(code, message.str());
}

std::string best_value_words(const Estimate& best) {
  Message text;
  text << "; the best value is " << best.value << " with error " << best.error;
  return text.str();
}

void fail_before_tolerance(const Request& request, const Estimate& best) {
  fail(before_tolerance, request, "failed to reach the specified tolerance" + best_value_words(best));
}

Estimate require_finite(const Request& request, const Estimate& answer) {
  if (std::isfinite(answer.value) && std::isfinite(answer.error)) return answer;
  fail(outside_domain, request, "the integral is not finite");
}

}  // namespace lubjoint::oracle

#include "oracle/quadrature/gsl_call.hpp"

#include <gsl/gsl_errno.h>

#include <cmath>
#include <sstream>

namespace lubjoint::oracle {

void disable_gsl_abort() { [[maybe_unused]] static const auto previous = gsl_set_error_handler_off(); }

namespace {

[[noreturn]] void fail(int code, const Request& request, const std::string& reason) {
  std::ostringstream message;
  message.precision(17);
  message << request.rule << " on [" << request.from << ", " << request.to << "] to relative tolerance "
          << request.tolerance.relative << ", absolute " << request.tolerance.absolute << ": " << reason;
  throw QuadratureError(code, message.str());
}

std::string number(double x) {
  std::ostringstream text;
  text.precision(17);
  text << x;
  return text.str();
}

}  // namespace

Estimate checked(int status, const Request& request, const Estimate& answer) {
  if (status != GSL_SUCCESS && status != GSL_EROUND) {
    fail(status, request,
         std::string(gsl_strerror(status)) + "; the best value is " + number(answer.value) + " with error " +
             number(answer.error));
  }
  if (std::isfinite(answer.value) && std::isfinite(answer.error)) return answer;
  fail(GSL_EDOM, request, "the integral is not finite");
}

GslFunction::GslFunction(const Integrand& function) : function_(function), view_{&GslFunction::call, this} {}

double GslFunction::call(double x, void* self) noexcept {
  auto* const carrier = static_cast<GslFunction*>(self);
  if (carrier->failure_ || carrier->not_finite_at_) return 0;  // the answer is lost: let GSL come to an end quickly
  try {
    const double value = carrier->function_(x);
    if (std::isfinite(value)) return value;
    carrier->not_finite_at_ = x;
  } catch (...) {
    carrier->failure_ = std::current_exception();
  }
  return 0;
}

Estimate GslFunction::finish(int status, const Request& request, const Estimate& answer) const {
  if (failure_) std::rethrow_exception(failure_);
  if (not_finite_at_) fail(GSL_EDOM, request, "the integrand is not finite at " + number(*not_finite_at_));
  return checked(status, request, answer);
}

}  // namespace lubjoint::oracle

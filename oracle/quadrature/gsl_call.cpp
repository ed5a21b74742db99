#include "oracle/quadrature/gsl_call.hpp"

#include <gsl/gsl_errno.h>

#include <cmath>
#include <sstream>

namespace lubjoint::oracle {

void disable_gsl_abort() { [[maybe_unused]] static const auto previous = gsl_set_error_handler_off(); }

Estimate checked(int status, const Request& request, const Estimate& answer) {
  const bool answered = status == GSL_SUCCESS || status == GSL_EROUND;
  const bool finite = std::isfinite(answer.value) && std::isfinite(answer.error);
  if (answered && finite) return answer;
  std::ostringstream message;
  message.precision(17);
  message << request.rule << " on [" << request.from << ", " << request.to << "] to relative tolerance "
          << request.tolerance.relative << ": "
          << (answered ? std::string("the integrand is not finite") : std::string(gsl_strerror(status)))
          << "; the best value is " << answer.value << " with error " << answer.error;
  throw QuadratureError(answered ? GSL_EDOM : status, message.str());
}

GslFunction::GslFunction(const Integrand& function) : function_(function), view_{&GslFunction::call, this} {}

double GslFunction::call(double x, void* self) noexcept {
  auto* const carrier = static_cast<GslFunction*>(self);
  if (carrier->failure_) return 0;  // the answer is discarded: let GSL come to an end quickly
  try {
    return carrier->function_(x);
  } catch (...) {
    carrier->failure_ = std::current_exception();
    return 0;
  }
}

void GslFunction::rethrow() const {
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace lubjoint::oracle

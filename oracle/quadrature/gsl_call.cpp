#include "oracle/quadrature/gsl_call.hpp"

#include <gsl/gsl_errno.h>

#include <cmath>

#include "lubjoint/text/message.hpp"

namespace lubjoint::oracle {

void disable_gsl_abort() { [[maybe_unused]] static const auto previous = gsl_set_error_handler_off(); }

namespace {

std::string number(double x) {
  Message text;
  text << x;
  return text.str();
}

}  // namespace

Estimate checked(int status, const Request& request, const Estimate& answer) {
  if (status != GSL_SUCCESS && status != GSL_EROUND) {
    fail(status, request, gsl_strerror(status) + best_value_words(answer));
  }
  return require_finite(request, answer);
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

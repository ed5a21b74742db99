/// What a rule was asked, and what it says when it has no answer.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "oracle/quadrature/estimate.hpp"

namespace lubjoint::oracle {

/// A quadrature that has no answer. The message says which rule, on which interval, to which tolerance, and why.
class QuadratureError : public std::runtime_error {
 public:
  QuadratureError(int code, const std::string& message) : std::runtime_error(message), code_(code) {}

  int code() const { return code_; }  ///< GSL's error code (gsl_errno.h)

 private:
  int code_;
};

/// What a rule was asked; the context of its errors.
struct Request {
  std::string_view rule;
  double from;
  double to;
  Tolerance tolerance;
};

/// @throws QuadratureError always, with the request and the reason
[[noreturn]] void fail(int code, const Request& request, const std::string& reason);

/// The same for a rule that came to its end before its tolerance; the best value is told.
[[noreturn]] void fail_before_tolerance(const Request& request, const Estimate& best);

/// The answer, if it is one.
/// @throws QuadratureError for a value or an error that is not finite
Estimate require_finite(const Request& request, const Estimate& answer);

/// "; the best value is ... with error ..."
std::string best_value_words(const Estimate& best);

}  // namespace lubjoint::oracle

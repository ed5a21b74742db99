/// GSL called from C++: status codes become exceptions, and exceptions of an integrand pass through C code safely.
#pragma once

#include <gsl/gsl_math.h>

#include <exception>
#include <optional>

#include "oracle/quadrature/integrand.hpp"
#include "oracle/quadrature/quadrature_error.hpp"

namespace lubjoint::oracle {

/// Turns off GSL's default handler, which aborts the program; every status is checked instead. Once per process.
void disable_gsl_abort();

/// The answer of a rule that returned `status`.
/// GSL_EROUND (the tolerance is below rounding) is an answer: its error estimate says what was reached.
/// @throws QuadratureError for any other status, and for a value or an error that is not finite
Estimate checked(int status, const Request& request, const Estimate& answer);

/// Carries an integrand through GSL. An exception of the integrand is kept and thrown again when GSL is done; so is a
/// value that is not finite, which CQUAD would otherwise leave out without a word.
class GslFunction {
 public:
  explicit GslFunction(const Integrand& function);
  GslFunction(const GslFunction&) = delete;
  GslFunction& operator=(const GslFunction&) = delete;

  gsl_function* get() { return &view_; }

  /// The answer of a rule that has been run on this function and returned `status`.
  /// @throws what the integrand threw; QuadratureError as `checked`, or with the place where the integrand is not
  /// finite
  Estimate finish(int status, const Request& request, const Estimate& answer) const;

 private:
  static double call(double x, void* self) noexcept;

  Integrand function_;
  std::exception_ptr failure_;
  std::optional<double> not_finite_at_;
  gsl_function view_;
};

}  // namespace lubjoint::oracle

#include "oracle/quadrature/adaptive.hpp"

#include <gsl/gsl_errno.h>

#include <new>
#include <utility>

#include "oracle/quadrature/gsl_call.hpp"

namespace lubjoint::oracle {

namespace {

template <class Workspace>
Workspace* required(Workspace* workspace) {
  if (workspace == nullptr) throw std::bad_alloc();
  return workspace;
}

}  // namespace

AdaptiveQuadrature::AdaptiveQuadrature(std::size_t most_intervals) : limit_(most_intervals) {
  disable_gsl_abort();
  workspace_.reset(required(gsl_integration_workspace_alloc(limit_)));
}

Estimate AdaptiveQuadrature::gauss_kronrod(const Integrand& f, double from, double to, const Tolerance& tolerance) {
  GslFunction function(f);
  Estimate answer;
  const int status = gsl_integration_qag(function.get(), from, to, tolerance.absolute, tolerance.relative, limit_,
                                         GSL_INTEG_GAUSS21, workspace_.get(), &answer.value, &answer.error);
  return function.finish(status, {"QAG", from, to, tolerance}, answer);
}

Estimate AdaptiveQuadrature::singular(const Integrand& f, double from, double to, const Tolerance& tolerance) {
  GslFunction function(f);
  Estimate answer;
  const int status = gsl_integration_qags(function.get(), from, to, tolerance.absolute, tolerance.relative, limit_,
                                          workspace_.get(), &answer.value, &answer.error);
  return function.finish(status, {"QAGS", from, to, tolerance}, answer);
}

Estimate AdaptiveQuadrature::with_break_points(const Integrand& f, std::vector<double> points,
                                               const Tolerance& tolerance) {
  if (points.size() < 2) throw QuadratureError(GSL_EINVAL, "QAGP: fewer than two points given; allowed are 2 or more");
  GslFunction function(f);
  Estimate answer;
  const int status = gsl_integration_qagp(function.get(), points.data(), points.size(), tolerance.absolute,
                                          tolerance.relative, limit_, workspace_.get(), &answer.value, &answer.error);
  return function.finish(status, {"QAGP", points.front(), points.back(), tolerance}, answer);
}

DoublyAdaptiveQuadrature::DoublyAdaptiveQuadrature(std::size_t most_intervals) {
  disable_gsl_abort();
  workspace_.reset(required(gsl_integration_cquad_workspace_alloc(most_intervals)));
}

Estimate DoublyAdaptiveQuadrature::operator()(const Integrand& f, double from, double to, const Tolerance& tolerance) {
  GslFunction function(f);
  Estimate answer;
  const int status = gsl_integration_cquad(function.get(), from, to, tolerance.absolute, tolerance.relative,
                                           workspace_.get(), &answer.value, &answer.error, nullptr);
  return function.finish(status, {"CQUAD", from, to, tolerance}, answer);
}

}  // namespace lubjoint::oracle

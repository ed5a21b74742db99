/// GSL's adaptive Gauss–Kronrod rules and CQUAD, with workspaces that are allocated once and used again.
#pragma once

#include <gsl/gsl_integration.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "oracle/quadrature/estimate.hpp"
#include "oracle/quadrature/integrand.hpp"

namespace lubjoint::oracle {

/// QAG, QAGS and QAGP of QUADPACK. Not for use by two threads at once: each thread has its own.
/// All members: an answer is value and error estimate, a tolerance below rounding gives what rounding allows.
/// @throws QuadratureError with rule, interval and tolerance if there is no answer
class AdaptiveQuadrature {
 public:
  /// @param most_intervals  bisections allowed before the rule gives up (GSL_EMAXITER)
  explicit AdaptiveQuadrature(std::size_t most_intervals = 1000);

  /// QAG with the 21-point Gauss–Kronrod rule: smooth integrands, steep ones included.
  Estimate gauss_kronrod(const Integrand& f, double from, double to, const Tolerance& tolerance);

  /// QAGS: integrable singularities anywhere, by the ε-algorithm.
  Estimate singular(const Integrand& f, double from, double to, const Tolerance& tolerance);

  /// QAGP: singularities or steep places at known break points.
  /// @param points  ends and break points of the interval, ascending
  Estimate with_break_points(const Integrand& f, std::vector<double> points, const Tolerance& tolerance);

 private:
  struct Free {
    void operator()(gsl_integration_workspace* workspace) const { gsl_integration_workspace_free(workspace); }
  };
  std::size_t limit_;
  std::unique_ptr<gsl_integration_workspace, Free> workspace_;
};

/// CQUAD: doubly adaptive Clenshaw–Curtis, the most forgiving and the slowest. Not for use by two threads at once.
class DoublyAdaptiveQuadrature {
 public:
  explicit DoublyAdaptiveQuadrature(std::size_t most_intervals = 200);

  /// @throws QuadratureError as above
  Estimate operator()(const Integrand& f, double from, double to, const Tolerance& tolerance);

 private:
  struct Free {
    void operator()(gsl_integration_cquad_workspace* workspace) const {
      gsl_integration_cquad_workspace_free(workspace);
    }
  };
  std::unique_ptr<gsl_integration_cquad_workspace, Free> workspace_;
};

}  // namespace lubjoint::oracle

/// The trapezoid rule for periodic integrands.
#pragma once

#include "oracle/quadrature/estimate.hpp"
#include "oracle/quadrature/integrand.hpp"

namespace lubjoint::oracle {

/// The trapezoid sum of a given number of points on one period from `start`.
double periodic_trapezoid_sum(const Integrand& f, double start, double period, long points);

/// ∫ f over one period from `start`, by the trapezoid rule with halved steps until two sums agree. For an analytic f
/// the error falls geometrically with the number of points, as e^{−n·2πd/period} with d the distance of the nearest
/// singularity from the real axis. The error estimate is the last difference plus the rounding of the sum.
/// @throws QuadratureError if 2^20 points do not reach the tolerance
Estimate periodic_trapezoid(const Integrand& f, double start, double period, const Tolerance& tolerance);

}  // namespace lubjoint::oracle

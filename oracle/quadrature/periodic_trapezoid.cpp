#include "oracle/quadrature/periodic_trapezoid.hpp"

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/quadrature/gsl_call.hpp"

namespace lubjoint::oracle {

double periodic_trapezoid_sum(const Integrand& f, double start, double period, long points) {
  double sum = 0;
  for (long i = 0; i < points; ++i) sum += f(start + period * (static_cast<double>(i) / static_cast<double>(points)));
  return sum * period / static_cast<double>(points);
}

Estimate periodic_trapezoid(const Integrand& f, double start, double period, const Tolerance& tolerance) {
  constexpr double unit = std::numeric_limits<double>::epsilon();
  constexpr long first_points = 8;
  constexpr long most_points = 1L << 20;
  double sum = 0;
  double magnitude = 0;
  const auto add = [&](double turn) {
    const double term = f(start + period * turn);
    sum += term;
    magnitude += std::abs(term);
  };
  for (long i = 0; i < first_points; ++i) add(static_cast<double>(i) / first_points);

  Estimate answer{sum * period / first_points, std::abs(sum * period)};
  for (long points = 2 * first_points; points <= most_points; points *= 2) {
    const double count = static_cast<double>(points);
    for (long i = 1; i < points; i += 2) add(static_cast<double>(i) / count);
    const double value = sum * period / count;
    const double difference = std::abs(value - answer.value);
    const double rounding = 4 * unit * magnitude * std::abs(period) / count;
    answer = {value, difference + rounding};
    const double wanted = std::max({tolerance.absolute, tolerance.relative * std::abs(value), rounding});
    if (difference <= wanted || !std::isfinite(value)) {
      return checked(GSL_SUCCESS, {"periodic trapezoid", start, start + period, tolerance}, answer);
    }
  }
  return checked(GSL_ETOL, {"periodic trapezoid", start, start + period, tolerance}, answer);
}

}  // namespace lubjoint::oracle

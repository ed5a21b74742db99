#include "oracle/quadrature/gauss_legendre.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "oracle/quadrature/gsl_call.hpp"

namespace lubjoint::oracle {

namespace {

bool held_to_full_precision(std::size_t points) {
  constexpr std::array<std::size_t, 8> beyond_twenty = {32, 64, 96, 100, 128, 256, 512, 1024};
  return (points >= 1 && points <= 20) || std::ranges::find(beyond_twenty, points) != beyond_twenty.end();
}

struct Sum {
  double value = 0;
  double magnitude = 0;  ///< the same with |f|: what rounding is relative to
};

Sum weighted_sum(const GaussLegendreRule& rule, const Integrand& f, double from, double to) {
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  Sum sum;
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const double term = rule.weights()[i] * f(middle + half * rule.nodes()[i]);
    sum.value += term;
    sum.magnitude += std::abs(term);
  }
  return {half * sum.value, std::abs(half) * sum.magnitude};
}

}  // namespace

GaussLegendreRule::GaussLegendreRule(std::size_t points) {
  if (!held_to_full_precision(points)) {
    throw std::invalid_argument("points of the Gauss-Legendre rule is " + std::to_string(points) +
                                "; allowed are 1 to 20, 32, 64, 96, 100, 128, 256, 512, 1024");
  }
  disable_gsl_abort();
  const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> table(
      gsl_integration_glfixed_table_alloc(points), &gsl_integration_glfixed_table_free);
  if (!table) throw std::bad_alloc();
  nodes_.resize(points);
  weights_.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    gsl_integration_glfixed_point(-1, 1, i, &nodes_[i], &weights_[i], table.get());
  }
}

double GaussLegendreRule::integrate(const Integrand& f, double from, double to) const {
  return weighted_sum(*this, f, from, to).value;
}

const GaussLegendreRule& gauss_legendre_rung(std::size_t rung) {
  static const std::vector<GaussLegendreRule> rules(gauss_legendre_ladder.begin(), gauss_legendre_ladder.end());
  return rules.at(rung);
}

Estimate gauss_legendre(const Integrand& f, double from, double to, const Tolerance& tolerance) {
  constexpr double unit = std::numeric_limits<double>::epsilon();
  Sum coarse = weighted_sum(gauss_legendre_rung(0), f, from, to);
  Estimate answer{coarse.value, std::abs(coarse.value)};
  for (std::size_t rung = 1; rung < gauss_legendre_ladder.size(); ++rung) {
    const Sum fine = weighted_sum(gauss_legendre_rung(rung), f, from, to);
    const double difference = std::abs(fine.value - coarse.value);
    const double rounding = 4 * unit * fine.magnitude;
    answer = {fine.value, difference + rounding};
    const double wanted = std::max({tolerance.absolute, tolerance.relative * std::abs(fine.value), rounding});
    if (difference <= wanted || !std::isfinite(fine.value)) {
      return checked(GSL_SUCCESS, {"Gauss-Legendre", from, to, tolerance}, answer);
    }
    coarse = fine;
  }
  return checked(GSL_ETOL, {"Gauss-Legendre", from, to, tolerance}, answer);
}

}  // namespace lubjoint::oracle

#include "oracle/quadrature/gauss_legendre.hpp"

#include <algorithm>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

#include "oracle/quadrature/quadrature_error.hpp"

namespace lubjoint::oracle {

namespace {

constexpr std::size_t most_points = 1024;

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
  if (points < 1 || points > most_points) {
    throw std::invalid_argument("points of the Gauss-Legendre rule is " + std::to_string(points) +
                                "; allowed are 1 to " + std::to_string(most_points));
  }
  using Extended = long double;  // its rounding is lost in that of a double
  const int n = static_cast<int>(points);
  nodes_.resize(points);
  weights_.resize(points);
  const std::vector<Extended> zeros = boost::math::legendre_p_zeros<Extended>(n);  // of ½n of them, from 0 on
  const std::size_t first = points / 2;
  for (std::size_t k = 0; k < zeros.size(); ++k) {
    const Extended x = zeros[k];
    const Extended slope = boost::math::legendre_p_prime(n, x);
    // Next to the ends 1 − x² feels the rounding of x: by how much x is off, and what that does to (1 − x²) P'².
    const Extended off = boost::math::legendre_p(n, x) / slope;
    const Extended one_minus_square = (1 - x) * (1 + x);
    const Extended weighed = (one_minus_square - 2 * x * off) * slope * slope;
    const double weight = static_cast<double>(2 / weighed);
    nodes_[first + k] = static_cast<double>(x);
    nodes_[points - 1 - first - k] = -static_cast<double>(x);
    weights_[first + k] = weights_[points - 1 - first - k] = weight;
  }
}

double GaussLegendreRule::integrate(const Integrand& f, double from, double to) const {
  return weighted_sum(*this, f, from, to).value;
}

const GaussLegendreRule& gauss_legendre_rung(std::size_t rung) {
  // The upper rungs take milliseconds to make, and are hardly ever climbed.
  static std::array<std::once_flag, gauss_legendre_ladder.size()> made;
  static std::array<std::optional<GaussLegendreRule>, gauss_legendre_ladder.size()> rules;
  std::call_once(made.at(rung), [rung] { rules[rung].emplace(gauss_legendre_ladder[rung]); });
  return *rules[rung];
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
      return require_finite({"Gauss-Legendre", from, to, tolerance}, answer);
    }
    coarse = fine;
  }
  fail_before_tolerance({"Gauss-Legendre", from, to, tolerance}, answer);
}

}  // namespace lubjoint::oracle

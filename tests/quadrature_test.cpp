#include <gsl/gsl_errno.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "oracle/quadrature/adaptive.hpp"
#include "oracle/quadrature/gauss_legendre.hpp"
#include "oracle/quadrature/gsl_call.hpp"
#include "oracle/quadrature/periodic_trapezoid.hpp"

namespace quadrature_test {

using namespace lubjoint::oracle;
using Catch::Contains;
using std::numbers::pi;

namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();

using Rule = std::function<Estimate(const Integrand&, double, double, const Tolerance&)>;

struct NamedRule {
  std::string name;
  Rule integrate;
};

std::vector<NamedRule> rules_on_an_interval() {
  return {
      {"QAG",
       [](const auto& f, double a, double b, const auto& t) { return AdaptiveQuadrature().gauss_kronrod(f, a, b, t); }},
      {"QAGS",
       [](const auto& f, double a, double b, const auto& t) { return AdaptiveQuadrature().singular(f, a, b, t); }},
      {"QAGP",
       [](const auto& f, double a, double b, const auto& t) {
         return AdaptiveQuadrature().with_break_points(f, {a, 0.5 * (a + b), b}, t);
       }},
      {"CQUAD",
       [](const auto& f, double a, double b, const auto& t) { return DoublyAdaptiveQuadrature()(f, a, b, t); }},
      {"Gauss-Legendre", gauss_legendre},
  };
}

int code_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const QuadratureError& error) {
    return error.code();
  }
  return GSL_SUCCESS;
}

}  // namespace

TEST_CASE("every rule gives a smooth and a steep integral, each within its own error estimate") {
  struct Exact {
    std::function<double(double)> f;
    double from, to, value;
  };
  const double s = 0.05;  // width of the spike
  const std::vector<Exact> integrals = {
      {[](double x) { return std::exp(x); }, 0, 1, std::numbers::e - 1},
      {[](double x) { return std::cos(20 * x); }, 0, 2, std::sin(40.0) / 20},
      {[s](double x) { return 1 / (s * s + x * x); }, -1, 2, (std::atan(2 / s) + std::atan(1 / s)) / s},
  };
  for (const NamedRule& rule : rules_on_an_interval()) {
    for (const Exact& exact : integrals) {
      INFO(rule.name << ", value " << exact.value);
      const Estimate answer = rule.integrate(exact.f, exact.from, exact.to, {1e-10, 0});
      const double error = std::abs(answer.value - exact.value);
      CHECK(error <= answer.error + 2 * unit * std::abs(exact.value));  // rounding: of the exact value itself
      CHECK(error <= 1e-10 * std::abs(exact.value));                    // what was asked for
    }
  }
}

TEST_CASE("QAGS reaches an end-point singularity and QAGP an interior one that is named") {
  AdaptiveQuadrature adaptive;
  const Estimate root = adaptive.singular([](double x) { return 1 / std::sqrt(x); }, 0, 1, {1e-10, 0});
  CHECK(std::abs(root.value - 2) <= root.error);
  CHECK(std::abs(root.value - 2) <= 2e-10);  // the tolerance asked for
  const double third = 1.0 / 3;
  const auto kink = [third](double x) { return x == third ? 0 : 1 / std::sqrt(std::abs(x - third)); };
  const Estimate interior = adaptive.with_break_points(kink, {0, third, 1}, {1e-9, 0});
  const double exact = 2 * std::sqrt(third) + 2 * std::sqrt(1 - third);
  CHECK(std::abs(interior.value - exact) <= interior.error);
  CHECK(std::abs(interior.value - exact) <= 1e-9 * exact);  // the tolerance asked for
}

TEST_CASE("CQUAD integrates across a jump") {
  const auto jump = [](double x) { return x < 0.3 ? 1.0 : 2.0; };
  const Estimate answer = DoublyAdaptiveQuadrature()(jump, 0, 1, {1e-9, 0});
  CHECK(std::abs(answer.value - 1.7) <= answer.error + 2 * unit);  // rounding of 1.7
  CHECK(std::abs(answer.value - 1.7) <= 1.7e-9);                   // the tolerance asked for
}

TEST_CASE("n-point Gauss-Legendre is exact to degree 2n-1 and has the textbook error at 2n") {
  for (const std::size_t n : std::vector<std::size_t>{1, 2, 3, 5, 8, 12}) {
    const GaussLegendreRule rule(n);
    const auto power = [&](std::size_t degree) {
      return rule.integrate([degree](double x) { return std::pow(x, static_cast<double>(degree)); }, 0, 1);
    };
    for (std::size_t degree = 0; degree < 2 * n; ++degree) {
      INFO(n << " points, degree " << degree);
      CHECK(power(degree) == Approx(1.0 / static_cast<double>(degree + 1)).epsilon(8 * unit));  // rounding of n terms
    }
    // Error for x^2n on [0, 1]: (n!)^4/((2n+1) ((2n)!)^2).
    const double m = static_cast<double>(n);
    const double error = std::exp(4 * std::lgamma(m + 1) - 2 * std::lgamma(2 * m + 1)) / (2 * m + 1);
    INFO(n << " points, degree " << 2 * n);
    CHECK(1 / (2 * m + 1) - power(2 * n) == Approx(error).margin(4 * unit).epsilon(1e-12));  // rounding of lgamma
  }
}

TEST_CASE("places and weights of the rules are those of GSL's tables of more than twenty digits, rounded") {
  for (const std::size_t n : gauss_legendre_ladder) {
    INFO(n << " points");
    const GaussLegendreRule rule(n);
    const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> table(
        gsl_integration_glfixed_table_alloc(n), &gsl_integration_glfixed_table_free);
    for (std::size_t i = 0; i < n; ++i) {
      double x = 0, w = 0;
      gsl_integration_glfixed_point(-1, 1, i, &x, &w, table.get());
      CHECK(rule.nodes()[i] == x);
      CHECK(std::abs(rule.weights()[i] - w) <= 3 * unit * w);  // 1024 steps of a recurrence in long double: at most 2.2
    }
  }
}

TEST_CASE("composite two-point Gauss-Legendre converges with order 4") {
  const GaussLegendreRule rule(2);
  const auto error = [&](int panels) {
    double sum = 0;
    for (int i = 0; i < panels; ++i) {
      sum += rule.integrate([](double x) { return std::exp(x); }, double(i) / panels, double(i + 1) / panels);
    }
    return std::abs(sum - (std::numbers::e - 1));
  };
  const double order = std::log2(error(16) / error(32));
  CHECK(order == Approx(4).margin(0.01));  // discretisation: the next term of the error is (1/16)² of the first
}

TEST_CASE("the ladder's rules with up to 1024 points hold 16 digits") {
  for (std::size_t rung = 0; rung < gauss_legendre_ladder.size(); ++rung) {
    INFO(gauss_legendre_ladder[rung] << " points");
    const double value = gauss_legendre_rung(rung).integrate([](double x) { return std::exp(x); }, 0, 1);
    CHECK(value == Approx(std::numbers::e - 1).epsilon(8 * unit));  // rounding of a sum of up to 1024 terms
  }
}

TEST_CASE("the periodic trapezoid converges geometrically, at the rate that the nearest pole sets") {
  // ∫ dx/(1 − ε cos x) = 2π/√q; the n-point sum is that × (1 + 2ρⁿ/(1 − ρⁿ)), ρ = ε/(1 + √q).
  const double epsilon = 0.9;
  const double root_q = std::sqrt(1 - epsilon * epsilon);
  const double rho = epsilon / (1 + root_q);
  const double exact = 2 * pi / root_q;
  const auto f = [epsilon](double x) { return 1 / (1 - epsilon * std::cos(x)); };
  for (const long n : {4L, 8L, 16L, 32L}) {
    INFO(n << " points");
    const double r = std::pow(rho, static_cast<double>(n));
    const double predicted = exact * (1 + 2 * r / (1 - r));
    CHECK(periodic_trapezoid_sum(f, 0, 2 * pi, n) == Approx(predicted).epsilon(16 * unit));  // rounding of n terms
  }
  const Estimate answer = periodic_trapezoid(f, -pi, 2 * pi, {1e-13, 0});
  CHECK(std::abs(answer.value - exact) <= answer.error);
  CHECK(answer.error <= 1e-12 * exact);  // the tolerance asked for, and the rounding of the sum
}

TEST_CASE("a tolerance below rounding is answered with the error that rounding leaves") {
  for (const NamedRule& rule : rules_on_an_interval()) {
    INFO(rule.name);
    const Estimate answer = rule.integrate([](double x) { return std::exp(3 * x); }, 0, 1, {1.2e-14, 0});
    const double exact = std::expm1(3.0) / 3;
    CHECK(std::abs(answer.value - exact) <= answer.error);
    CHECK(answer.error <= 1e-12 * exact);  // rounding: GSL allows for 50 units of each panel's sum
  }
}

TEST_CASE("a failing rule throws with its name, the interval, the tolerance and the reason, and never aborts") {
  AdaptiveQuadrature two_intervals(2);
  const auto steep = [](double x) { return 1 / (1e-8 + x * x); };
  CHECK_THROWS_WITH(two_intervals.gauss_kronrod(steep, -1, 1, {1e-10, 0}),
                    Contains("QAG on [-1, 1]") && Contains("1e-10") && Contains("iterations"));
  CHECK(code_of([&] { two_intervals.gauss_kronrod(steep, -1, 1, {1e-10, 0}); }) == GSL_EMAXITER);
  const auto divergent = [](double x) { return 1 / x; };
  CHECK_THROWS_WITH(AdaptiveQuadrature().singular(divergent, 0, 1, {1e-10, 0}), Contains("QAGS on [0, 1]"));
  CHECK_THROWS_WITH(AdaptiveQuadrature().gauss_kronrod(steep, 0, 1, {0, 0}), Contains("tolerance"));
  CHECK(code_of([&] { AdaptiveQuadrature().gauss_kronrod(steep, 0, 1, {0, 0}); }) == GSL_EBADTOL);
  CHECK_THROWS_WITH(gauss_legendre(steep, -1, 1, {1e-10, 0}), Contains("Gauss-Legendre on [-1, 1]"));
  CHECK_THROWS_WITH(periodic_trapezoid([](double x) { return x; }, 0, 1, {1e-10, 0}), Contains("periodic trapezoid"));
  CHECK_THROWS_WITH(GaussLegendreRule(0), Contains("is 0") && Contains("1 to 1024"));
  CHECK_THROWS_WITH(GaussLegendreRule(1025), Contains("is 1025"));
  CHECK(code_of([&] { gauss_legendre(steep, -1, 1, {1e-10, 0}); }) == GSL_ETOL);
}

TEST_CASE("an integrand that is not finite is refused by every rule") {
  for (const NamedRule& rule : rules_on_an_interval()) {
    INFO(rule.name);
    const auto f = [](double) { return std::nan(""); };
    CHECK_THROWS_WITH(rule.integrate(f, 0, 1, {1e-10, 0}), Contains("not finite"));
  }
}

TEST_CASE("an exception of the integrand passes through GSL, and the workspace serves again with the same bits") {
  AdaptiveQuadrature adaptive;
  DoublyAdaptiveQuadrature cquad;
  const auto good = [](double x) { return 1 / (1e-4 + x * x); };
  const auto bad = [](double x) -> double { return x > 0.5 ? throw std::out_of_range("beyond a half") : x; };
  const double before = adaptive.gauss_kronrod(good, 0, 1, {1e-10, 0}).value;
  const double before_cquad = cquad(good, 0, 1, {1e-10, 0}).value;
  CHECK_THROWS_AS(adaptive.gauss_kronrod(bad, 0, 1, {1e-10, 0}), std::out_of_range);
  CHECK_THROWS_AS(adaptive.singular(bad, 0, 1, {1e-10, 0}), std::out_of_range);
  CHECK_THROWS_AS(cquad(bad, 0, 1, {1e-10, 0}), std::out_of_range);
  CHECK(adaptive.gauss_kronrod(good, 0, 1, {1e-10, 0}).value == before);
  CHECK(cquad(good, 0, 1, {1e-10, 0}).value == before_cquad);
}

TEST_CASE("a single place where the integrand is not finite is named, not left out") {
  const auto hole = [](double x) { return x == 0.5 ? std::nan("") : x; };
  CHECK_THROWS_WITH(DoublyAdaptiveQuadrature()(hole, 0, 1, {1e-10, 0}), Contains("CQUAD") && Contains("at 0.5"));
}

}  // namespace quadrature_test

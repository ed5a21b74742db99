// The arctangent and its remainder in double precision, against fifty digits.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>

#include "lubjoint/film/arc_series.hpp"
#include "lubjoint/number/dual.hpp"

namespace arc_series_test {

using namespace lubjoint;
using Exact = boost::multiprecision::cpp_bin_float_50;

namespace {

/// |given − exact| in units in the last place of the exact number.
double ulps(double given, const Exact& exact) {
  const int exponent = std::ilogb(static_cast<double>(exact));
  return static_cast<double>(abs(Exact(given) - exact)) / std::ldexp(1.0, exponent - 52);
}

}  // namespace

TEST_CASE("arc series: the angle above an axis is atan2, to three units in the last place") {
  double worst = 0;
  const auto see = [&worst](double y, double x) {
    worst = std::max(worst, ulps(detail::angle_above(y, x), atan2(Exact(y), Exact(x))));
  };
  for (int i = 1; i < 40000; ++i) {  // all directions, and beside the five that are taken off
    const double angle = pi<double>() * i / 40000;
    see(std::sin(angle), std::cos(angle));
  }
  for (const double near : {1e-3, 1e-8, 1e-15, 1e-200, 5e-324}) {
    for (const double x : {1.0, -1.0, 1e100, -1e100}) see(near, x);
    for (const double x : {near, -near, 0.0}) see(1.0, x);
    see(1.0, 1 + near);
    see(1 + near, -1.0);
  }
  // Roundings: of the quotient's parts, the quotient, the square, the cubic part, its sum and that with the direction,
  // the arctangent being at most a quarter of its scale there; 2.2 are seen.
  CHECK(worst <= 3);
}

TEST_CASE("arc series: the remainder of the arc is its series, to a few roundings") {
  double worst = 0;
  for (int i = 0; i <= 20000; ++i) {
    const double y = detail::largest_narrow * i / 20000;
    worst = std::max(worst, ulps(detail::arc_remainder(y), detail::arc_remainder(Exact(y))));
  }
  CHECK(worst <= 4);  // roundings of four sums and three products; 2.7 are seen
}

TEST_CASE("arc series: derivatives are those of the functions") {
  using D = Dual<double, 2>;
  for (const double y : {0.0, 0.1, 0.3, 0.49}) {
    // By differences of fifty digits; at y = 0 the series goes on to both sides.
    const Exact h("1e-20");
    const Exact slope = (detail::arc_remainder(Exact(Exact(y) + h)) - detail::arc_remainder(Exact(Exact(y) - h))) /
                        (2 * h);
    const double given = detail::arc_remainder(D::variable(y, 0)).derivatives()[0];
    CHECK(static_cast<double>(abs(Exact(given) - slope) / slope) <= 2e-15);  // ten roundings; the cut is 24²·4e-19
  }
  const D angle = detail::angle_above(D::variable(0.6, 0), D::variable(-0.8, 1));
  CHECK(angle.value() == detail::angle_above(0.6, -0.8));
  CHECK(angle.derivatives()[0] == Approx(-0.8).epsilon(1e-15));
  CHECK(angle.derivatives()[1] == Approx(-0.6).epsilon(1e-15));
}

}  // namespace arc_series_test

#include "lubjoint/film/pressure.hpp"

#include <catch2/catch.hpp>

#include "support/film_reference.hpp"

namespace pressure_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

using Big = FiftyDigits;
using BigState = PolarFilmState<Big>;

const Bearing<Big>& big_bearing() {
  static const Bearing<Big> same(bearing.length(), bearing.radius(), bearing.clearance());
  return same;
}
const Lubricant<Big>& big_oil() {
  static const Lubricant<Big> same(oil.viscosity());
  return same;
}

const double ratios[] = {0.0, 1e-300, 0.25, 0.75, 0.999};
const double motions[][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1.5, 0.75}, {-0.5, -2}};

/// 6μ/c² (a sinθ − 2b cosθ), minus the right-hand side of Reynolds' equation.
Big source(const BigState& s, const Big& theta) {
  const Big scale = 6 * big_oil().viscosity() / (big_bearing().clearance() * big_bearing().clearance());
  return scale * (s.slip_rate * sin(theta) - 2 * s.squeeze_rate * cos(theta));
}

Big cubed_thickness(const BigState& s, const Big& theta) {
  const Big h = 1 + s.eccentricity_ratio * cos(theta);
  return h * h * h;
}

Big source_scale(const BigState& s) {
  const Big scale = 6 * big_oil().viscosity() / (big_bearing().clearance() * big_bearing().clearance());
  return scale * (abs(s.slip_rate) + 2 * abs(s.squeeze_rate));
}

}  // namespace

TEST_CASE("short bearing: the pressure satisfies Reynolds' equation without its term in θ, and vanishes at the ends") {
  const Big half_length = big_bearing().length() / 2;
  for (const double epsilon : ratios) {
    for (const auto& [a, b] : motions) {
      const BigState s{Big(epsilon), Big(a), Big(b)};
      for (const double angle : {0.0, 0.7, 2.0, 3.1, 4.0, 6.0}) {
        const Big theta(angle);
        const auto p = [&](const Big& z) { return short_bearing_pressure(big_bearing(), big_oil(), s, theta, z); };
        const Big z = half_length / 3;
        const Big h = half_length / 8;  // a parabola in z: its second difference is exact for any step
        const Big residual = cubed_thickness(s, theta) * (p(z + h) - 2 * p(z) + p(z - h)) / (h * h) + source(s, theta);
        INFO("epsilon " << epsilon << ", a " << a << ", b " << b << ", theta " << angle);
        CHECK(static_cast<double>(abs(residual) / source_scale(s)) < 1e-40);  // 50 digits, less 1/(1 − ε)³ = 1e9
        CHECK(p(half_length) == 0);
        CHECK(p(Big(-half_length)) == 0);
      }
    }
  }
}

TEST_CASE("long bearing: the pressure satisfies Reynolds' equation without its term in z, and p(0) = p(2π) = 0") {
  const Big h("1e-12");
  for (const double epsilon : ratios) {
    for (const auto& [a, b] : motions) {
      const BigState s{Big(epsilon), Big(a), Big(b)};
      const auto p = [&](const Big& theta) { return long_bearing_pressure(big_bearing(), big_oil(), s, theta); };
      const Big r2 = big_bearing().radius() * big_bearing().radius();
      for (const double angle : {0.0, 0.7, 2.0, 3.1, 4.0, 6.0}) {
        const Big theta(angle);
        const Big ahead = cubed_thickness(s, theta + h / 2) * (p(theta + h) - p(theta));
        const Big behind = cubed_thickness(s, theta - h / 2) * (p(theta) - p(theta - h));
        const Big residual = (ahead - behind) / (h * h * r2) + source(s, theta);
        INFO("epsilon " << epsilon << ", a " << a << ", b " << b << ", theta " << angle);
        // h² = 1e-24 times fourth derivatives of H³p', which grow as (1 − ε)^{-3} near the minimum film: 1e9 at 0.999
        CHECK(static_cast<double>(abs(residual) / source_scale(s)) < 1e-13);
      }
      CHECK(p(Big(0)) == 0);
      const Big turn = 2 * boost::math::constants::pi<Big>();
      const Big size = 6 * big_oil().viscosity() * r2 / (big_bearing().clearance() * big_bearing().clearance());
      CHECK(static_cast<double>(abs(p(turn)) / size) < 1e-48);  // rounding of 2π in 50 digits
      CHECK(long_bearing_pressure(bearing, oil, PolarFilmState<double>(epsilon, a, b), 0.0) == 0);
    }
  }
}

TEST_CASE("at ε = 0 both pressures are finite and the limits ε → 0: nothing is divided by ε") {
  for (const auto& [a, b] : motions) {
    for (const double theta : {0.5, 2.0, 3.14, 5.0}) {
      INFO("a " << a << ", b " << b << ", theta " << theta);
      const PolarFilmState<double> centred(0, a, b);
      const PolarFilmState<double> nearly(1e-300, a, b);
      const double slenderness = bearing.radius() / bearing.clearance();
      const double scale = 6 * oil.viscosity() * slenderness * slenderness;
      const double limit = scale * (a * std::sin(theta) + 2 * b * (1 - std::cos(theta)));
      const double at_zero = long_bearing_pressure(bearing, oil, centred, theta);
      CHECK(std::abs(at_zero - limit) <= 10 * 0x1p-52 * scale * (std::abs(a) + 4 * std::abs(b)));  // rounding
      CHECK(long_bearing_pressure(bearing, oil, nearly, theta) == at_zero);
      CHECK(short_bearing_pressure(bearing, oil, nearly, theta, 0.0) ==
            short_bearing_pressure(bearing, oil, centred, theta, 0.0));
    }
  }
}

TEST_CASE("film thickness and pressure keep their digits in the thin film near θ = π, up to ε = 1 - 1e-15") {
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    const double epsilon = 1 - gap;
    for (const double away : {0.0, 1e-9, 1e-6, 1e-3, 0.1}) {
      const double theta = std::numbers::pi - away;
      for (const auto& [a, b] : {std::pair{0.0, 1.0}, {1.0, 0.5}, {0.0, -1.0}}) {
        INFO("1 - epsilon " << gap << ", pi - theta " << away << ", a " << a << ", b " << b);
        const PolarFilmState<double> s(epsilon, a, b);
        const BigState exact{Big(epsilon), Big(a), Big(b)};
        const Big big_theta(theta);
        const Big h = 1 + exact.eccentricity_ratio * cos(big_theta);
        // Seven roundings; θ is taken as the double it is, on both sides.
        CHECK(static_cast<double>(abs(relative_film_thickness(s, theta) / h - 1)) <= 6 * 0x1p-52);
        const Big p_short = short_bearing_pressure(big_bearing(), big_oil(), exact, big_theta, Big(0.003));
        const Big p_long = long_bearing_pressure(big_bearing(), big_oil(), exact, big_theta);
        const double of_short = short_bearing_pressure(bearing, oil, s, theta, 0.003);
        const double of_long = long_bearing_pressure(bearing, oil, s, theta);
        CHECK(static_cast<double>(abs(of_short / p_short - 1)) <= 40 * 0x1p-52);  // H³ triples the thickness's error
        CHECK(static_cast<double>(abs(of_long / p_long - 1)) <= 40 * 0x1p-52);    // the same, H²
      }
    }
  }
}

}  // namespace pressure_test

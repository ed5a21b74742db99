// The impedance of the short film, in its own literature's terms, is short_dynamic.
#include <catch2/catch.hpp>

#include "support/film_reference.hpp"
#include "support/printed_value.hpp"

namespace impedance_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Vec50 = Vector2<FiftyDigits>;

namespace {

Vec50 vector(double x, double y) { return Vec50(FiftyDigits(x), FiftyDigits(y)); }

/// Capone's form of the short cavitating film: with G = ∫dφ/(1 − x cosφ − y sinφ) over |φ| < π/2 and w = q + x²,
///   I_nn = [(q + 3x²)G + 6x]/(2q²),  I_nt = y[3xG + 4 + 2x²/w]/(2q²),  F = −|u|(I_nn n + I_nt n⊥).
Vec50 capone(const Vec50& e, const Vec50& u) {
  const FiftyDigits speed = u.norm();
  const Vec50 n = u / speed;
  const Vec50 across = perpendicular(n);
  const FiftyDigits x = e.dot(n);
  const FiftyDigits y = e.dot(across);
  const FiftyDigits q = 1 - e.dot(e);
  const FiftyDigits w = q + x * x;
  const FiftyDigits g = 2 / sqrt(q) * atan2(FiftyDigits(sqrt(q)), FiftyDigits(-x));
  const FiftyDigits along = ((q + 3 * x * x) * g + 6 * x) / (2 * q * q);
  const FiftyDigits aside = y * (3 * x * g + 4 + 2 * x * x / w) / (2 * q * q);
  return -speed * (along * n + aside * across);
}

}  // namespace

TEST_CASE("short_dynamic has every printed digit of the short film's impedance") {
  struct Row {
    Vec50 e, u;
    const char* x;
    const char* y;
  };
  for (const Row& row : {Row{vector(0.25, -0.5), vector(0.75, 2), "-1.6844963907772313149", "-1.3076537795227558619"},
                         Row{vector(0, 0.984375), vector(1, 1), "-573.58422899697854620", "-54524.685989626737724"},
                         Row{vector(0, 0.984375), vector(0.5, -1), "-0.46590821938348051692", "0.23922679118471409705"},
                         Row{vector(0.875, 0.25), vector(-1, 0.5), "0.2839288277051189178", "-1.0916088142699196587"},
                         Row{vector(0.5, 0), vector(0, 1), "-1.7777777777777777778", "-2.4183991523122904675"}}) {
    const Vec50 force = force_ratio<ShortDynamic>(FilmState<FiftyDigits>(row.e, row.u));
    INFO(row.x << ", " << row.y);
    CHECK(units_of_last_digit(FiftyDigits(force.x()), row.x) <= 0.51);  // the digits there, rounded
    CHECK(units_of_last_digit(FiftyDigits(force.y()), row.y) <= 0.51);  // the same
  }
}

TEST_CASE("Capone's form of the short cavitating film is short_dynamic") {
  RandomStates random(1991);
  for (int i = 0; i < 300; ++i) {
    const PolarFilmState<double> state = random();
    if (state.eccentricity_ratio > 0.99) continue;  // it cancels there
    const FilmState<FiftyDigits> film = in_fifty_digits(state).in_own_frame();
    if (is_zero(film.velocity)) continue;
    const Vec50 force = force_ratio<ShortDynamic>(film);
    const FiftyDigits apart = (capone(film.eccentricity, film.velocity) - force).norm() / force.norm();
    CHECK(static_cast<double>(apart) <= 1e-38);  // 50 digits, less what an opening film cancels in it: q⁻²·…
  }
}

}  // namespace impedance_test

#include <catch2/catch.hpp>
#include <random>

#include "support/film_reference.hpp"

namespace film_state_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

using Vec = Vector2<double>;

FiftyDigits exact_q(double x, double y) { return 1 - FiftyDigits(x) * x - FiftyDigits(y) * y; }

double relative_error(double q, const FiftyDigits& exact) { return static_cast<double>(abs(q - exact) / exact); }

/// A motion as an observer sees it who is turned by an angle and turns with a spin.
JournalMotion<double> seen_turning(const JournalMotion<double>& m, double angle, double spin) {
  const auto turned = [&](const Vec& v) {
    return Vec(std::cos(angle) * v.x() - std::sin(angle) * v.y(), std::sin(angle) * v.x() + std::cos(angle) * v.y());
  };
  const Vec e = turned(m.eccentricity);
  return {e, Vec(turned(m.velocity) + spin * perpendicular(e)), m.bearing_spin + spin, m.journal_spin + spin};
}

}  // namespace

TEST_CASE("q = 1 - ε² is correctly rounded in polar form, up to the last double below 1") {
  for (int k = 1; k <= 53; ++k) {
    for (const double below : {1 - std::ldexp(1.0, -k), 1 - 0.7 * std::ldexp(1.0, -k)}) {
      if (below >= 1) continue;
      INFO("1 - epsilon " << 1 - below);
      CHECK(relative_error(PolarFilmState<double>(below, 0, 0).q, exact_q(below, 0)) <= 0x1p-53);  // half an ulp
      const long double longer = PolarFilmState<long double>(static_cast<long double>(below), 0, 0).q;
      const FiftyDigits exact = exact_q(below, 0);
      CHECK(static_cast<double>(abs(FiftyDigits(longer) - exact) / exact) <= 0x1p-64);  // the same
    }
  }
}

TEST_CASE("q = 1 - ê·ê keeps its digits near ε = 1 in every direction of e") {
  std::mt19937_64 random(20090331);
  const auto part = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  int checked = 0;
  for (int i = 0; i < 40000; ++i) {
    // Every fourth on the diagonal, where both squares are near ½ and neither difference from 1 is exact.
    const double angle = i % 4 == 0 ? std::numbers::pi / 4 * (1 + std::pow(10, -10 * part() - 1)) : 6.3 * part();
    const double radius = 1 - std::pow(10, -15 * part());
    const double x = radius * std::cos(angle);
    const double y = radius * std::sin(angle);
    const FiftyDigits exact = exact_q(x, y);
    if (exact <= 0) continue;
    ++checked;
    const double error = relative_error(FilmState<double>(Vec(x, y), Vec(0, 0)).q, exact);
    if (error <= 0x1p-51) continue;  // three roundings of numbers up to 2q
    INFO("x " << x << ", y " << y << ", q " << exact);
    CHECK(error <= 0x1p-51);  // as above
  }
  CHECK(checked > 30000);
}

TEST_CASE("a state at or beyond the wall, or not a number, is refused with its numbers and what is allowed") {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double epsilon : {1.0, 1.5, -0.25, nan, infinity}) {
    CHECK_THROWS_WITH(PolarFilmState<double>(epsilon, 1, 1), Contains("eccentricity_ratio") && Contains("[0, 1)"));
    CHECK_THROWS_AS(PolarFilmState<double>(epsilon, 1, 1), FilmDomainError);
  }
  CHECK_THROWS_WITH(PolarFilmState<double>(1.25, 1, 1), Contains("1.25"));
  CHECK_THROWS_WITH(PolarFilmState<double>(0.5, nan, 1), Contains("slip_rate nan"));
  CHECK_THROWS_WITH(PolarFilmState<double>(0.5, 1, -infinity), Contains("squeeze_rate -inf"));
  for (const Vec& e : {Vec(1, 0), Vec(0, -1), Vec(0.6, 0.8000001), Vec(0.8, 0.8), Vec(nan, 0), Vec(0, infinity)}) {
    CHECK_THROWS_WITH(FilmState<double>(e, Vec(0, 0)), Contains("no film") && Contains("[0, 1)"));
    CHECK_THROWS_AS(FilmState<double>(e, Vec(0, 0)), FilmDomainError);
  }
  CHECK_THROWS_WITH(FilmState<double>(Vec(0.75, 0.75), Vec(0, 0)), Contains("(0.75, 0.75)"));
  CHECK_THROWS_AS(FilmState<double>(Vec(0, 0), Vec(nan, 0)), FilmDomainError);
  CHECK_THROWS_AS(FilmState<double>(Vec(0, 0), Vec(0, infinity)), FilmDomainError);
  CHECK_NOTHROW(FilmState<double>(Vec(0.6, std::nextafter(0.8, 0.0)), Vec(1, 1)));
  const JournalMotion<double> outside{Vec(2.5e-4, 0), Vec(0, 0), 0, 1};
  CHECK_THROWS_AS(film_state(outside, 2e-4), FilmDomainError);
}

TEST_CASE("polar view: ε, b along e, a = -2u·t across it, also where |e| is 1e-300") {
  for (const double epsilon : {1e-300, 1e-160, 1e-8, 0.5, 0.99}) {
    for (int i = 0; i < 12; ++i) {
      const double angle = 0.1 + i * std::numbers::pi / 6;
      const Vec r(std::cos(angle), std::sin(angle));
      const Vec u = 0.75 * r - 1.25 * perpendicular(r);
      const PolarView<double> view = polar_view(FilmState<double>(Vec(epsilon * r), u));
      INFO("epsilon " << epsilon << ", angle " << angle);
      const double rounding = 8 * 0x1p-52;  // some roundings of numbers of order 1
      CHECK((view.radial - r).norm() <= rounding);
      CHECK(std::abs(view.state.eccentricity_ratio / epsilon - 1) <= rounding);
      CHECK(std::abs(view.state.squeeze_rate - 0.75) <= rounding);
      CHECK(std::abs(view.state.slip_rate - 2.5) <= rounding);
    }
  }
}

TEST_CASE("polar view at e = 0 looks along u: all squeeze, no wedge") {
  const PolarView<double> view = polar_view(FilmState<double>(Vec(0, 0), Vec(-3, 4)));
  CHECK(view.state.eccentricity_ratio == 0);
  CHECK(view.state.slip_rate == 0);
  CHECK(view.state.squeeze_rate == Approx(5).epsilon(1e-15));   // rounding
  CHECK((view.radial - Vec(-0.6, 0.8)).norm() <= 4 * 0x1p-52);  // rounding
  const PolarFilmState<double> polar(0.5, 2.5, 0.75);
  const PolarView<double> back = polar_view(polar.in_own_frame());
  CHECK(back.state.eccentricity_ratio == 0.5);
  CHECK(back.state.slip_rate == 2.5);
  CHECK(back.state.squeeze_rate == 0.75);
}

TEST_CASE("a and b of a motion are ε(ω_J + ω_B) - 2(v·t)/c and (v·r)/c") {
  const double c = 2e-4;
  const JournalMotion<double> m{Vec(0.9e-4, -1.2e-4), Vec(3e-3, 1e-3), 7, 52};
  const Vec r(0.6, -0.8);
  const PolarFilmState<double> state = polar_view(film_state(m, c)).state;
  CHECK(state.eccentricity_ratio == Approx(0.75).epsilon(1e-14));             // rounding
  CHECK(state.squeeze_rate == Approx(m.velocity.dot(r) / c).epsilon(1e-14));  // rounding
  const double slip = 0.75 * 59 - 2 * m.velocity.dot(perpendicular(r)) / c;
  CHECK(state.slip_rate == Approx(slip).epsilon(1e-13));  // rounding, and the two terms cancel in part
}

TEST_CASE("ε, a and b do not depend on how the observer is turned, nor on how he turns") {
  const double c = 2e-4;
  const JournalMotion<double> m{Vec(0.9e-4, -1.2e-4), Vec(3e-3, 1e-3), 7, 52};
  const PolarFilmState<double> at_rest = polar_view(film_state(m, c)).state;
  for (const double angle : {0.0, 1.0, 2.5, -2.0}) {
    for (const double spin : {0.0, 30.0, -400.0}) {
      INFO("angle " << angle << ", spin " << spin);
      const PolarFilmState<double> seen = polar_view(film_state(seen_turning(m, angle, spin), c)).state;
      const double rounding = 20 * 0x1p-52 * (60 + std::abs(spin));  // of ε(ω_J + ω_B), which the spin enters
      CHECK(std::abs(seen.eccentricity_ratio - at_rest.eccentricity_ratio) <= 20 * 0x1p-52);  // rounding
      CHECK(std::abs(seen.slip_rate - at_rest.slip_rate) <= rounding);
      CHECK(std::abs(seen.squeeze_rate - at_rest.squeeze_rate) <= rounding);
    }
  }
}

}  // namespace film_state_test

#include <catch2/catch.hpp>
#include <numbers>

#include "lubjoint/film/extent.hpp"
#include "lubjoint/number/dual.hpp"

namespace film_bounds_test {

using namespace lubjoint;

namespace {
constexpr double half_turn = std::numbers::pi;
}

TEST_CASE("the dynamic film begins at atan2(2b, a), between -π and π, and is half a turn long") {
  struct Case {
    double a, b, start;
  };
  for (const Case& c : {Case{1, 0, 0}, Case{0, 1, half_turn / 2}, Case{0, -1, -half_turn / 2}, Case{-1, 0, half_turn},
                        Case{2, 1, half_turn / 4}, Case{-2, 1, 3 * half_turn / 4}, Case{-2, -1, -3 * half_turn / 4}}) {
    const FilmBounds<double> film = film_bounds(FilmExtent::dynamic, PolarFilmState<double>(0.5, c.a, c.b));
    INFO("a " << c.a << ", b " << c.b);
    CHECK(film.start == Approx(c.start).margin(1e-15));            // rounding of atan2
    CHECK(film.end == Approx(c.start + half_turn).margin(1e-15));  // the same: the end is not reduced
  }
}

TEST_CASE("the dynamic film is where a sinθ - 2b cosθ is positive") {
  for (int i = 0; i < 32; ++i) {
    const double a = 2 * std::cos(0.2 * i);
    const double b = std::sin(0.2 * i);
    const FilmBounds<double> film = film_bounds(FilmExtent::dynamic, PolarFilmState<double>(0.3, a, b));
    const auto source = [&](double theta) { return a * std::sin(theta) - 2 * b * std::cos(theta); };
    INFO("a " << a << ", b " << b);
    CHECK(source(film.start + 1e-6) > 0);
    CHECK(source(film.end - 1e-6) > 0);
    CHECK(source((film.start + film.end) / 2) > 0);
    CHECK(source(film.start - 1e-6) < 0);
    CHECK(source(film.end + 1e-6) < 0);
  }
}

TEST_CASE("at rest the dynamic film is 0 to π, in double and with derivatives that are numbers") {
  const FilmBounds<double> film = film_bounds(FilmExtent::dynamic, PolarFilmState<double>(0.5, 0, 0));
  CHECK(film.start == 0);
  CHECK(film.end == half_turn);
  using T = Dual<double, 2>;
  const PolarFilmState<T> rest(T(0.5), T::variable(0, 0), T::variable(0, 1));
  const FilmBounds<T> dual = film_bounds(FilmExtent::dynamic, rest);
  CHECK(dual.start.value() == 0);
  CHECK(dual.end.value() == half_turn);
}

TEST_CASE("the full film is 0 to 2π, the half film 0 to π for a ≥ 0 and π to 2π for a < 0, whatever b") {
  for (const double b : {-1.0, 0.0, 1.0}) {
    for (const double a : {-1.0, -1e-300, -0.0, 0.0, 1e-300, 1.0}) {
      INFO("a " << a << ", b " << b);
      const PolarFilmState<double> state(0.5, a, b);
      const FilmBounds<double> full = film_bounds(FilmExtent::full, state);
      CHECK(full.start == 0);
      CHECK(full.end == 2 * half_turn);
      const FilmBounds<double> half = film_bounds(FilmExtent::half, state);
      CHECK(half.start == (a < 0 ? half_turn : 0));
      CHECK(half.end == (a < 0 ? 2 * half_turn : half_turn));
    }
  }
}

TEST_CASE("the side of a half film is the same in polar and in vector form") {
  for (int i = 0; i < 24; ++i) {
    const Vector2<double> e(0.5 * std::cos(0.3 * i), 0.5 * std::sin(0.3 * i));
    const Vector2<double> u(1, -0.4);
    const FilmState<double> film(e, u);
    CHECK(side_of(film) == side_of(polar_view(film).state));
  }
  const FilmState<double> radial(Vector2<double>(0.25, 0.5), Vector2<double>(1, 2));
  CHECK(side_of(radial) == HalfFilmSide::converging);  // a = 0 counts as a ≥ 0
}

}  // namespace film_bounds_test

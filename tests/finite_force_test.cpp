// The finite-length film as a function of the film's state: what laws and programs are held against.
#include "oracle/reynolds/finite_force.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

namespace finite_force_test {

using namespace lubjoint;
using namespace lubjoint::oracle;
using Vec = Vector2<double>;

namespace {

constexpr std::array<FiniteFilm, 4> films = {FiniteFilm::finite_full, FiniteFilm::finite_half,
                                             FiniteFilm::finite_dynamic, FiniteFilm::finite_reynolds};
const FilmState<double> sliding(Vec(0.36, 0.48), Vec(1.5, -0.5));

/// ê and u turned by the angle of cosine 0.6 and sine 0.8.
Vec turned(const Vec& v) { return {0.6 * v.x() - 0.8 * v.y(), 0.8 * v.x() + 0.6 * v.y()}; }

}  // namespace

TEST_CASE("finite force: it is the force of a bearing with dimensions over its scale") {
  const Bearing<double> bearing(0.03, 0.02, 1e-4);  // L/D = 3/4
  const Lubricant<double> oil(0.04);
  const double scale = force_scale(BearingLimit::long_bearing, bearing, oil);
  const Vec r(0.6, 0.8);
  for (const FiniteFilm film : films) {
    INFO(name_of(film));
    const FiniteForce force = finite_force(film, 0.75, sliding);
    const FiniteLengthResult polar = finite_length_force(film, bearing, oil, polar_view(sliding).state);
    const Vec expected = (polar.radial * r + polar.tangential * perpendicular(r)) / scale;
    CHECK((force.ratio - expected).norm() < 1e-13 * expected.norm());  // rounding of the dimensions
    CHECK(force.error == Approx(std::hypot(polar.radial_error, polar.tangential_error) / scale).epsilon(1e-9));
    CHECK(force.tolerance_met == polar.tolerance_met);
  }
}

TEST_CASE("finite force: turned with its state, homogeneous in u, zero at rest, isotropic at the centre") {
  for (const FiniteFilm film : films) {
    INFO(name_of(film));
    const Vec force = finite_force(film, 1, sliding).ratio;
    // Rounding of the turned state, through the grid's choice of its free boundary in a cavitated film.
    const double rounding = (film == FiniteFilm::finite_reynolds ? 1e-6 : 1e-11) * force.norm();
    const FilmState<double> other(turned(sliding.eccentricity), turned(sliding.velocity));
    CHECK((finite_force(film, 1, other).ratio - turned(force)).norm() < rounding);
    const FilmState<double> fast(sliding.eccentricity, Vec(1024 * sliding.velocity));
    CHECK((finite_force(film, 1, fast).ratio - 1024 * force).norm() < 1024 * rounding);
    const FilmState<double> rest(sliding.eccentricity, Vec(0, 0));
    CHECK(finite_force(film, 1, rest).ratio == Vec(0, 0));
    CHECK(std::isinf(finite_force(film, 1, rest).relative_error()));
    const FiniteForce centre = finite_force(film, 1, FilmState<double>(Vec(0, 0), sliding.velocity));
    CHECK(std::abs(cross(centre.ratio, sliding.velocity)) <= centre.error * sliding.velocity.norm() + 1e-12);
    CHECK(dot(centre.ratio, sliding.velocity) < 0);
  }
}

TEST_CASE("finite force: its error is a bound, which a bearing of another shape exceeds") {
  for (const FiniteFilm film : {FiniteFilm::finite_full, FiniteFilm::finite_half, FiniteFilm::finite_dynamic}) {
    INFO(name_of(film));
    const FiniteForce series = finite_force(film, 0.5, sliding, {1e-8, {}, SmoothFilmMethod::axial_series});
    const FiniteForce modes = finite_force(film, 0.5, sliding, {1e-8, {}, SmoothFilmMethod::circumferential_modes});
    CHECK((series.ratio - modes.ratio).norm() <= series.error + modes.error);
    CHECK(series.relative_error() < 1e-8);
    const FiniteForce other = finite_force(film, 0.5001, sliding, {1e-8, {}, SmoothFilmMethod::circumferential_modes});
    CHECK((series.ratio - other.ratio).norm() > series.error + other.error);
  }
  const FiniteForce coarse = finite_force(FiniteFilm::finite_reynolds, 0.5, sliding, {1e-2});
  const FiniteForce fine = finite_force(FiniteFilm::finite_reynolds, 0.5, sliding, {1e-4});
  CHECK((coarse.ratio - fine.ratio).norm() <= coarse.error + fine.error);
  CHECK(fine.error < coarse.error);
  const FiniteForce longer = finite_force(FiniteFilm::finite_reynolds, 0.51, sliding, {1e-4});
  CHECK((longer.ratio - fine.ratio).norm() > longer.error + fine.error);
}

TEST_CASE("finite force: a bearing without length, and a tolerance that no solver has, are refused by name") {
  for (const double shape : std::array<double, 4>{0.0, -1.0, INFINITY, NAN}) {
    CHECK_THROWS_WITH(finite_force(FiniteFilm::finite_full, shape, sliding), Catch::Contains("length over diameter"));
  }
  CHECK_THROWS_WITH(finite_force(FiniteFilm::finite_full, 1, sliding, {1.0}), Catch::Contains("relative_tolerance"));
}

}  // namespace finite_force_test

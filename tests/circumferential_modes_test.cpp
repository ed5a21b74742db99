// The finite-length film by separation along the axis, against the axial cosine series and against printed values.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "oracle/reynolds/finite_length.hpp"

namespace circumferential_modes_test {

using namespace lubjoint;
using namespace lubjoint::oracle;

namespace {

constexpr std::array<FiniteFilm, 3> smooth_films{FiniteFilm::finite_full, FiniteFilm::finite_half,
                                                 FiniteFilm::finite_dynamic};
constexpr double radius = 0.01;
constexpr double clearance = 1e-5;
const Lubricant<double> oil(0.01);

FiniteLengthResult solve(FiniteFilm film, double length_to_diameter, const PolarFilmState<double>& state,
                         double tolerance, SmoothFilmMethod method) {
  const Bearing<double> bearing(2 * radius * length_to_diameter, radius, clearance);
  return finite_length_force(film, bearing, oil, state, {tolerance, FilmOnset::free, method});
}

double size(const FiniteLengthResult& force) { return std::hypot(force.radial, force.tangential); }
double error(const FiniteLengthResult& force) { return std::hypot(force.radial_error, force.tangential_error); }
double distance(const FiniteLengthResult& one, const FiniteLengthResult& other) {
  return std::hypot(one.radial - other.radial, one.tangential - other.tangential);
}

struct RandomStates {
  std::mt19937 random{20240611};
  std::uniform_real_distribution<double> uniform{0, 1};
  double length_to_diameter = 1;

  /// ε evenly up to a limit, u in any direction, L/D from 0.1 to 5.
  PolarFilmState<double> next(double limit) {
    const double direction = 2 * std::numbers::pi * uniform(random);
    length_to_diameter = std::pow(10, -1 + 1.7 * uniform(random));
    return {limit * uniform(random), 2 * std::sin(direction), std::cos(direction)};
  }
};

}  // namespace

TEST_CASE("finite length: two solvers that share no step agree within their estimates") {
  RandomStates states;
  double worst_estimate = 0;
  for (const FiniteFilm film : smooth_films) {
    for (int n = 0; n < 60; ++n) {
      const auto state = states.next(0.99);
      const double shape = states.length_to_diameter;
      const auto series = solve(film, shape, state, 1e-9, SmoothFilmMethod::axial_series);
      const auto modes = solve(film, shape, state, 1e-9, SmoothFilmMethod::circumferential_modes);
      INFO(name_of(film) << ", L/D " << shape << ", eccentricity ratio " << state.eccentricity_ratio << ", a "
                         << state.slip_rate << ", b " << state.squeeze_rate);
      CHECK(distance(series, modes) <= error(series) + error(modes));  // the solvers' own estimates
      worst_estimate = std::max(worst_estimate, error(modes) / size(modes));
      // A bearing longer by a millionth is not the same to either.
      const auto longer = solve(film, shape * (1 + 1e-6), state, 1e-9, SmoothFilmMethod::circumferential_modes);
      CHECK(distance(series, longer) > error(series) + error(longer));
    }
  }
  CHECK(worst_estimate < 1e-8);  // the tolerance asked for, and what corners of a half film leave
}

TEST_CASE("finite length: separation along the axis contains its error in its estimate, coarse or fine") {
  RandomStates states;
  for (const FiniteFilm film : smooth_films) {
    for (int n = 0; n < 40; ++n) {
      const auto state = states.next(0.999);
      const double shape = states.length_to_diameter;
      const auto coarse = solve(film, shape, state, 1e-3, SmoothFilmMethod::circumferential_modes);
      const auto fine = solve(film, shape, state, 1e-9, SmoothFilmMethod::axial_series);
      INFO(name_of(film) << ", L/D " << shape << ", eccentricity ratio " << state.eccentricity_ratio << ", a "
                         << state.slip_rate << ", b " << state.squeeze_rate);
      CHECK(distance(coarse, fine) <= error(coarse) + error(fine));
    }
  }
}

TEST_CASE("finite length: separation along the axis gives the values that a third program printed") {
  // In units of μLR³/c², to the digits printed: an axial series in Sommerfeld's angle, written elsewhere.
  const auto in_units = [](double length_to_diameter) {
    return oil.viscosity() * 2 * radius * length_to_diameter * std::pow(radius, 3) / (clearance * clearance);
  };
  const auto modes = SmoothFilmMethod::circumferential_modes;
  const auto dynamic = solve(FiniteFilm::finite_dynamic, 2.03125, {0.5, 1, 0}, 1e-11, modes);
  CHECK(dynamic.radial / in_units(2.03125) == Approx(-2.34760358874).epsilon(1e-11));     // the last digit printed
  CHECK(dynamic.tangential / in_units(2.03125) == Approx(5.59418509897).epsilon(1e-11));  // the same
  const auto full = solve(FiniteFilm::finite_full, 1, {0.5, 0, 1}, 1e-11, modes);
  CHECK(full.radial / in_units(1) == Approx(-20.7969090995).epsilon(1e-11));  // the same
}

}  // namespace circumferential_modes_test

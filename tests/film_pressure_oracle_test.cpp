#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "lubjoint/film/pressure.hpp"
#include "oracle/quadrature/adaptive.hpp"
#include "oracle/quadrature/gauss_legendre.hpp"
#include "support/film_reference.hpp"

namespace film_pressure_oracle_test {

using namespace lubjoint;
using namespace lubjoint::oracle;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

constexpr double half_turn = std::numbers::pi;

const std::vector<PolarFilmState<double>>& sample_states() {
  static const std::vector<PolarFilmState<double>> states = {{0.0, 1, 0.5},    {0.3, 1, 0.25},    {0.6, -1, 0.25},
                                                             {0.8, 0.5, -0.5}, {0.9, -0.2, -1.0}, {0.95, 0, 1}};
  return states;
}

}  // namespace

TEST_CASE("the force is the integral of the oracle's own pressure over the film, in θ and z") {
  AdaptiveQuadrature adaptive;
  const GaussLegendreRule across(2);  // exact in z: the short pressure is a parabola, the long one constant
  const double half_length = bearing.length() / 2;
  for (const OneDimensionalFilmEntry& film : one_dimensional_films) {
    for (const PolarFilmState<double>& state : sample_states()) {
      const FilmForceEstimate force = film_force_by_quadrature(film.film, bearing, oil, state);
      const auto line_pressure = [&](double theta) {
        const auto at = [&](double z) {
          return film_pressure_by_quadrature(film.film, bearing, oil, state, theta, z).value;
        };
        return across.integrate(at, -half_length, half_length);
      };
      const double size = std::hypot(force.radial.value, force.tangential.value);
      const Tolerance tolerance{0, 1e-9 * size / bearing.radius()};
      const auto component = [&](double phase) {
        const auto f = [&](double theta) { return line_pressure(theta) * std::cos(theta - phase); };
        const double middle = std::clamp(half_turn, force.theta_s, force.theta_e);
        const double inner = adaptive.gauss_kronrod(f, force.theta_s, middle, tolerance).value;
        const double outer =
            middle < force.theta_e ? adaptive.gauss_kronrod(f, middle, force.theta_e, tolerance).value : 0;
        return bearing.radius() * (inner + outer);
      };
      INFO(film.name << ", epsilon " << state.eccentricity_ratio << ", b " << state.squeeze_rate);
      CHECK(component(0) == Approx(force.radial.value).margin(4e-9 * size));  // the tolerance of two parts
      CHECK(component(half_turn / 2) == Approx(force.tangential.value).margin(4e-9 * size));  // the same
    }
  }
}

TEST_CASE("where the pressure has a closed form, oracle and library give the same field") {
  for (const PolarFilmState<double>& state : sample_states()) {
    for (int i = 0; i <= 60; ++i) {
      const double theta = i * half_turn / 30;
      const double z = 0.3 * bearing.length();
      const Estimate p_short =
          film_pressure_by_quadrature(OneDimensionalFilm::short_full, bearing, oil, state, theta, z);
      const Estimate p_long = film_pressure_by_quadrature(OneDimensionalFilm::long_full, bearing, oil, state, theta);
      const double h = relative_film_thickness(state, theta);
      // Rounding of θ near π: 4e-16 of an angle over which H³ changes by 3/H of itself.
      const double scale = oil.viscosity() * std::pow(bearing.radius() / bearing.clearance(), 2);
      const double rounding = 1e-14 * 100 * scale / (h * h * h * h);
      CHECK(short_bearing_pressure(bearing, oil, state, theta, z) == Approx(p_short.value).margin(rounding));
      CHECK(long_bearing_pressure(bearing, oil, state, theta) == Approx(p_long.value).margin(rounding));
    }
  }
}

TEST_CASE("the pressure of a dynamic film is positive inside, zero at both ends and outside, in every image of θ") {
  for (const auto film : {OneDimensionalFilm::short_dynamic, OneDimensionalFilm::long_dynamic}) {
    for (const PolarFilmState<double>& state : sample_states()) {
      const FilmForceEstimate bounds = film_force_by_quadrature(film, bearing, oil, state);
      const auto p = [&](double theta) { return film_pressure_by_quadrature(film, bearing, oil, state, theta).value; };
      double largest = 0;
      for (int i = 1; i < 100; ++i) {
        const double theta = bounds.theta_s + i * 0.01 * half_turn;
        largest = std::max(largest, p(theta));
        CHECK(p(theta) > 0);
        CHECK(p(theta + 2 * half_turn) ==
              Approx(p(theta)).epsilon(1e-12));  // rounding of θ + 2π, over the thinnest film
        CHECK(p(theta + half_turn) == 0);
      }
      CHECK(std::abs(p(bounds.theta_s)) <= 1e-12 * largest);  // rounding of the edge, over the thinnest film
      CHECK(std::abs(p(bounds.theta_e)) <= 1e-12 * largest);  // the same
    }
  }
}

TEST_CASE("the published long half film has p = 0 at π, eq. 5 cut at π has not") {
  const PolarFilmState<double> state(0.6, 1, 0.5);
  const auto p = [&](OneDimensionalFilm film, double theta) {
    return film_pressure_by_quadrature(film, bearing, oil, state, theta).value;
  };
  const double typical = p(OneDimensionalFilm::long_half, 0.75 * half_turn);
  CHECK(std::abs(p(OneDimensionalFilm::long_half, half_turn)) <= 1e-12 * typical);  // rounding
  CHECK(p(OneDimensionalFilm::long_half_eq5, half_turn) > typical);
}

TEST_CASE("a place outside the bearing has no pressure to ask for") {
  CHECK_THROWS_WITH(film_pressure_by_quadrature(OneDimensionalFilm::short_full, bearing, oil, {0.5, 1, 0}, 1.0, 0.03),
                    Contains("z is 0.03") && Contains("0.02"));
}

}  // namespace film_pressure_oracle_test

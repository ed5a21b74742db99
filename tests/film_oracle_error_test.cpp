#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "support/film_reference.hpp"

namespace film_oracle_error_test {

using namespace lubjoint;
using namespace lubjoint::oracle;
using namespace lubjoint::test;

namespace {

/// How true errors compare with their estimates over many states.
struct Tally {
  int states = 0;
  int outside = 0;            ///< states with a component beyond its estimate
  double worst_ratio = 0;     ///< true error over estimate
  double worst_relative = 0;  ///< error over |F|, where the estimate does not show a cancellation

  void add(const FilmForceEstimate& force, const TrueError& error) {
    ++states;
    const bool inside = error.radial <= force.radial.error && error.tangential <= force.tangential.error;
    if (!inside) ++outside;
    if (error.radial > 0) worst_ratio = std::max(worst_ratio, error.radial / force.radial.error);
    if (error.tangential > 0) worst_ratio = std::max(worst_ratio, error.tangential / force.tangential.error);
    const double estimate = std::hypot(force.radial.error, force.tangential.error);
    const double relative = std::hypot(error.radial, error.tangential) / error.size;
    if (estimate <= 1e-12 * error.size) worst_relative = std::max(worst_relative, relative);
  }
};

Tally tally_of(const OneDimensionalFilmEntry& film, const FilmQuadratureOptions& options, int states) {
  RandomStates random_state(20240607);
  Tally tally;
  for (int i = 0; i < states; ++i) {
    const PolarFilmState<double> state = random_state();
    const FilmForceEstimate force = film_force_by_quadrature(film.film, bearing, oil, state, options);
    tally.add(force, true_error(force, reference_force(film.name, in_fifty_digits(state))));
  }
  return tally;
}

}  // namespace

TEST_CASE("the oracle's error estimates are honest: 10,000 random states of each film against 50 digits") {
  for (const OneDimensionalFilmEntry& film : one_dimensional_films) {
    const Tally tally = tally_of(film, {}, 10000);
    INFO(film.name << ": outside " << tally.outside << ", worst ratio " << tally.worst_ratio
                   << ", worst error over |F| " << tally.worst_relative);
    CHECK(tally.states == 10000);
    CHECK(tally.outside <= tally.states / 1000);  // the promise: inside in 99.9 % of states
    CHECK(tally.worst_ratio <= 10);               // the promise: never more than 10 times the estimate
    CHECK(tally.worst_relative <= 1e-12);         // the promise for |F|
  }
}

TEST_CASE("the other rules' error estimates are honest at a tolerance of 1e-10") {
  for (const OneDimensionalFilmEntry& film : one_dimensional_films) {
    for (const auto rule : {FilmQuadratureRule::gauss_legendre, FilmQuadratureRule::qag, FilmQuadratureRule::qags,
                            FilmQuadratureRule::qagp, FilmQuadratureRule::cquad}) {
      const Tally tally = tally_of(film, {rule, 1e-10}, 1000);
      INFO(film.name << ", " << film_quadrature_rule_names[static_cast<std::size_t>(rule)] << ": outside "
                     << tally.outside << ", worst ratio " << tally.worst_ratio);
      CHECK(tally.outside <= tally.states / 1000);  // the promise: inside in 99.9 % of states
      CHECK(tally.worst_ratio <= 10);               // the promise: never more than 10 times the estimate
    }
  }
}

}  // namespace film_oracle_error_test

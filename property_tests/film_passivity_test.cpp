#include <rapidcheck/catch.h>

#include <catch2/catch.hpp>

#include "generators.hpp"
#include "support/law_property.hpp"

namespace film_passivity_test {

using namespace lubjoint;
using generate::Vec;

namespace {

/// F·u over |F||u|.
template <FilmLaw Law>
double cosine_of_power(const FilmState<double>& film) {
  const Vec force = force_ratio<Law>(film);
  return force.dot(film.velocity) / (force.norm() * film.velocity.norm());
}

}  // namespace

// Why, by law. In polar form F·u = F_r b − F_t a/2 is a quadratic form in b and |a|.
// Full films: both squares have negative coefficients and there is no product.
// short_half: half of that, and the product −(2ε/q²)|a|b; 4ε²/q⁴ is less than 4·π²(1 + 2ε²)/(16q⁴).
// long_half, long_half_eq5: the product has 24ε/(Dq), and 12ε/(Dq) + 12/((1 + ε)q). Over 2√ of the product of the
// squares' coefficients that is at most 0.77, and 0.65 (ε → 1): long_half_eq5 is passive too, though its force is
// turned. short_dynamic: −F·u is |u|²W, an integral of a square. long_dynamic: a variance. pinkus_sternlicht: for s =
// ê·u ≥ 0 all terms of 4Ks + 3πφs² + 2πφq|u|² are positive; for s = −σ|u| < 0 the sum times t/K is |u|²(2πq − 4√q σ +
// (3π − 6)σ²), whose discriminant 16 − 8π(3π − 6) is negative.
TEST_CASE("in the frame of the mean spin every law takes energy from the journal: F·u ≤ 0") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("F·u < 0 for u ≠ 0"), [] {
      const FilmState<double> film = (*generate::film()).in_own_frame();
      RC_ASSERT(cosine_of_power<Law>(film) < 0);
    });
  });
}

TEST_CASE("F·u < 0 on a fine grid of ε and direction: every law, to ε = 1 - 1e-9") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    double worst = -1;
    for (int k = 0; k <= 90; ++k) {
      const double epsilon = 1 - std::pow(10.0, -0.1 * k);
      for (int i = 0; i < 720; ++i) {
        const double turn = 2 * std::numbers::pi * i / 720;
        const PolarFilmState<double> state(epsilon, 2 * std::cos(turn), std::sin(turn));
        worst = std::max(worst, cosine_of_power<Law>(state.in_own_frame()));
      }
    }
    CHECK(worst < 0);
  });
}

TEST_CASE("in the inertial frame no law is passive: counterexample, whirl slower than half the spin is driven") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    const double mean_spin = 25;
    const Vec e(0.25, 0);
    const Vec v(0, 0.25 * 10);  // a circle at 10 rad/s, in clearances
    const Vec u = v - mean_spin * perpendicular(e);
    CHECK(force_ratio<Law>(FilmState<double>(e, u)).dot(v) > 0);
  });
}

}  // namespace film_passivity_test

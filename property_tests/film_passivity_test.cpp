#include <rapidcheck/catch.h>

#include <catch2/catch.hpp>

#include "generators.hpp"

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

// Proofs, by law. In polar form F·u = F_r b − F_t a/2 is a quadratic form in b and |a|.
// Full films: both squares have negative coefficients and there is no product.
// short_half: half of that, and the product −(3ε/q²)|a|b: its square 9ε²/q⁴ stays below 4·π²(1+2ε²)/(16q⁴) for ε < 1.
// long_half, long_half_eq5: the same with 24ε/(Dq) and 12ε/(Dq) + 12/((1+ε)q): √q times the product stays below
// 2√(coefficients) by a fifth at least, over all ε; long_half_eq5 is passive too, though its force at e = 0 is turned.
// short_dynamic: −F·u is W ≥ 0, an integral of a square. long_dynamic: a variance.
// pinkus_sternlicht: with s = ê·u, −F·u is (6S/(Dq^{3/2}))[4Ks + 3πφs² + 2πφq|u|²], K = √q|u|, φ ≥ ½ for b < 0.
TEST_CASE("in the frame of the mean spin every law takes energy from the journal: F·u ≤ 0") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop("F·u < 0 for u ≠ 0", [] {
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

#include <rapidcheck/catch.h>

#include <catch2/catch.hpp>

#include "generators.hpp"
#include "support/law_property.hpp"

namespace film_limits_test {

using namespace lubjoint;
using generate::Vec;

namespace {

double apart(const PolarForce<double>& f, const PolarForce<double>& g) {
  return std::hypot(f.radial - g.radial, f.tangential - g.tangential);
}
double size(const PolarForce<double>& f) { return std::hypot(f.radial, f.tangential); }

/// ∂(F_r, F_t)/∂b.
template <FilmLaw Law>
Vec slope_in_squeeze(double epsilon, double a, double b) {
  using T = Dual<double, 1>;
  const PolarForce<T> ratio = polar_force_ratio<Law>(PolarFilmState<T>(T(epsilon), T(a), T::variable(b, 0)));
  return Vec(ratio.radial.derivatives()(0), ratio.tangential.derivatives()(0));
}

}  // namespace

TEST_CASE("as ε → 0 the force of every law tends to its value at ε = 0 in the same frame") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("|F(ε) - F(0)| ≤ 60 ε |F(0)|"), [] {
      const double epsilon = *generate::log_uniform(-14, -3);
      const auto rates = *generate::rates();
      const PolarForce<double> near = polar_force_ratio<Law>(generate::polar_state(epsilon, rates));
      const PolarForce<double> centre = polar_force_ratio<Law>(generate::polar_state(0, rates));
      RC_ASSERT(apart(near, centre) <= 60 * epsilon * size(centre));  // first order in ε: slopes of up to 24/(π − 8/π)
    });
  });
}

TEST_CASE("at e = 0 the laws that are isotropic there answer any velocity with the same damping, the others do not") {
  const auto answer = []<FilmLaw Law>(double turn) {
    // Frame r at the given angle from u: what a journal feels that leaves the centre along r.
    return polar_force_ratio<Law>(PolarFilmState<double>(0, -2 * std::sin(turn), std::cos(turn)));
  };
  rc::prop("F = -k u", [&] {
    const double turn = *generate::angle();
    const auto is_damping = [&](const PolarForce<double>& f, double k) {
      return apart(f, {-k * std::cos(turn), -k * std::sin(turn)}) <= 20 * 0x1p-52 * k;  // rounding
    };
    constexpr double half_turn = std::numbers::pi;
    RC_ASSERT(is_damping(answer.operator()<ShortFull>(turn), half_turn));
    RC_ASSERT(is_damping(answer.operator()<ShortHalf>(turn), half_turn / 2));
    RC_ASSERT(is_damping(answer.operator()<ShortDynamic>(turn), half_turn / 2));
    RC_ASSERT(is_damping(answer.operator()<LongFull>(turn), 12 * half_turn));
    RC_ASSERT(is_damping(answer.operator()<LongDynamic>(turn), 6 * half_turn));
    RC_ASSERT(is_damping(answer.operator()<PinkusSternlicht>(turn), 6 * half_turn));
  });
  // Counterexamples: radial and tangential velocity, published half film; a tangential force for a radial velocity.
  const double radial = -polar_force_ratio<LongHalf>(PolarFilmState<double>(0, 0, 1)).radial;
  const double tangential = polar_force_ratio<LongHalf>(PolarFilmState<double>(0, 2, 0)).tangential;
  CHECK(radial == Approx(6 * (std::numbers::pi - 8 / std::numbers::pi)).epsilon(1e-15));  // rounding
  CHECK(tangential == Approx(6 * std::numbers::pi).epsilon(1e-15));                       // rounding
  CHECK(polar_force_ratio<LongHalfEq5>(PolarFilmState<double>(0, 0, 1)).tangential == 24);
}

TEST_CASE("as b → 0 from either side the force of every law tends to that at b = 0") {
  for_each_film_law([]<class Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("|F(b) - F(0)| ≤ K |b|, b = ±10^-k"), [] {
      const double epsilon = *generate::moderate_ratio();
      const double a = *rc::gen::element(2.0, -2.0);
      const double b = *rc::gen::element(1.0, -1.0) * *generate::log_uniform(-14, -4);
      const PolarForce<double> beside = polar_force_ratio<Law>(PolarFilmState<double>(epsilon, a, b));
      const PolarForce<double> on = polar_force_ratio<Law>(PolarFilmState<double>(epsilon, a, 0));
      // First order in b, squeeze over wedge: at most 20/q for ε ≤ 0.95; and rounding of the angle of the film.
      RC_ASSERT(apart(beside, on) <= (200 * std::abs(b) + 1e-14) * size(on));
    });
  });
}

TEST_CASE("with b = 0 Pinkus and Sternlicht's film and the exact dynamic films are the half films' wedge") {
  rc::prop("F(ε, a, 0) of a dynamic film = F(ε, a, 0) of the half film", [] {
    const double epsilon = *generate::moderate_ratio();
    const double a = *rc::gen::element(2.0, -2.0);
    const PolarFilmState<double> wedge(epsilon, a, 0);
    const PolarForce<double> long_half = polar_force_ratio<LongHalf>(wedge);
    const PolarForce<double> short_half = polar_force_ratio<ShortHalf>(wedge);
    const double rounding = 40 * 0x1p-52;  // a dozen operations on either side, moments included
    RC_ASSERT(apart(polar_force_ratio<PinkusSternlicht>(wedge), long_half) <= rounding * size(long_half));
    RC_ASSERT(apart(polar_force_ratio<LongDynamic>(wedge), long_half) <= rounding * size(long_half));
    RC_ASSERT(apart(polar_force_ratio<ShortDynamic>(wedge), short_half) <= rounding * size(short_half));
  });
}

TEST_CASE("the dynamic laws and Pinkus and Sternlicht's are once continuously differentiable across b = 0") {
  const auto smooth = []<FilmLaw Law>() {
    INFO(Law::name);
    rc::prop(of_law<Law>("∂F/∂b at b = +10^-k and -10^-k differ by O(10^-k)"), [] {
      const double epsilon = *generate::moderate_ratio();
      const double a = *rc::gen::element(2.0, -2.0);
      const double b = *generate::log_uniform(-10, -4);
      const Vec above = slope_in_squeeze<Law>(epsilon, a, b);
      const Vec below = slope_in_squeeze<Law>(epsilon, a, -b);
      RC_ASSERT((above - below).norm() <=
                1000 * b * above.norm() + 1e-12 * above.norm());  // second derivative; rounding
    });
  };
  smooth.operator()<PinkusSternlicht>();
  smooth.operator()<ShortDynamic>();
  smooth.operator()<LongDynamic>();
}

TEST_CASE(
    "the half films jump at a = 0 by twice the tangential force of their squeeze: they are not continuous there") {
  rc::prop("F_t(a = 0) - F_t(a → 0-) = 2 F_t(a = 0)", [] {
    const double epsilon = *generate::moderate_ratio();
    const double b = *rc::gen::element(1.0, -1.0);
    const auto jumps = [&]<FilmLaw Law>() {
      const double on = polar_force_ratio<Law>(PolarFilmState<double>(epsilon, 0, b)).tangential;
      const double below = polar_force_ratio<Law>(PolarFilmState<double>(epsilon, -1e-200, b)).tangential;
      return on - below == 2 * on && on * b > 0;
    };
    RC_ASSERT(jumps.operator()<ShortHalf>());
    RC_ASSERT(jumps.operator()<LongHalf>());
    RC_ASSERT(jumps.operator()<LongHalfEq5>());
  });
}

}  // namespace film_limits_test

#include "oracle/verify/states/film_terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/verify/states/dynamic_film.hpp"
#include "oracle/verify/states/solved_films.hpp"

namespace lubjoint::verify {

namespace {

constexpr Real turn_half = boost::math::constants::pi<Real>();

Real root_of_q(const Solution& s) { return std::sqrt(s.q()); }

/// Of a half film: where a < 0, it is on the other side.
Real side(const Solution& s) { return s.mirrors_half && s.a < 0 ? -1 : 1; }

void short_full(Solution& s) {
  const Real q = s.q();
  s.radial_squeeze = -turn_half * s.b * (1 + 2 * s.ratio * s.ratio) / (q * q * root_of_q(s));
  s.tangential_wedge = turn_half * s.a / (2 * q * root_of_q(s));
}

void short_half(Solution& s) {
  const Real q = s.q();
  s.radial_wedge = -side(s) * s.ratio * s.a / (q * q);
  s.radial_squeeze = -turn_half * s.b * (1 + 2 * s.ratio * s.ratio) / (2 * q * q * root_of_q(s));
  s.tangential_wedge = turn_half * s.a / (4 * q * root_of_q(s));
  s.tangential_squeeze = side(s) * 2 * s.ratio * s.b / (q * q);
}

void long_full(Solution& s) {
  s.radial_squeeze = -12 * turn_half * s.b / (s.q() * root_of_q(s));
  s.tangential_wedge = 12 * turn_half * s.a / (s.d() * root_of_q(s));
}

void long_half_wedge(Solution& s) {
  s.radial_wedge = -side(s) * 12 * s.ratio * s.a / (s.d() * s.q());
  s.tangential_wedge = 6 * turn_half * s.a / (s.d() * root_of_q(s));
}

void long_half(Solution& s) {
  long_half_wedge(s);
  s.radial_squeeze = -6 * s.b / (s.q() * root_of_q(s)) * (turn_half - 16 / (turn_half * s.d()));
  s.tangential_squeeze = side(s) * 24 * s.ratio * s.b / (s.d() * s.q());
}

void long_half_eq5(Solution& s) {
  long_half_wedge(s);
  s.radial_squeeze = -6 * turn_half * s.b / (s.q() * root_of_q(s));
  s.tangential_squeeze = side(s) * 24 * s.b / ((1 + s.ratio) * s.q());
}

/// Not a sum of a wedge and a squeeze: the film's ends depend on both.
template <auto by_quadrature>
void dynamic(Solution& s) {
  const DynamicForce f = by_quadrature(DynamicFilm{s.ratio, s.ratio_gap, s.a, s.b});
  s.radial_wedge = f.radial;
  s.tangential_wedge = f.tangential;
}

void pinkus_sternlicht(Solution& s) {
  const Real q = s.q();
  const Real k = std::sqrt(q * (s.a * s.a / 4 + s.b * s.b));
  const Real big_b = s.ratio * std::abs(s.b);
  const Real phi = k + big_b == 0 ? 1 : (k + (s.b >= 0 ? 3 * big_b : 0)) / (k + 1.5L * big_b);
  s.radial_wedge = -24 * s.ratio * k / (s.d() * q * root_of_q(s));
  s.radial_squeeze = -6 * turn_half * s.b * phi / (q * root_of_q(s));
  s.tangential_wedge = 6 * turn_half * s.a * phi / (s.d() * root_of_q(s));
}

Real nothing_hidden(const Solution&) { return 0; }

// 3π/q^{5/2} bounds the short film's integrals; the long film's are larger than its force by up to 1/q^{3/2}.
Real hidden_in_short_dynamic(const Solution& s) {
  return 3 * turn_half * (std::abs(s.a) + 2 * std::abs(s.b)) / (s.q() * s.q() * root_of_q(s));
}
Real hidden_in_long_dynamic(const Solution& s) {
  return 12 * turn_half * (std::abs(s.a) + 2 * std::abs(s.b)) / (s.q() * s.q() * s.q());
}
/// Of the bracket's two terms the second.
Real hidden_in_long_half(const Solution& s) { return std::abs(96 * s.b / (turn_half * s.d() * s.q() * root_of_q(s))); }

struct Formula {
  std::string_view law;
  void (*find)(Solution&);
  Real (*hidden)(const Solution&);  ///< size of what the terms are made of and does not show in them, over S
};

constexpr Formula formulas[] = {
    {"short_full", short_full, nothing_hidden},
    {"short_half", short_half, nothing_hidden},
    {"short_dynamic", dynamic<short_dynamic_by_quadrature>, hidden_in_short_dynamic},
    {"long_full", long_full, nothing_hidden},
    {"long_half", long_half, hidden_in_long_half},
    {"long_half_eq5", long_half_eq5, nothing_hidden},
    {"long_dynamic", dynamic<long_dynamic_by_quadrature>, hidden_in_long_dynamic},
    {"pinkus_sternlicht", pinkus_sternlicht, nothing_hidden},
    // The films above without their wedge: a is 0.
    {"squeeze_long_full", long_full, nothing_hidden},
    {"squeeze_short_full", short_full, nothing_hidden},
    {"squeeze_long", dynamic<long_dynamic_by_quadrature>, hidden_in_long_dynamic},
    {"squeeze_short", dynamic<short_dynamic_by_quadrature>, hidden_in_short_dynamic},
};

/// By the law's place; a law without a formula here does not compile.
constexpr auto formula_of_law = [] {
  std::array<Formula, law_count> ordered{};
  for (std::size_t i = 0; i < law_count; ++i) {
    const auto* found = std::find_if(std::begin(formulas), std::end(formulas),
                                     [&](const Formula& each) { return each.law == law_names[i]; });
    if (found == std::end(formulas)) throw std::logic_error("verify has no formula of a law");
    ordered[i] = *found;
  }
  return ordered;
}();

}  // namespace

void find_terms(Solution& s) {
  if (!(s.q() > 0) || !std::isfinite(s.a) || !std::isfinite(s.b)) {
    s.radial_wedge = s.tangential_wedge = std::numeric_limits<Real>::quiet_NaN();
    return;
  }
  if (is_solved_film(s.law)) {
    const Real pull = s.pull();
    s.moving = s.films->force(s.law, s.shape, s.ratio, pull * s.a, pull * s.b);
    s.radial_wedge = pull * s.moving.radial;
    s.tangential_wedge = pull * s.moving.tangential;
    return;
  }
  formula_of_law[s.law.place].find(s);
}

Real size_of_film_terms(const Solution& s) {
  return std::abs(s.radial_wedge) + std::abs(s.radial_squeeze) + std::abs(s.tangential_wedge) +
         std::abs(s.tangential_squeeze) + (is_solved_film(s.law) ? 0 : formula_of_law[s.law.place].hidden(s));
}

}  // namespace lubjoint::verify

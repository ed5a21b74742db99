// Mobility: the velocity for a force, of full films; determinants of half films; what Booker's closed form is.

#include <stdexcept>

#include "oracle/proofs/laws.hpp"
#include "oracle/proofs/ledger.hpp"

namespace lubjoint::proofs {

namespace {

const char* const group = "mobility";

/// u = −factor [weight q F + 3(ê⊥·F) ê⊥].
Planar full_mobility(const FreeState& free, const Planar& force, const ex& factor, int weight) {
  const Planar across = turned_90(free.state.e_hat);
  return -factor * (weight * pow(free.state.s, 2) * force + 3 * dot(across, force) * across);
}

/// u = −factor [F − 3(ê·F)ê/denominator], which cancels as ε → 1.
Planar published_mobility(const FreeState& free, const Planar& force, const ex& factor, const ex& denominator) {
  return -factor * (force - 3 * dot(free.state.e_hat, force) / denominator * free.state.e_hat);
}

struct FullFilm {
  std::string law;
  ex growth;     ///< 1 + 2ε² or D
  ex factor;     ///< of full_mobility
  ex published;  ///< of published_mobility
  int weight;    ///< 1 or 2
};

FullFilm short_film(const FreeState& free) {
  const ex growth = 1 + 2 * free.state.e_e;
  const ex published = pow(free.state.s, 3) / Pi;
  return {"short full", growth, published / growth, published, 1};
}

FullFilm long_film(const FreeState& free) {
  const ex d = 2 + free.state.e_e;
  const ex factor = free.state.s / (24 * Pi);
  return {"long full", d, factor, factor * d, 2};
}

Planar force_of(const std::string& name, const PlaneState& state) {
  for (const Law& law : laws()) {
    if (law.name == name) return law.vector(state);
  }
  throw std::logic_error("no such law: " + name);
}

/// F(ê, M(f)) = f, and M is the published form, and symmetric: M = −½∇Ψ, Ψ = −M·f.
void inverse(Proof& proof, FullFilm (*film_of)(const FreeState&), int weight_change) {
  const FreeState free;
  const FullFilm film = film_of(free);
  const symbol f_x("f_x"), f_y("f_y");
  const Planar f{f_x, f_y};
  const Planar u = full_mobility(free, f, film.factor, film.weight + weight_change);
  equal(proof, free.algebra, force_of(film.law, free.state.with(free.state.e_hat, u)), f);
  equal(proof, free.algebra, u, published_mobility(free, f, film.published, film.growth));
  proof.equal(free.algebra, u.x.diff(f_y), u.y.diff(f_x));
}

/// F_r and sgn(a)F_t are linear in |a| and b on each side; the determinant is the same on both, and not 0.
void half_is_regular(Proof& proof, Polar (*law)(), const ex& determinant, const ex& polynomial) {
  const auto& [a, b, sigma, eps] = std::tie(sym().a, sym().b, sym().sigma, sym().eps);
  const Polar f = law();
  const symbol w("w");
  const ex by_abs_a_radial = sigma * f.radial.diff(a);
  const ex by_abs_a_across = sigma * sigma * f.tangential.diff(a);
  const ex by_b_radial = f.radial.diff(b);
  const ex by_b_across = sigma * f.tangential.diff(b);
  proof.equal(film_algebra(), by_abs_a_radial * by_b_across - by_abs_a_across * by_b_radial, determinant * polynomial);
  proof.positive(polynomial.subs(Pi == 3 + w).expand(), {w, eps});
}

/// M∥ = (1 − ξ)^{5/2}/π and M⊥ = −4η(1 − ξ)^{3/2}/π². At ê = 0 the film gives F = −½πu: M∥ = 2/π over F, and
/// u = |F|/2 M in Booker's unit.
void booker_at_the_centre(Proof& proof) {
  const FreeState free;
  const ex resistance = short_dynamic(0, 0, 1, Pi / 2).along;
  proof.equal(Algebra(), 1 / resistance, 2 / Pi);
  proof.zero(Algebra(), short_dynamic(0, 0, 1, Pi / 2).across);
}

/// M⊥ = ½(η∂_ξ − ξ∂_η)M∥ with 1 − ξ = g²: `coefficient` is that of η g³ in M⊥.
void is_potential_pair(Proof& proof, const ex& coefficient) {
  const symbol g("g"), eta("eta");
  // ∂_ξ = −(1/(2g)) ∂_g
  const ex along = pow(g, 5) / Pi;
  proof.equal(Algebra(), eta * (-along.diff(g) / (2 * g)) / 2, coefficient * eta * pow(g, 3));
}

}  // namespace

std::vector<Statement> mobility_statements() {
  using enum Expectation;
  const ex e = sym().eps, p = Pi, qq = q(), d = d_factor();
  std::vector<Statement> all;
  all.push_back({group, "short full: u = -(q^(3/2)/(pi (1 + 2 eps^2))) [q F + 3 (e^perp.F) e^perp] carries F",
                 "eqs. 6, 7", holds, [](Proof& proof) { inverse(proof, short_film, 0); },
                 "nothing cancels as eps -> 1, as it does in F - 3 (e.F) e/(1 + 2 eps^2)"});
  all.push_back({group, "long full: u = -(sqrt(q)/(24 pi)) [2q F + 3 (e^perp.F) e^perp] carries F", "eqs. 10, 11",
                 holds, [](Proof& proof) { inverse(proof, long_film, 0); }, "likewise"});
  all.push_back({group, "short half: on each side of a = 0 one (|a|, b) for a force", "eqs. 8, 9", holds,
                 [=](Proof& proof) {
                   half_is_regular(proof, short_half, 1 / (8 * pow(qq, 4)), p * p * (1 + 2 * e * e) - 16 * e * e);
                 },
                 "it is an answer only if |a| >= 0: no velocity, one, or two"});
  all.push_back({group, "long half: on each side of a = 0 one (|a|, b) for a force", "eqs. 12, 13", holds,
                 [=](Proof& proof) { half_is_regular(proof, long_half, 36 / (d * qq * qq), p * p - 8); }, "likewise"});
  all.push_back({group, "long half of eq. 5: on each side of a = 0 one (|a|, b) for a force", "eq. 5", holds,
                 [=](Proof& proof) {
                   half_is_regular(proof, long_half_eq5, 36 / (d * qq * qq * (1 + e)), p * p * (1 + e) - 8 * e);
                 },
                 "likewise"});
  all.push_back(
      {group, "short dynamic at the centre: u = -2F/(pi S)", "exact dynamic film", holds, booker_at_the_centre});
  all.push_back({group, "a potential pair with Booker's M1 = (1 - xi)^(5/2)/pi has M2 = -(5/(4 pi)) eta (1 - xi)^(3/2)",
                 "M2 = M1'/2", holds, [=](Proof& proof) { is_potential_pair(proof, -5 / (4 * p)); }});
  all.push_back({group, "Booker's pair, M2 = -(4/pi^2) eta (1 - xi)^(3/2), comes from one potential",
                 "Booker's closed form of the short mobility", not_an_identity,
                 [=](Proof& proof) { is_potential_pair(proof, -4 / (p * p)); },
                 "5/(4 pi) = 0.39789 against 4/pi^2 = 0.40528: 1.9 %"});
  all.push_back({group, "WRONG: short full: u with 2q F", "eqs. 6, 7 altered", wrong,
                 [](Proof& proof) { inverse(proof, short_film, 1); }});
  return all;
}

}  // namespace lubjoint::proofs

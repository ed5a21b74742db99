// Films of the squeeze alone: a = 0, the film where the pressure is positive, or the whole of it.
//
// The film that closes lies on π/2…3π/2, the one that opens on −π/2…π/2. With δ = ψ(π/2) = arccos ε (cosψ = ε, sinψ = s
// there) their ends are ψ = δ, 2π − δ and −δ, δ.

#include "oracle/proofs/ledger.hpp"
#include "oracle/proofs/long_film.hpp"

namespace lubjoint::proofs {

namespace {

const char* const group = "squeeze films";

enum class Motion { closes, opens };

std::pair<FilmEnd, FilmEnd> ends(Motion motion) {
  const ex& delta = sym().delta;
  if (motion == Motion::closes) return {{0, 1, delta}, {0, -1, 2 * Pi - delta}};
  return {{0, -1, -delta}, {0, 1, delta}};
}

ex without_wedge(const ex& f) { return f.subs(sym().a == 0); }

/// The published bracket with arccos ε for an opening film, π − arccos ε for a closing one, and the sign of ε.
Polar short_claimed(const ex& arc, int sign) {
  const auto& [eps, s, b] = std::tie(sym().eps, sym().s, sym().b);
  return {-b / pow(s, 4) * ((1 + 2 * pow(eps, 2)) * arc / s + sign * 3 * eps), 0};
}
Polar long_claimed(const ex& arc, int sign) {
  const auto& [eps, s, b] = std::tie(sym().eps, sym().s, sym().b);
  return {-12 * b / pow(s, 3) * (arc + sign * eps * s), 0};
}
Polar claimed(Polar (*law)(const ex&, int), Motion motion) {
  return motion == Motion::closes ? law(Pi - sym().delta, 1) : law(sym().delta, -1);
}

/// cosψ and sinψ at the ends are those of the angle that stands for them.
void ends_are_quarters(Proof& proof) {
  const auto& [eps, s] = std::tie(sym().eps, sym().s);
  proof.equal(film_algebra(), cos_psi_of(0), eps);
  proof.equal(film_algebra(), sin_psi_of(0, 1), s);
  proof.equal(film_algebra(), sin_psi_of(0, -1), -s);
}

void short_film(Proof& proof, Motion motion, const Polar& force) {
  const ex profile = without_wedge(short_profile());
  const ex& theta = sym().theta;
  const auto [from, to] = ends(motion);
  prove_force(proof, profile, {antiderivative(profile * cos(theta)), antiderivative(profile * sin(theta))}, from, to,
              frac(1, 2), force);
}

void long_film(Proof& proof, Motion motion, const Polar& force) {
  const auto [from, to] = ends(motion);
  const LongFilm film = long_film_between(from, to);
  const ex pressure = without_wedge(film.pressure);
  prove_force(proof, pressure,
              antiderivatives_of_force(pressure, long_slope(without_wedge(film.constant)).subs(sym().a == 0)), from, to,
              6, force);
}

void both_are_the_full_film(Proof& proof) {
  const Algebra algebra = film_algebra();
  equal(proof, algebra, claimed(short_claimed, Motion::closes) + claimed(short_claimed, Motion::opens),
        short_full().subs({{sym().a, 0}}));
  equal(proof, algebra, claimed(long_claimed, Motion::closes) + claimed(long_claimed, Motion::opens),
        long_full().subs({{sym().a, 0}}));
}

/// ê = εr and u = br: e₁ = ε or −ε, e₂ = 0, and the force is −b times the resistance along u.
void dynamic_without_wedge(Proof& proof) {
  const auto& [eps, s, b, delta] = std::tie(sym().eps, sym().s, sym().b, sym().delta);
  const Algebra algebra = film_algebra();
  proof.equal(algebra, claimed(short_claimed, Motion::closes).radial, -b * short_dynamic(eps, 0, s, Pi - delta).along);
  proof.equal(algebra, claimed(short_claimed, Motion::opens).radial, -b * short_dynamic(-eps, 0, s, delta).along);
  proof.equal(algebra, claimed(long_claimed, Motion::closes).radial, -b * long_dynamic(eps, 0, s, Pi - delta).along);
  proof.equal(algebra, claimed(long_claimed, Motion::opens).radial, -b * long_dynamic(-eps, 0, s, delta).along);
}

/// arccos ε = εs(1 + 2q/3 + q²ρ(q)): the film that opens without its cancelling terms, and its limits at ε = 1, where
/// ρ = 8/15.
void opening_in_rho(Proof& proof) {
  const auto& [eps, s, b, delta] = std::tie(sym().eps, sym().s, sym().b, sym().delta);
  const symbol rho("rho");
  const Algebra algebra = film_algebra();
  const GiNaC::exmap arc{{delta, eps * s * (1 + 2 * q() / 3 + pow(q(), 2) * rho)}};
  const ex long_k = 12 * eps * (frac(2, 3) + q() * rho);
  const ex short_k = eps * ((3 - 2 * q()) * rho - frac(4, 3));
  proof.equal(algebra, claimed(long_claimed, Motion::opens).radial.subs(arc), -b * long_k);
  proof.equal(algebra, claimed(short_claimed, Motion::opens).radial.subs(arc), -b * short_k);
  const GiNaC::exmap wall{{eps, 1}, {rho, frac(8, 15)}};
  proof.equal(algebra, long_k.subs(wall), 8);
  proof.equal(algebra, short_k.subs(wall), frac(4, 15));
}

}  // namespace

std::vector<Statement> squeeze_statements() {
  using enum Expectation;
  const std::string eq3 = "eq. 3 with a = 0";
  const std::string eq5 = "Reynolds' equation with a = 0";
  std::vector<Statement> all;
  all.push_back({group, "at theta = -pi/2 and pi/2 cos(psi) = eps, sin(psi) = -sqrt(q) and sqrt(q)",
                 "Sommerfeld's angle", holds, ends_are_quarters});
  for (const auto& [motion, word] : {std::pair{Motion::closes, "closes"}, std::pair{Motion::opens, "opens"}}) {
    all.push_back({group, std::string("short film that ") + word + ": the closed form is the integral of its pressure",
                   eq3, holds, [m = motion](Proof& proof) { short_film(proof, m, claimed(short_claimed, m)); }});
    all.push_back({group, std::string("long film that ") + word + ": the closed form is the integral of its pressure",
                   eq5, holds, [m = motion](Proof& proof) { long_film(proof, m, claimed(long_claimed, m)); }});
  }
  all.push_back({group, "closing and opening film together are the b-part of the full film, short and long",
                 "eqs. 6, 10", holds, both_are_the_full_film});
  all.push_back({group, "they are the dynamic films at a = 0, short and long", "exact dynamic film", holds,
                 dynamic_without_wedge});
  all.push_back({group, "films that open in rho, and their limits 8 and 4/15 at eps = 1", "exact dynamic film", holds,
                 opening_in_rho});
  all.push_back({group, "WRONG: long film that closes with arccos(eps) for pi - arccos(eps)", eq5 + " altered", wrong,
                 [](Proof& proof) { long_film(proof, Motion::closes, long_claimed(sym().delta, 1)); }});
  all.push_back({group, "WRONG: short film that opens with + 3 eps", eq3 + " altered", wrong,
                 [](Proof& proof) { short_film(proof, Motion::opens, short_claimed(sym().delta, 1)); }});
  return all;
}

}  // namespace lubjoint::proofs

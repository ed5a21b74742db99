// Each closed-form force of the full and half films is the integral of its pressure field.

#include "oracle/proofs/ledger.hpp"
#include "oracle/proofs/long_film.hpp"

namespace lubjoint::proofs {

namespace {

Polar short_primitive() {
  return {antiderivative(short_profile() * cos(sym().theta)), antiderivative(short_profile() * sin(sym().theta))};
}

/// C of eq. 5.
ex full_film_constant() { return 3 * sym().a * sym().eps / d_factor(); }

Polar long_primitive() { return antiderivatives_of_force(long_profile(), long_slope(full_film_constant())); }

void short_force(Proof& proof, int from, int to, const Polar& claimed) {
  prove_force(proof, short_profile(), short_primitive(), film_end_at_half_turns(from), film_end_at_half_turns(to),
              frac(1, 2), claimed);
}

void long_force(Proof& proof, int from, int to, const Polar& claimed) {
  prove_force(proof, long_profile(), long_primitive(), film_end_at_half_turns(from), film_end_at_half_turns(to), 6,
              claimed);
}

void published_long_half(Proof& proof, int from, int to, const Polar& claimed) {
  const FilmEnd start = film_end_at_half_turns(from);
  const FilmEnd end = film_end_at_half_turns(to);
  const LongFilm film = long_film_between(start, end);
  prove_force(proof, film.pressure, antiderivatives_of_force(film.pressure, long_slope(film.constant)), start, end, 6,
              claimed);
}

Polar on_side(const Polar& law, int side) { return law.subs({{sym().sigma, side}}); }

Statement claim(const std::string& text, const std::string& source, std::function<void(Proof&)> examine,
                const std::string& note = "") {
  return {"forces as integrals of their pressure", text, source, Expectation::holds, std::move(examine), note};
}

Statement mistake(const std::string& text, const std::string& source, std::function<void(Proof&)> examine) {
  return {"forces as integrals of their pressure", "WRONG: " + text, source, Expectation::wrong, std::move(examine)};
}

void sommerfeld_angle(Proof& proof) {
  const auto& [eps, s, theta] = std::tie(sym().eps, sym().s, sym().theta);
  const Algebra algebra = film_algebra();
  const ex c = cos_psi_of(cos(theta));
  const ex w = sin_psi_of(cos(theta), sin(theta));
  const ex rate = s / film_at(cos(theta));
  proof.equal(algebra, pow(c, 2) + pow(w, 2), 1);
  proof.equal(algebra, c.diff(theta), -w * rate);
  proof.equal(algebra, w.diff(theta), c * rate);
  proof.equal(algebra, film_at(cos(theta)) * (1 - eps * c), q());
}

/// tan(ψ/2) = sinψ/(1 + cosψ), the same for θ, and κ = √((1 − ε)/(1 + ε)) = s/(1 + ε).
void half_angle(Proof& proof) {
  const auto& [eps, s, theta] = std::tie(sym().eps, sym().s, sym().theta);
  const ex c = cos_psi_of(cos(theta));
  const ex w = sin_psi_of(cos(theta), sin(theta));
  proof.equal(film_algebra(), w / (1 + c), s / (1 + eps) * sin(theta) / (1 + cos(theta)));
  proof.equal(film_algebra(), pow(s / (1 + eps), 2), (1 - eps) / (1 + eps));
}

/// The principal arctangent: ψ runs from 0 to π, falls by 2π at θ = π, and from −π to 0.
Polar principal_branch_difference(const Polar& primitive, bool with_jump) {
  const FilmEnd zero = film_end_at_half_turns(0);
  const FilmEnd before = film_end_at_half_turns(1);
  FilmEnd after = before;
  after.psi = -Pi;
  FilmEnd end = film_end_at_half_turns(2);
  end.psi = 0;
  if (!with_jump) return {between(primitive.radial, zero, end), between(primitive.tangential, zero, end)};
  return Polar{between(primitive.radial, zero, before), between(primitive.tangential, zero, before)} +
         Polar{between(primitive.radial, after, end), between(primitive.tangential, after, end)};
}

void add_mistakes(std::vector<Statement>& all) {
  all.push_back(mistake(
      "short full film, antiderivative taken across the jump of the arctangent", "eqs. 6, 7 altered", [](Proof& proof) {
        equal(proof, film_algebra(), frac(1, 2) * principal_branch_difference(short_primitive(), false), short_full());
      }));
  all.push_back(mistake("long full film, antiderivative taken across the jump of the arctangent", "eqs. 10, 11 altered",
                        [](Proof& proof) {
                          equal(proof, film_algebra(), 6 * principal_branch_difference(long_primitive(), false),
                                long_full());
                        }));
  all.push_back(mistake("short full film with b/2 for b", "eq. 6 altered", [](Proof& proof) {
    short_force(proof, 0, 2, short_full().subs({{sym().b, sym().b / 2}}));
  }));
  all.push_back(
      mistake("short half film with q^(3/2) for q^(5/2) in the squeeze term", "eq. 8 altered", [](Proof& proof) {
        const Symbols& y = sym();
        Polar altered = on_side(short_half(), 1);
        altered.radial += Pi * y.b * (1 + 2 * pow(y.eps, 2)) / 2 * (1 / pow(y.s, 5) - 1 / pow(y.s, 3));
        short_force(proof, 0, 1, altered);
      }));
  all.push_back(mistake("short half film on pi..2pi with the formula of 0..pi", "eqs. 8, 9 not mirrored",
                        [](Proof& proof) { short_force(proof, 1, 2, on_side(short_half(), 1)); }));
  all.push_back(mistake("long half film of eq. 5 cut at pi is the published one", "eqs. 5, 12, 13",
                        [](Proof& proof) { long_force(proof, 0, 1, on_side(long_half(), 1)); }));
  all.push_back(mistake("published long half film with pi + 16/(pi D)", "eq. 12 altered", [](Proof& proof) {
    Polar altered = on_side(long_half(), 1);
    altered.radial -= 6 * sym().b / pow(sym().s, 3) * 32 / (Pi * d_factor());
    published_long_half(proof, 0, 1, altered);
  }));
}

}  // namespace

std::vector<Statement> force_integral_statements() {
  std::vector<Statement> all;
  all.push_back(claim("Sommerfeld's angle: cos^2 + sin^2 = 1, d(psi)/d(theta) = sqrt(q)/H, H(1 - eps cos(psi)) = q",
                      "Sommerfeld's substitution", sommerfeld_angle,
                      "the slope is positive: psi has no jump on 0..2pi"));
  all.push_back(claim("tan(psi/2) = sqrt((1 - eps)/(1 + eps)) tan(theta/2)", "Sommerfeld's substitution", half_angle,
                      "so psi(0) = 0, psi(pi) = pi and psi grows by 2 pi in a turn; the principal arctangent falls by "
                      "2 pi at theta = pi"));
  all.push_back(claim(
      "the axial integral of the short pressure gives the scale S/2, S = mu R L^3/c^2", "eqs. 6 to 9",
      [](Proof& proof) {
        const symbol mu("mu"), length("L"), radius("R"), c("c"), z("z");
        const ex primitive = z * pow(length, 2) / 4 - pow(z, 3) / 3;
        const ex factor = 3 * mu / pow(c, 2);
        proof.equal(Algebra(), primitive.diff(z), pow(length, 2) / 4 - pow(z, 2));
        proof.equal(Algebra(), radius * factor * (primitive.subs(z == length / 2) - primitive.subs(z == -length / 2)),
                    mu * radius * pow(length, 3) / pow(c, 2) / 2);
      }));
  all.push_back(claim("the axial integral of the long pressure gives the scale 6S, S = mu L R^3/c^2", "eqs. 10 to 13",
                      [](Proof& proof) {
                        const symbol mu("mu"), length("L"), radius("R"), c("c");
                        proof.equal(Algebra(), radius * length * 6 * mu * pow(radius / c, 2),
                                    6 * mu * length * pow(radius, 3) / pow(c, 2));
                      }));
  all.push_back(claim("short full film is the integral of eq. 3 over 0..2pi", "eqs. 6, 7",
                      [](Proof& proof) { short_force(proof, 0, 2, short_full()); }));
  all.push_back(claim("short half film, a >= 0, is the integral of eq. 3 over 0..pi", "eqs. 8, 9",
                      [](Proof& proof) { short_force(proof, 0, 1, on_side(short_half(), 1)); }));
  all.push_back(claim("short half film, a < 0, is the integral of eq. 3 over pi..2pi", "eqs. 8, 9 mirrored",
                      [](Proof& proof) { short_force(proof, 1, 2, on_side(short_half(), -1)); }));
  all.push_back(claim("long full film is the integral of eq. 5 over 0..2pi", "eqs. 10, 11",
                      [](Proof& proof) { long_force(proof, 0, 2, long_full()); }));
  all.push_back(
      claim("a constant added to the pressure does not change the full film's force", "eqs. 10, 11", [](Proof& proof) {
        const FilmEnd from = film_end_at_half_turns(0);
        const FilmEnd to = film_end_at_half_turns(2);
        proof.zero(film_algebra(), between(sin(sym().theta), from, to));
        proof.zero(film_algebra(), between(-cos(sym().theta), from, to));
      }));
  all.push_back(claim("long half film, a >= 0, is the integral of its pressure, p(0) = p(pi) = 0", "eqs. 12, 13",
                      [](Proof& proof) { published_long_half(proof, 0, 1, on_side(long_half(), 1)); }));
  all.push_back(claim("long half film, a < 0, is the integral of its pressure, p(pi) = p(2pi) = 0",
                      "eqs. 12, 13 mirrored",
                      [](Proof& proof) { published_long_half(proof, 1, 2, on_side(long_half(), -1)); }));
  all.push_back(claim("long half film of eq. 5 cut at pi, a >= 0, is the integral of eq. 5 over 0..pi", "eq. 5",
                      [](Proof& proof) { long_force(proof, 0, 1, on_side(long_half_eq5(), 1)); }));
  all.push_back(claim("long half film of eq. 5 cut at pi, a < 0, is the integral of eq. 5 over pi..2pi",
                      "eq. 5 mirrored", [](Proof& proof) { long_force(proof, 1, 2, on_side(long_half_eq5(), -1)); }));
  all.push_back(
      claim("short full film with the principal arctangent and its jump at theta = pi", "eqs. 6, 7", [](Proof& proof) {
        equal(proof, film_algebra(), frac(1, 2) * principal_branch_difference(short_primitive(), true), short_full());
      }));
  all.push_back(
      claim("long full film with the principal arctangent and its jump at theta = pi", "eqs. 10, 11", [](Proof& proof) {
        equal(proof, film_algebra(), 6 * principal_branch_difference(long_primitive(), true), long_full());
      }));
  add_mistakes(all);
  return all;
}

}  // namespace lubjoint::proofs

// Passivity: the film takes power from its own motion, −F·u ≥ 0, by squares and polynomials of one sign.
//
// F·u = F_r b − F_t a/2. Where π enters an inequality, π = 3 + w with w > 0 is all that is used.

#include "oracle/proofs/ledger.hpp"
#include "oracle/proofs/sommerfeld.hpp"

namespace lubjoint::proofs {

namespace {

const char* const group = "passivity";

/// −F·u = A|a|² + 2B|a|b + C b² of a half film: A > 0 and C − B²/A > 0.
struct Form {
  ex a2, ab, b2;
};

Form form_of(const Polar& law) {
  const symbol magnitude("abs_a");
  const ex power = (-power_of(law)).subs(GiNaC::exmap{{sym().a, sym().sigma * magnitude}}).expand();
  const ex reduced = power.subs(sym().sigma * sym().sigma == 1, GiNaC::subs_options::algebraic);
  return {reduced.coeff(magnitude, 2), reduced.coeff(magnitude, 1).coeff(sym().b, 1) / 2,
          reduced.coeff(magnitude, 0).coeff(sym().b, 2)};
}

/// −F·u = A(|a| + Bb/A)² + (C − B²/A) b² with A = `leading`, and (C − B²/A) · `positive` = `rest`, a polynomial in π
/// and ε. `leading` and `positive` are products of positive quantities (π, s, D, 1 + ε); `rest` is shown to be
/// positive.
void sum_of_squares(Proof& proof, const Polar& law, const ex& leading, const ex& positive, const ex& rest) {
  const auto& [a, b, sigma] = std::tie(sym().a, sym().b, sym().sigma);
  const Algebra algebra = film_algebra();
  const Form f = form_of(law);
  proof.equal(algebra, f.a2, leading);
  proof.equal(algebra, (f.b2 - f.ab * f.ab / f.a2) * positive, rest);
  proof.equal(algebra, -power_of(law),
              f.a2 * pow(sigma * a + f.ab / f.a2 * b, 2) + (f.b2 - f.ab * f.ab / f.a2) * b * b);
  const symbol w("w");
  proof.positive(rest.subs(Pi == 3 + w), {w, sym().eps});
}

void short_full_power(Proof& proof, const ex& factor) {
  const auto& [eps, s, a, b] = std::tie(sym().eps, sym().s, sym().a, sym().b);
  proof.equal(film_algebra(), -power_of(short_full()),
              Pi / pow(s, 5) * (factor * (1 + 2 * pow(eps, 2)) * b * b + pow(s * a / 2, 2)));
}

void long_full_power(Proof& proof) {
  const auto& [s, a, b] = std::tie(sym().s, sym().a, sym().b);
  proof.equal(film_algebra(), -power_of(long_full()),
              12 * Pi / (d_factor() * pow(s, 3)) * (d_factor() * b * b + frac(1, 2) * pow(s * a, 2)));
}

/// Leading coefficient 3π/(D s).
ex long_leading() { return 3 * Pi / (d_factor() * sym().s); }

/// F·u with K² = q(a²/4 + b²): −F·u D q^{3/2}/6 = 4εKb + φ(2πK² + 3πε²b²).
void pinkus_sternlicht_power(Proof& proof) {
  const auto& [eps, s, a, b] = std::tie(sym().eps, sym().s, sym().a, sym().b);
  const symbol k("K"), bb("B"), w("w"), x("x");
  const Algebra algebra = film_algebra().root(k, q() * (a * a / 4 + b * b));
  const ex factor = d_factor() * pow(s, 3) / 6;
  const ex even = 2 * Pi * k * k + 3 * Pi * pow(eps * b, 2);
  proof.equal(algebra, -power_of(pinkus_sternlicht(k, true)) * factor,
              4 * eps * k * b + (k + 3 * eps * b) / (k + frac(3, 2) * eps * b) * even);
  // b < 0: with B = −εb the bracket is a quadratic form in K and B.
  const ex form = 2 * Pi * k * k - 4 * k * bb + (3 * Pi - 6) * bb * bb;
  proof.equal(algebra, -power_of(pinkus_sternlicht(k, false)) * factor,
              k / (k - frac(3, 2) * eps * b) * form.subs(bb == -eps * b));
  const ex rest = 3 * Pi - 6 - 2 / Pi;
  proof.equal(Algebra(), form, 2 * Pi * pow(k - bb / Pi, 2) + rest * bb * bb);
  proof.positive((rest * Pi).expand().subs(Pi == 3 + w), {w});
}

/// −F·û = |u| W/q^{5/2} and W = ∫(e₁ + N cosχ)² dχ; −F·û = 12|u| N²AV/(A + q e₂²V/N²)/q^{3/2}, A and V likewise.
void dynamic_power(Proof& proof) {
  const symbol e1("e1"), e2("e2"), s("s"), delta("delta"), a("A"), v("V"), w("W"), n2("N2");
  const Algebra algebra = Algebra().root(s, 1 - e1 * e1 - e2 * e2);
  const FrameMoments m = frame_moments(e1, e2, s, delta);
  proof.equal(algebra, short_dynamic(e1, e2, s, delta).along, m.w / pow(s, 5));
  const ex nn = 1 - e2 * e2;
  proof.equal(algebra, long_dynamic(e1, e2, s, delta).along,
              12 * nn * m.a * m.v / (m.a + s * s * e2 * e2 * m.v / nn) / pow(s, 3));
}

}  // namespace

std::vector<Statement> passivity_statements() {
  using enum Expectation;
  std::vector<Statement> all;
  const auto& [eps, s] = std::tie(sym().eps, sym().s);
  const ex e = eps, ss = s, d = d_factor(), p = Pi;
  all.push_back({group, "short full: -F.u is a sum of two squares", "eqs. 6, 7", holds,
                 [](Proof& proof) { short_full_power(proof, 1); }});
  all.push_back({group, "long full: -F.u is a sum of two squares", "eqs. 10, 11", holds, long_full_power});
  all.push_back({group, "short half: -F.u is a sum of two squares", "eqs. 8, 9", holds,
                 [=](Proof& proof) {
                   sum_of_squares(proof, short_half(), p / (8 * pow(ss, 3)), 2 * p * pow(ss, 5),
                                  p * p * (1 + 2 * e * e) - 16 * e * e);
                 },
                 "the smaller coefficient is pi^2 + 2(pi^2 - 8) eps^2 > 0"});
  all.push_back(
      {group, "long half: -F.u is a sum of two squares", "eqs. 12, 13", holds,
       [=](Proof& proof) { sum_of_squares(proof, long_half(), long_leading(), pow(ss, 3) * p / 6, p * p - 8); },
       "the smaller coefficient is pi^2 - 8 > 0"});
  all.push_back({group, "long half of eq. 5: -F.u is a sum of two squares", "eq. 5", holds, [=](Proof& proof) {
                   // 4AC − B² over a positive factor, on 0 ≤ ε < 1.
                   sum_of_squares(proof, long_half_eq5(), long_leading(), pow(ss, 3) * d * pow(1 + e, 2) * p / 6,
                                  p * p * d * pow(1 + e, 2) - 2 * pow(2 + e + 2 * e * e, 2));
                 }});
  all.push_back({group, "Pinkus-Sternlicht: -F.u >= 0 for both signs of b", "eqs. 14 to 18", holds,
                 pinkus_sternlicht_power, "b >= 0: every term is; b < 0: a sum of two squares in K and B"});
  all.push_back({group, "dynamic films: -F.u is made of V, A and W, integrals of squares", "exact dynamic film", holds,
                 dynamic_power});
  all.push_back({group, "WRONG: short full: the same squares, the first one halved", "eqs. 6, 7 altered", wrong,
                 [](Proof& proof) { short_full_power(proof, frac(1, 2)); }});
  all.push_back({group, "WRONG: short half: the same squares with pi^2 - 16 eps^2 for the smaller coefficient",
                 "eqs. 8, 9 altered", wrong, [=](Proof& proof) {
                   sum_of_squares(proof, short_half(), p / (8 * pow(ss, 3)), 2 * p * pow(ss, 5), p * p - 16 * e * e);
                 }});
  return all;
}

}  // namespace lubjoint::proofs

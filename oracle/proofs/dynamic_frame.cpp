// Closed forms of the dynamic films in the frame of u = |u| û: e₁ = ê·û, e₂ = ê·û⊥, wall direction
// d(φ) = û cosφ + û⊥ sinφ, H = 1 − ê·d, film on |φ| < π/2, Sommerfeld's angle χ from the middle of the film.

#include "oracle/proofs/ledger.hpp"
#include "oracle/proofs/sommerfeld.hpp"

namespace lubjoint::proofs {

namespace {

const char* const group = "dynamic films: closed forms in the frame of u";

struct Frame {
  symbol e1{"e1"}, e2{"e2"}, n{"N"}, s{"s"}, chi{"chi"}, delta{"delta"}, rho{"rho"}, y{"y"};

  ex q() const { return 1 - pow(e1, 2) - pow(e2, 2); }
  ex n2() const { return 1 - pow(e2, 2); }
  /// N² = 1 − e₂², s² = q, and the angle χ.
  Algebra algebra() const { return Algebra().root(n, n2()).root(s, q()).angle(chi); }
  ex g() const { return 1 + (e1 * cos(chi) + s * e2 * sin(chi)) / n; }
  ex d1() const { return (e1 + n * cos(chi)) / g(); }
  ex d2() const { return e2 + s * n * sin(chi) / g(); }

  ex at_end(const ex& expression, int sign) const {
    return expression.subs(GiNaC::exmap{{cos(chi), -e1 / n}, {sin(chi), sign * s / n}}).subs(chi == sign * delta);
  }
  /// ∫ over |χ| ≤ δ by an antiderivative whose derivative is checked.
  ex integral(Proof& proof, const ex& integrand) const {
    const ex primitive = trigonometric_antiderivative(integrand, chi);
    proof.equal(algebra(), primitive.diff(chi), integrand);
    return at_end(primitive, 1) - at_end(primitive, -1);
  }
  FrameMoments moments() const { return frame_moments(e1, e2, s, delta); }
};

void substitution(Proof& proof) {
  const Frame f;
  const Algebra algebra = f.algebra();
  proof.equal(algebra, pow(f.d1(), 2) + pow(f.d2(), 2), 1);
  proof.equal(algebra, 1 - f.e1 * f.d1() - f.e2 * f.d2(), f.q() / f.g());
  // dφ = d₁ dd₂ − d₂ dd₁.
  const ex dphi = f.d1() * f.d2().diff(f.chi) - f.d2() * f.d1().diff(f.chi);
  proof.equal(algebra, dphi / pow(f.q() / f.g(), 3), pow(f.g(), 2) / pow(f.s, 5));
  proof.equal(algebra, f.g() * (f.d1() - f.e1), f.s / f.n * (f.s * cos(f.chi) - f.e1 * f.e2 * sin(f.chi)));
}

void ends(Proof& proof) {
  const Frame f;
  for (const int sign : {-1, 1}) {
    proof.zero(f.algebra(), f.at_end(f.d1(), sign));
    proof.equal(f.algebra(), f.at_end(f.d2(), sign), sign);
  }
  proof.equal(f.algebra(), pow(f.e1 / f.n, 2) + pow(f.s / f.n, 2), 1);
}

void four_moments(Proof& proof) {
  const Frame f;
  const ex c = cos(f.chi);
  const FrameMoments m = f.moments();
  proof.equal(f.algebra(), f.integral(proof, pow(sin(f.chi), 2)), m.v);
  proof.equal(f.algebra(), f.integral(proof, pow(1 + f.e1 * c / f.n, 2)), m.a);
  proof.equal(f.algebra(), f.integral(proof, (f.e1 + f.n * c) * (f.n + f.e1 * c)) / f.n, m.e);
  proof.equal(f.algebra(), f.integral(proof, pow(f.e1 + f.n * c, 2)), m.w);
}

/// ∫ d₁ʲ d₂ᵏ/H³ dφ.
ex wall_moment(Proof& proof, const Frame& f, int j, int k) {
  const ex integrand = pow(f.e1 + f.n * cos(f.chi), j) * pow(f.e2 * f.g() + f.s * f.n * sin(f.chi), k) *
                       pow(f.g(), 2 - j - k) / pow(f.s, 5);
  return f.integral(proof, integrand);
}

/// The pressure is 2|u| cosφ/H³ over 3μ/c²(L²/4 − z²) and pushes the journal along −d.
void short_form(Proof& proof) {
  const Frame f;
  const Resistance claimed = short_dynamic(f.e1, f.e2, f.s, f.delta);
  proof.equal(f.algebra(), wall_moment(proof, f, 2, 0), claimed.along);
  proof.equal(f.algebra(), wall_moment(proof, f, 1, 1), claimed.across);
}

/// ∫ (w₁d₁ + w₂d₂)²/H³ dφ, an integral of a square, is the quadratic form of the three second moments.
void short_moments(Proof& proof) {
  const Frame f;
  const symbol w1("w1"), w2("w2");
  const Resistance along = short_dynamic(f.e1, f.e2, f.s, f.delta);
  const ex across = short_dynamic_across(f.e1, f.e2, f.s, f.delta);
  const ex d1 = f.e1 + f.n * cos(f.chi);
  const ex d2 = f.e2 * f.g() + f.s * f.n * sin(f.chi);
  proof.equal(f.algebra(), wall_moment(proof, f, 0, 2), across);
  proof.equal(f.algebra(), f.integral(proof, pow(w1 * d1 + w2 * d2, 2) / pow(f.s, 5)),
              w1 * w1 * along.along + 2 * w1 * w2 * along.across + w2 * w2 * across);
}

/// Covariances with weight 1/H³; p′ = −12|u|(sinφ − mean)/H³ and integration by parts give the force.
void long_form(Proof& proof) {
  const Frame f;
  const ex m0 = wall_moment(proof, f, 0, 0);
  const ex m1 = wall_moment(proof, f, 1, 0);
  const ex m2 = wall_moment(proof, f, 0, 1);
  const Resistance claimed = long_dynamic(f.e1, f.e2, f.s, f.delta);
  proof.equal(f.algebra(), 12 * (wall_moment(proof, f, 0, 2) - m2 * m2 / m0), claimed.along);
  proof.equal(f.algebra(), -12 * (wall_moment(proof, f, 1, 1) - m1 * m2 / m0), claimed.across);
}

/// (H³p′)′ = −12|u| cosφ over μ(R/c)², and with d₂′ = d₁ and d₁′ = −d₂ integration by parts gives
/// −∫p d₁ = ∫p′ d₂ and −∫p d₂ = −∫p′ d₁ where p vanishes at both ends; `mean` makes ∫p′ = 0.
void long_field(Proof& proof) {
  const symbol phi("phi"), speed("speed"), mean("mean"), m0("M0"), m2("M2");
  const Algebra algebra = Algebra().angle(phi);
  proof.equal(algebra, (-12 * speed * (sin(phi) - mean)).diff(phi), -12 * speed * cos(phi));
  proof.equal(algebra, sin(phi).diff(phi), cos(phi));
  proof.equal(algebra, cos(phi).diff(phi), -sin(phi));
  proof.zero(algebra, (m2 - mean * m0).subs(mean == m2 / m0));
}

/// With δ = sinδ cosδ (1 + 2y/3 + y²ρ), y = q/N², m = −e₁, σ = m√q/N².
GiNaC::exmap opening(const Frame& f) {
  const ex y = f.q() / f.n2();
  const ex product = -f.e1 * f.s / f.n2();
  return {{f.delta, product * (1 + 2 * y / 3 + pow(y, 2) * f.rho)}};
}

void opening_moments(Proof& proof, int power_in_v) {
  const Frame f;
  const ex y = f.q() / f.n2();
  const ex m = -f.e1;
  const ex sigma = m * f.s / f.n2();
  const FrameMoments moments = f.moments();
  const GiNaC::exmap map = opening(f);
  proof.equal(f.algebra(), moments.v.subs(map), sigma * pow(y, power_in_v) * (frac(2, 3) + y * f.rho));
  proof.equal(f.algebra(), moments.a.subs(map), sigma * pow(y, 2) * ((3 - y) * f.rho - frac(2, 3)));
  proof.equal(f.algebra(), moments.e.subs(map), sigma * pow(y, 2) * (2 * f.n2() / m - 3 * m * f.rho));
  proof.equal(f.algebra(), moments.w.subs(map), m * f.s * pow(y, 2) * ((3 - 2 * y) * f.rho - frac(4, 3)));
}

void opening_short(Proof& proof) {
  const Frame f;
  const ex y = f.q() / f.n2();
  const ex m = -f.e1;
  const Resistance law = short_dynamic(f.e1, f.e2, f.s, f.delta);
  proof.equal(f.algebra(), law.along.subs(opening(f)), m / pow(f.n2(), 2) * ((3 - 2 * y) * f.rho - frac(4, 3)));
  proof.equal(f.algebra(), law.across.subs(opening(f)), f.e2 / pow(f.n2(), 3) * (2 * f.n2() - 3 * m * m * f.rho));
  proof.equal(f.algebra(), short_dynamic_across(f.e1, f.e2, f.s, f.delta).subs(opening(f)),
              m / pow(f.n2(), 2) * (frac(2, 3) + f.rho * (f.q() + 3 * pow(f.e2, 2)) / f.n2()));
}

void opening_long(Proof& proof) {
  const Frame f;
  const ex y = f.q() / f.n2();
  const ex m = -f.e1;
  const ex v = frac(2, 3) + y * f.rho;
  const ex a = (3 - y) * f.rho - frac(2, 3);
  const ex factor = 12 * v / (f.n2() * (a + pow(f.e2, 2) * v));
  const Resistance law = long_dynamic(f.e1, f.e2, f.s, f.delta);
  proof.equal(f.algebra(), law.along.subs(opening(f)), factor * m * a);
  proof.equal(f.algebra(), law.across.subs(opening(f)), factor * f.e2 * (2 * f.n2() - 3 * m * m * f.rho) / f.n2());
}

/// f(y) = δ/(sinδ cosδ), y = sin²δ obeys 2y(1 − y) f′ = 1 − (1 − 2y) f.
void arc_equation(Proof& proof) {
  const symbol delta("delta");
  const Algebra algebra = Algebra().angle(delta);
  const ex y = pow(sin(delta), 2);
  const ex f = delta / (sin(delta) * cos(delta));
  proof.equal(algebra, 2 * y * (1 - y) * f.diff(delta) / y.diff(delta), 1 - (1 - 2 * y) * f);
}

/// The equation of ρ, left − right, for given ρ and ρ′; a common factor y² is divided out.
ex remainder_equation(const ex& y, const ex& rho, const ex& slope) {
  return 2 * y * (1 - y) * slope + (5 - 6 * y) * rho - frac(8, 3);
}

void remainder_obeys(Proof& proof) {
  const symbol y("y"), rho("rho"), slope("slope");
  const ex f = 1 + 2 * y / 3 + pow(y, 2) * rho;
  const ex f_slope = f.diff(y) + pow(y, 2) * slope;
  proof.equal(Algebra(), 2 * y * (1 - y) * f_slope - 1 + (1 - 2 * y) * f,
              pow(y, 2) * remainder_equation(y, rho, slope));
}

/// ρ = Σ c_n yⁿ, c₀ = 8/15, c_n = c_{n−1}(2n + 4)/(2n + 5): the coefficients of the equation for every n.
void remainder_series(Proof& proof, const ex& first, const std::function<ex(const symbol&)>& ratio) {
  const symbol n("n"), previous("c_previous");
  const ex current = previous * ratio(n);
  // Coefficient of y⁰, and of yⁿ with n ≥ 1, of 2y(1 − y)ρ′ + (5 − 6y)ρ − 8/3.
  proof.zero(Algebra(), 5 * first - frac(8, 3));
  proof.zero(Algebra(), 2 * n * current - 2 * (n - 1) * previous + 5 * current - 6 * previous);
}

/// (a)_n(b)_n/((c)_n n!) with a = 1, b = 3, c = 7/2: the ratio of one coefficient to the one before it.
ex hypergeometric_ratio(const symbol& n) { return (n - 1 + 1) * (n - 1 + 3) / ((n - 1 + frac(7, 2)) * n); }

}  // namespace

std::vector<Statement> dynamic_frame_statements() {
  using enum Expectation;
  const std::string source = "exact dynamic film";
  std::vector<Statement> all;
  all.push_back(
      {group, "Sommerfeld's substitution from the middle of the film: |d| = 1, H = q/G, dphi/H^3 = q^(-5/2) G^2 dchi",
       source, holds, substitution});
  all.push_back({group, "its ends chi = -delta, delta are phi = -pi/2, pi/2", source, holds, ends,
                 "cos(delta) = -e1/N, sin(delta) = sqrt(q)/N: delta = atan2(sqrt(q), -e1)"});
  all.push_back({group, "V, A, E and W are the integrals of their squares and products over |chi| <= delta", source,
                 holds, four_moments});
  all.push_back({group, "short dynamic: F = -(S|u|/q^(5/2)) [W u^ + e2 E u^perp] is the integral of the pressure",
                 source, holds, short_form});
  all.push_back({group, "short dynamic: the second moments of d over H^3 are closed, and their form is int (w.d)^2/H^3",
                 source, holds, short_moments});
  all.push_back({group, "long dynamic: p' = -12|u| (sin(phi) - mean)/H^3, and the force by parts is a covariance",
                 source, holds, long_field});
  all.push_back({group, "long dynamic: F = -12 S|u| [Var(d2) u^ - Cov(d1, d2) u^perp] has the closed form in V, A, E",
                 source, holds, long_form});
  all.push_back({group, "opening film: V, A, E, W with delta = sin cos (1 + 2y/3 + y^2 rho)", source, holds,
                 [](Proof& proof) { opening_moments(proof, 1); }, "e1 < 0, y = q/N^2"});
  all.push_back({group, "opening film: short dynamic in rho", source, holds, opening_short});
  all.push_back({group, "opening film: long dynamic in rho", source, holds, opening_long});
  all.push_back({group, "f = delta/(sin(delta) cos(delta)) obeys 2y(1 - y) f' = 1 - (1 - 2y) f, y = sin^2(delta)",
                 source, holds, arc_equation});
  all.push_back({group, "rho, f = 1 + 2y/3 + y^2 rho, obeys 2y(1 - y) rho' + (5 - 6y) rho = 8/3", source, holds,
                 remainder_obeys});
  all.push_back({group, "rho(y) = (8/15) 2F1(1, 3; 7/2; y)", source, holds,
                 [](Proof& proof) { remainder_series(proof, frac(8, 15), hypergeometric_ratio); },
                 "the recurrence fixes every coefficient: the solution that is analytic at y = 0, as f is, is unique"});
  all.push_back({group, "the series' ratio is (2n + 4)/(2n + 5), n = 1, 2, ...", source, holds, [](Proof& proof) {
                   const symbol n("n");
                   proof.equal(Algebra(), hypergeometric_ratio(n), (2 * n + 4) / (2 * n + 5));
                 }});

  all.push_back({group, "WRONG: opening film with V = sigma y^2 (2/3 + y rho)", source + " altered", wrong,
                 [](Proof& proof) { opening_moments(proof, 2); }});
  all.push_back({group, "WRONG: rho(y) = (8/15) 2F1(1, 3; 5/2; y)", source + " altered", wrong, [](Proof& proof) {
                   remainder_series(proof, frac(8, 15),
                                    [](const symbol& n) { return ex(n * (n + 2) / ((n - 1 + frac(5, 2)) * n)); });
                 }});
  all.push_back({group, "WRONG: rho(0) = 8/5", source + " altered", wrong,
                 [](Proof& proof) { remainder_series(proof, frac(8, 5), hypergeometric_ratio); }});
  all.push_back({group, "WRONG: long dynamic with +Cov(d1, d2)", source + " altered", wrong, [](Proof& proof) {
                   const Frame f;
                   const ex m0 = wall_moment(proof, f, 0, 0);
                   const ex covariance =
                       wall_moment(proof, f, 1, 1) - wall_moment(proof, f, 1, 0) * wall_moment(proof, f, 0, 1) / m0;
                   proof.equal(f.algebra(), 12 * covariance, long_dynamic(f.e1, f.e2, f.s, f.delta).across);
                 }});
  return all;
}

}  // namespace lubjoint::proofs

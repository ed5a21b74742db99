// The potential of a film: Φ(u) = −F·u with F = −½ ∇Φ, ê fixed.
//
// Where there is one, ∂F/∂u is symmetric; where it is convex, too, the film is monotone and has one velocity for every
// force. In the frame of u, with F = −|u|(W₁ û + W₂ û⊥), Φ = |u|²W₁ and ∇Φ = |u|(2W₁ û + W₁′ û⊥), ′ the derivative in
// the direction of u: F = −½∇Φ is W₂ = ½W₁′.

#include <stdexcept>

#include "oracle/proofs/laws.hpp"
#include "oracle/proofs/ledger.hpp"

namespace lubjoint::proofs {

namespace {

const char* const group = "potential";

struct Turned {
  symbol e1{"e1"}, e2{"e2"}, s{"s"}, delta{"delta"};

  Algebra algebra() const { return Algebra().root(s, 1 - e1 * e1 - e2 * e2); }
  /// The derivative as û turns, ê fixed: e₁′ = e₂, e₂′ = −e₁ and, since δ = atan2(√q, −e₁), δ′ = √q e₂/(q + e₁²).
  ex slope(const ex& f) const { return e2 * f.diff(e1) - e1 * f.diff(e2) + s * e2 / (1 - e2 * e2) * f.diff(delta); }
  /// u at a right angle to e: e₁ = 0, e₂ = ε, δ = π/2.
  ex sliding(const ex& f) const {
    return f.subs(GiNaC::exmap{{e1, 0}, {delta, Pi / 2}}).subs(GiNaC::exmap{{e2, sym().eps}, {s, sym().s}});
  }
};

/// tanδ = −√q/e₁, differentiated: δ′/cos²δ = √q e₁′/e₁² with cos²δ = e₁²/(q + e₁²).
void arc_turns(Proof& proof) {
  const Turned t;
  const ex square = pow(t.s, 2) + pow(t.e1, 2);
  proof.equal(t.algebra(), t.slope(t.delta) * square / pow(t.e1, 2), t.s * t.slope(t.e1) / pow(t.e1, 2));
  proof.zero(t.algebra(), t.e1 * t.slope(t.e1) + t.e2 * t.slope(t.e2));
}

/// W₂ = factor · W₁′.
void across_is_slope(Proof& proof, Resistance (*law)(const ex&, const ex&, const ex&, const ex&), const ex& factor) {
  const Turned t;
  const Resistance f = law(t.e1, t.e2, t.s, t.delta);
  proof.equal(t.algebra(), f.across, factor * t.slope(f.along));
}

/// −∂F/∂u maps û to W and û⊥ to dW/dφ = (W₁′ − W₂) û + (W₁ + W₂′) û⊥: with the second moments I it is I.
void slope_is_moments(Proof& proof) {
  const Turned t;
  const Resistance f = short_dynamic(t.e1, t.e2, t.s, t.delta);
  proof.equal(t.algebra(), t.slope(f.along) - f.across, f.across);
  proof.equal(t.algebra(), f.along + t.slope(f.across), short_dynamic_across(t.e1, t.e2, t.s, t.delta));
}

/// F = −½∇Φ in the plane, of a law that is linear on each side of a = 0.
void is_gradient(Proof& proof, const Law& law) {
  const FreeState free;
  const Planar force = law.vector(free.state);
  const ex phi = -dot(force, free.state.u);
  equal(proof, free.algebra, force, {-phi.diff(free.u_x) / 2, -phi.diff(free.u_y) / 2});
}

/// −(F(u) − F(w))·(u − w) of a full film is `factor` [q·`weight`|u − w|² + 3(ê·(u − w))²], factor > 0.
void full_is_monotone(Proof& proof, const Law& law, const ex& factor, int weight) {
  const FreeState free;
  const symbol w_x("w_x"), w_y("w_y");
  const Planar w{w_x, w_y};
  const Planar apart = free.state.u - w;
  const Planar change = law.vector(free.state) - law.vector(free.state.with(free.state.e_hat, w));
  proof.equal(free.algebra, -dot(change, apart),
              factor.subs(sym().eps == free.state.eps).subs(sym().s == free.state.s) *
                  (weight * pow(free.state.s, 2) * dot(apart, apart) + 3 * pow(dot(free.state.e_hat, apart), 2)));
}

/// ∂F_r/∂u_t − ∂F_t/∂u_r = −2∂_aF_r − ∂_bF_t.
ex asymmetry(const Polar& law) { return -2 * law.radial.diff(sym().a) - law.tangential.diff(sym().b); }

/// The film cut at π: the asymmetry is −24 sgn(a)(2 − ε)/(D(1 + ε)q), never 0.
void eq5_is_asymmetric(Proof& proof) {
  const auto& [eps, sigma] = std::tie(sym().eps, sym().sigma);
  const symbol gap("gap");
  proof.equal(film_algebra(), asymmetry(long_half_eq5()), -24 * sigma * (2 - eps) / (d_factor() * (1 + eps) * q()));
  proof.positive((2 - eps).subs(eps == 1 - gap).expand(), {gap});
}

/// Pinkus–Sternlicht at b = 0, a > 0, where K = √q a/2, ∂K/∂a = √q/2 and ∂K/∂b = 0: −6ε(3π − 4)/(Dq).
void pinkus_sternlicht_is_asymmetric(Proof& proof, bool closing) {
  const auto& [eps, s, a, b] = std::tie(sym().eps, sym().s, sym().a, sym().b);
  const symbol k("K"), w("w");
  const Polar law = pinkus_sternlicht(k, closing);
  const ex by_a = law.radial.diff(a) + law.radial.diff(k) * s / 2;
  const ex at_slide = (-2 * by_a - law.tangential.diff(b)).subs(b == 0).subs(k == s * a / 2);
  proof.equal(film_algebra(), at_slide, -6 * eps * (3 * Pi - 4) / (d_factor() * q()));
  proof.positive((3 * Pi - 4).subs(Pi == 3 + w).expand(), {w});
}

/// Long dynamic with u at a right angle to e, û⊥ = r: 2W₂ − W₁′ = −24ε³/(D²q).
void long_dynamic_is_asymmetric(Proof& proof) {
  const Turned t;
  const Resistance f = long_dynamic(t.e1, t.e2, t.s, t.delta);
  proof.equal(film_algebra(), t.sliding(2 * f.across - t.slope(f.along)),
              -24 * pow(sym().eps, 3) / (pow(d_factor(), 2) * q()));
}

/// A journal that opens the gap with b = −B, and slips with a or −a. a is given with B = 1.
struct Slips {
  std::string name;
  Polar (*law)();
  ex slip;     ///< a at which the tangential force is zero
  ex product;  ///< (F₁ − F₂)·(u₁ − u₂) at half of it
};

const std::vector<Slips>& half_films() {
  const auto& [eps, s] = std::tie(sym().eps, sym().s);
  static const std::vector<Slips> all = {
      {"short half", short_half, 8 * eps / (Pi * s), 8 * pow(eps, 2) / (Pi * s * pow(q(), 2))},
      {"long half", long_half, 4 * eps / (Pi * s), 48 * pow(eps, 2) / (Pi * s * d_factor() * q())},
      {"long half of eq. 5", long_half_eq5, 4 * d_factor() / (Pi * s * (1 + eps)),
       48 * d_factor() / (Pi * s * pow(1 + eps, 2) * q())}};
  return all;
}

/// a and −a have one force: two velocities for it.
void two_velocities(Proof& proof, const Slips& film) {
  const Polar law = film.law().subs({{sym().b, -1}});
  const Polar ahead = law.subs({{sym().sigma, 1}, {sym().a, film.slip}});
  const Polar back = law.subs({{sym().sigma, -1}, {sym().a, -film.slip}});
  equal(proof, film_algebra(), ahead, back);
}

/// At half of that slip the force pulls the two velocities apart: (F₁ − F₂)·(u₁ − u₂) > 0.
void not_monotone(Proof& proof, const Slips& film) {
  const Polar law = film.law().subs({{sym().b, -1}});
  const ex half = film.slip / 2;
  const Polar change = law.subs({{sym().sigma, 1}, {sym().a, half}}) - law.subs({{sym().sigma, -1}, {sym().a, -half}});
  // u₁ − u₂ = −a t; F·u takes half of the difference in a, as power_of does.
  proof.equal(film_algebra(), -change.tangential * half, film.product);
}

const Law& named(const std::string& name) {
  for (const Law& law : laws()) {
    if (law.name == name) return law;
  }
  throw std::logic_error("no such law: " + name);
}

}  // namespace

std::vector<Statement> potential_statements() {
  using enum Expectation;
  const ex& s = sym().s;
  std::vector<Statement> all;
  for (const std::string name : {"short full", "long full", "short half", "long half"}) {
    const bool half = name.ends_with("half");
    all.push_back({group, name + ": F = -grad(Phi)/2 with Phi = -F.u" + (half ? ", on each side of a = 0" : ""),
                   named(name).source, holds, [name](Proof& proof) { is_gradient(proof, named(name)); }});
  }
  all.push_back({group, "short full is monotone: -(F(u) - F(w)).(u - w) is a sum of squares", "eqs. 6, 7", holds,
                 [s](Proof& proof) { full_is_monotone(proof, named("short full"), Pi / pow(s, 5), 1); },
                 "so Phi is convex, and the velocity for a force is unique"});
  all.push_back(
      {group, "long full is monotone: -(F(u) - F(w)).(u - w) is a sum of squares", "eqs. 10, 11", holds,
       [s](Proof& proof) { full_is_monotone(proof, named("long full"), 12 * Pi / (d_factor() * pow(s, 3)), 2); },
       "likewise"});
  all.push_back({group, "as u turns, e1' = e2, e2' = -e1 and delta' = sqrt(q) e2/(q + e1^2)", "exact dynamic film",
                 holds, arc_turns});
  all.push_back({group, "short dynamic: W2 = W1'/2, so F = -grad(Phi)/2 with Phi = |u|^2 W1", "exact dynamic film",
                 holds, [](Proof& proof) { across_is_slope(proof, short_dynamic, frac(1, 2)); }});
  all.push_back(
      {group, "short dynamic: -dF/du is the matrix of second moments of d over H^3", "exact dynamic film", holds,
       slope_is_moments,
       "its form is int (w.d)^2/H^3 > 0 (dynamic films): Phi is strictly convex, F is monotone, dF/du symmetric "
       "and negative definite, and the velocity for a force is unique"});
  all.push_back({group, "long half of eq. 5 has none: dF/du is not symmetric at any state", "eq. 5", holds,
                 eq5_is_asymmetric, "dF_r/du_t - dF_t/du_r = -24 sgn(a) (2 - eps)/(D (1 + eps) q)"});
  for (const bool closing : {true, false}) {
    all.push_back({group,
                   std::string("Pinkus-Sternlicht, b ") + (closing ? ">= 0" : "< 0") +
                       ", has none: dF/du is not symmetric at b = 0, eps > 0",
                   "eqs. 14 to 18", holds, [closing](Proof& proof) { pinkus_sternlicht_is_asymmetric(proof, closing); },
                   "dF_r/du_t - dF_t/du_r = -6 eps (3 pi - 4)/(D q)"});
  }
  all.push_back({group, "long dynamic has none: dF/du is not symmetric at b = 0, eps > 0", "exact dynamic film", holds,
                 long_dynamic_is_asymmetric, "2 W2 - W1' = -24 eps^3/(D^2 q)"});
  for (const Slips& film : half_films()) {
    all.push_back({group, film.name + ": two velocities for one force, a and -a where b < 0 and F_t = 0",
                   "the film mirrored at a < 0", holds, [film](Proof& proof) { two_velocities(proof, film); }});
    all.push_back({group, film.name + " is not monotone: (F1 - F2).(u1 - u2) > 0 at half that slip",
                   "the film mirrored at a < 0", holds, [film](Proof& proof) { not_monotone(proof, film); },
                   "so its potential is not convex across a = 0"});
  }
  all.push_back({group, "WRONG: long dynamic: W2 = W1'/2", "exact dynamic film", wrong,
                 [](Proof& proof) { across_is_slope(proof, long_dynamic, frac(1, 2)); }});
  all.push_back({group, "WRONG: short dynamic: W2 = W1'", "exact dynamic film altered", wrong,
                 [](Proof& proof) { across_is_slope(proof, short_dynamic, 1); }});
  all.push_back({group, "WRONG: long half of eq. 5: F = -grad(Phi)/2", "eq. 5", wrong,
                 [](Proof& proof) { is_gradient(proof, named("long half of eq. 5 cut at pi")); }});
  all.push_back({group, "WRONG: short full is monotone with half the square of e.(u - w)", "eqs. 6, 7 altered", wrong,
                 [s](Proof& proof) { full_is_monotone(proof, named("short full"), Pi / pow(s, 5), 2); }});
  return all;
}

}  // namespace lubjoint::proofs

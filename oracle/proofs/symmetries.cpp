// Vector form = polar form of every law; mirror symmetry, homogeneity, linearity, frame indifference.

#include <stdexcept>

#include "oracle/proofs/laws.hpp"
#include "oracle/proofs/ledger.hpp"

namespace lubjoint::proofs {

namespace {

/// ê = ε r and u = b r − (a/2) t with a = 2|u| cosθs, b = |u| sinθs, for any direction of r.
void vector_is_polar(Proof& proof, const std::function<Planar(const PlaneState&)>& vector, const Polar& polar) {
  const symbol c("cos_e"), w("sin_e");
  const Algebra algebra = film_algebra().root(w, 1 - c * c);
  const Planar r{c, w};
  const Planar t = turned_90(r);
  const Symbols& y = sym();
  const Planar u = y.speed * y.sin_start * r - y.speed * y.cos_start * t;
  PlaneState state;
  state.eps = y.eps;
  state.s = y.s;
  state.speed = y.speed;
  state.sigma = y.sigma;
  state.delta = y.delta;
  state = state.with(y.eps * r, u);
  const Planar force = vector(state);
  // sgn(a) = −sgn(ê × u): ê × u = −εa/2.
  proof.equal(algebra, state.e_cross_u, (-y.eps * y.a / 2).subs(in_dynamic_motion()));
  proof.equal(algebra, dot(u, u), pow(y.speed, 2));
  equal(proof, algebra, force, polar.radial * r + polar.tangential * t);
}

Planar mirrored(const Planar& v) { return {v.x, -v.y}; }

/// (ê, u) mirrored at the x axis: a and σ change sign, b, |u| and δ do not.
void mirror(Proof& proof, const Law& law, bool turn_sigma) {
  const FreeState free;
  PlaneState image = free.state.with(mirrored(free.state.e_hat), mirrored(free.state.u));
  if (turn_sigma) image.sigma = -image.sigma;
  equal(proof, free.algebra, law.vector(image), mirrored(law.vector(free.state)));
}

void mirror_polar(Proof& proof, const Polar& law) {
  const Symbols& y = sym();
  const Polar image = law.subs({{y.cos_start, -y.cos_start}, {y.sigma, -y.sigma}});
  equal(proof, film_algebra(), image, {law.radial, -law.tangential});
}

void homogeneous(Proof& proof, const Law& law, int degree) {
  const FreeState free;
  const symbol factor("lambda");
  PlaneState scaled = free.state.with(free.state.e_hat, factor * free.state.u);
  scaled.speed = factor * scaled.speed;
  equal(proof, free.algebra, law.vector(scaled), pow(factor, degree) * law.vector(free.state));
}

/// F(ê, u + w) = F(ê, u) + F(ê, w), every state with its own |u|, and with σ and δ held fixed.
void additive(Proof& proof, const Law& law) {
  const FreeState free;
  const symbol w_x("w_x"), w_y("w_y"), w_speed("speed_w"), sum_speed("speed_sum");
  const Planar w{w_x, w_y};
  Algebra algebra = free.algebra;
  PlaneState other = free.state.with(free.state.e_hat, w);
  PlaneState sum = free.state.with(free.state.e_hat, free.state.u + w);
  other.speed = w_speed;
  sum.speed = sum_speed;
  algebra.root(w_speed, dot(w, w)).root(sum_speed, dot(sum.u, sum.u));
  equal(proof, algebra, law.vector(sum), law.vector(free.state) + law.vector(other));
}

/// The force turns with (ê, u). The scalars of the state do not change: this is proved first, and then they stand as
/// symbols of their own, with no relation to the vectors.
void turns(Proof& proof, const Law& law, bool turn_velocity) {
  const FreeState free;
  const ex c = cos(free.angle), w = sin(free.angle);
  PlaneState y = free.state;
  PlaneState image = y.with(turned(y.e_hat, c, w), turn_velocity ? turned(y.u, c, w) : y.u);
  proof.equal(free.algebra, image.e_e, y.e_e);
  proof.equal(free.algebra, dot(image.u, image.u), dot(y.u, y.u));
  proof.equal(free.algebra, image.e_dot_u, y.e_dot_u);
  proof.equal(free.algebra, image.e_cross_u, y.e_cross_u);
  const symbol e_e("e_e"), e_dot_u("e_dot_u"), e_cross_u("e_cross_u");
  for (PlaneState* state : {&y, &image}) {
    state->e_e = e_e;
    state->e_dot_u = e_dot_u;
    state->e_cross_u = e_cross_u;
  }
  equal(proof, free.algebra, law.vector(image), turned(law.vector(y), c, w));
}

/// e, v and both spins seen by an observer who turns with the rate Ω: ė gains Ω e⊥ and each spin gains Ω.
struct Observer {
  symbol e_x{"e_x"}, e_y{"e_y"}, v_x{"v_x"}, v_y{"v_y"}, journal{"omega_J"}, bearing{"omega_B"}, rate{"Omega"};
  symbol length{"e"}, c{"c"}, angle{"angle"};
  Planar e{e_x, e_y}, v{v_x, v_y};
  Algebra algebra = Algebra().root(length, e_x* e_x + e_y * e_y).angle(angle);

  Planar seen(const Planar& w) const { return turned(w, cos(angle), sin(angle)); }
  Planar seen_velocity() const { return seen(v) + rate * turned_90(seen(e)); }
  ex squeeze(const Planar& ee, const Planar& vv) const { return dot(vv, ee) / length / c; }
  ex sliding(const Planar& ee, const Planar& vv) const { return dot(vv, turned_90(ee)) / length / c; }
  ex slip(const Planar& ee, const Planar& vv, const ex& spins) const {
    return length / c * spins - 2 * sliding(ee, vv);
  }
  Planar pure_squeeze(const Planar& ee, const Planar& vv, const ex& spins) const {
    return 1 / ex(c) * (vv - spins / 2 * turned_90(ee));
  }
};

void film_state_is_indifferent(Proof& proof) {
  const Observer o;
  const Planar e = o.seen(o.e);
  const Planar v = o.seen_velocity();
  const ex spins = o.journal + o.bearing;
  proof.equal(o.algebra, o.squeeze(e, v), o.squeeze(o.e, o.v));
  proof.equal(o.algebra, o.slip(e, v, spins + 2 * o.rate), o.slip(o.e, o.v, spins));
  equal(proof, o.algebra, o.pure_squeeze(e, v, spins + 2 * o.rate), o.seen(o.pure_squeeze(o.e, o.v, spins)));
}

void pure_squeeze_velocity(Proof& proof) {
  const Observer o;
  const ex spins = o.journal + o.bearing;
  const Planar r = 1 / ex(o.length) * o.e;
  const Planar u = o.pure_squeeze(o.e, o.v, spins);
  proof.equal(o.algebra, dot(u, r), o.squeeze(o.e, o.v));
  proof.equal(o.algebra, -2 * dot(u, turned_90(r)), o.slip(o.e, o.v, spins));
}

/// a = ε(ω − 2γ̇), ω = ω_J − ω_B, with γ̇ in the frame of the bearing: γ̇ = v·t/|e| − ω_B; or inertial (wrong).
void slip_by_attitude(Proof& proof, bool relative_to_bearing) {
  const Observer o;
  const ex inertial = o.c * o.sliding(o.e, o.v) / o.length;
  const ex attitude_rate = relative_to_bearing ? inertial - o.bearing : inertial;
  proof.equal(o.algebra, o.length / o.c * (o.journal - o.bearing - 2 * attitude_rate),
              o.slip(o.e, o.v, o.journal + o.bearing));
}

void relative_spin_with_inertial_rate(Proof& proof) {
  const Observer o;
  const ex spin = o.journal - o.bearing;
  proof.equal(o.algebra, o.slip(o.seen(o.e), o.seen_velocity(), spin), o.slip(o.e, o.v, spin));
}

void add_mistakes(std::vector<Statement>& all) {
  using enum Expectation;
  const auto law = [](const std::string& name) {
    for (const Law& each : laws()) {
      if (each.name == name) return each;
    }
    throw std::logic_error("no such law: " + name);
  };
  all.push_back({"vector form = polar form", "WRONG: short full in vectors with 2 (e.u) e for 3 (e.u) e",
                 "eqs. 6, 7 altered", wrong, [law](Proof& proof) {
                   const auto altered = [](const PlaneState& y) {
                     return -Pi / pow(y.s, 5) * (pow(y.s, 2) * y.u + 2 * dot(y.e_hat, y.u) * y.e_hat);
                   };
                   vector_is_polar(proof, altered, law("short full").polar);
                 }});
  all.push_back({"mirror symmetry", "WRONG: short half, film not mirrored at a < 0", "eqs. 8, 9 not mirrored", wrong,
                 [law](Proof& proof) { mirror(proof, law("short half"), false); }});
  all.push_back({"homogeneity and linearity", "WRONG: short half is linear in u across a = 0", "eqs. 8, 9", wrong,
                 [](Proof& proof) {
                   // F(−u) = −F(u) would follow; |a| and so σa keep their sign.
                   const GiNaC::exmap reversed{{sym().a, -sym().a}, {sym().b, -sym().b}, {sym().sigma, -sym().sigma}};
                   equal(proof, film_algebra(), short_half().subs(reversed), -1 * short_half());
                 }});
  all.push_back({"homogeneity and linearity", "WRONG: Pinkus-Sternlicht, b >= 0, is linear in u", "eqs. 14, 15", wrong,
                 [law](Proof& proof) { additive(proof, law("Pinkus-Sternlicht, b >= 0")); }});
  all.push_back(
      {"homogeneity and linearity", "WRONG: short dynamic is linear in u: F(-u) = -F(u)", "exact dynamic film", wrong,
       [law](Proof& proof) {
         const Symbols& y = sym();
         const GiNaC::exmap reversed{{y.cos_start, -y.cos_start}, {y.sin_start, -y.sin_start}, {y.delta, Pi - y.delta}};
         const Polar film = law("short dynamic").polar;
         equal(proof, film_algebra(), film.subs(reversed), -1 * film);
       }});
  all.push_back({"homogeneity and linearity", "WRONG: short dynamic is homogeneous of degree two",
                 law("short dynamic").source, wrong,
                 [law](Proof& proof) { homogeneous(proof, law("short dynamic"), 2); }});
  all.push_back({"frame indifference", "WRONG: the force turns when e alone is turned", "eqs. 6, 7", wrong,
                 [law](Proof& proof) { turns(proof, law("short full"), false); }});
  all.push_back({"frame indifference", "WRONG: a = eps (omega_J - omega_B) - 2 v.t/c does not depend on the observer",
                 "relative spin with inertial attitude rate", wrong, relative_spin_with_inertial_rate});
  all.push_back({"frame indifference", "WRONG: a = eps (omega - 2 gamma') with the inertial attitude rate",
                 "relative spin with inertial attitude rate", wrong,
                 [](Proof& proof) { slip_by_attitude(proof, false); }});
}

}  // namespace

std::vector<Statement> symmetry_statements() {
  using enum Expectation;
  std::vector<Statement> all;
  for (const Law& law : laws()) {
    all.push_back({"vector form = polar form", law.name, law.source, holds,
                   [law](Proof& proof) { vector_is_polar(proof, law.vector, law.polar); }});
  }
  for (const Law& law : laws()) {
    all.push_back({"mirror symmetry", law.name + ": F_r(-a) = F_r(a), F_t(-a) = -F_t(a), and in the plane", law.source,
                   holds, [law](Proof& proof) {
                     mirror_polar(proof, law.polar);
                     mirror(proof, law, true);
                   }});
  }
  for (const Law& law : laws()) {
    all.push_back({"homogeneity and linearity", law.name + ": F(lambda u) = lambda F(u), lambda > 0", law.source, holds,
                   [law](Proof& proof) { homogeneous(proof, law, 1); }});
  }
  for (const Law& law : laws()) {
    if (law.name != "short full" && law.name != "long full") continue;
    all.push_back({"homogeneity and linearity", law.name + ": F(u + w) = F(u) + F(w)", law.source, holds,
                   [law](Proof& proof) { additive(proof, law); }});
  }
  for (const Law& law : laws()) {
    all.push_back({"frame indifference", law.name + ": the force turns with (e, u)", law.source, holds,
                   [law](Proof& proof) { turns(proof, law, true); }});
  }
  all.push_back({"frame indifference", "b, a and u are the same for an observer who turns, u turned with the frame",
                 "film state", holds, film_state_is_indifferent});
  all.push_back({"frame indifference", "b = u.r and a = -2 u.t with u = (v - (omega_J + omega_B) e^perp/2)/c",
                 "film state", holds, pure_squeeze_velocity});
  all.push_back({"frame indifference", "a = eps (omega - 2 gamma') with gamma' in the frame of the bearing",
                 "before eq. 3", holds, [](Proof& proof) { slip_by_attitude(proof, true); }});
  add_mistakes(all);
  return all;
}

}  // namespace lubjoint::proofs

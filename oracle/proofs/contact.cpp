// Dry contact of Lankarani and Nikravesh, and the transition from film to contact (eq. 20).

#include "oracle/proofs/formulas.hpp"
#include "oracle/proofs/ledger.hpp"

namespace lubjoint::proofs {

namespace {

const char* const impact = "dry contact";
const char* const transition = "transition from film to contact";

using GiNaC::log;

/// A free impact m dv/dt = −Kδⁿ(1 + d v), v = dδ/dt, with constant d.
struct Impact {
  symbol v{"v"}, delta{"delta"}, d{"d"}, stiffness{"K"}, mass{"m"}, n{"n"}, entry{"v_0"}, exit{"v_1"};

  /// G = (d v − ln(1 + d v))/d², the antiderivative of v/(1 + d v).
  ex speed_part(const ex& speed) const { return (d * speed - log(1 + d * speed)) / pow(d, 2); }
  ex penetration_part() const { return stiffness / mass * pow(delta, n + 1) / (n + 1); }
  ex deceleration() const { return -stiffness / mass * pow(delta, n) * (1 + d * v); }
};

void speed_integral(Proof& proof) {
  const Impact y;
  proof.equal(Algebra(), y.speed_part(y.v).diff(y.v), y.v / (1 + y.d * y.v));
}

/// δⁿ⁺¹ = δ·δⁿ, with δⁿ as a symbol: the exponent stays general.
ex with_power_as_symbol(const Impact& y, const ex& expression, const symbol& power) {
  return expression.expand().subs(GiNaC::exmap{{pow(y.delta, y.n + 1), y.delta * power}, {pow(y.delta, y.n), power}});
}

void invariant(Proof& proof) {
  const Impact y;
  const symbol power("delta_n");
  const ex rate = y.speed_part(y.v).diff(y.v) * y.deceleration() + y.penetration_part().diff(y.delta) * y.v;
  proof.zero(Algebra(), with_power_as_symbol(y, rate, power));
  // Hertz' exponent, written out.
  const ex hertz = rate.subs(y.n == frac(3, 2));
  const symbol root("root_delta");
  proof.zero(Algebra(), hertz.subs(pow(y.delta, frac(3, 2)) == pow(root, 3)));
}

/// G(δ̇₀) = G(−v₁), times d².
void exit_speed(Proof& proof, int sign_in_log) {
  const Impact y;
  const ex balance = (y.speed_part(y.entry) - y.speed_part(-y.exit)) * pow(y.d, 2);
  const ex claimed = (y.d * y.entry - log(1 + y.d * y.entry)) - (-y.d * y.exit - log(1 + sign_in_log * y.d * y.exit));
  proof.equal(Algebra(), balance, claimed);
}

/// With d = 3(1 − c²)/(4δ̇₀) and v₁ = c δ̇₀ the balance f(c) is not zero, but f′ = O((1 − c)³) and f(1) = 0.
ex restitution_balance(const symbol& c) {
  const ex x = frac(3, 4) * (1 - c * c);
  return x - log(1 + x) + x * c + log(1 - x * c);
}

void restitution_near_one(Proof& proof) {
  const symbol c("c_r");
  const ex slope = restitution_balance(c).diff(c).normal();
  proof.zero(Algebra(), restitution_balance(c).subs(c == 1));
  for (int order = 0; order < 3; ++order)
    proof.zero(Algebra(), slope.diff(c, static_cast<unsigned>(order)).subs(c == 1));
}

void restitution_exact(Proof& proof) {
  // A function that vanishes identically has a slope that does.
  const symbol c("c_r");
  proof.zero(Algebra(), restitution_balance(c).diff(c));
}

struct Blend {
  symbol length{"e"}, c{"c"}, e0{"e_0"}, gap{"w"}, film{"F_film"}, dry{"F_dry"};

  ex blended() const { return ((c + e0 - length) * film + (length - c) * dry) / e0; }
  ex swapped() const { return ((c + e0 - length) * dry + (length - c) * film) / e0; }
};

void seams(Proof& proof, const ex& blended, const Blend& y) {
  proof.equal(Algebra(), blended.subs(y.length == y.c), y.film);
  proof.equal(Algebra(), blended.subs(y.length == y.c + y.e0), y.dry);
}

void weights(Proof& proof) {
  const Blend y;
  const symbol part("x");
  const ex film = y.blended().diff(y.film), dry = y.blended().diff(y.dry);
  proof.equal(Algebra(), film + dry, 1);
  // Between the seams, |e| = c + x e₀.
  proof.equal(Algebra(), film.subs(y.length == y.c + part * y.e0), 1 - part);
  proof.equal(Algebra(), dry.subs(y.length == y.c + part * y.e0), part);
}

/// 1 − ε² of a film with the given clearance. The transition uses c + e₁, e₁ = e₀ + w, w > 0.
ex film_q(const ex& clearance, const ex& length) { return 1 - pow(length / clearance, 2); }

void film_stays_finite(Proof& proof) {
  const Blend y;
  const ex clearance = y.c + y.e0 + y.gap;
  const ex q_at_seam = film_q(clearance, y.c + y.e0) * pow(clearance, 2);
  proof.equal(Algebra(), q_at_seam, y.gap * (2 * y.c + 2 * y.e0 + y.gap));
  proof.positive(q_at_seam.normal().expand(), {y.c, y.e0, y.gap});
  // q falls with |e|: it is smallest at the seam.
  proof.positive((-film_q(clearance, y.length).diff(y.length) * pow(clearance, 2)).normal(), {y.length});
}

void film_with_nominal_clearance(Proof& proof) {
  const Blend y;
  proof.positive((film_q(y.c, y.c + y.e0) * pow(y.c, 2)).normal().expand(), {y.c, y.e0});
}

}  // namespace

std::vector<Statement> contact_statements() {
  using enum Expectation;
  const std::string source = "Lankarani and Nikravesh";
  std::vector<Statement> all;
  all.push_back(
      {impact, "(d v - ln(1 + d v))/d^2 is the antiderivative of v/(1 + d v)", source, holds, speed_integral});
  all.push_back({impact, "free impact: (d v - ln(1 + d v))/d^2 + (K/m) delta^(n+1)/(n+1) is constant", source, holds,
                 invariant, "any exponent n, and Hertz' 3/2 written out; d = 3(1 - c_r^2)/(4 v_0)"});
  all.push_back(
      {impact, "exit speed: d v_0 - ln(1 + d v_0) = -d v_1 - ln(1 - d v_1), whatever K, m and n", source, holds,
       [](Proof& proof) { exit_speed(proof, -1); },
       "delta = 0 at both ends; the left side grows without bound as d v falls to -1: the force 1 + d v stays "
       "positive"});
  all.push_back({impact, "c_r -> 1: the exit speed c_r v_0 leaves an imbalance of fourth order in 1 - c_r", source,
                 holds, restitution_near_one, "so c_r is the restitution only near 1"});
  all.push_back({impact, "WRONG: the exit speed is c_r v_0", source, wrong, restitution_exact});
  all.push_back({impact, "WRONG: exit speed with ln(1 + d v_1)", source + " altered", wrong,
                 [](Proof& proof) { exit_speed(proof, 1); }});
  all.push_back({transition, "F is F_film at |e| = c and F_dry at |e| = c + e0", "eq. 20", holds,
                 [](Proof& proof) {
                   const Blend y;
                   seams(proof, y.blended(), y);
                 },
                 "continuous at both seams for every film and contact law"});
  all.push_back({transition, "between the seams F is a weighted mean of F_film and F_dry", "eq. 20", holds, weights});
  all.push_back({transition, "the film with clearance c + e1, e1 > e0, has q > 0 up to |e| = c + e0", "eq. 20", holds,
                 film_stays_finite, "so the film force is finite in the blend"});
  all.push_back({transition, "WRONG: transition with the weights swapped", "eq. 20 altered", wrong, [](Proof& proof) {
                   const Blend y;
                   seams(proof, y.swapped(), y);
                 }});
  all.push_back({transition, "WRONG: the film with clearance c has q > 0 up to |e| = c + e0", "eq. 20 altered", wrong,
                 film_with_nominal_clearance});
  return all;
}

}  // namespace lubjoint::proofs

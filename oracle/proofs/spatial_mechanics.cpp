// Bodies with Euler parameters (eqs. 35 to 37), and the constraints between them (eqs. 38 to 41).

#include "oracle/proofs/ledger.hpp"
#include "oracle/proofs/spatial.hpp"

namespace lubjoint::proofs {

namespace {

const char* const bodies = "bodies in space";
const char* const constraints = "constraints in space";

const Spatial unit_x{1, 0, 0};
const Spatial unit_y{0, 1, 0};
const Spatial unit_z{0, 0, 1};

Algebra algebra_of(const MovingBody& body) {
  Algebra algebra;
  body.add_relation(algebra);
  return algebra;
}

// Bodies.

void orthogonal(Proof& proof) {
  const MovingBody b("b");
  const Algebra algebra = algebra_of(b);
  const SpatialSymbol v("v"), w("w");
  proof.equal(algebra, dot(b.turned(v), b.turned(w)), dot(v, w));
  equal(proof, algebra, cross(b.turned(v), b.turned(w)), b.turned(cross(v, w)));
  equal(proof, algebra, turned_back(b.p(), b.turned(v)), v);
  equal(proof, algebra, turned({-b.e0, -Spatial(b.e)}, v), b.turned(v));
}

/// e₀ = cos(θ/2), e = sin(θ/2) n: v cosθ + n × v sinθ + n(n·v)(1 − cosθ).
void turn_about_an_axis(Proof& proof) {
  const symbol c("cos_half"), s("sin_half");
  const SpatialSymbol n("n"), v("v");
  const Algebra algebra = Algebra().root(s, 1 - pow(c, 2)).root(n.z, 1 - pow(n.x, 2) - pow(n.y, 2));
  const ex cosine = pow(c, 2) - pow(s, 2);
  const Spatial expected = cosine * Spatial(v) + 2 * s * c * cross(n, v) + (1 - cosine) * dot(n, v) * Spatial(n);
  equal(proof, algebra, turned({c, s * Spatial(n)}, v), expected);
}

/// For any ṗ along |p| = 1: d/dt(A v′) = A(ω′ × v′) with ω′ = factor · L ṗ; or with the matrix of the inertial spin,
/// [−e, ẽ + e₀I], in L's place.
void spin_of_rates(Proof& proof, const ex& factor, bool inertial) {
  const MovingBody b("b");
  const Algebra algebra = algebra_of(b);
  const SpatialSymbol rate("e_dot"), v("v");
  const ex first = -dot(b.e, rate) / b.e0;
  const Spatial spin =
      factor * (inertial ? times_l({b.e0, -Spatial(b.e)}, {-first, rate}) : times_l(b.p(), {first, rate}));
  const Spatial at = b.turned(v);
  const auto along = [&](const ex& f) {
    return f.diff(b.e0) * first + f.diff(b.e.x) * rate.x + f.diff(b.e.y) * rate.y + f.diff(b.e.z) * rate.z;
  };
  equal(proof, algebra, {along(at.x), along(at.y), along(at.z)}, b.turned(cross(spin, v)));
}

/// L Lᵀ = I, L p = 0: ṗ = ½Lᵀω′ gives ω′ back, and keeps |p|.
void rates_of_spin(Proof& proof, const ex& factor) {
  const MovingBody b("b");
  const Algebra algebra = algebra_of(b);
  const Parameters rate = times_l_transposed(b.p(), factor * Spatial(b.w));
  equal(proof, algebra, 2 * times_l(b.p(), rate), b.w);
  equal(proof, algebra, times_l(b.p(), b.p()), {0, 0, 0});
  proof.zero(Algebra(), b.e0 * rate.first + dot(b.e, rate.rest));
}

struct Inertia {
  symbol xx{"J_xx"}, yy{"J_yy"}, zz{"J_zz"}, xy{"J_xy"}, xz{"J_xz"}, yz{"J_yz"};

  Spatial operator()(const Spatial& w) const {
    return {xx * w.x + xy * w.y + xz * w.z, xy * w.x + yy * w.y + yz * w.z, xz * w.x + yz * w.y + zz * w.z};
  }
};

/// d/dt(A J′ω′) = A n′ with J′ω̇′ + sign · ω′ × J′ω′ = n′; and the power ω′·n′ is the rate of ½ω′·J′ω′.
void rotation(Proof& proof, int sign) {
  const MovingBody b("b");
  const Algebra algebra = algebra_of(b);
  const Inertia inertia;
  const Spatial moment = inertia(b.alpha) + sign * cross(b.w, inertia(b.w));
  const Spatial momentum = b.turned(inertia(b.w));
  equal(proof, algebra, {b.rate(momentum.x), b.rate(momentum.y), b.rate(momentum.z)}, b.turned(moment));
  proof.equal(algebra, b.rate(dot(b.w, inertia(b.w)) / 2), dot(b.w, moment));
}

// Constraints.

/// What a row acts on the motion of a body with: its force and its moment for a unit multiplier, inertial.
struct Columns {
  Spatial force;
  Spatial moment;
};

/// Two bodies in motion, and the identities that a row of Φ has to fulfil along it.
struct Pair {
  MovingBody i{"i"}, j{"j"};
  symbol t{"t"};
  Algebra algebra;

  Pair() {
    i.add_relation(algebra);
    j.add_relation(algebra);
  }
  ex rate(const ex& f) const { return (f.diff(t) + i.rate(f) + j.rate(f)).expand(); }
  static ex share(const Columns& c, const Spatial& force_by, const Spatial& moment_by) {
    return dot(c.force, force_by) + dot(c.moment, moment_by);
  }
  /// Φ̇ = columns · (ṙ, ω) + Φt and Φ̈ = columns · (r̈, ω̇) − γ.
  void row(Proof& proof, const ex& phi, const Columns& first, const Columns& second, const ex& gamma) const {
    const ex once = rate(phi);
    proof.equal(algebra, once, share(first, i.v, i.spin()) + share(second, j.v, j.spin()) + phi.diff(t));
    proof.equal(algebra, rate(once), share(first, i.a, i.spin_rate()) + share(second, j.a, j.spin_rate()) - gamma);
  }
};

/// Points s_i′, s_j′ of the two bodies, and d with what is left of its rates without r̈ and ω̇.
struct Points {
  SpatialSymbol s_i{"s_i"}, s_j{"s_j"};
  Spatial arm_i, arm_j, d, rate, second;

  explicit Points(const Pair& y)
      : arm_i(y.i.turned(s_i)),
        arm_j(y.j.turned(s_j)),
        d(y.j.point(s_j) - y.i.point(s_i)),
        rate(Spatial(y.j.v) + y.j.turning(s_j) - y.i.v - y.i.turning(s_i)),
        second(y.j.turning_twice(s_j) - y.i.turning_twice(s_i)) {}
};

void spherical(Proof& proof) {
  const Pair y;
  const Points p(y);
  const std::array<std::pair<Spatial, ex>, 3> rows = {std::pair{unit_x, p.d.x}, {unit_y, p.d.y}, {unit_z, p.d.z}};
  for (const auto& [unit, phi] : rows) {
    y.row(proof, phi, {-unit, -cross(p.arm_i, unit)}, {unit, cross(p.arm_j, unit)}, -dot(unit, p.second));
  }
}

/// γ = −ä·b − mixed ȧ·ḃ − a·b̈, mixed = 2.
void perpendicular_axes(Proof& proof, const ex& mixed) {
  const Pair y;
  const SpatialSymbol a_i("a"), b_j("b");
  const Spatial a = y.i.turned(a_i), b = y.j.turned(b_j);
  const ex gamma = -dot(y.i.turning_twice(a_i), b) - mixed * dot(y.i.turning(a_i), y.j.turning(b_j)) -
                   dot(a, y.j.turning_twice(b_j));
  const Spatial none{0, 0, 0};
  y.row(proof, dot(a, b), {none, cross(a, b)}, {none, -cross(a, b)}, gamma);
}

/// The rate of what is prescribed, f₀ + f₁ t + ½ f₂ t².
struct Prescribed {
  symbol start{"f_0"}, speed{"f_1"}, acceleration{"f_2"};
  ex at(const symbol& t) const { return start + speed * t + acceleration * pow(t, 2) / 2; }
};

/// a·d = f(t): a slider's motor, and with f = 0 the block. The arm is the distance from P_i to where the force acts.
void perpendicular_distance(Proof& proof, bool with_distance_in_arm) {
  const Pair y;
  const Points p(y);
  const SpatialSymbol a_i("a");
  const Prescribed f;
  const Spatial a = y.i.turned(a_i);
  const Spatial arm = with_distance_in_arm ? p.arm_i + p.d : p.arm_i;
  const ex gamma =
      f.acceleration - dot(y.i.turning_twice(a_i), p.d) - 2 * dot(y.i.turning(a_i), p.rate) - dot(a, p.second);
  y.row(proof, dot(a, p.d) - f.at(y.t), {-a, -cross(arm, a)}, {a, cross(p.arm_j, a)}, gamma);
}

void distance(Proof& proof) {
  const Pair y;
  const Points p(y);
  const symbol length("l");
  const Spatial along = 1 / length * p.d;
  const ex gamma = -(dot(p.rate, p.rate) + dot(p.d, p.second)) / length;
  y.row(proof, (dot(p.d, p.d) - pow(length, 2)) / (2 * length), {-along, -cross(p.arm_i, along)},
        {along, cross(p.arm_j, along)}, gamma);
}

/// θ = atan(S/C) of two blocks C = t₁i·t₁j, S = t₂i·t₁j, of which only the rates are needed.
void rotational_driver(Proof& proof, const ex& mixed) {
  const symbol c("C"), s("S"), c_rate("C_rate"), s_rate("S_rate"), c_left("C_left"), s_left("S_left"), t("t");
  const SpatialSymbol alpha("alpha"), t1_i("t1_i"), t2_i("t2_i"), t1_j("t1_j");  // ω̇_i − ω̇_j and the axes
  const Prescribed f;
  const ex square = pow(c, 2) + pow(s, 2);
  // By the block: the angular accelerations' share of the second rates.
  const ex c_second = c_left + dot(alpha, cross(t1_i, t1_j));
  const ex s_second = s_left + dot(alpha, cross(t2_i, t1_j));
  const auto rate = [&](const ex& g) {
    return g.diff(c) * c_rate + g.diff(s) * s_rate + g.diff(c_rate) * c_second + g.diff(s_rate) * s_second + g.diff(t);
  };
  const ex phi = GiNaC::atan(s / c) - f.at(t);
  const ex turning = (c * s_rate - s * c_rate) / square;
  proof.equal(Algebra(), rate(phi), turning - f.speed - f.acceleration * t);
  const Spatial m = 1 / square * cross(c * Spatial(t2_i) - s * Spatial(t1_i), t1_j);
  const ex gamma =
      f.acceleration - (c * s_left - s * c_left) / square + mixed * (c * c_rate + s * s_rate) * turning / square;
  proof.equal(Algebra(), rate(rate(phi)), dot(alpha, m) - gamma);
}

/// Where the axes coincide, that row turns about −n (on ω_i − ω_j), and θ is the angle between the bodies.
void driver_in_place(Proof& proof) {
  const MovingBody b("i");
  const symbol theta("theta");
  Algebra algebra = algebra_of(b);
  algebra.angle(theta);
  const Spatial t1 = b.turned(unit_x), t2 = b.turned(unit_y), n = b.turned(unit_z);
  const Spatial t1_j = cos(theta) * t1 + sin(theta) * t2;
  const ex c = dot(t1, t1_j), s = dot(t2, t1_j);
  proof.equal(algebra, c, cos(theta));
  proof.equal(algebra, s, sin(theta));
  equal(proof, algebra, cross(cos(theta) * t2 - sin(theta) * t1, t1_j), -n);
}

/// Where a joint is closed, its rows' rates are components of the bodies' relative motion, each once: w = ω_j − ω_i and
/// v, the rate of P_j seen from body i, in the axes of body i, which turns by any ω_i itself.
struct ClosedJoint {
  symbol theta{"theta"}, slid{"sigma"};
  SpatialSymbol turning{"w_i"}, w{"w"}, v{"v"};
  Algebra algebra = Algebra().angle(theta);
  Spatial t1_j{cos(theta), sin(theta), 0}, t2_j{-sin(theta), cos(theta), 0}, n_j{0, 0, 1};
  Spatial d{0, 0, slid};

  /// d/dt(a_i·b_j): ȧ_i = ω_i × a_i, ḃ_j = ω_j × b_j. The mistake: b_j as if it turned by w alone.
  ex axes(const Spatial& a, const Spatial& b, bool with_both = true) const {
    const Spatial spin_j = with_both ? Spatial(turning) + w : Spatial(w);
    return dot(cross(turning, a), b) + dot(a, cross(spin_j, b));
  }
  /// d/dt(a_i·d): ḋ = v + ω_i × d.
  ex across(const Spatial& a) const { return dot(cross(turning, a), d) + dot(a, Spatial(v) + cross(turning, d)); }
};

void closed_joints(Proof& proof, bool with_both) {
  const ClosedJoint y;
  // Revolute and cylindrical: t₁i·n_j, t₂i·n_j; prismatic: t₁i·t₂j, where both frames coincide.
  proof.equal(y.algebra, y.axes(unit_x, y.n_j, with_both), y.w.y);
  proof.equal(y.algebra, y.axes(unit_y, y.n_j, with_both), -y.w.x);
  const GiNaC::exmap coincide{{cos(y.theta), 1}, {sin(y.theta), 0}};
  const auto held = [&](const Spatial& a, const Spatial& b) { return y.axes(a, b, with_both).subs(coincide); };
  proof.equal(y.algebra, held(unit_x, y.t2_j), -y.w.z);
  // Spherical, and across the axis of the cylindrical: d; along it, planar: n_i·d.
  proof.equal(y.algebra, y.across(unit_x), y.v.x);
  proof.equal(y.algebra, y.across(unit_y), y.v.y);
  proof.equal(y.algebra, y.across(unit_z), y.v.z);
  // Fixed: t₁i·t₂j, t₂i·n_j, n_i·t₁j.
  proof.equal(y.algebra, held(unit_y, y.n_j), -y.w.x);
  proof.equal(y.algebra, held(unit_z, y.t1_j), -y.w.y);
  // A turn by θ about n and a way along it leave the rows of the cylindrical joint at zero.
  for (const Spatial& a : {unit_x, unit_y}) {
    proof.zero(y.algebra, dot(a, y.n_j));
    proof.zero(y.algebra, dot(a, y.d));
  }
  // Universal: n_i·n_j of two axes at right angles: what turns about either is free.
  const symbol first("w_i"), second("w_j");
  proof.zero(y.algebra, dot(unit_z, cross(first * unit_z + second * y.t1_j, y.t1_j)));
}

/// In the plane the rows of the spherical joint are those of the planar revolute: γ = ω_j² s_j − ω_i² s_i.
void plane(Proof& proof) {
  const symbol spin_i("omega_i"), spin_j("omega_j"), six("s_ix"), siy("s_iy"), sjx("s_jx"), sjy("s_jy");
  const Spatial w_i = spin_i * unit_z, w_j = spin_j * unit_z, s_i{six, siy, 0}, s_j{sjx, sjy, 0};
  const Spatial gamma = cross(w_i, cross(w_i, s_i)) - cross(w_j, cross(w_j, s_j));
  equal(proof, Algebra(), gamma, pow(spin_j, 2) * s_j - pow(spin_i, 2) * s_i);
  // A about z by φ is the plane's turn.
  const symbol half("phi_half"), x("x"), y("y");
  const ex c = pow(cos(half), 2) - pow(sin(half), 2), s = 2 * sin(half) * cos(half);
  equal(proof, Algebra().angle(half), turned({cos(half), sin(half) * unit_z}, {x, y, 0}),
        {c * x - s * y, s * x + c * y, 0});
}

}  // namespace

std::vector<Statement> spatial_mechanics_statements() {
  using enum Expectation;
  std::vector<Statement> all;
  all.push_back({bodies, "A(p) is a rotation, and A(-p) = A(p)", "eq. 35", holds, orthogonal, "where |p| = 1"});
  all.push_back(
      {bodies, "A(cos(theta/2), n sin(theta/2)) turns by theta about n", "eq. 35", holds, turn_about_an_axis});
  all.push_back({bodies, "d/dt(A v') = A(w' x v') with w' = 2 L p_dot", "eq. 36", holds,
                 [](Proof& proof) { spin_of_rates(proof, 2, false); }, "for every p_dot along |p| = 1"});
  all.push_back({bodies, "p_dot = L^T w'/2 gives w' back and keeps |p|", "eq. 36", holds,
                 [](Proof& proof) { rates_of_spin(proof, frac(1, 2)); }, "L L^T = I and L p = 0"});
  all.push_back({bodies, "J' w'_dot + w' x J' w' = n': A J' w' changes by A n', its energy by w'.n'", "eq. 37", holds,
                 [](Proof& proof) { rotation(proof, 1); }});
  all.push_back(
      {constraints, "spherical: row and gamma", "eq. 40", holds, spherical, "P_j = P_i, along any motion p(t)"});
  all.push_back({constraints, "perpendicular axes, a_i.b_j = 0: row and gamma", "eq. 40", holds,
                 [](Proof& proof) { perpendicular_axes(proof, 2); }});
  all.push_back({constraints, "perpendicular distance, a_i.d = f(t), a driver's too: row and gamma", "eq. 40", holds,
                 [](Proof& proof) { perpendicular_distance(proof, true); }});
  all.push_back({constraints, "distance, (d.d - l^2)/(2l): row and gamma", "eq. 40", holds, distance});
  all.push_back({constraints, "rotational driver, atan2(S, C) = f(t): row and gamma", "eq. 40", holds,
                 [](Proof& proof) { rotational_driver(proof, 2); }, "C = t1_i.t1_j, S = t2_i.t1_j"});
  all.push_back({constraints, "rotational driver: its angle turns about n where the axes coincide", "eq. 40", holds,
                 driver_in_place});
  all.push_back({constraints, "closed joints: each row is one component of the relative motion", "section 6", holds,
                 [](Proof& proof) { closed_joints(proof, true); },
                 "fixed, universal, revolute, cylindrical, prismatic, planar"});
  all.push_back(
      {constraints, "in the plane: the planar joint's gamma, and A is the plane's turn", "eq. 40", holds, plane});
  all.push_back(
      {bodies, "WRONG: w' = L p_dot", "eq. 36 altered", wrong, [](Proof& proof) { spin_of_rates(proof, 1, false); }});
  all.push_back({bodies, "WRONG: L with the other sign of e x, which gives the inertial spin", "eq. 36 altered", wrong,
                 [](Proof& proof) { spin_of_rates(proof, 2, true); }});
  all.push_back(
      {bodies, "WRONG: p_dot = L^T w'", "eq. 36 altered", wrong, [](Proof& proof) { rates_of_spin(proof, 1); }});
  all.push_back({bodies, "WRONG: gyroscopic moment of the other sign", "eq. 37 altered", wrong,
                 [](Proof& proof) { rotation(proof, -1); }});
  all.push_back({constraints, "WRONG: closed joints, the second axis turned by the relative spin alone",
                 "section 6 altered", wrong, [](Proof& proof) { closed_joints(proof, false); }});
  all.push_back({constraints, "WRONG: perpendicular axes, mixed term once", "eq. 40 altered", wrong,
                 [](Proof& proof) { perpendicular_axes(proof, 1); }});
  all.push_back({constraints, "WRONG: perpendicular distance, its force on body i at P_i", "eq. 40 altered", wrong,
                 [](Proof& proof) { perpendicular_distance(proof, false); }});
  all.push_back({constraints, "WRONG: rotational driver without the rate of C^2 + S^2", "eq. 40 altered", wrong,
                 [](Proof& proof) { rotational_driver(proof, 0); }});
  return all;
}

}  // namespace lubjoint::proofs

// Constraints (eqs. 39 to 41) and the wrenches of a lubricated joint on its two bodies.

#include "oracle/proofs/formulas.hpp"
#include "oracle/proofs/ledger.hpp"

namespace lubjoint::proofs {

namespace {

const char* const constraints = "constraint equations";
const char* const wrenches = "wrenches of the joint";

// A constraint of two coordinates and the time of which nothing is known but that it can be differentiated twice.
DECLARE_FUNCTION_3P(unknown_constraint)
REGISTER_FUNCTION(unknown_constraint, dummy())

/// Coordinates q(t) with their first and second derivatives, and the time.
struct Motion {
  std::vector<symbol> position, velocity, acceleration;
  symbol t{"t"};

  explicit Motion(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      position.emplace_back(name);
      velocity.emplace_back(name + "_dot");
      acceleration.emplace_back(name + "_ddot");
    }
  }
  /// d/dt along the motion.
  ex rate(const ex& f) const {
    ex sum = f.diff(t);
    for (std::size_t i = 0; i < position.size(); ++i) {
      sum += f.diff(position[i]) * velocity[i] + f.diff(velocity[i]) * acceleration[i];
    }
    return sum;
  }
  /// Φq w for a vector w of the tangent space.
  ex along(const ex& f, const std::vector<symbol>& w) const {
    ex sum = 0;
    for (std::size_t i = 0; i < position.size(); ++i) sum += f.diff(position[i]) * w[i];
    return sum;
  }
  /// γ = −(Φq q̇)q q̇ − m Φqt q̇ − Φtt, m = 2.
  ex gamma(const ex& f, const ex& mixed = 2) const {
    const ex first = along(f, velocity);
    return -along(first, velocity) - mixed * along(f.diff(t), velocity) - f.diff(t).diff(t);
  }
  Algebra algebra(const std::vector<std::size_t>& angles) const {
    Algebra result;
    for (const std::size_t i : angles) result.angle(position[i]);
    return result;
  }
};

/// Two planar bodies: x, y, φ of each.
Motion two_bodies() { return Motion({"x_i", "y_i", "phi_i", "x_j", "y_j", "phi_j"}); }

struct PlanarBody {
  Planar r;
  ex phi;

  PlanarBody(const Motion& m, std::size_t first)
      : r{m.position[first], m.position[first + 1]}, phi(m.position[first + 2]) {}
  Planar in_plane(const Planar& fixed) const { return turned(fixed, cos(phi), sin(phi)); }
  Planar point(const Planar& fixed) const { return r + in_plane(fixed); }
};

/// Φ̈ = Φq q̈ − γ: what makes γ the right-hand side of the acceleration equation.
void gamma_is_acceleration(Proof& proof, const Motion& motion, const Algebra& algebra, const ex& constraint,
                           const ex& mixed = 2) {
  const ex twice = motion.rate(motion.rate(constraint));
  proof.equal(algebra, twice, motion.along(constraint, motion.acceleration) - motion.gamma(constraint, mixed));
}

void unknown(Proof& proof, const ex& mixed) {
  const Motion m({"q1", "q2"});
  gamma_is_acceleration(proof, m, Algebra(), unknown_constraint(m.position[0], m.position[1], m.t), mixed);
}

void revolute(Proof& proof) {
  const Motion m = two_bodies();
  const symbol six("s_ix"), siy("s_iy"), sjx("s_jx"), sjy("s_jy");
  const PlanarBody i(m, 0), j(m, 3);
  const Planar s_i{six, siy}, s_j{sjx, sjy};
  const Planar phi = j.point(s_j) - i.point(s_i);
  const Algebra algebra = m.algebra({2, 5});
  gamma_is_acceleration(proof, m, algebra, phi.x);
  gamma_is_acceleration(proof, m, algebra, phi.y);
  const Planar closed = pow(m.velocity[5], 2) * j.in_plane(s_j) - pow(m.velocity[2], 2) * i.in_plane(s_i);
  equal(proof, algebra, {m.gamma(phi.x), m.gamma(phi.y)}, closed);
}

/// The point of body j stays on the line of body i through P_i along d_i, and the relative angle is constant.
void translational(Proof& proof) {
  const Motion m = two_bodies();
  const symbol six("s_ix"), siy("s_iy"), sjx("s_jx"), sjy("s_jy"), dx("d_x"), dy("d_y"), angle("angle_0");
  const PlanarBody i(m, 0), j(m, 3);
  const Planar axis = i.in_plane({dx, dy});
  const Planar distance = j.point({sjx, sjy}) - i.point({six, siy});
  const Algebra algebra = m.algebra({2, 5});
  gamma_is_acceleration(proof, m, algebra, cross(axis, distance));
  gamma_is_acceleration(proof, m, algebra, j.phi - i.phi - angle);
  proof.zero(algebra, m.gamma(j.phi - i.phi - angle));
}

/// A driven angle with any acceleration, and a rheonomic distance whose terms mix q and t.
void driver(Proof& proof) {
  const Motion m = two_bodies();
  const symbol start("phi_0"), speed("omega_0"), acceleration("alpha"), length("l_0"), rate("l_rate");
  const PlanarBody i(m, 0), j(m, 3);
  const ex driven = i.phi - start - speed * m.t - acceleration * pow(m.t, 2) / 2;
  gamma_is_acceleration(proof, m, m.algebra({2, 5}), driven);
  proof.equal(m.algebra({2, 5}), m.gamma(driven), acceleration);
  const Planar d = j.r - i.r;
  const ex stretch = dot(d, d) - pow(length + rate * m.t, 2);
  gamma_is_acceleration(proof, m, m.algebra({2, 5}), stretch);
  gamma_is_acceleration(proof, m, m.algebra({2, 5}), stretch * cos(i.phi) + d.x * m.t);
}

/// The way of a point of body j along an axis of body i is prescribed; its closed form is the library's.
void slide_driver(Proof& proof) {
  const Motion m = two_bodies();
  const symbol six("s_ix"), siy("s_iy"), sjx("s_jx"), sjy("s_jy"), ux("u_x"), uy("u_y");
  const symbol start("p_0"), speed("v_0"), acceleration("a_0");
  const PlanarBody i(m, 0), j(m, 3);
  const Planar u = i.in_plane({ux, uy});
  const Planar s_i = i.in_plane({six, siy});
  const Planar s_j = j.in_plane({sjx, sjy});
  const Planar d = j.r + s_j - (i.r + s_i);
  const ex driven = dot(u, d) - start - speed * m.t - acceleration * pow(m.t, 2) / 2;
  const Algebra algebra = m.algebra({2, 5});
  gamma_is_acceleration(proof, m, algebra, driven);
  const Planar n{-u.y, u.x};
  const Planar rate{m.rate(d.x), m.rate(d.y)};
  const ex spin_i = m.velocity[2];
  const ex spin_j = m.velocity[5];
  proof.equal(algebra, m.gamma(driven),
              pow(spin_i, 2) * dot(u, d) - 2 * spin_i * dot(n, rate) + pow(spin_j, 2) * dot(u, s_j) -
                  pow(spin_i, 2) * dot(u, s_i) + acceleration);
  proof.equal(algebra, driven.diff(m.position[2]), dot(n, d) + dot(n, s_i));
  proof.equal(algebra, driven.diff(m.position[5]), -dot(n, s_j));
}

/// With Φq q̈ = γ − 2αΦ̇ − β²Φ (second row of eq. 41) the constraint obeys Φ̈ + 2αΦ̇ + β²Φ = 0.
void baumgarte(Proof& proof, int sign) {
  const Motion m({"q1", "q2"});
  const symbol alpha("alpha"), beta("beta");
  const ex phi = unknown_constraint(m.position[0], m.position[1], m.t);
  const ex velocity = m.rate(phi);
  proof.equal(Algebra(), velocity, m.along(phi, m.velocity) + phi.diff(m.t));
  const ex right = m.gamma(phi) + sign * (2 * alpha * velocity + pow(beta, 2) * phi);
  const ex second_row = m.along(phi, m.acceleration) - right;
  proof.equal(Algebra(), second_row, m.rate(velocity) + 2 * alpha * velocity + pow(beta, 2) * phi);
}

void without_stabilisation(Proof& proof) {
  const symbol gamma("gamma"), phi("Phi"), rate("Phi_rate"), alpha("alpha"), beta("beta");
  const ex right = gamma - 2 * alpha * rate - pow(beta, 2) * phi;
  proof.equal(Algebra(), right.subs(GiNaC::lst{alpha == 0, beta == 0}), gamma);
}

/// The forces −Φqᵀλ have the power −λᵀΦq q̇ = −λᵀ(Φ̇ − Φt): λᵀΦt where the constraint is kept, zero without time.
void constraint_power(Proof& proof) {
  const Motion m({"q1", "q2"});
  const symbol lambda("lambda");
  const ex phi = unknown_constraint(m.position[0], m.position[1], m.t);
  ex power = 0;
  for (std::size_t i = 0; i < 2; ++i) power -= phi.diff(m.position[i]) * lambda * m.velocity[i];
  proof.equal(Algebra(), power, -lambda * (m.rate(phi) - phi.diff(m.t)));
}

/// Two bodies with centres r_i, r_j and arms s_i, s_j; e = P_j − P_i.
struct Joint {
  symbol rix{"r_ix"}, riy{"r_iy"}, rjx{"r_jx"}, rjy{"r_jy"}, six{"s_ix"}, siy{"s_iy"}, sjx{"s_jx"}, sjy{"s_jy"};
  symbol fx{"F_x"}, fy{"F_y"}, ax{"a_x"}, ay{"a_y"};
  Planar r_i{rix, riy}, r_j{rjx, rjy}, s_i{six, siy}, s_j{sjx, sjy}, force{fx, fy}, about{ax, ay};
  Planar e = r_j + s_j - r_i - s_i;
  Planar reaction = ex(-1) * force;
  ex moment_j = cross(s_j, force);

  ex moment_i(int transport_sign) const { return cross(s_i, reaction) + transport_sign * cross(e, reaction); }
  ex moment_of_pair(int transport_sign) const {
    return cross(r_j - about, force) + moment_j + cross(r_i - about, reaction) + moment_i(transport_sign);
  }
};

void pair_vanishes(Proof& proof) {
  const Joint y;
  equal(proof, Algebra(), y.force + y.reaction, {0, 0});
  proof.zero(Algebra(), y.moment_of_pair(1));
}

void transport_moment(Proof& proof) {
  const Joint y;
  proof.equal(Algebra(), cross(y.e, y.reaction), -(y.e.x * y.force.y - y.e.y * y.force.x));
  // −F at P_j has this moment about the centre of body i.
  proof.equal(Algebra(), cross(y.r_j + y.s_j - y.r_i, y.reaction), y.moment_i(1));
}

/// Power of the pair on the bodies = F·v − ω_i (e × F), v = Ṗ_j − Ṗ_i.
void power_of_pair(Proof& proof) {
  const Joint y;
  const symbol vix("v_ix"), viy("v_iy"), vjx("v_jx"), vjy("v_jy"), spin_i("omega_i"), spin_j("omega_j");
  const Planar v_i{vix, viy}, v_j{vjx, vjy};
  const Planar v = v_j + spin_j * turned_90(y.s_j) - v_i - spin_i * turned_90(y.s_i);
  const ex power = dot(y.force, v_j) + spin_j * y.moment_j + dot(y.reaction, v_i) + spin_i * y.moment_i(1);
  proof.equal(Algebra(), power, dot(y.force, v) - spin_i * cross(y.e, y.force));
}

}  // namespace

std::vector<Statement> mechanics_statements() {
  using enum Expectation;
  std::vector<Statement> all;
  all.push_back({constraints, "gamma of any constraint: Phi'' = Phi_q q'' - gamma", "eq. 40", holds,
                 [](Proof& proof) { unknown(proof, 2); }, "an unknown function of two coordinates and the time"});
  all.push_back({constraints, "gamma of the revolute joint is omega_j^2 s_j - omega_i^2 s_i", "eq. 40", holds, revolute,
                 "Phi = P_j - P_i"});
  all.push_back({constraints, "gamma of the translational joint, and 0 for its angle", "eq. 40", holds, translational});
  all.push_back(
      {constraints, "gamma of a driver is its prescribed acceleration; rheonomic distance", "eq. 40", holds, driver});
  all.push_back({constraints, "gamma and columns of a driver along an axis of a body", "eq. 40", holds, slide_driver});
  all.push_back({constraints, "eq. 41 is Phi'' + 2 alpha Phi' + beta^2 Phi = 0", "eq. 41", holds,
                 [](Proof& proof) { baumgarte(proof, -1); }, "Phi' = Phi_q q' + Phi_t"});
  all.push_back({constraints, "eq. 41 with alpha = beta = 0 is eq. 39", "eqs. 39, 41", holds, without_stabilisation});
  all.push_back({constraints, "the constraint forces -Phi_q^T lambda have the power lambda^T (Phi_t - Phi')", "eq. 39",
                 holds, constraint_power, "with Phi' = 0 the drivers' power, and none without time"});
  all.push_back({wrenches, "the pair has no resultant and no moment about any point", "eqs. 33, 34", holds,
                 pair_vanishes, "so two bodies joined only by the film keep their momentum and angular momentum"});
  all.push_back({wrenches, "the transport moment e x (-F) is -F acting at P_j on the bearing's body", "eqs. 33, 34",
                 holds, transport_moment});
  all.push_back({wrenches, "power of the pair = F.v - omega_B (e x F)", "eqs. 33, 34", holds, power_of_pair});
  all.push_back({constraints, "WRONG: gamma with Phi_qt q' once", "eq. 40 altered", wrong,
                 [](Proof& proof) { unknown(proof, 1); }});
  all.push_back({constraints, "WRONG: eq. 41 with +2 alpha Phi' + beta^2 Phi on the right", "eq. 41 altered", wrong,
                 [](Proof& proof) { baumgarte(proof, 1); }});
  all.push_back({wrenches, "WRONG: transport moment of the other sign", "eqs. 33, 34 altered", wrong, [](Proof& proof) {
                   const Joint y;
                   proof.zero(Algebra(), y.moment_of_pair(-1));
                 }});
  all.push_back({wrenches, "WRONG: transport moment missing", "eqs. 33, 34 altered", wrong, [](Proof& proof) {
                   const Joint y;
                   proof.zero(Algebra(), y.moment_of_pair(0));
                 }});
  return all;
}

}  // namespace lubjoint::proofs

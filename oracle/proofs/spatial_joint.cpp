// The lubricated joint in space: where the journal is in its bearing, for any observer, and its pair of forces.

#include "oracle/proofs/ledger.hpp"
#include "oracle/proofs/spatial.hpp"

namespace lubjoint::proofs {

namespace {

const char* const joint = "the joint in space";

/// What an observer sees of a joint: the axes n and n_J, d = P_j − P_i with its rate, the spins.
struct Seen {
  Spatial n, n_j, d, d_rate, spin_i, spin_j;

  ex cosine() const { return dot(n, n_j); }
  ex sliding() const { return dot(n, d) / cosine(); }
  /// e = d − σ n_J, σ = (n·d)/(n·n_J).
  Spatial eccentricity() const { return d - sliding() * n_j; }

  // Rates of the axes and of d as seen from the bearing.
  Spatial axis_rate() const { return cross(spin_j - spin_i, n_j); }
  Spatial d_rate_in_bearing() const { return d_rate - cross(spin_i, d); }
  /// σ̇ = (n·d° − σ n·n_J°)/(n·n_J).
  ex sliding_rate() const { return (dot(n, d_rate_in_bearing()) - sliding() * dot(n, axis_rate())) / cosine(); }
  /// v_B = d° − σ n_J° − σ̇ n_J.
  Spatial velocity() const { return d_rate_in_bearing() - sliding() * axis_rate() - sliding_rate() * n_j; }
  /// ω = n·(ω_J − ω_B).
  ex spin() const { return dot(n, spin_j - spin_i); }
  /// u c = v_B − share · ω n × e, share = 1/2.
  Spatial pure_squeeze(const ex& share = frac(1, 2)) const {
    return velocity() - share * spin() * cross(n, eccentricity());
  }
};

/// A joint in general position: all components are symbols.
struct Symbols {
  SpatialSymbol n{"n"}, n_j{"m"}, d{"d"}, d_rate{"d_dot"}, spin_i{"w_i"}, spin_j{"w_j"};

  Seen seen() const { return {n, n_j, d, d_rate, spin_i, spin_j}; }
  /// d/dt with ṅ = ω_B × n, ṅ_J = ω_J × n_J.
  ex rate(const ex& f) const {
    ex sum = 0;
    const auto along = [&](const SpatialSymbol& at, const Spatial& by) {
      sum += f.diff(at.x) * by.x + f.diff(at.y) * by.y + f.diff(at.z) * by.z;
    };
    along(n, cross(spin_i, n));
    along(n_j, cross(spin_j, n_j));
    along(d, d_rate);
    return sum;
  }
  Spatial rate(const Spatial& v) const { return {rate(v.x), rate(v.y), rate(v.z)}; }
  /// n and n_J are unit vectors.
  Algebra algebra() const {
    return Algebra().root(n.z, 1 - pow(n.x, 2) - pow(n.y, 2)).root(n_j.z, 1 - pow(n_j.x, 2) - pow(n_j.y, 2));
  }
};

/// e lies in the plane through P_i normal to n, and its end on the journal's axis; v_B and u lie in the plane, too.
void in_the_plane(Proof& proof) {
  const Symbols y;
  const Seen seen = y.seen();
  const Algebra algebra = y.algebra();
  proof.zero(algebra, dot(seen.n, seen.eccentricity()));
  equal(proof, algebra, cross(seen.d - seen.eccentricity(), seen.n_j), {0, 0, 0});
  proof.zero(algebra, dot(seen.n, seen.velocity()));
  proof.zero(algebra, dot(seen.n, seen.pure_squeeze()));
}

/// v_B = ė − ω_B × e along any motion, and σ̇ is the rate of σ.
void rates(Proof& proof) {
  const Symbols y;
  const Seen seen = y.seen();
  const Algebra algebra = y.algebra();
  const Spatial e = seen.eccentricity();
  proof.equal(algebra, y.rate(seen.sliding()), seen.sliding_rate());
  equal(proof, algebra, y.rate(e) - cross(seen.spin_i, e), seen.velocity());
}

/// An observer at c who moves, and turns with the spin −Ω, at the instant at which his axes are the inertial ones:
/// spins gain Ω.
void turning_observer(Proof& proof, bool with_inertial_rate) {
  const Symbols y;
  const SpatialSymbol turning("Omega"), at("c"), speed("c_dot"), p_i("P_i"), v_i("v_i");
  const Seen seen = y.seen();
  Seen other = seen;
  const Spatial p_j = Spatial(p_i) + seen.d, v_j = Spatial(v_i) + seen.d_rate;
  // To him P is at P - c, and moves by that point's velocity less his own there.
  const auto velocity = [&](const Spatial& p, const Spatial& v) { return v - speed + cross(turning, p - at); };
  other.d = (p_j - at) - (Spatial(p_i) - at);
  other.d_rate = velocity(p_j, v_j) - velocity(p_i, v_i);
  other.spin_i = seen.spin_i + turning;
  other.spin_j = seen.spin_j + turning;
  const auto u = [&](const Seen& s) {
    // The mistake: ė in place of v_B, with the relative spin.
    return with_inertial_rate ? s.pure_squeeze() + cross(s.spin_i, s.eccentricity()) : s.pure_squeeze();
  };
  const Algebra algebra = y.algebra();
  equal(proof, algebra, other.eccentricity(), seen.eccentricity());
  equal(proof, algebra, u(other), u(seen));
}

/// Turned by any angle about z, and about x: every turn is made of such; e and u turn with the axes. The mistake: the
/// spins are those in the old axes.
void turned_observer(Proof& proof, bool with_spins) {
  const symbol angle("phi");
  const Symbols y;
  const Seen seen = y.seen();
  const Algebra algebra = y.algebra().angle(angle);
  const ex c = cos(angle), s = sin(angle);
  const auto about_z = [&](const Spatial& v) { return Spatial{c * v.x - s * v.y, s * v.x + c * v.y, v.z}; };
  const auto about_x = [&](const Spatial& v) { return Spatial{v.x, c * v.y - s * v.z, s * v.y + c * v.z}; };
  const auto check = [&](const auto& turn) {
    const Seen other{turn(seen.n),
                     turn(seen.n_j),
                     turn(seen.d),
                     turn(seen.d_rate),
                     with_spins ? turn(seen.spin_i) : seen.spin_i,
                     with_spins ? turn(seen.spin_j) : seen.spin_j};
    // The scalars stay ...
    proof.equal(algebra, other.cosine(), seen.cosine());
    proof.equal(algebra, other.sliding() * other.cosine(), seen.sliding() * seen.cosine());
    proof.equal(algebra, dot(other.n, other.d_rate_in_bearing()), dot(seen.n, seen.d_rate_in_bearing()));
    proof.equal(algebra, dot(other.n, other.axis_rate()), dot(seen.n, seen.axis_rate()));
    proof.equal(algebra, other.spin(), seen.spin());
    // ... and with them, as symbols, e and u turn.
    const symbol sigma("sigma"), sigma_rate("sigma_dot"), omega("omega");
    const auto e = [&](const Seen& by) { return by.d - sigma * by.n_j; };
    const auto u = [&](const Seen& by) {
      return by.d_rate_in_bearing() - sigma * by.axis_rate() - sigma_rate * by.n_j -
             frac(1, 2) * omega * cross(by.n, e(by));
    };
    equal(proof, algebra, e(other), turn(e(seen)));
    equal(proof, algebra, u(other), turn(u(seen)));
  };
  check(about_z);
  check(about_x);
}

/// u is the same for either body taken as the bearing's frame when the axes coincide: v_B − ½ω n×e = ė − ½(ω_B +
/// ω_J)n×e.
void plane(Proof& proof, const ex& share) {
  const symbol ex_("e_x"), ey("e_y"), vx("v_x"), vy("v_y"), spin_i("omega_B"), spin_j("omega_J");
  const Spatial z{0, 0, 1};
  const Seen seen{z, z, {ex_, ey, 0}, {vx, vy, 0}, spin_i * z, spin_j * z};
  equal(proof, Algebra(), seen.eccentricity(), {ex_, ey, 0});
  const Planar v{vx, vy}, e{ex_, ey};
  const Planar u = v - frac(1, 2) * (spin_i + spin_j) * turned_90(e);
  equal(proof, Algebra(), seen.pure_squeeze(share), {u.x, u.y, 0});
  proof.zero(Algebra(), seen.sliding_rate());
  // b and a of page 1, times |e|, of the joint's own u and e.
  const Spatial in_space = seen.pure_squeeze(share), off = seen.eccentricity();
  proof.equal(Algebra(), dot(in_space, off), dot(v, e));
  proof.equal(Algebra(), -2 * dot(in_space, cross(z, off)), (spin_i + spin_j) * dot(e, e) - 2 * dot(v, turned_90(e)));
}

/// The pair of forces at X on two bodies with mass centres r_i, r_j. Each body's force acts at its own arm: −F on body
/// i at s_i + e, which is reached from P_i, and F on body j at s_j − σ n_J, from P_j along the journal's axis.
struct Wrenches {
  Symbols y;
  Seen seen = y.seen();
  SpatialSymbol r_i{"r_i"}, s_i{"s_i"}, s_j{"s_j"}, v_i{"v_i"}, force{"F"}, about{"a"};
  Spatial p_i = Spatial(r_i) + s_i;
  Spatial r_j = p_i + seen.d - s_j;  // as P_j = P_i + d
  Spatial arm_i = Spatial(s_i) + seen.eccentricity();
  Spatial arm_j = Spatial(s_j) - seen.sliding() * seen.n_j;
  Algebra algebra = y.algebra();

  explicit Wrenches(bool without_tilt = false) {
    if (!without_tilt) return;
    seen.n_j = seen.n;
    arm_i = Spatial(s_i) + seen.eccentricity();
    arm_j = Spatial(s_j) - seen.sliding() * seen.n_j;
  }

  /// What the pair does to both bodies, by their own velocities and spins.
  ex power_of(const Spatial& f) const {
    // ṙ_j from Ṗ_j = Ṗ_i + ḋ.
    const Spatial v_j = Spatial(v_i) + cross(seen.spin_i, s_i) + seen.d_rate - cross(seen.spin_j, s_j);
    return dot(f, v_j) + dot(seen.spin_j, cross(arm_j, f)) - dot(f, v_i) - dot(seen.spin_i, cross(arm_i, f));
  }
  Spatial moment_about(const Spatial& arm_of_j) const {
    return cross(r_j - about, force) + cross(arm_of_j, force) + cross(Spatial(r_i) - about, -Spatial(force)) +
           cross(arm_i, -Spatial(force));
  }
};

void pair_vanishes(Proof& proof) {
  const Wrenches y;
  equal(proof, y.algebra, y.moment_about(y.arm_j), {0, 0, 0});
}

/// Power on both bodies = F·v_B + sign · σ̇ F·n_J for σ = (n·d)/(n·n_J), the way from X to P_j along n_J; sign = 1.
void power(Proof& proof, int sign) {
  const Wrenches y;
  const Seen& s = y.seen;
  const Spatial f = y.force;
  proof.equal(y.algebra, y.power_of(f), dot(f, s.velocity()) + sign * s.sliding_rate() * dot(f, s.n_j));
}

/// Where n_J = n, a force in the film's plane has the power F·v_B, whatever the bodies' spins: also those that begin to
/// tilt. Along n it has that of the sliding, too.
void power_without_tilt(Proof& proof, bool in_plane) {
  const Wrenches y(true);
  const Seen& s = y.seen;
  const Spatial any = y.force;
  const Spatial f = in_plane ? any - dot(any, s.n) * s.n : any;
  proof.equal(y.algebra, y.power_of(f), dot(f, s.velocity()));
}

}  // namespace

std::vector<Statement> spatial_joint_statements() {
  using enum Expectation;
  std::vector<Statement> all;
  all.push_back({joint, "e ends on the journal's axis in the film's middle plane; v_B and u lie in it", "section 5",
                 holds, in_the_plane, "e = d - sigma n_J, sigma = (n.d)/(n.n_J)"});
  all.push_back({joint, "v_B = e_dot - w_B x e and sigma_dot along any motion", "section 5", holds, rates});
  all.push_back({joint, "an observer who moves and turns with any spin sees the same e and u", "frame indifference",
                 holds, [](Proof& proof) { turning_observer(proof, false); }, "u c = v_B - omega n x e/2"});
  all.push_back({joint, "e and u turn with the observer's axes", "frame indifference", holds,
                 [](Proof& proof) { turned_observer(proof, true); }});
  all.push_back({joint, "in the plane u is v - (omega_B + omega_J) e_perp/2", "section 5", holds,
                 [](Proof& proof) { plane(proof, frac(1, 2)); }, "and b and a are those of page 1's film"});
  all.push_back({joint, "the pair, F on the journal and -F on the bearing, has no moment about any point",
                 "eqs. 33, 34", holds, pair_vanishes});
  all.push_back({joint, "power of the pair = F.v_B + sigma_dot F.n_J", "eqs. 33, 34", holds,
                 [](Proof& proof) { power(proof, 1); }});
  all.push_back({joint, "power of the pair = F.v_B where the axes are parallel", "eqs. 33, 34", holds,
                 [](Proof& proof) { power_without_tilt(proof, true); }, "F in the film's plane"});
  all.push_back({joint, "WRONG: e_dot in place of v_B, for a turning observer", "frame indifference altered", wrong,
                 [](Proof& proof) { turning_observer(proof, true); }});
  all.push_back({joint, "WRONG: e and u by turned places and axes, and spins that are not",
                 "frame indifference altered", wrong, [](Proof& proof) { turned_observer(proof, false); }});
  all.push_back({joint, "WRONG: the whole relative spin in u", "section 5 altered", wrong,
                 [](Proof& proof) { plane(proof, 1); }});
  all.push_back({joint, "WRONG: the journal's force at P_j when it has slid and tilted", "eqs. 33, 34 altered", wrong,
                 [](Proof& proof) {
                   const Wrenches y;
                   equal(proof, y.algebra, y.moment_about(y.s_j), {0, 0, 0});
                 }});
  all.push_back({joint, "WRONG: power = F.v_B of a force along the axis, too", "eqs. 33, 34 altered", wrong,
                 [](Proof& proof) { power_without_tilt(proof, false); }});
  all.push_back({joint, "WRONG: power with sigma_dot of the other sign", "eqs. 33, 34 altered", wrong,
                 [](Proof& proof) { power(proof, -1); }});
  return all;
}

}  // namespace lubjoint::proofs

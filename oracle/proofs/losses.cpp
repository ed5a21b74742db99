// Wall shear, torques and power of the film: what the torques sum to, and where the power goes.
//
// Torques are over μωR³L/c (Couette) and over the force scale times c (pressure); p over the scale of its field.

#include "oracle/proofs/ledger.hpp"
#include "oracle/proofs/long_film.hpp"

namespace lubjoint::proofs {

namespace {

const char* const group = "shear torque and power";

/// Profile between the walls: u = U_B + (U_J − U_B) y/h + p_x (y² − h y)/(2μ).
struct Profile {
  symbol mu{"mu"}, h{"h"}, y{"y"}, u_b{"U_B"}, u_j{"U_J"}, slope{"p_x"};
  ex flow = u_b + (u_j - u_b) * y / h + slope * (y * y - h * y) / (2 * mu);
  ex shear = mu * flow.diff(y);

  /// ∫₀ʰ f dy of a polynomial in y.
  ex across(const ex& f) const {
    const ex polynomial = f.expand();
    ex sum = 0;
    for (int n = 0; n <= polynomial.degree(y); ++n) sum += polynomial.coeff(y, n) * pow(h, n + 1) / (n + 1);
    return sum;
  }
};

void wall_shear(Proof& proof, int pressure_sign) {
  const Profile p;
  proof.equal(Algebra(), p.flow.subs(p.y == 0), p.u_b);
  proof.equal(Algebra(), p.flow.subs(p.y == p.h), p.u_j);
  proof.equal(Algebra(), p.mu * p.flow.diff(p.y).diff(p.y), p.slope);
  const ex couette = p.mu * (p.u_j - p.u_b) / p.h;
  proof.equal(Algebra(), -p.shear.subs(p.y == p.h), -couette - p.h / 2 * p.slope);
  proof.equal(Algebra(), p.shear.subs(p.y == 0), couette - pressure_sign * p.h / 2 * p.slope);
}

void dissipation_density(Proof& proof) {
  const Profile p;
  proof.equal(Algebra(), p.across(p.shear * p.shear / p.mu),
              p.mu * pow(p.u_j - p.u_b, 2) / p.h + pow(p.h, 3) * pow(p.slope, 2) / (12 * p.mu));
}

/// ∫ dθ/H: its antiderivative is ψ/s.
void couette_integral(Proof& proof, const FilmEnd& from, const FilmEnd& to, const ex& claimed) {
  const ex density = 1 / film_at(cos(sym().theta));
  const ex primitive = antiderivative(density);
  proof.equal(film_algebra(), total_derivative(primitive), density);
  proof.equal(film_algebra(), between(primitive, from, to), claimed);
}

/// The cavity behind the minimum film carries the film that left there: a share (1 − ε)/H of the gap is wet.
void striated_cavity(Proof& proof) {
  const auto& [eps, s, theta] = std::tie(sym().eps, sym().s, sym().theta);
  const ex density = (1 - eps) / pow(film_at(cos(theta)), 2);
  const ex primitive = antiderivative(density);
  proof.equal(film_algebra(), total_derivative(primitive), density);
  for (const int start : {1, 0}) {  // behind a film on 0…π, and behind its mirror image
    proof.equal(film_algebra(), between(primitive, film_end_at_half_turns(start), film_end_at_half_turns(start + 1)),
                (1 - eps) * Pi / pow(s, 3));
  }
}

/// −½∫H dp = −½ε∫p sinθ dθ, the steps of p at the ends included: with `edges` = 0 they are left out.
void torque_by_parts(Proof& proof, const ex& pressure, const ex& slope, const FilmEnd& from, const FilmEnd& to,
                     const ex& scale, const Polar& law, int edges) {
  const auto& [eps, theta] = std::tie(sym().eps, sym().theta);
  const ex h = film_at(cos(theta));
  const ex primitive = antiderivative(h * slope);
  const ex steps = value_at(h * pressure, from) - value_at(h * pressure, to);
  proof.equal(film_algebra(), scale * (between(primitive, from, to) + edges * steps), eps * law.tangential);
}

ex short_slope() { return short_profile().diff(sym().theta); }

void short_torque(Proof& proof, const FilmEnd& from, const FilmEnd& to, const Polar& law, int edges = 1) {
  torque_by_parts(proof, short_profile(), short_slope(), from, to, frac(1, 2), law, edges);
}

/// C of eq. 5.
ex full_film_constant() { return 3 * sym().a * sym().eps / d_factor(); }

void long_torque(Proof& proof, const LongFilm& film, const FilmEnd& from, const FilmEnd& to, const Polar& law) {
  torque_by_parts(proof, film.pressure, long_slope(film.constant), from, to, 6, law, 1);
}

LongFilm full_film() { return {long_profile(), full_film_constant()}; }

/// T_J = −T_C − ½e×F and T_B = T_C − ½e×F balance the pair of forces; P = ωT_C − cF·u in any frame.
struct Losses {
  symbol ex_{"e_x"}, ey{"e_y"}, fx{"F_x"}, fy{"F_y"}, ux{"u_x"}, uy{"u_y"}, couette{"T_C"}, c{"c"};
  symbol journal{"omega_J"}, bearing{"omega_B"};
  Planar e{ex_, ey}, force{fx, fy}, u{ux, uy};
  Planar v = c * u + (journal + bearing) / 2 * turned_90(e);
  ex on_journal = -couette - cross(e, force) / 2;
  ex on_bearing = couette - cross(e, force) / 2;
};

void torque_sum(Proof& proof, int sign) {
  const Losses y;
  proof.zero(Algebra(), y.on_journal + sign * y.on_bearing + cross(y.e, y.force));
}

/// Reduced to the journal's centre, where −F acts on the bearing, the bearing's couple is −T_J.
void couple_of_the_bearing(Proof& proof, const ex& extra) {
  const Losses y;
  proof.equal(Algebra(), y.on_bearing + cross(y.e, y.force) + extra * cross(y.e, y.force), -y.on_journal);
}

void power_identity(Proof& proof, const ex& share_of_friction) {
  const Losses y;
  const ex on_bodies = dot(y.force, y.v) + share_of_friction * (y.on_journal * y.journal + y.on_bearing * y.bearing);
  proof.equal(Algebra(), -on_bodies, (y.journal - y.bearing) * y.couette - y.c * dot(y.force, y.u));
}

/// −F·u/S = ∫(g/2)²/H³ dθ, g = a sinθ − 2b cosθ = 2u·m: the short film's flow along the axis.
void short_dissipation(Proof& proof, const FilmEnd& from, const FilmEnd& to, const Polar& law) {
  const ex density = pow(reynolds_source(sym().theta) / 2, 2) / pow(film_at(cos(sym().theta)), 3);
  const ex primitive = antiderivative(density);
  proof.equal(film_algebra(), total_derivative(primitive), density);
  proof.equal(film_algebra(), between(primitive, from, to), -power_of(law));
}

/// −F·u/S = 3∫(a cosθ + 2b sinθ + C)²/H³ dθ: the long film's flow around.
void long_dissipation(Proof& proof, const ex& constant, const FilmEnd& from, const FilmEnd& to, const Polar& law) {
  const ex density = 3 * pow(long_slope(constant), 2) * pow(film_at(cos(sym().theta)), 3);
  const ex primitive = antiderivative(density);
  proof.equal(film_algebra(), total_derivative(primitive), density);
  proof.equal(film_algebra(), between(primitive, from, to), -power_of(law));
}

/// ∫u·m dθ, over cRL the oil that leaves by both sides: −∫∂_z(h³p_z/12μ).
void side_flow(Proof& proof, const FilmEnd& from, const FilmEnd& to, const ex& claimed) {
  const ex density = reynolds_source(sym().theta) / 2;
  const ex primitive = trigonometric_antiderivative(density, sym().theta);
  const auto at = [&](const FilmEnd& end) {
    return primitive.subs(GiNaC::exmap{{cos(sym().theta), end.cos_theta}, {sin(sym().theta), end.sin_theta}});
  };
  proof.equal(film_algebra(), at(to) - at(from), claimed);
}

Polar on_side(const Polar& law, int side) { return law.subs({{sym().sigma, side}}); }

/// The dynamic film in its own motion.
GiNaC::exmap dynamic() { return in_dynamic_motion(); }

}  // namespace

std::vector<Statement> loss_statements() {
  using enum Expectation;
  const std::string source = "wall shear of the film";
  std::vector<Statement> all;
  const auto claim = [&](const std::string& text, std::function<void(Proof&)> examine, const std::string& note = "") {
    all.push_back({group, text, source, holds, std::move(examine), note});
  };
  const auto mistake = [&](const std::string& text, std::function<void(Proof&)> examine, const std::string& note = "") {
    all.push_back({group, "WRONG: " + text, source + " altered", wrong, std::move(examine), note});
  };
  const FilmEnd zero = film_end_at_half_turns(0), half = film_end_at_half_turns(1), whole = film_end_at_half_turns(2);
  const FilmEnd from = dynamic_film_start(), to = dynamic_film_end();

  claim(
      "shear on the walls: -mu U/h - (h/2) p_x on the journal, mu U/h - (h/2) p_x on the bearing",
      [](Proof& proof) { wall_shear(proof, 1); }, "a parabola between the walls, U = U_J - U_B");
  claim("dissipation across the gap: mu U^2/h + h^3 p_x^2/(12 mu)", dissipation_density);
  claim("int dtheta/H = 2 pi/sqrt(q) full, pi/sqrt(q) half", [=](Proof& proof) {
    couette_integral(proof, zero, whole, 2 * Pi / sym().s);
    couette_integral(proof, zero, half, Pi / sym().s);
    couette_integral(proof, half, whole, Pi / sym().s);
  });
  claim(
      "int dtheta/H = (2/sqrt(q)) delta over the dynamic film",
      [=](Proof& proof) { couette_integral(proof, from, to, 2 * sym().delta / sym().s); },
      "delta = atan2(sqrt(q), -e.u/|u|)");
  claim("a striated cavity adds (1 - eps) pi/q^(3/2)", striated_cavity, "steady half film: the wet share is h_min/h");
  claim("the pressure's torque on either wall is -(1/2) e x F: short films, steps of p at the ends included",
        [=](Proof& proof) {
          short_torque(proof, zero, whole, short_full());
          short_torque(proof, zero, half, on_side(short_half(), 1));
          short_torque(proof, half, whole, on_side(short_half(), -1));
        });
  claim("the same of the short dynamic film", [=](Proof& proof) {
    const auto& [a, b] = std::tie(sym().a, sym().b);
    const ex j20 = moment(2, 0, from, to), j11 = moment(1, 1, from, to);
    short_torque(proof, from, to, {0, (a * j20 - 2 * b * j11) / 2});
  });
  claim("the same of the long films, the one cut at pi included", [=](Proof& proof) {
    long_torque(proof, full_film(), zero, whole, long_full());
    long_torque(proof, full_film(), zero, half, on_side(long_half_eq5(), 1));
    long_torque(proof, long_film_between(zero, half), zero, half, on_side(long_half(), 1));
    long_torque(proof, long_film_between(half, whole), half, whole, on_side(long_half(), -1));
  });
  claim("T_J + T_B + e x F = 0", [](Proof& proof) { torque_sum(proof, 1); });
  claim("beside -F at the journal's centre the bearing gets the couple -T_J",
        [](Proof& proof) { couple_of_the_bearing(proof, 0); });
  claim(
      "power lost = -(F.v + T_J omega_J + T_B omega_B) = omega T_C - c F.u",
      [](Proof& proof) { power_identity(proof, 1); }, "the mean spin cancels: every observer sees the same loss");
  claim("-c F.u is the pressure flow's dissipation: short films", [=](Proof& proof) {
    short_dissipation(proof, zero, whole, short_full());
    short_dissipation(proof, zero, half, on_side(short_half(), 1));
    short_dissipation(proof, half, whole, on_side(short_half(), -1));
  });
  claim("-c F.u is the pressure flow's dissipation: short dynamic", [=](Proof& proof) {
    const auto& [a, b] = std::tie(sym().a, sym().b);
    const ex j11 = moment(1, 1, from, to), j02 = moment(0, 2, from, to), j20 = moment(2, 0, from, to);
    short_dissipation(proof, from, to, {(a * j11 - 2 * b * j02) / 2, (a * j20 - 2 * b * j11) / 2});
  });
  claim("-c F.u is the pressure flow's dissipation: long full and long half", [=](Proof& proof) {
    long_dissipation(proof, full_film_constant(), zero, whole, long_full());
    long_dissipation(proof, long_film_between(zero, half).constant, zero, half, on_side(long_half(), 1));
    long_dissipation(proof, long_film_between(half, whole).constant, half, whole, on_side(long_half(), -1));
  });
  claim("-c F.u is the pressure flow's dissipation: long dynamic", [=](Proof& proof) {
    const auto& [a, b] = std::tie(sym().a, sym().b);
    const ex j00 = moment(0, 0, from, to), j01 = moment(0, 1, from, to), j10 = moment(1, 0, from, to);
    const ex j11 = moment(1, 1, from, to), j20 = moment(2, 0, from, to), j02 = moment(0, 2, from, to);
    const ex constant = -(a * j01 + 2 * b * j10) / j00;
    long_dissipation(proof, constant, from, to,
                     {-6 * (a * j11 + 2 * b * j20 + constant * j10), 6 * (a * j02 + 2 * b * j11 + constant * j01)});
  });
  claim("side flow of the short film over cRL: 0 full, |a| half, 2|u| dynamic", [=](Proof& proof) {
    side_flow(proof, zero, whole, 0);
    side_flow(proof, zero, half, sym().a);
    side_flow(proof, half, whole, -sym().a);
    const ex dynamic_flow = sym().a * sym().cos_start + 2 * sym().b * sym().sin_start;
    side_flow(proof, from, to, dynamic_flow);
    proof.equal(film_algebra(), dynamic_flow.subs(dynamic()), 2 * sym().speed);
  });

  mistake("the pressure drives both walls apart: mu U/h + (h/2) p_x on the bearing",
          [](Proof& proof) { wall_shear(proof, -1); });
  mistake("the short half film's torque without the steps of p at 0 and pi",
          [=](Proof& proof) { short_torque(proof, zero, half, on_side(short_half(), 1), 0); });
  mistake("T_J = T_B - e x F", [](Proof& proof) { torque_sum(proof, -1); });
  mistake(
      "beside -F at the journal's centre the bearing gets T_B", [](Proof& proof) { couple_of_the_bearing(proof, -1); },
      "counts e x F twice");
  mistake(
      "the film's forces alone take omega T_C - c F.u from the bodies", [](Proof& proof) { power_identity(proof, 0); },
      "without T_J and T_B a joint is not passive");
  mistake(
      "the long film cut at pi dissipates -c F.u",
      [=](Proof& proof) { long_dissipation(proof, full_film_constant(), zero, half, on_side(long_half_eq5(), 1)); },
      "p is not zero at pi");
  return all;
}

}  // namespace lubjoint::proofs

// Linear coefficients of the film about a steady state, and the stability of a rigid rotor on them.
//
// K = −∂F/∂e over Sω/c and C = −∂F/∂v over S/c, in (r, t), at a = εω > 0 and b = 0.

#include <array>
#include <stdexcept>

#include "oracle/proofs/laws.hpp"
#include "oracle/proofs/ledger.hpp"

namespace lubjoint::proofs {

namespace {

const char* const group = "linear coefficients";

struct Coefficients {
  ex krr, ktr, krt, ktt, crr, ctr, crt, ctt;
};

/// At the steady state, with ω = 1.
ex steady(const ex& f) {
  const Symbols& y = sym();
  const GiNaC::exmap at{{y.speed, y.a / 2}, {y.cos_start, 1}, {y.sin_start, 0},
                        {y.delta, Pi / 2},  {y.b, 0},         {y.sigma, 1}};
  return f.subs(at).subs(y.a == y.eps);
}

/// ∂f/∂ε, ∂f/∂a or ∂f/∂b at the steady state, through s, |u|, θs and δ = π/2 + arctan(ε sinθs/s). There ∂|u|/∂a = ½,
/// ∂sinθs/∂b = 1/|u| = 2/a and ∂δ/∂sinθs = ε/s; the others vanish.
ex by_eps(const ex& f) { return steady(f.diff(sym().eps) - sym().eps / sym().s * f.diff(sym().s)); }
ex by_a(const ex& f) { return steady(f.diff(sym().a) + f.diff(sym().speed) / 2); }
ex by_b(const ex& f) {
  const Symbols& y = sym();
  const ex turn = f.diff(y.sin_start) + y.eps / y.s * f.diff(y.delta);
  return steady(f.diff(y.b)) + steady(turn) * 2 / y.eps;
}

Coefficients differentiated(const Polar& law) {
  const ex& eps = sym().eps;
  return {-by_eps(law.radial) - by_a(law.radial),
          -by_eps(law.tangential) - by_a(law.tangential),
          steady(law.tangential) / eps,
          -steady(law.radial) / eps,
          -by_b(law.radial),
          -by_b(law.tangential),
          2 * by_a(law.radial),
          2 * by_a(law.tangential)};
}

void equal(Proof& proof, const Coefficients& x, const Coefficients& y) {
  const Algebra algebra = film_algebra();
  proof.equal(algebra, x.krr, y.krr);
  proof.equal(algebra, x.ktr, y.ktr);
  proof.equal(algebra, x.krt, y.krt);
  proof.equal(algebra, x.ktt, y.ktt);
  proof.equal(algebra, x.crr, y.crr);
  proof.equal(algebra, x.ctr, y.ctr);
  proof.equal(algebra, x.crt, y.crt);
  proof.equal(algebra, x.ctt, y.ctt);
}

ex square() { return pow(sym().eps, 2); }

Coefficients closed_short_full() {
  const ex s = sym().s, growth = Pi * (1 + 2 * square()) / pow(s, 5);
  return {0, -growth / 2, Pi / (2 * pow(s, 3)), 0, growth, 0, 0, Pi / pow(s, 3)};
}

Coefficients closed_short_half() {
  const ex eps = sym().eps, s = sym().s, q2 = pow(s, 4), growth = Pi * (1 + 2 * square()) / pow(s, 5);
  return {2 * eps * (1 + square()) / pow(s, 6),
          -growth / 4,
          Pi / (4 * pow(s, 3)),
          eps / q2,
          growth / 2,
          -2 * eps / q2,
          -2 * eps / q2,
          Pi / (2 * pow(s, 3))};
}

Coefficients closed_long_full() {
  const ex s = sym().s, d = d_factor();
  return {0,
          -12 * Pi * (2 - square() + 2 * pow(square(), 2)) / (d * d * pow(s, 3)),
          12 * Pi / (d * s),
          0,
          12 * Pi / pow(s, 3),
          0,
          0,
          24 * Pi / (d * s)};
}

/// Of all long films that are on 0…π at b = 0: only the answer to a squeeze differs.
Coefficients closed_long(const ex& crr, const ex& ctr) {
  const ex eps = sym().eps, s = sym().s, q = s * s, d = d_factor();
  return {24 * eps * (2 + pow(square(), 2)) / (d * d * q * q),
          -6 * Pi * (2 - square() + 2 * pow(square(), 2)) / (d * d * pow(s, 3)),
          6 * Pi / (d * s),
          12 * eps / (d * q),
          crr,
          ctr,
          -24 * eps / (d * q),
          12 * Pi / (d * s)};
}
ex long_damping() { return 6 * Pi / pow(sym().s, 3); }
Coefficients closed_long_half() {
  const ex eps = sym().eps, q = pow(sym().s, 2), d = d_factor();
  return closed_long(6 * (Pi - 16 / (Pi * d)) / pow(sym().s, 3), -24 * eps / (d * q));
}
Coefficients closed_long_half_eq5() { return closed_long(long_damping(), -24 / ((1 + sym().eps) * pow(sym().s, 2))); }
Coefficients closed_long_dynamic(const ex& sixteen = 16) {
  const ex eps = sym().eps, q = pow(sym().s, 2), d = d_factor();
  return closed_long(6 * (Pi - sixteen * square() / (Pi * d * d)) / pow(sym().s, 3),
                     -48 * eps * (1 + square()) / (d * d * q));
}
Coefficients closed_pinkus_sternlicht() {
  return closed_long(long_damping(), -18 * Pi * sym().eps / (d_factor() * pow(sym().s, 2)));
}

/// The polar law in the symbols of its motion: a and b, or |u| and θs.
const Polar& polar(const std::string& name) {
  for (const Law& law : laws()) {
    if (law.name == name) return law.polar;
  }
  throw std::invalid_argument("no law " + name);
}

/// A function of (ε, a, b) and its three slopes, of which nothing else is known.
struct Known {
  symbol value, eps, a, b;
  explicit Known(const std::string& name) : value(name), eps(name + "_eps"), a(name + "_a"), b(name + "_b") {}
};

/// −∂F/∂e and −∂F/∂v of F = F_r r + F_t t with ε = |e|/c, b = v·r/c, a = εω − 2v·t/c, at e = cε x̂, v = 0.
void polar_to_plane(Proof& proof, int factor_of_slip) {
  const symbol x("x"), y("y"), vx("v_x"), vy("v_y"), rho("rho"), c("c"), omega("omega"), eps("eps");
  const Known fr("F_r"), ft("F_t");
  const Planar r{x / rho, y / rho}, v{vx, vy};
  const ex ratio = rho / c, b = dot(v, r) / c, a = omega * rho / c - factor_of_slip * dot(v, turned_90(r)) / c;
  const GiNaC::exmap place{{rho, c * eps}, {x, c * eps}, {y, 0}, {vx, 0}, {vy, 0}};
  const auto slope = [&](const ex& f, const symbol& in) {  // ρ² = x² + y²
    const bool position = in.is_equal(x) || in.is_equal(y);
    return ex((f.diff(in) + (position ? in / rho * f.diff(rho) : ex(0))).subs(place));
  };
  const auto force = [&](const symbol& in) {
    const auto component = [&](const Known& f) {
      return f.eps * slope(ratio, in) + f.a * slope(a, in) + f.b * slope(b, in);
    };
    const Planar t = turned_90(r);
    return Planar{component(fr) + fr.value * slope(r.x, in) + ft.value * slope(t.x, in),
                  component(ft) + fr.value * slope(r.y, in) + ft.value * slope(t.y, in)};
  };
  proofs::equal(proof, Algebra(), force(x), {(fr.eps + omega * fr.a) / c, (ft.eps + omega * ft.a) / c});
  proofs::equal(proof, Algebra(), force(y), {-ft.value / (c * eps), fr.value / (c * eps)});
  proofs::equal(proof, Algebra(), force(vx), {fr.b / c, ft.b / c});
  proofs::equal(proof, Algebra(), force(vy), {-2 * fr.a / c, -2 * ft.a / c});
}

struct Rotor {
  symbol kxx{"K_xx"}, kxy{"K_xy"}, kyx{"K_yx"}, kyy{"K_yy"}, cxx{"C_xx"}, cxy{"C_xy"}, cyx{"C_yx"}, cyy{"C_yy"}, m{"m"};
  ex det_c = cxx * cyy - cxy * cyx;
  ex trace_c = cxx + cyy;
  ex kappa = (kxx * cyy + kyy * cxx - kxy * cyx - kyx * cxy) / trace_c;
  ex det_at_kappa = (kxx - kappa) * (kyy - kappa) - kxy * kyx;

  /// det(m s² + C s + K) by powers of s.
  ex coefficient(int power) const {
    const symbol s("s");
    const auto entry = [&](const ex& c, const ex& k, const ex& mass) { return mass * s * s + c * s + k; };
    const ex determinant = entry(cxx, kxx, m) * entry(cyy, kyy, m) - entry(cxy, kxy, 0) * entry(cyx, kyx, 0);
    return determinant.expand().coeff(s, power);
  }
};

void hurwitz(Proof& proof, const ex& factor) {
  const Rotor y;
  const auto a = [&](int power) { return y.coefficient(power); };
  proof.equal(Algebra(), a(1) * (a(3) * a(2) - a(4) * a(1)) - a(3) * a(3) * a(0),
              y.m * pow(y.trace_c, 2) * (y.kappa * y.det_c - factor * y.m * y.det_at_kappa));
}

/// At s = iν with mν² = κ both parts of the characteristic polynomial vanish if ν² det C = det(K − κ).
void whirl_at_threshold(Proof& proof) {
  const Rotor y;
  const symbol nu2("nu2");
  const GiNaC::exmap at{{y.m, y.kappa / nu2}};
  proof.zero(Algebra(), (y.coefficient(1) - y.coefficient(3) * nu2).subs(at));
  proof.equal(Algebra(), (y.coefficient(0) - y.coefficient(2) * nu2 + y.coefficient(4) * nu2 * nu2).subs(at),
              y.det_at_kappa - nu2 * y.det_c);
}

/// K and C turned by an angle give the same κ and ν².
void turned_frame(Proof& proof) {
  const Rotor y;
  const symbol phi("phi");
  const Algebra algebra = Algebra().angle(phi);
  const auto turn = [&](const ex& xx, const ex& xy, const ex& yx, const ex& yy) {
    const ex c = cos(phi), s = sin(phi);
    return std::array<ex, 4>{c * c * xx - c * s * (xy + yx) + s * s * yy, c * s * (xx - yy) + c * c * xy - s * s * yx,
                             c * s * (xx - yy) + c * c * yx - s * s * xy, s * s * xx + c * s * (xy + yx) + c * c * yy};
  };
  const auto k = turn(y.kxx, y.kxy, y.kyx, y.kyy);
  const auto c = turn(y.cxx, y.cxy, y.cyx, y.cyy);
  const GiNaC::exmap map{{y.kxx, k[0]}, {y.kxy, k[1]}, {y.kyx, k[2]}, {y.kyy, k[3]},
                         {y.cxx, c[0]}, {y.cxy, c[1]}, {y.cyx, c[2]}, {y.cyy, c[3]}};
  proof.equal(algebra, y.kappa.subs(map), y.kappa);
  proof.equal(algebra, y.det_at_kappa.subs(map), y.det_at_kappa);
  proof.equal(algebra, y.det_c.subs(map), y.det_c);
}

/// κ over W/c and ν² over ω² as ε → 0, W → Sω F_t′(0) ε: every coefficient is used to first order in ε.
void concentric_threshold(Proof& proof, const Coefficients& at, const ex& slope_of_load, const ex& kappa,
                          const ex& nu_squared) {
  const symbol& eps = sym().eps;
  const auto first = [&](const ex& f) {  // Taylor's first two terms, with s = 1 − …ε²
    return f.subs(GiNaC::exmap{{eps, 0}, {sym().s, 1}}) +
           eps * (f.diff(eps) - eps / sym().s * f.diff(sym().s)).subs(GiNaC::exmap{{eps, 0}, {sym().s, 1}});
  };
  const ex krr = first(at.krr), ktr = first(at.ktr), krt = first(at.krt), ktt = first(at.ktt);
  const ex crr = first(at.crr), ctr = first(at.ctr), crt = first(at.crt), ctt = first(at.ctt);
  const ex k = (krr * ctt + ktt * crr - krt * ctr - ktr * crt) / (crr + ctt);
  proof.equal(Algebra(), (k / (slope_of_load * eps)).normal().subs(eps == 0), kappa);
  const ex n = ((krr - k) * (ktt - k) - krt * ktr) / (crr * ctt - crt * ctr);
  proof.equal(Algebra(), n.normal().subs(eps == 0), nu_squared);
}

}  // namespace

std::vector<Statement> coefficient_statements() {
  using enum Expectation;
  const std::string source = "derivatives of the law";
  std::vector<Statement> all;
  const auto closed = [&](const std::string& text, const std::string& law, const Coefficients& claimed,
                          const std::string& note = "") {
    all.push_back(
        {group, text, source, holds, [=](Proof& proof) { equal(proof, differentiated(polar(law)), claimed); }, note});
  };
  all.push_back({group,
                 "K_rr = -dF_r/deps/c along a = eps omega, K_tr likewise, K_rt = F_t/(c eps), K_tt = -F_r/(c eps), "
                 "C_rr = -F_r,b/c, C_tr = -F_t,b/c, C_rt = 2F_r,a/c, C_tt = 2F_t,a/c",
                 "F = F_r r + F_t t", holds, [](Proof& proof) { polar_to_plane(proof, 2); }});
  closed("closed K and C of short full", "short full", closed_short_full());
  closed("closed K and C of short half", "short half", closed_short_half());
  closed("closed K and C of short dynamic are those of short half", "short dynamic", closed_short_half(),
         "the pressure vanishes at its moving ends");
  closed("closed K and C of long full", "long full", closed_long_full());
  closed("closed K and C of long half", "long half", closed_long_half());
  closed("closed K and C of the long half film of eq. 5", "long half of eq. 5 cut at pi", closed_long_half_eq5());
  closed("closed K and C of long dynamic", "long dynamic", closed_long_dynamic(), "C is not symmetric");
  closed("closed K and C of Pinkus-Sternlicht, b -> 0+", "Pinkus-Sternlicht, b >= 0", closed_pinkus_sternlicht());
  closed("closed K and C of Pinkus-Sternlicht, b -> 0-", "Pinkus-Sternlicht, b < 0", closed_pinkus_sternlicht());
  const std::string routh = "Routh and Hurwitz";
  all.push_back({group, "rigid rotor: Hurwitz's determinant is m (tr C)^2 (kappa det C - m det(K - kappa))", routh,
                 holds, [](Proof& proof) { hurwitz(proof, 1); },
                 "kappa = (K_xx C_yy + K_yy C_xx - K_xy C_yx - K_yx C_xy)/tr C"});
  all.push_back({group, "at m = kappa/nu^2, nu^2 = det(K - kappa)/det C, the rotor whirls at nu", routh, holds,
                 whirl_at_threshold});
  all.push_back({group, "kappa and nu^2 are the same in every frame", routh, holds, turned_frame});
  all.push_back({group, "eps -> 0: short half has c kappa/W = 6/pi and nu = omega/2", routh, holds,
                 [](Proof& proof) { concentric_threshold(proof, closed_short_half(), Pi / 4, 6 / Pi, frac(1, 4)); }});
  all.push_back({group, "eps -> 0: long dynamic has c kappa/W = 3/pi and nu = omega/2", routh, holds,
                 [](Proof& proof) { concentric_threshold(proof, closed_long_dynamic(), 3 * Pi, 3 / Pi, frac(1, 4)); }});
  const ex pi2 = pow(Pi, 2);
  all.push_back({group,
                 "eps -> 0: long half has c kappa/W = (3 pi^2 - 8)/(pi (pi^2 - 4)), nu^2/omega^2 = pi^2/(4 (pi^2 - 8))",
                 routh, holds,
                 [=](Proof& proof) {
                   concentric_threshold(proof, closed_long_half(), 3 * Pi, (3 * pi2 - 8) / (Pi * (pi2 - 4)),
                                        pi2 / (4 * (pi2 - 8)));
                 },
                 "nu = 1.149 omega: its damping at the centre depends on the direction, so it is no film that turns "
                 "with the mean spin"});
  all.push_back({group, "WRONG: a = eps omega - (v.t)/c", "F = F_r r + F_t t altered", wrong,
                 [](Proof& proof) { polar_to_plane(proof, 1); }});
  all.push_back({group, "WRONG: long dynamic has long half's C", source + " altered", wrong,
                 [](Proof& proof) { equal(proof, differentiated(polar("long dynamic")), closed_long_half()); }});
  all.push_back(
      {group, "WRONG: long half whirls at half the spin as eps -> 0", routh + " altered", wrong, [=](Proof& proof) {
         concentric_threshold(proof, closed_long_half(), 3 * Pi, (3 * pi2 - 8) / (Pi * (pi2 - 4)), frac(1, 4));
       }});
  all.push_back({group, "WRONG: Hurwitz's determinant with m/2", routh + " altered", wrong,
                 [](Proof& proof) { hurwitz(proof, frac(1, 2)); }});
  return all;
}

}  // namespace lubjoint::proofs

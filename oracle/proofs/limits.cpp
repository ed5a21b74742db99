// Limits of the laws: concentric journal, pure wedge, pure squeeze, half and full film.

#include "oracle/proofs/laws.hpp"
#include "oracle/proofs/ledger.hpp"

namespace lubjoint::proofs {

namespace {

const char* const group = "limits";

const GiNaC::exmap& concentric() {
  static const GiNaC::exmap map{{sym().eps, 0}, {sym().s, 1}, {sym().delta, Pi / 2}};
  return map;
}

GiNaC::exmap motion(const ex& a, const ex& b) { return {{sym().a, a}, {sym().b, b}}; }

/// b = 0: θs = 0 for a > 0 and π for a < 0, whichever side b comes from; e₁ = 0 and so δ = π/2.
GiNaC::exmap pure_wedge(int side) {
  return {{sym().cos_start, side},           {sym().sin_start, 0}, {sym().delta, Pi / 2}, {sym().sigma, side},
          {sym().a, 2 * side * sym().speed}, {sym().b, 0}};
}

/// a = 0: θs = ±π/2.
GiNaC::exmap pure_squeeze(int side) {
  return {{sym().cos_start, 0}, {sym().sin_start, side}, {sym().a, 0}, {sym().b, side * sym().speed}};
}

Polar side_of(const Polar& law, int side) { return law.subs({{sym().sigma, side}}); }

Statement claim(const std::string& text, const std::string& source, std::function<void(Proof&)> examine,
                const std::string& note = "") {
  return {group, text, source, Expectation::holds, std::move(examine), note};
}

/// −u is b and −a/2 with its sign turned: −factor·u = (−factor·b, factor·a/2).
Polar damping(const ex& factor) { return {-factor * sym().b, factor * sym().a / 2}; }

void concentric_polar(Proof& proof, const Polar& law, const Polar& limit) {
  equal(proof, film_algebra(), law.subs(concentric()), limit);
}

void concentric_dynamic(Proof& proof, Resistance (*law)(const ex&, const ex&, const ex&, const ex&), const ex& factor) {
  equal(proof, film_algebra(), in_polar_components(law).subs(concentric()), damping(factor).subs(in_dynamic_motion()));
}

void dynamic_is_half_at_wedge(Proof& proof, Resistance (*law)(const ex&, const ex&, const ex&, const ex&),
                              const Polar& half) {
  for (const int side : {1, -1}) {
    equal(proof, film_algebra(), in_polar_components(law).subs(pure_wedge(side)), half.subs(pure_wedge(side)));
  }
}

/// p⁺ of u and p⁺ of −u together are the whole pressure: F(u) − F(−u) = full film. −u has −e₁, −e₂ and π − δ.
void both_parts_of_short_film(Proof& proof, Resistance (*law)(const ex&, const ex&, const ex&, const ex&),
                              const Polar& full) {
  const Symbols& y = sym();
  const GiNaC::exmap reversed{{y.cos_start, -y.cos_start}, {y.sin_start, -y.sin_start}, {y.delta, Pi - y.delta}};
  const Polar film = in_polar_components(law);
  equal(proof, film_algebra(), film - film.subs(reversed), full.subs(in_dynamic_motion()));
}

void add_concentric(std::vector<Statement>& all) {
  const auto concentric_claim = [&](const std::string& name, const std::string& source, const Polar& law,
                                    const Polar& limit) {
    all.push_back(claim("eps -> 0: " + name, source, [=](Proof& proof) { concentric_polar(proof, law, limit); }));
  };
  const auto& [a, b, sigma] = std::tie(sym().a, sym().b, sym().sigma);
  concentric_claim("short full tends to -pi S u", "eqs. 6, 7", short_full(), damping(Pi));
  concentric_claim("short half tends to -(pi/2) S u", "eqs. 8, 9", short_half(), damping(Pi / 2));
  concentric_claim("long full tends to -12 pi S u", "eqs. 10, 11", long_full(), damping(12 * Pi));
  concentric_claim("long half tends to F_r = -6(pi - 8/pi) S u_r, F_t = -6 pi S u_t", "eqs. 12, 13", long_half(),
                   {-6 * (Pi - 8 / Pi) * b, 3 * Pi * a});
  concentric_claim("long half of eq. 5 tends to -6 pi S u + 24 sgn(a) S b t", "eq. 5", long_half_eq5(),
                   damping(6 * Pi) + Polar{0, 24 * sigma * b});
  const ex k = sym().s * sym().speed;
  concentric_claim("Pinkus-Sternlicht, b >= 0, tends to -6 pi S u", "eqs. 14, 15", pinkus_sternlicht(k, true),
                   damping(6 * Pi));
  concentric_claim("Pinkus-Sternlicht, b < 0, tends to -6 pi S u", "eqs. 16, 17", pinkus_sternlicht(k, false),
                   damping(6 * Pi));
  all.push_back(claim(
      "eps -> 0: short dynamic tends to -(pi/2) S u", "exact dynamic film",
      [](Proof& proof) { concentric_dynamic(proof, short_dynamic, Pi / 2); }, "e1 = 0: delta = atan2(1, 0) = pi/2"));
  all.push_back(claim(
      "eps -> 0: long dynamic tends to -6 pi S u", "exact dynamic film",
      [](Proof& proof) { concentric_dynamic(proof, long_dynamic, 6 * Pi); }, "e1 = 0: delta = atan2(1, 0) = pi/2"));
}

void add_mistakes(std::vector<Statement>& all) {
  using enum Expectation;
  all.push_back({group, "WRONG: eps -> 0: long half is isotropic", "eqs. 12, 13", wrong,
                 [](Proof& proof) { concentric_polar(proof, long_half(), damping(6 * Pi)); }});
  all.push_back({group, "WRONG: long half on 0..pi and on pi..2pi add up to the full film", "eqs. 10 to 13", wrong,
                 [](Proof& proof) {
                   equal(proof, film_algebra(), side_of(long_half(), 1) + side_of(long_half(), -1), long_full());
                 }});
  all.push_back({group, "WRONG: long dynamic, F(u) - F(-u) = full film", "exact dynamic film", wrong,
                 [](Proof& proof) { both_parts_of_short_film(proof, long_dynamic, long_full()); }});
  all.push_back({group, "WRONG: a = 0: F_r of the long half film is half of the full film's", "eqs. 10, 12", wrong,
                 [](Proof& proof) {
                   proof.equal(film_algebra(), long_half().subs(motion(0, sym().b)).radial,
                               long_full().subs(motion(0, sym().b)).radial / 2);
                 }});
  all.push_back({group, "WRONG: short dynamic is short half at b != 0", "exact dynamic film", wrong, [](Proof& proof) {
                   const Polar film = in_polar_components(short_dynamic).subs(pure_squeeze(1));
                   equal(proof, film_algebra(), film, short_half().subs(pure_squeeze(1)));
                 }});
}

}  // namespace

std::vector<Statement> limit_statements() {
  const ex a = sym().a;
  const ex b = sym().b;
  std::vector<Statement> all;
  add_concentric(all);
  all.push_back(claim("b -> 0: short half is the wedge -eps|a|/q^2, pi a/(4 q^(3/2))", "eqs. 8, 9", [=](Proof& proof) {
    equal(proof, film_algebra(), short_half().subs(motion(a, 0)),
          {-sym().eps * sym().sigma * a / pow(q(), 2), Pi * a / (4 * pow(sym().s, 3))});
  }));
  all.push_back(claim("b -> 0: both long half films are the same wedge", "eqs. 5, 12, 13", [=](Proof& proof) {
    equal(proof, film_algebra(), long_half().subs(motion(a, 0)), long_half_eq5().subs(motion(a, 0)));
  }));
  for (const int side : {1, -1}) {
    const std::string sign = side > 0 ? "a > 0" : "a < 0";
    all.push_back(claim("b -> 0+ and b -> 0-, " + sign + ": Pinkus-Sternlicht tends to the long half film's wedge",
                        "eqs. 12 to 18", [=](Proof& proof) {
                          const ex k = sym().s * sym().speed;
                          for (const bool closing : {true, false}) {
                            equal(proof, film_algebra(), pinkus_sternlicht(k, closing).subs(pure_wedge(side)),
                                  long_half().subs(pure_wedge(side)));
                          }
                        }));
  }
  all.push_back(claim(
      "b = 0: short dynamic is short half, both signs of a", "exact dynamic film",
      [](Proof& proof) { dynamic_is_half_at_wedge(proof, short_dynamic, short_half()); },
      "theta_s = 0 (a > 0) or pi (a < 0), delta = pi/2"));
  all.push_back(claim(
      "b = 0: long dynamic is long half, both signs of a", "exact dynamic film",
      [](Proof& proof) { dynamic_is_half_at_wedge(proof, long_dynamic, long_half()); },
      "theta_s = 0 (a > 0) or pi (a < 0), delta = pi/2"));
  all.push_back(claim("a = 0: both dynamic films are purely radial", "exact dynamic film", [](Proof& proof) {
    for (const int side : {1, -1}) {
      proof.zero(film_algebra(), in_polar_components(short_dynamic).subs(pure_squeeze(side)).tangential);
      proof.zero(film_algebra(), in_polar_components(long_dynamic).subs(pure_squeeze(side)).tangential);
    }
  }));
  all.push_back(claim("short half on 0..pi and on pi..2pi add up to the full film", "eqs. 6 to 9", [](Proof& proof) {
    equal(proof, film_algebra(), side_of(short_half(), 1) + side_of(short_half(), -1), short_full());
  }));
  all.push_back(
      claim("long half of eq. 5 on 0..pi and on pi..2pi add up to the full film", "eqs. 5, 10, 11", [](Proof& proof) {
        equal(proof, film_algebra(), side_of(long_half_eq5(), 1) + side_of(long_half_eq5(), -1), long_full());
      }));
  all.push_back(claim(
      "short dynamic, F(u) - F(-u) = full film", "exact dynamic film",
      [](Proof& proof) { both_parts_of_short_film(proof, short_dynamic, short_full()); },
      "the positive and the negative part of one pressure; -u has pi - delta"));
  all.push_back(claim("b = 0: F_t of every half film is half of the full film's", "eqs. 6 to 13", [=](Proof& proof) {
    const GiNaC::exmap wedge = motion(a, 0);
    proof.equal(film_algebra(), short_half().subs(wedge).tangential, short_full().subs(wedge).tangential / 2);
    proof.equal(film_algebra(), long_half().subs(wedge).tangential, long_full().subs(wedge).tangential / 2);
    proof.equal(film_algebra(), long_half_eq5().subs(wedge).tangential, long_full().subs(wedge).tangential / 2);
  }));
  all.push_back(
      claim("a = 0: F_r of short half and of long half of eq. 5 is half of the full film's", "eqs. 5 to 11",
            [=](Proof& proof) {
              const GiNaC::exmap squeeze = motion(0, b);
              proof.equal(film_algebra(), short_half().subs(squeeze).radial, short_full().subs(squeeze).radial / 2);
              proof.equal(film_algebra(), long_half_eq5().subs(squeeze).radial, long_full().subs(squeeze).radial / 2);
            }));
  add_mistakes(all);
  return all;
}

}  // namespace lubjoint::proofs

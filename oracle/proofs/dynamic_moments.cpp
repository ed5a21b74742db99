// The six moments J_lm of the dynamic films in Sommerfeld's angle, and the polar laws made of them.

#include "oracle/proofs/ledger.hpp"
#include "oracle/proofs/long_film.hpp"

namespace lubjoint::proofs {

namespace {

const char* const group = "dynamic films: moments in Sommerfeld's angle";

ex moment_integrand(int l, int m) {
  const symbol& theta = sym().theta;
  return pow(sin(theta), l) * pow(cos(theta), m) / pow(film_at(cos(theta)), 3);
}

/// q^{(1+l)/2 − 3} sinˡψ (cosψ − ε)ᵐ (1 − ε cosψ)^{2−l−m}.
ex claimed_moment_integrand(int l, int m, int power_of_s) {
  const auto& [eps, s, psi] = std::tie(sym().eps, sym().s, sym().psi);
  return pow(s, power_of_s) * pow(sin(psi), l) * pow(cos(psi) - eps, m) * pow(1 - eps * cos(psi), 2 - l - m);
}

Algebra psi_algebra() { return film_algebra().angle(sym().psi); }

void moment_in_psi(Proof& proof, int l, int m) {
  const ex claimed = claimed_moment_integrand(l, m, 1 + l - 6);
  proof.equal(psi_algebra(), integrand_in_psi(moment_integrand(l, m)), claimed);
  const ex primitive = trigonometric_antiderivative(claimed, sym().psi);
  proof.equal(psi_algebra(), primitive.diff(sym().psi), claimed);
  proof.equal(film_algebra(), total_derivative(primitive), moment_integrand(l, m));
}

/// cos and sin of ψe − ψs from the ends θs and θs + π.
std::pair<ex, ex> film_length() {
  const FilmEnd from = dynamic_film_start();
  const FilmEnd to = dynamic_film_end();
  const ex c1 = cos_psi_of(from.cos_theta), w1 = sin_psi_of(from.cos_theta, from.sin_theta);
  const ex c2 = cos_psi_of(to.cos_theta), w2 = sin_psi_of(to.cos_theta, to.sin_theta);
  return {c2 * c1 + w2 * w1, w2 * c1 - c2 * w1};
}

/// tan((ℓ − π)/2) = −cot(ℓ/2) = −(1 + cosℓ)/sinℓ.
void film_length_holds(Proof& proof, const ex& tangent) {
  const auto [cosine, sine] = film_length();
  proof.equal(film_algebra(), -(1 + cosine) / sine, tangent);
}

struct Moments {
  ex j00, j01, j10, j11, j20, j02;
};

Moments moments() {
  const FilmEnd from = dynamic_film_start();
  const FilmEnd to = dynamic_film_end();
  return {moment(0, 0, from, to), moment(0, 1, from, to), moment(1, 0, from, to),
          moment(1, 1, from, to), moment(2, 0, from, to), moment(0, 2, from, to)};
}

Polar short_by_moments() {
  const auto& [a, b] = std::tie(sym().a, sym().b);
  const Moments j = moments();
  return {frac(1, 2) * (a * j.j11 - 2 * b * j.j02), frac(1, 2) * (a * j.j20 - 2 * b * j.j11)};
}

Polar long_by_moments() {
  const auto& [a, b] = std::tie(sym().a, sym().b);
  const Moments j = moments();
  const ex constant = -(a * j.j01 + 2 * b * j.j10) / j.j00;
  return {-6 * (a * j.j11 + 2 * b * j.j20 + constant * j.j10), 6 * (a * j.j02 + 2 * b * j.j11 + constant * j.j01)};
}

void short_law(Proof& proof, const Polar& claimed) {
  const symbol& theta = sym().theta;
  const Polar primitive{antiderivative(short_profile() * cos(theta)), antiderivative(short_profile() * sin(theta))};
  prove_force(proof, short_profile(), primitive, dynamic_film_start(), dynamic_film_end(), frac(1, 2), claimed);
}

void long_law(Proof& proof, const Polar& claimed) {
  const LongFilm film = long_film_between(dynamic_film_start(), dynamic_film_end());
  const Polar primitive = antiderivatives_of_force(film.pressure, long_slope(film.constant));
  prove_force(proof, film.pressure, primitive, dynamic_film_start(), dynamic_film_end(), 6, claimed);
}

void polar_law_equals_frame_law(Proof& proof, const Polar& by_moments,
                                Resistance (*law)(const ex&, const ex&, const ex&, const ex&)) {
  const GiNaC::exmap motion = in_dynamic_motion();
  equal(proof, film_algebra(), by_moments.subs(motion), in_polar_components(law));
}

}  // namespace

std::vector<Statement> dynamic_moment_statements() {
  using enum Expectation;
  const std::string source = "exact dynamic film";
  std::vector<Statement> all;
  constexpr std::pair<int, int> orders[] = {{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 0}, {0, 2}};
  for (const auto& [l, m] : orders) {
    const std::string name = "J" + std::to_string(l) + std::to_string(m);
    all.push_back(
        {group, name + " = int sin^l cos^m/H^3 dtheta is q^((1+l)/2-3) int sin^l (cos-eps)^m (1-eps cos)^(2-l-m) dpsi",
         source, holds, [l = l, m = m](Proof& proof) { moment_in_psi(proof, l, m); },
         "a trigonometric polynomial in psi; its antiderivative differentiates to the integrand in theta"});
  }
  all.push_back(
      {group, "the dynamic film is psi_e - psi_s = pi + 2 arctan(eps sin(theta_s)/sqrt(q)) long", source, holds,
       [](Proof& proof) { film_length_holds(proof, sym().eps * sym().sin_start / sym().s); },
       "psi_e - psi_s lies in (0, 2 pi) as theta_e - theta_s = pi, so half of it less pi/2 is the arctangent's "
       "principal value"});
  all.push_back({group,
                 "the length is 2 delta, cos(delta) = -eps sin(theta_s)/N, sin(delta) = sqrt(q)/N, N^2 = 1 - eps^2 "
                 "cos^2(theta_s)",
                 source, holds, [](Proof& proof) {
                   const Symbols& y = sym();
                   const ex n2 = 1 - pow(y.eps * y.cos_start, 2);
                   const auto [cosine, sine] = film_length();
                   proof.equal(film_algebra(), cosine, (pow(y.eps * y.sin_start, 2) - q()) / n2);
                   proof.equal(film_algebra(), sine, -2 * y.eps * y.sin_start * y.s / n2);
                   proof.equal(film_algebra(), pow(y.eps * y.sin_start, 2) + q(), n2);
                 }});
  all.push_back({group, "short dynamic: F_r = (a J11 - 2b J02)/2, F_t = (a J20 - 2b J11)/2 is the integral of eq. 3",
                 source, holds, [](Proof& proof) { short_law(proof, short_by_moments()); }});
  all.push_back(
      {group,
       "long dynamic: F_r = -6(a J11 + 2b J20 + C J10), F_t = 6(a J02 + 2b J11 + C J01) is the integral of its field",
       source, holds, [](Proof& proof) { long_law(proof, long_by_moments()); }});
  all.push_back({group, "short dynamic: the closed form in the frame of u is the polar form with J_lm", source, holds,
                 [](Proof& proof) { polar_law_equals_frame_law(proof, short_by_moments(), short_dynamic); },
                 "e1 = eps sin(theta_s), e2 = eps cos(theta_s)"});
  all.push_back({group, "long dynamic: the closed form in the frame of u is the polar form with J_lm", source, holds,
                 [](Proof& proof) { polar_law_equals_frame_law(proof, long_by_moments(), long_dynamic); },
                 "e1 = eps sin(theta_s), e2 = eps cos(theta_s)"});

  all.push_back({group, "WRONG: J20 with q^((1+l)/2-2)", source + " altered", wrong, [](Proof& proof) {
                   proof.equal(psi_algebra(), integrand_in_psi(moment_integrand(2, 0)),
                               claimed_moment_integrand(2, 0, 1 + 2 - 4));
                 }});
  all.push_back({group, "WRONG: the dynamic film is pi - 2 arctan(eps sin(theta_s)/sqrt(q)) long", source + " altered",
                 wrong, [](Proof& proof) { film_length_holds(proof, -sym().eps * sym().sin_start / sym().s); }});
  all.push_back(
      {group, "WRONG: short dynamic force with the film pi long in psi", source + " altered", wrong, [](Proof& proof) {
         const GiNaC::exmap straight{{sym().delta, Pi / 2}};
         equal(proof, film_algebra(), short_by_moments().subs(in_dynamic_motion()).subs(straight),
               in_polar_components(short_dynamic));
       }});
  all.push_back({group, "WRONG: long dynamic force with C = 0", source + " altered", wrong, [](Proof& proof) {
                   const auto& [a, b] = std::tie(sym().a, sym().b);
                   const Moments j = moments();
                   long_law(proof, {-6 * (a * j.j11 + 2 * b * j.j20), 6 * (a * j.j02 + 2 * b * j.j11)});
                 }});
  return all;
}

}  // namespace lubjoint::proofs

// Each pressure field satisfies Reynolds' equation and its edge conditions.

#include "oracle/proofs/ledger.hpp"
#include "oracle/proofs/long_film.hpp"

namespace lubjoint::proofs {

namespace {

struct Dimensions {
  symbol mu{"mu"}, length{"L"}, radius{"R"}, clearance{"c"}, z{"z"};
};

ex short_pressure(const Dimensions& y) {
  return 3 * y.mu / pow(y.clearance, 2) * (pow(y.length, 2) / 4 - pow(y.z, 2)) * short_profile();
}

/// Reynolds' equation (left − right) with the axial and the circumferential term switched on or off. The pressure may
/// contain ψ(θ).
ex residual(const Dimensions& y, const ex& pressure, bool circumferential, bool axial) {
  const ex h3 = pow(film_at(cos(sym().theta)), 3);
  ex left = 0;
  if (circumferential) left += total_derivative(h3 * total_derivative(pressure)) / pow(y.radius, 2);
  if (axial) left += (h3 * pressure.diff(y.z)).diff(y.z);
  return left + 6 * y.mu / pow(y.clearance, 2) * reynolds_source(sym().theta);
}

ex long_scale(const Dimensions& y) { return 6 * y.mu * pow(y.radius / y.clearance, 2); }

ex at_theta(const ex& expression, int half_turns) {
  const FilmEnd end = film_end_at_half_turns(half_turns);
  return value_at(expression, end);
}

void long_film_holds(Proof& proof, const FilmEnd& from, const FilmEnd& to) {
  const Dimensions y;
  const Algebra algebra = film_algebra();
  const LongFilm film = long_film_between(from, to);
  proof.zero(algebra, residual(y, long_scale(y) * film.pressure, true, false));
  proof.equal(algebra, total_derivative(film.pressure), long_slope(film.constant));
  proof.zero(algebra, value_at(film.pressure, from));
  proof.zero(algebra, value_at(film.pressure, to));
}

}  // namespace

std::vector<Statement> reynolds_field_statements() {
  const std::string group = "Reynolds' equation and edge conditions";
  using enum Expectation;
  std::vector<Statement> all;

  all.push_back({group, "short bearing: the pressure satisfies d/dz(H^3 dp/dz) = -(6 mu/c^2)(a sin - 2b cos)", "eq. 3",
                 holds, [](Proof& proof) {
                   const Dimensions y;
                   proof.zero(film_algebra(), residual(y, short_pressure(y), false, true));
                 }});
  all.push_back({group, "short bearing: p = 0 at |z| = L/2", "eq. 3", holds, [](Proof& proof) {
                   const Dimensions y;
                   proof.zero(film_algebra(), short_pressure(y).subs(y.z == y.length / 2));
                   proof.zero(film_algebra(), short_pressure(y).subs(y.z == -y.length / 2));
                 }});
  all.push_back({group, "short bearing, dynamic film: a sin(theta) - 2b cos(theta) = 2|u| sin(theta - theta_s)",
                 "the angles before eq. 14", holds,
                 [](Proof& proof) {
                   const Symbols& y = sym();
                   proof.equal(film_algebra(), reynolds_source(y.theta).subs(in_dynamic_motion()),
                               2 * y.speed * (sin(y.theta) * y.cos_start - cos(y.theta) * y.sin_start));
                 },
                 "a = 2|u| cos(theta_s), b = |u| sin(theta_s): p > 0 exactly on theta_s < theta < theta_s + pi"});
  all.push_back({group,
                 "long bearing: the pressure satisfies d/dtheta(H^3 dp/dtheta)/R^2 = -(6 mu/c^2)(a sin - 2b cos)",
                 "eq. 5", holds, [](Proof& proof) {
                   const Dimensions y;
                   proof.zero(film_algebra(), residual(y, long_scale(y) * long_profile_printed(), true, false));
                 }});
  all.push_back({group, "long bearing: the form without division by eps is the printed one", "eq. 5", holds,
                 [](Proof& proof) { proof.equal(film_algebra(), long_profile(), long_profile_printed()); }});
  all.push_back({group, "long bearing: p(0) = 0 and p(2 pi) = p(0), slope included", "eq. 5", holds, [](Proof& proof) {
                   const ex slope = total_derivative(long_profile());
                   proof.zero(film_algebra(), at_theta(long_profile(), 0));
                   proof.equal(film_algebra(), at_theta(long_profile(), 2), at_theta(long_profile(), 0));
                   proof.equal(film_algebra(), at_theta(slope, 2), at_theta(slope, 0));
                 }});
  all.push_back(
      {group, "long bearing: p(pi) of eq. 5 is 4b/q^2 in units of 6 mu (R/c)^2", "eq. 5", holds,
       [](Proof& proof) { proof.equal(film_algebra(), at_theta(long_profile(), 1), 4 * sym().b / pow(q(), 2)); }});
  all.push_back({group, "long half film on 0..pi: Reynolds' equation, p(0) = p(pi) = 0", "eqs. 12, 13", holds,
                 [](Proof& proof) { long_film_holds(proof, film_end_at_half_turns(0), film_end_at_half_turns(1)); }});
  all.push_back({group, "long half film on pi..2pi: Reynolds' equation, p(pi) = p(2 pi) = 0", "eqs. 12, 13 mirrored",
                 holds,
                 [](Proof& proof) { long_film_holds(proof, film_end_at_half_turns(1), film_end_at_half_turns(2)); }});
  all.push_back({group, "long dynamic film: Reynolds' equation on theta_s..theta_s + pi, p = 0 at both ends",
                 "exact dynamic film", holds,
                 [](Proof& proof) { long_film_holds(proof, dynamic_film_start(), dynamic_film_end()); },
                 "p in closed form with psi; C = -(a J01 + 2b J10)/J00"});

  all.push_back({group, "WRONG: short bearing without the factor 2 in the squeeze term", "eq. 3 altered", wrong,
                 [](Proof& proof) {
                   const Dimensions y;
                   proof.zero(film_algebra(), residual(y, short_pressure(y).subs(sym().b == sym().b / 2), false, true));
                 }});
  all.push_back({group, "WRONG: long bearing with 1/H in place of 1/H^2 in the squeeze term", "eq. 5 altered", wrong,
                 [](Proof& proof) {
                   const Dimensions y;
                   const ex squeeze = sym().b / sym().eps / film_at(cos(sym().theta));
                   const ex altered = long_profile_printed().subs(sym().b == 0) + squeeze;
                   proof.zero(film_algebra(), residual(y, long_scale(y) * altered, true, false));
                 }});
  all.push_back({group, "WRONG: the short pressure satisfies the full Reynolds equation, circumferential term included",
                 "eq. 3 beyond its range", wrong, [](Proof& proof) {
                   const Dimensions y;
                   proof.zero(film_algebra(), residual(y, short_pressure(y), true, true));
                 }});
  all.push_back({group, "WRONG: long bearing of eq. 5 has p(pi) = 0", "eq. 5 cut at pi", wrong,
                 [](Proof& proof) { proof.zero(film_algebra(), at_theta(long_profile(), 1)); }});
  all.push_back({group, "WRONG: long dynamic film that keeps the constant C of the full film vanishes at both ends",
                 "exact dynamic film altered", wrong, [](Proof& proof) {
                   const FilmEnd from = dynamic_film_start();
                   const FilmEnd to = dynamic_film_end();
                   const ex difference = value_at(long_profile(), to) - value_at(long_profile(), from);
                   proof.zero(film_algebra(), difference.subs(in_dynamic_motion()));
                 }});
  return all;
}

}  // namespace lubjoint::proofs

#include "oracle/certified/film_laws.hpp"

#include "oracle/certified/sommerfeld_moments.hpp"

namespace lubjoint::certified {

namespace {

/// Moments of the dynamic film, from sinθs = 2b/w, cosθs = a/w to the place opposite. The angle between them is
/// π + 2 arctan(ε sinθs/√q) = 2 atan2(√q, −ε sinθs).
SommerfeldMoments dynamic_moments(const FilmBalls& film) {
  const Ball w = sqrt(film.a * film.a + 4 * (film.b * film.b));
  const Ball sine = 2 * film.b / w;
  const Ball cosine = film.a / w;
  const Ball angle = 2 * atan2(sqrt(film.q()), -(film.epsilon * sine));
  return {film.epsilon, sine, cosine, -sine, -cosine, angle};
}

PolarBalls dynamic_force(Law law, const FilmBalls& film) {
  const auto& [epsilon, a, b] = film;
  const SommerfeldMoments j = dynamic_moments(film);
  PolarBalls force;
  if (law == Law::short_dynamic) {
    force.radial = (a * j.j11 - 2 * b * j.j02) / 2;
    force.tangential = (a * j.j20 - 2 * b * j.j11) / 2;
  } else {
    const Ball constant = -((a * j.j01 + 2 * b * j.j10) / j.j00);
    force.radial = -6 * (a * j.j11 + 2 * b * j.j20 + constant * j.j10);
    force.tangential = 6 * (a * j.j02 + 2 * b * j.j11 + constant * j.j01);
  }
  // The film of pure squeeze is its own mirror image; the one of a concentric wedge is symmetric to θ = π/2.
  if (a.is_exact_zero()) force.tangential = Ball(0);
  if (b.is_exact_zero() && epsilon.is_exact_zero()) force.radial = Ball(0);
  return force;
}

PolarBalls pinkus_sternlicht(const FilmBalls& film) {
  const auto& [epsilon, a, b] = film;
  const Ball q = film.q();
  const Ball root = sqrt(q);
  const Ball d = Ball(2) + epsilon * epsilon;
  const Ball k = sqrt(q * (a * a / 4 + b * b));
  const Ball big_b = epsilon * abs(b);
  const Ball below = k + 3 * big_b / 2;
  const Ball phi = (b.sign() < 0 ? k : k + 3 * big_b) / below;
  return {-(6 * (4 * epsilon * k + ball_pi() * d * b * phi) / (d * q * root)), 6 * ball_pi() * a * phi / (d * root)};
}

/// Where p > 0 in a film of pure squeeze: −(12b/q^{3/2})[π − arccos ε + ε√q] and, opening, [arccos ε − ε√q]; short:
/// −(b/q²)[(1+2ε²)(π − arccos ε)/√q + 3ε] and [(1+2ε²) arccos ε/√q − 3ε].
Ball positive_squeeze(Law law, const FilmBalls& film) {
  const Ball& epsilon = film.epsilon;
  const Ball q = film.q();
  const Ball root = sqrt(q);
  const bool opens = film.b.sign() < 0;
  const Ball arc = atan2(root, epsilon);  // arccos ε
  const Ball angle = opens ? arc : ball_pi() - arc;
  const Ball rest = opens ? -epsilon : epsilon;
  if (law == Law::squeeze_long) return -(12 * film.b / (q * root) * (angle + rest * root));
  const Ball growth = Ball(1) + 2 * epsilon * epsilon;
  return -(film.b / (q * q) * (growth * angle / root + 3 * rest));
}

}  // namespace

FilmBalls film_seen(const LawEntry& law, const FilmBalls& film) {
  return law.squeeze_only ? FilmBalls{film.epsilon, Ball(0), film.b} : film;
}

LawEntry law_entry(Law law, std::string_view name) {
  const LawFacts& facts = law_facts(name);
  return {law, facts.name, facts.is_short(), facts.extent, facts.has_pressure, facts.squeeze_only};
}

Ball force_scale(const LawEntry& law, double viscosity, double length, double radius, const Ball& clearance) {
  const Ball l(length);
  const Ball r(radius);
  const Ball slender = law.is_short ? l : r;
  return Ball(viscosity) * l * r * slender * slender / (clearance * clearance);
}

ExtentBalls film_extent(Extent extent, const FilmBalls& film) {
  const Ball pi = ball_pi();
  switch (extent) {
    case Extent::full:
      return {Ball(0), 2 * pi};
    case Extent::half:
      if (film.side() > 0) return {Ball(0), pi};
      return {pi, 2 * pi};
    case Extent::dynamic:
      break;
  }
  const Ball start = film.at_rest() ? Ball(0) : atan2(2 * film.b, film.a);
  return {start, start + pi};
}

PolarBalls force_ratio(Law law, const FilmBalls& film) {
  if (film.at_rest()) return {};
  const auto& [epsilon, a, b] = film;
  const Ball pi = ball_pi();
  const Ball q = film.q();
  const Ball root = sqrt(q);
  const Ball q_32 = q * root;
  const Ball q_52 = q * q * root;
  const Ball d = Ball(2) + epsilon * epsilon;
  const Ball growth = Ball(1) + 2 * epsilon * epsilon;
  const Ball side(film.side());
  switch (law) {
    case Law::short_full:
      return {-(pi * b * growth / q_52), pi * a / (2 * q_32)};
    case Law::short_half:
      return {-((2 * epsilon * abs(a) / (q * q) + pi * b * growth / q_52) / 2),
              (pi * a / (2 * q_32) + side * 4 * epsilon * b / (q * q)) / 2};
    case Law::long_full:
      return {-(12 * pi * b / q_32), 12 * pi * a / (d * root)};
    case Law::long_half:
      return {-(12 * epsilon * abs(a) / (d * q) + 6 * b / q_32 * (pi - 16 / (pi * d))),
              6 * pi * a / (d * root) + side * 24 * epsilon * b / (d * q)};
    case Law::long_half_eq5:
      return {-(12 * epsilon * abs(a) / (d * q) + 6 * pi * b / q_32),
              6 * pi * a / (d * root) + side * 24 * b / ((Ball(1) + epsilon) * q)};
    case Law::pinkus_sternlicht:
      return pinkus_sternlicht(film);
    case Law::squeeze_long_full:
      return {-(12 * pi * b / q_32), Ball(0)};
    case Law::squeeze_short_full:
      return {-(pi * b * growth / q_52), Ball(0)};
    case Law::squeeze_long:
    case Law::squeeze_short:
      return {b.is_exact_zero() ? Ball(0) : positive_squeeze(law, film), Ball(0)};
    case Law::short_dynamic:
    case Law::long_dynamic:
      break;
  }
  return dynamic_force(law, film);
}

}  // namespace lubjoint::certified

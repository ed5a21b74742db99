#include "oracle/proofs/sommerfeld.hpp"

#include <stdexcept>

namespace lubjoint::proofs {

FilmEnd film_end_at_half_turns(int half_turns) { return {half_turns % 2 == 0 ? 1 : -1, 0, half_turns * Pi}; }

FilmEnd dynamic_film_start() { return {sym().cos_start, sym().sin_start, sym().psi_start}; }

FilmEnd dynamic_film_end() { return {-sym().cos_start, -sym().sin_start, sym().psi_start + 2 * sym().delta}; }

ex cos_psi_of(const ex& cos_theta) { return (sym().eps + cos_theta) / film_at(cos_theta); }

ex sin_psi_of(const ex& cos_theta, const ex& sin_theta) { return sym().s * sin_theta / film_at(cos_theta); }

ex integrand_in_psi(const ex& integrand) {
  const Symbols& y = sym();
  const ex denominator = 1 - y.eps * cos(y.psi);
  const GiNaC::exmap map{{cos(y.theta), (cos(y.psi) - y.eps) / denominator},
                         {sin(y.theta), y.s * sin(y.psi) / denominator}};
  return integrand.subs(map) * y.s / denominator;
}

ex trigonometric_antiderivative(const ex& integrand, const symbol& angle) {
  const symbol c("c");
  const symbol w("w");
  const ex fraction = integrand.subs(GiNaC::exmap{{cos(angle), c}, {sin(angle), w}}).normal();
  const ex denominator = fraction.denom();
  if (denominator.has(c) || denominator.has(w)) throw std::domain_error("not a trigonometric polynomial");
  const ex numerator = fraction.numer().expand();
  // With sin² = 1 − cos² the polynomial is P(cos) + sin·Q(cos).
  ex even = 0;
  ex odd = 0;
  for (int k = 0; k <= numerator.degree(w); ++k) {
    (k % 2 == 0 ? even : odd) += numerator.coeff(w, k) * pow(1 - c * c, k / 2);
  }
  even = even.expand();
  odd = odd.expand();
  ex sum = 0;
  for (int n = 0; n <= odd.degree(c); ++n) sum -= odd.coeff(c, n) * pow(cos(angle), n + 1) / (n + 1);
  // ∫cosⁿ = cosⁿ⁻¹ sin/n + (n−1)/n ∫cosⁿ⁻².
  std::vector<ex> cosine_powers{angle, sin(angle)};
  for (int n = 0; n <= even.degree(c); ++n) {
    if (n >= 2) {
      cosine_powers.push_back(pow(cos(angle), n - 1) * sin(angle) / n +
                              frac(n - 1, n) * cosine_powers[static_cast<std::size_t>(n - 2)]);
    }
    sum += even.coeff(c, n) * cosine_powers[static_cast<std::size_t>(n)];
  }
  return sum / denominator;
}

ex antiderivative(const ex& integrand) { return trigonometric_antiderivative(integrand_in_psi(integrand), sym().psi); }

Polar antiderivatives_of_force(const ex& pressure, const ex& slope) {
  const symbol& theta = sym().theta;
  return {pressure * sin(theta) - antiderivative(slope * sin(theta)),
          -pressure * cos(theta) + antiderivative(slope * cos(theta))};
}

ex total_derivative(const ex& expression) {
  const Symbols& y = sym();
  const ex h = film_at(cos(y.theta));
  const ex derivative = expression.diff(y.theta) + expression.diff(y.psi) * y.s / h;
  return derivative.subs(
      GiNaC::exmap{{cos(y.psi), cos_psi_of(cos(y.theta))}, {sin(y.psi), sin_psi_of(cos(y.theta), sin(y.theta))}});
}

ex value_at(const ex& expression, const FilmEnd& end) {
  const Symbols& y = sym();
  const ex trigonometric = expression.subs(GiNaC::exmap{{cos(y.theta), end.cos_theta},
                                                        {sin(y.theta), end.sin_theta},
                                                        {cos(y.psi), cos_psi_of(end.cos_theta)},
                                                        {sin(y.psi), sin_psi_of(end.cos_theta, end.sin_theta)}});
  return trigonometric.subs(y.psi == end.psi);
}

ex between(const ex& antiderivative, const FilmEnd& from, const FilmEnd& to) {
  return value_at(antiderivative, to) - value_at(antiderivative, from);
}

void prove_force(Proof& proof, const ex& pressure, const Polar& primitive, const FilmEnd& from, const FilmEnd& to,
                 const ex& scale, const Polar& claimed) {
  const symbol& theta = sym().theta;
  const GiNaC::exmap to_theta{{cos(sym().psi), cos_psi_of(cos(theta))},
                              {sin(sym().psi), sin_psi_of(cos(theta), sin(theta))}};
  const ex field = pressure.subs(to_theta);
  const Algebra algebra = film_algebra();
  proof.equal(algebra, total_derivative(primitive.radial), field * cos(theta));
  proof.equal(algebra, total_derivative(primitive.tangential), field * sin(theta));
  proof.equal(algebra, scale * between(primitive.radial, from, to), claimed.radial);
  proof.equal(algebra, scale * between(primitive.tangential, from, to), claimed.tangential);
}

}  // namespace lubjoint::proofs

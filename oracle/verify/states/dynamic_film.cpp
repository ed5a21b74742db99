#include "oracle/verify/states/dynamic_film.hpp"

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace lubjoint::verify {

namespace {

using Real = long double;

constexpr Real square(Real x) { return x * x; }

/// The film in Sommerfeld's angle ψ, in which sinθ = √q sinψ/G, cosθ = (cosψ − ε)/G, dθ/H³ = q^{−5/2} G² dψ with
/// G = q/H = 1 − ε cosψ: every integrand below is a trigonometric polynomial of degree two over at most one turn, which
/// thirty nodes of Gauss and Legendre integrate to 1e-30.
class SommerfeldFilm {
 public:
  using Rule = boost::math::quadrature::gauss<Real, 30>;
  static constexpr std::size_t pairs = 15;

  struct Node {
    Real weight;  ///< of dψ
    Real ends;    ///< sin((ψ − ψs)/2) sin((ψe − ψ)/2); G sin(θ − θs) is 2A times that
    Real sine;    ///< G sinθ
    Real cosine;  ///< G cosθ
    Real wall;    ///< G (1 + cosθ), small where the film is thin
    Real gap;     ///< G
  };

  explicit SommerfeldFilm(const DynamicFilm& film) {
    const Real a = film.slip_rate, b2 = 2 * film.squeeze_rate;
    rate = std::hypot(a, b2);
    cosine_s = a / rate;
    sine_s = b2 / rate;
    const Real q = film.gap * (1 + film.ratio), root_q = std::sqrt(q);
    // 1 + cosθs without cancellation.
    const Real from_wall = a >= 0 ? 1 + cosine_s : square(sine_s) / (1 - cosine_s);
    const Real begin = std::atan2(root_q * sine_s, from_wall - film.gap);
    const Real half = std::atan2(root_q, -film.ratio * sine_s);
    amplitude = std::sqrt(q + square(film.ratio * sine_s));
    to_theta = 1 / (q * q * root_q);
    const Real middle = (begin + half) / 2;  // ψ/2 there
    const Real sine_m = std::sin(middle), cosine_m = std::cos(middle), sine_h = std::sin(half / 2);
    for (std::size_t i = 0; i < pairs; ++i) {
      const Real x = half * Rule::abscissa()[i] / 2, weight = half * Rule::weights()[i];
      const Real sine_x = std::sin(x), cosine_x = std::cos(x);
      const Real ends = (sine_h - sine_x) * (sine_h + sine_x);
      for (const Real side : {-sine_x, sine_x}) {
        const Real s = sine_m * cosine_x + cosine_m * side, c = cosine_m * cosine_x - sine_m * side;
        nodes[2 * i + (side < 0 ? 0 : 1)] = {weight,
                                             ends,
                                             2 * root_q * s * c,
                                             film.gap - 2 * s * s,
                                             2 * film.gap * c * c,
                                             film.gap + 2 * film.ratio * s * s};
      }
    }
  }

  template <class F>
  Real integral(const F& f) const {
    Real sum = 0;
    for (const Node& node : nodes) sum += node.weight * f(node);
    return sum;
  }

  Real rate;              ///< ρ = √(a² + 4b²)
  Real cosine_s, sine_s;  ///< of θs
  Real amplitude;         ///< A
  Real to_theta;          ///< q^{−5/2}
  std::array<Node, 2 * pairs> nodes;
};

bool at_rest(const DynamicFilm& film) { return film.slip_rate == 0 && film.squeeze_rate == 0; }

}  // namespace

DynamicForce short_dynamic_by_quadrature(const DynamicFilm& film) {
  if (at_rest(film)) return {0, 0};
  using Node = SommerfeldFilm::Node;
  const SommerfeldFilm s(film);
  const Real scale = s.rate * s.amplitude * s.to_theta;  // ½ρ · 2A
  return {scale * s.integral([](const Node& n) { return n.ends * n.cosine; }),
          scale * s.integral([](const Node& n) { return n.ends * n.sine; })};
}

DynamicForce long_dynamic_by_quadrature(const DynamicFilm& film) {
  if (at_rest(film)) return {0, 0};
  using Node = SommerfeldFilm::Node;
  const SommerfeldFilm s(film);
  const Real weight = s.integral([](const Node& n) { return n.gap * n.gap; });
  const Real sine = s.integral([](const Node& n) { return n.sine * n.gap; }) / weight;
  const Real wall = s.integral([](const Node& n) { return n.wall * n.gap; }) / weight;
  const auto across = [&](const Node& n) { return n.sine - sine * n.gap; };
  const auto along = [&](const Node& n) { return n.wall - wall * n.gap; };
  const auto flow = [&](const Node& n) { return s.cosine_s * along(n) + s.sine_s * across(n); };
  const Real scale = 6 * s.rate * s.to_theta;
  return {-scale * s.integral([&](const Node& n) { return flow(n) * across(n); }),
          scale * s.integral([&](const Node& n) { return flow(n) * along(n); })};
}

}  // namespace lubjoint::verify

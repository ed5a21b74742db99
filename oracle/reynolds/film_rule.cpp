#include "oracle/reynolds/film_rule.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "oracle/quadrature/adaptive.hpp"
#include "oracle/quadrature/periodic_trapezoid.hpp"

namespace lubjoint::oracle {

namespace {

using std::numbers::pi;

/// Ends of the window and, as far as they lie inside, the minimum film and places a few widths of the dip from it.
std::vector<double> break_points(const NarrowGap& gap, const FilmWindow& window) {
  std::vector<double> points{window.from};
  const auto add = [&](double phi) {
    if (phi > points.back() && phi < window.to) points.push_back(phi);
  };
  std::vector<double> widths;
  for (double phi = gap.dip_width(); phi < 2 * pi; phi *= 8) widths.push_back(phi);
  for (auto phi = widths.rbegin(); phi != widths.rend(); ++phi) add(-*phi);
  add(0);
  for (const double phi : widths) add(phi);
  points.push_back(window.to);
  return points;
}

Estimate integrate_stretched(FilmQuadratureRule rule, const NarrowGap& gap, const FilmWindow& window,
                             const Integrand& f, const Tolerance& tolerance) {
  const StretchedAngle angle(gap, window);
  const auto stretched = [&](double t) {
    const StretchedAngle::Place place = angle.at(t);
    return f(place.phi) * place.rate;
  };
  const double from = angle.stretched(window.from);
  const double to = angle.stretched(window.to);
  if (rule == FilmQuadratureRule::cquad) {
    thread_local DoublyAdaptiveQuadrature cquad;
    return cquad(stretched, from, to, tolerance);
  }
  thread_local AdaptiveQuadrature adaptive;
  if (rule == FilmQuadratureRule::qags) return adaptive.singular(stretched, from, to, tolerance);
  return adaptive.gauss_kronrod(stretched, from, to, tolerance);
}

Estimate integrate_around(const NarrowGap& gap, const FilmWindow& window, const Integrand& f,
                          const Tolerance& tolerance) {
  if (window.from != -pi || window.to != pi) {
    throw std::invalid_argument("the trapezoid rule is for full films; allowed elsewhere are the other rules");
  }
  const double ratio = gap.dip_ratio();
  const auto in_sommerfelds_angle = [&](double chi) {
    const double s = std::sin(0.5 * chi);
    const double c = std::cos(0.5 * chi);
    return f(2 * std::atan2(ratio * s, c)) * ratio / (c * c + ratio * ratio * s * s);
  };
  return periodic_trapezoid(in_sommerfelds_angle, -pi, 2 * pi, tolerance);
}

}  // namespace

Estimate integrate_over_film(FilmQuadratureRule rule, const NarrowGap& gap, const FilmWindow& window,
                             const Integrand& f, const Tolerance& tolerance) {
  switch (rule) {
    case FilmQuadratureRule::gauss_legendre:
      throw std::invalid_argument("gauss_legendre integrates all components at once; allowed here are the other rules");
    case FilmQuadratureRule::trapezoid:
      return integrate_around(gap, window, f, tolerance);
    case FilmQuadratureRule::qagp: {
      thread_local AdaptiveQuadrature adaptive;
      return adaptive.with_break_points(f, break_points(gap, window), tolerance);
    }
    case FilmQuadratureRule::qag:
    case FilmQuadratureRule::qags:
    case FilmQuadratureRule::cquad:
      break;
  }
  return integrate_stretched(rule, gap, window, f, tolerance);
}

}  // namespace lubjoint::oracle

#include "oracle/quadrature/gauss_legendre.hpp"
#include "oracle/reynolds/film_rule.hpp"

namespace lubjoint::oracle {

namespace {

void place_panel(const StretchedAngle& angle, double from, double to, const GaussLegendreRule& rule, FilmNodes& nodes) {
  const double first = angle.stretched(from);
  const double last = angle.stretched(to);
  const double middle = 0.5 * (first + last);
  const double half = 0.5 * (last - first);
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const StretchedAngle::Place place = angle.at(middle + half * rule.nodes()[i]);
    nodes.phi.push_back(place.phi);
    nodes.weight.push_back(half * rule.weights()[i] * place.rate);
  }
}

}  // namespace

void place_film_nodes(const NarrowGap& gap, const FilmWindow& window, std::size_t rung, FilmNodes& nodes) {
  const GaussLegendreRule& rule = gauss_legendre_rung(rung);
  nodes.phi.clear();
  nodes.weight.clear();
  const StretchedAngle angle(gap, window);
  if (window.from < angle.origin()) place_panel(angle, window.from, angle.origin(), rule, nodes);
  if (window.to > angle.origin()) place_panel(angle, angle.origin(), window.to, rule, nodes);
}

}  // namespace lubjoint::oracle

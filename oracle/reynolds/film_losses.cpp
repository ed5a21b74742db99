#include "oracle/reynolds/film_losses.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "oracle/reynolds/film_edges.hpp"
#include "oracle/reynolds/film_rule.hpp"

namespace lubjoint::oracle {

namespace {

/// Integrals over the film without dimensions, and the sums of their terms' magnitudes.
struct Sums {
  double couette = 0;         ///< ∫ dθ/H
  double shear = 0;           ///< ∫ H dP, steps included
  double shear_size = 0;      ///< of its terms
  double dissipation = 0;     ///< short: ∫ g²/H³; long: ∫ H³P'²
  double side_flow = 0;       ///< ∫ g
  double side_flow_size = 0;  ///< of its terms
};

struct Film {
  NarrowGap gap;
  FilmWindow window;
  OneDimensionalFilmEntry entry;

  /// a cosθ + 2b sinθ at φ: −∫g.
  double wave(const GapPlace& at) const { return -gap.slip() * at.cos - 2 * gap.squeeze() * at.sin; }
};

double sum_over(const FilmNodes& nodes, const Integrand& f) {
  double sum = 0;
  for (std::size_t n = 0; n < nodes.phi.size(); ++n) sum += nodes.weight[n] * f(nodes.phi[n]);
  return sum;
}

void add_short(const Film& film, const FilmNodes& nodes, Sums& sums) {
  const NarrowGap& gap = film.gap;
  const auto pressure = [](const GapPlace& at) { return at.source() / at.cubed_thickness(); };
  for (std::size_t n = 0; n < nodes.phi.size(); ++n) {
    const GapPlace at = gap.at(nodes.phi[n]);
    const double widening = gap.epsilon() * at.sin;  // dH/dφ
    const double slope = film.wave(at) / at.cubed_thickness() - 3 * pressure(at) * widening / at.thickness;
    sums.shear += nodes.weight[n] * at.thickness * slope;
    sums.shear_size += nodes.weight[n] * std::abs(at.thickness * slope);
    sums.dissipation += nodes.weight[n] * at.source() * pressure(at);
    sums.side_flow += nodes.weight[n] * at.source();
    sums.side_flow_size += nodes.weight[n] * at.source_magnitude();
  }
  if (film.entry.extent() == FilmExtent::full) return;
  const GapPlace begin = gap.at(film.window.from);
  const GapPlace end = gap.at(film.window.to);
  sums.shear += begin.thickness * pressure(begin) - end.thickness * pressure(end);
  sums.shear_size += begin.thickness * std::abs(pressure(begin)) + end.thickness * std::abs(pressure(end));
}

void add_long(const Film& film, const FilmNodes& nodes, const FilmNodes& whole, Sums& sums) {
  const NarrowGap& gap = film.gap;
  const auto weight = [&](double phi) { return 1 / gap.at(phi).cubed_thickness(); };
  const auto wave = [&](double phi) { return film.wave(gap.at(phi)) * weight(phi); };
  const FilmNodes& where = film.entry.pressure_by_ode ? nodes : whole;  // eq. 5: C is the full film's
  const double constant = -sum_over(where, wave) / sum_over(where, weight);
  double rise = 0;
  for (std::size_t n = 0; n < nodes.phi.size(); ++n) {
    const GapPlace at = gap.at(nodes.phi[n]);
    const double flow = film.wave(at) + constant;  // H³P'
    const double slope = flow / at.cubed_thickness();
    rise += nodes.weight[n] * slope;
    sums.shear += nodes.weight[n] * at.thickness * slope;
    sums.shear_size += nodes.weight[n] * at.thickness * std::abs(slope);
    sums.dissipation += nodes.weight[n] * flow * slope;
  }
  if (film.entry.film != OneDimensionalFilm::long_half_eq5) return;
  // p = 0 at the maximum film; the step is at the minimum film, one end of either half.
  const bool mirrored = film.window.from >= 0;
  const double step = (mirrored ? -1 : 1) * rise * gap.thinnest();
  sums.shear += mirrored ? step : -step;
  sums.shear_size += std::abs(step);
}

Sums sums_of(const Film& film, std::size_t rung) {
  FilmNodes nodes;
  FilmNodes whole;
  place_film_nodes(film.gap, film.window, rung, nodes);
  Sums sums;
  for (std::size_t n = 0; n < nodes.phi.size(); ++n) {
    sums.couette += nodes.weight[n] / film.gap.at(nodes.phi[n]).thickness;
  }
  if (film.entry.limit() == BearingLimit::short_bearing) {
    add_short(film, nodes, sums);
  } else {
    place_film_nodes(film.gap, FilmWindow{-std::numbers::pi, std::numbers::pi}, rung, whole);
    add_long(film, nodes, whole, sums);
  }
  return sums;
}

constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();  // of a sum of a few hundred terms

}  // namespace

FilmLossEstimate film_losses_by_quadrature(OneDimensionalFilm film, const Bearing<double>& bearing,
                                           const Lubricant<double>& lubricant, const PolarFilmState<double>& state,
                                           double relative_spin) {
  const OneDimensionalFilmEntry& entry = entry_of(film);
  const NarrowGap gap(state);
  const Film where{gap, film_window(entry.extent(), gap), entry};
  constexpr std::size_t rung = 5;  // 256 points on either side of the minimum film
  const Sums coarse = sums_of(where, rung - 1);
  const Sums fine = sums_of(where, rung);

  const double mu = lubricant.viscosity();
  const double r = bearing.radius();
  const double l = bearing.length();
  const double c = bearing.clearance();
  const bool is_short = entry.limit() == BearingLimit::short_bearing;
  // ∫dz ∂p/∂θ over P': short μL³/(2c²), long 6μ(R/c)²L; the wall's share is −½R h ∂p/∂θ.
  const double pressure_scale = is_short ? mu * l * l * l / (2 * c * c) : 6 * mu * l * (r / c) * (r / c);
  const double shear_scale = -r * c * pressure_scale / 2;
  const double couette_scale = mu * relative_spin * r * r * r * l / c;
  const double dissipation_scale = is_short ? mu * l * l * l * r / (4 * c) : 3 * mu * l * r * r * r / c;

  const auto estimate = [](double scale, double value, double before, double size) {
    return Estimate{scale * value, std::abs(scale) * (std::abs(value - before) + rounding * size)};
  };
  const Estimate couette = estimate(couette_scale, fine.couette, coarse.couette, fine.couette);
  const Estimate shear = estimate(shear_scale, fine.shear, coarse.shear, fine.shear_size);
  FilmLossEstimate result;
  result.torque_journal = {-couette.value + shear.value, couette.error + shear.error};
  result.torque_bearing = {couette.value + shear.value, couette.error + shear.error};
  result.couette_power = {relative_spin * couette.value, std::abs(relative_spin) * couette.error};
  result.pressure_power = estimate(dissipation_scale, fine.dissipation, coarse.dissipation, fine.dissipation);
  if (is_short) {
    result.side_flow = estimate(c * r * l / 2, fine.side_flow, coarse.side_flow, fine.side_flow_size);
  }
  return result;
}

}  // namespace lubjoint::oracle

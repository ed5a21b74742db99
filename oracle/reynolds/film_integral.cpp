#include "oracle/reynolds/film_integral.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

#include "lubjoint/text/message.hpp"
#include "oracle/quadrature/quadrature_error.hpp"
#include "oracle/reynolds/film_edges.hpp"
#include "oracle/reynolds/film_sums.hpp"
#include "oracle/reynolds/pressure_slope.hpp"

namespace lubjoint::oracle {

namespace {

using std::numbers::pi;

constexpr double smallest_q = 1e-40;  // H^-3 and its integrals stay far from overflow

std::string described(std::string_view what, const OneDimensionalFilmEntry& entry, const PolarFilmState<double>& s) {
  Message text;
  text << what << " of the film " << entry.name << " at eccentricity_ratio " << s.eccentricity_ratio << ", q " << s.q
       << ", slip_rate " << s.slip_rate << " 1/s, squeeze_rate " << s.squeeze_rate << " 1/s";
  return text.str();
}

/// The state with both rates divided by a power of two, so that no product of them leaves the range of double.
struct ScaledState {
  PolarFilmState<double> state;
  double rate;  ///< the power of two [1/s]; 0 at rest

  ScaledState(const OneDimensionalFilmEntry& entry, const PolarFilmState<double>& given) : state(given), rate(0) {
    if (!(given.q >= smallest_q))
      throw FilmDomainError(described("no force", entry, given) + "; allowed is q >= 1e-40");
    const double larger = std::max(std::abs(given.slip_rate), std::abs(given.squeeze_rate));
    if (larger == 0) return;
    int exponent = 0;
    std::frexp(larger, &exponent);
    state.slip_rate = std::ldexp(given.slip_rate, -exponent);
    state.squeeze_rate = std::ldexp(given.squeeze_rate, -exponent);
    rate = std::ldexp(1.0, std::min(exponent, std::numeric_limits<double>::max_exponent - 1));
    if (exponent > std::numeric_limits<double>::max_exponent - 1) {
      state.slip_rate *= 2;
      state.squeeze_rate *= 2;
    }
  }
};

FilmPair force_integrals(const OneDimensionalFilmEntry& entry, const NarrowGap& gap, const FilmWindow& window,
                         const FilmRule& rule, double relative_tolerance, double& factor) {
  if (entry.pressure_by_ode) {
    factor = 6;
    const bool edges_are_zeros = entry.extent() == FilmExtent::dynamic;
    return integrate_pressure_slope(gap, window, edges_are_zeros, rule, relative_tolerance);
  }
  const KnownPressure pressure(gap, entry);
  factor = pressure.factor();
  return integrate_known_pressure(pressure, gap, window, rule, relative_tolerance);
}

/// Bounds in θ. The dynamic film's begin is brought to (−π, π].
FilmForceEstimate with_bounds(const OneDimensionalFilmEntry& entry, const FilmWindow& window) {
  FilmForceEstimate force{};
  force.theta_s = window.from + pi;
  if (entry.extent() == FilmExtent::dynamic && force.theta_s > pi) force.theta_s -= 2 * pi;
  if (entry.extent() == FilmExtent::dynamic && force.theta_s <= -pi) force.theta_s += 2 * pi;
  force.theta_e = force.theta_s + (window.to - window.from);
  return force;
}

/// φ of an angle θ, brought into the window where a whole number of turns does that. π is subtracted in two parts,
/// because φ must be right relative to its own size.
double gap_angle(double theta, const FilmWindow& window) {
  constexpr double pi_rest = 1.2246467991473532e-16;  // π − double(π)
  const double middle = 0.5 * (window.from + window.to);
  const double turns = std::round((theta - pi - middle) / (2 * pi));
  const double half_turns = 1 + 2 * turns;
  return (theta - half_turns * pi) - half_turns * pi_rest;
}

/// ∫ −(G − Ḡ)/H³ dφ from an edge to φ: the pressure over 6μ(R/c)², from the edge on φ's side of the minimum film.
Estimate pressure_from_edge(const NarrowGap& gap, const FilmWindow& window, bool edges_are_zeros, double phi) {
  const PressureSlope slope(gap, window, edges_are_zeros);
  FilmNodes nodes;
  WeightedMeans means;
  double weight = 0;
  place_film_nodes(gap, window, 3, nodes);
  for (std::size_t n = 0; n < nodes.phi.size(); ++n) {
    const PressureSlope::Place place = slope.at(nodes.phi[n]);
    weight += nodes.weight[n] * place.weight;
    means.x += nodes.weight[n] * place.weight * place.x;
    means.y += nodes.weight[n] * place.weight * place.y;
  }
  const PressureSlope::Place mean{means.x / weight, means.y / weight, 0};
  const bool from_begin = phi - window.from < window.to - phi && phi <= window.narrowest();
  const FilmWindow part = from_begin ? FilmWindow{window.from, phi} : FilmWindow{phi, window.to};
  std::array<double, 2> value{};
  double magnitude = 0;
  for (const std::size_t rung : {std::size_t{2}, std::size_t{3}}) {
    place_film_nodes(gap, part, rung, nodes);
    magnitude = 0;
    for (std::size_t n = 0; n < nodes.phi.size(); ++n) {
      const PressureSlope::Place place = slope.at(nodes.phi[n]);
      const double w = nodes.weight[n] * place.weight * (from_begin ? -1 : 1);
      value[rung - 2] += w * (slope.g(place) - slope.g(mean));
      magnitude += std::abs(w) * (slope.g_magnitude(place) + slope.g_magnitude(mean));
    }
  }
  // The rounding of φ and of the edge, up to π both, matters where they are close to each other.
  const auto steepness = [&](double at) {
    const PressureSlope::Place place = slope.at(at);
    return std::abs(place.weight * (slope.g(place) - slope.g(mean)));
  };
  const double edges = 4 * (steepness(part.from) + steepness(part.to));
  return {value[1], std::abs(value[1] - value[0]) + std::numeric_limits<double>::epsilon() * (8 * magnitude + edges)};
}

}  // namespace

FilmForceEstimate film_force_by_rule(OneDimensionalFilm film, const Bearing<double>& bearing,
                                     const Lubricant<double>& lubricant, const PolarFilmState<double>& state,
                                     const FilmRule& rule, double relative_tolerance) {
  if (!(relative_tolerance >= 0)) {
    throw std::invalid_argument("relative_tolerance is " + std::to_string(relative_tolerance) +
                                "; allowed is a number that is not negative");
  }
  const OneDimensionalFilmEntry& entry = entry_of(film);
  const ScaledState scaled(entry, state);
  const NarrowGap gap(scaled.state);
  const FilmWindow window = film_window(entry.extent(), gap);
  FilmForceEstimate force = with_bounds(entry, window);
  if (scaled.rate == 0) return force;
  double factor = 0;
  FilmPair integrals;
  try {
    integrals = force_integrals(entry, gap, window, rule, relative_tolerance, factor);
  } catch (const QuadratureError& error) {
    throw QuadratureError(error.code(), described("force", entry, state) + ": " + error.what());
  }
  const double scale = force_scale(entry.limit(), bearing, lubricant) * factor * scaled.rate;
  constexpr double products = 2 * std::numeric_limits<double>::epsilon();  // the roundings of scale times integral
  const auto scaled_estimate = [&](const Estimate& e) {
    return Estimate{scale * e.value, scale * (e.error + products * std::abs(e.value))};
  };
  force.radial = scaled_estimate(integrals.first);
  force.tangential = scaled_estimate(integrals.second);
  return force;
}

FilmForceEstimate film_force_by_gauss_legendre(OneDimensionalFilm film, const Bearing<double>& bearing,
                                               const Lubricant<double>& lubricant, const PolarFilmState<double>& state,
                                               double relative_tolerance) {
  return film_force_by_rule(film, bearing, lubricant, state, {}, relative_tolerance);
}

Estimate film_pressure_by_quadrature(OneDimensionalFilm film, const Bearing<double>& bearing,
                                     const Lubricant<double>& lubricant, const PolarFilmState<double>& state,
                                     double theta, double z) {
  const OneDimensionalFilmEntry& entry = entry_of(film);
  const double half_length = 0.5 * bearing.length();
  if (!(std::abs(z) <= half_length)) {
    std::ostringstream message;
    message << "z is " << z << " m; allowed is at most half the bearing's length, " << half_length << " m";
    throw std::domain_error(message.str());
  }
  const ScaledState scaled(entry, state);
  const NarrowGap gap(scaled.state);
  const FilmWindow window = film_window(entry.extent(), gap);
  const double phi = gap_angle(theta, window);
  if (scaled.rate == 0 || phi < window.from || phi > window.to) return {};
  const double mu = lubricant.viscosity();
  const double slenderness = bearing.radius() / bearing.clearance();
  const double axial = (half_length - z) * (half_length + z) / (bearing.clearance() * bearing.clearance());
  const bool is_short = entry.limit() == BearingLimit::short_bearing;
  const double scale = scaled.rate * (is_short ? 3 * mu * axial : 6 * mu * slenderness * slenderness);
  Estimate p;
  if (entry.pressure_by_ode) {
    p = pressure_from_edge(gap, window, entry.extent() == FilmExtent::dynamic, phi);
  } else {
    const KnownPressure::Parts parts = KnownPressure(gap, entry).pressure(gap.at(phi));
    p.value = parts.wedge + parts.squeeze;
    p.error = 16 * std::numeric_limits<double>::epsilon() * (std::abs(parts.wedge) + std::abs(parts.squeeze));
  }
  return {scale * p.value, scale * p.error};
}

}  // namespace lubjoint::oracle

#include "oracle/reynolds/finite_length.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "lubjoint/film/extent.hpp"
#include "lubjoint/text/message.hpp"
#include "oracle/reynolds/cavitated_film.hpp"
#include "oracle/reynolds/circumferential_modes.hpp"
#include "oracle/reynolds/smooth_film.hpp"

namespace lubjoint::oracle {

namespace {

constexpr std::array<std::pair<FiniteFilm, std::string_view>, 4> film_names{
    {{FiniteFilm::finite_full, "finite_full"},
     {FiniteFilm::finite_half, "finite_half"},
     {FiniteFilm::finite_dynamic, "finite_dynamic"},
     {FiniteFilm::finite_reynolds, "finite_reynolds"}}};

/// Of the largest pressure, where a field is a sum of harmonics.
constexpr double truncation = 1e-7;

/// A state without dimensions.
struct Scaled {
  ScaledFilm film;
  double rate;    ///< that a and b were divided by [1/s]
  double mirror;  ///< −1 if the film was mirrored because a < 0: the sign of θ and of the tangential force

  /// What P is to be multiplied with, 6μ(R/c)² times the rate [Pa].
  double pressure(const Bearing<double>& bearing, const Lubricant<double>& oil) const {
    const double ratio = bearing.radius() / bearing.clearance();
    return 6 * oil.viscosity() * ratio * ratio * rate;
  }
};

Scaled without_dimensions(const Bearing<double>& bearing, const PolarFilmState<double>& state) {
  const double a = std::abs(state.slip_rate);
  const double b = state.squeeze_rate;
  const double rate = std::max(a, std::abs(b));
  const ScaledFilm film{state.eccentricity_ratio, state.q / (1 + state.eccentricity_ratio), rate > 0 ? a / rate : 0.0,
                        rate > 0 ? b / rate : 0.0, bearing.length() / (2 * bearing.radius())};
  return {film, rate, state.slip_rate < 0 ? -1.0 : 1.0};
}

FilmExtent extent_of(FiniteFilm film) {
  switch (film) {
    case FiniteFilm::finite_full:
      return FilmExtent::full;
    case FiniteFilm::finite_half:
      return FilmExtent::half;
    case FiniteFilm::finite_dynamic:
      return FilmExtent::dynamic;
    case FiniteFilm::finite_reynolds:
      break;
  }
  throw std::logic_error("the bounds of a cavitated film are part of its solution");
}

bool is_pinned(const ScaledFilm& film, FilmOnset onset) {
  return onset == FilmOnset::maximum_film && film.squeeze == 0;
}

template <class T>
void require_between(const char* name, T given, T lowest, T highest) {
  if (given >= lowest && given <= highest) return;
  Message message;
  message << name << " is " << given << "; allowed is " << lowest << " to " << highest;
  throw std::invalid_argument(message.str());
}

}  // namespace

std::string_view name_of(FiniteFilm film) {
  for (const auto& [known, name] : film_names) {
    if (known == film) return name;
  }
  throw std::invalid_argument("there is no finite-length film number " + std::to_string(static_cast<int>(film)));
}

FiniteFilm finite_film_of(std::string_view name) {
  std::string allowed;
  for (const auto& [film, known] : film_names) {
    if (known == name) return film;
    allowed += (allowed.empty() ? "" : ", ") + std::string(known);
  }
  throw std::invalid_argument("there is no finite-length film \"" + std::string(name) + "\"; allowed are " + allowed);
}

FiniteLengthResult finite_length_force(FiniteFilm film, const Bearing<double>& bearing, const Lubricant<double>& oil,
                                       const PolarFilmState<double>& state, const FiniteLengthOptions& options) {
  require_between("relative_tolerance", options.relative_tolerance, 1e-12, 0.1);
  const Scaled scaled = without_dimensions(bearing, state);
  const double pressure = scaled.pressure(bearing, oil);
  FiniteLengthResult result;
  result.observed_order = std::numeric_limits<double>::quiet_NaN();
  result.tolerance_met = true;
  if (pressure == 0) return result;
  const double tolerance = options.relative_tolerance;
  const auto solve = [&] {
    if (film == FiniteFilm::finite_reynolds) {
      return cavitated_film_force(scaled.film, is_pinned(scaled.film, options.onset), tolerance);
    }
    const bool by_modes = options.method == SmoothFilmMethod::circumferential_modes;
    return (by_modes ? circumferential_film_force : smooth_film_force)(extent_of(film), scaled.film, tolerance);
  };
  const ScaledForce force = solve();
  const double scale = pressure * bearing.radius() * bearing.radius();
  result.radial = scale * force.value[0];
  result.tangential = scaled.mirror * scale * force.value[1];
  result.radial_error = scale * force.error[0];
  result.tangential_error = scale * force.error[1];
  if (std::isfinite(force.observed_order)) result.observed_order = force.observed_order;
  result.unknowns = force.unknowns;
  result.tolerance_met = force.error.norm() <= tolerance * force.value.norm();
  return result;
}

FiniteLengthFlow finite_length_flow(FiniteFilm film, const Bearing<double>& bearing,
                                    const PolarFilmState<double>& state, const FiniteLengthOptions& options) {
  require_between("relative_tolerance", options.relative_tolerance, 1e-12, 0.1);
  const Scaled scaled = without_dimensions(bearing, state);
  FiniteLengthFlow result;
  result.observed_order = std::numeric_limits<double>::quiet_NaN();
  result.tolerance_met = true;
  if (scaled.rate == 0) return result;
  const double tolerance = options.relative_tolerance;
  const auto solve = [&] {
    if (film == FiniteFilm::finite_reynolds) {
      return cavitated_film_flow(scaled.film, is_pinned(scaled.film, options.onset), tolerance);
    }
    const bool by_modes = options.method == SmoothFilmMethod::circumferential_modes;
    return (by_modes ? circumferential_film_flow : smooth_film_flow)(extent_of(film), scaled.film, tolerance);
  };
  const ScaledFlow flow = solve();
  const double scale = bearing.clearance() * bearing.radius() * bearing.radius() * scaled.rate;
  result.side_flow = scale * flow.value[0];
  result.error = scale * flow.error[0];
  if (std::isfinite(flow.observed_order)) result.observed_order = flow.observed_order;
  result.unknowns = flow.unknowns;
  result.tolerance_met = flow.error[0] <= tolerance * scaled.film.displacement();
  return result;
}

FiniteLengthCouette finite_reynolds_couette(const Bearing<double>& bearing, const PolarFilmState<double>& state,
                                            double relative_tolerance) {
  require_between("relative_tolerance", relative_tolerance, 1e-12, 0.1);
  const Scaled scaled = without_dimensions(bearing, state);
  FiniteLengthCouette result;
  result.observed_order = std::numeric_limits<double>::quiet_NaN();
  result.tolerance_met = true;
  if (scaled.rate == 0) {
    result.integral = std::numbers::pi / std::sqrt(state.q);
    return result;
  }
  const ScaledCouette couette = cavitated_film_couette(scaled.film, relative_tolerance);
  result.integral = couette.value[0];
  result.error = couette.error[0];
  if (std::isfinite(couette.observed_order)) result.observed_order = couette.observed_order;
  result.unknowns = couette.unknowns;
  result.tolerance_met = result.error <= relative_tolerance * result.integral;
  return result;
}

FiniteLengthPressure finite_length_pressure_at(FiniteFilm film, const Bearing<double>& bearing,
                                               const Lubricant<double>& oil, const PolarFilmState<double>& state,
                                               double theta, double zeta, FilmOnset onset) {
  const Scaled scaled = without_dimensions(bearing, state);
  const double pressure = scaled.pressure(bearing, oil);
  FiniteLengthPressure result;
  if (pressure == 0) return result;
  const auto solve = [&]() -> ScaledPressure {
    const bool inside = std::abs(zeta) < scaled.film.slenderness;
    if (film == FiniteFilm::finite_reynolds) {
      return cavitated_film_pressure_at(scaled.film, is_pinned(scaled.film, onset), scaled.mirror * theta, zeta);
    }
    constexpr int angles = 180;  // in which the largest is looked for
    std::vector<double> places = {scaled.mirror * theta};
    for (int i = 0; i < angles; ++i) places.push_back(2 * std::numbers::pi * i / angles);
    const std::vector<double> field = smooth_film_pressure(extent_of(film), scaled.film, places,
                                                           {inside ? zeta : scaled.film.slenderness, 0}, truncation);
    double largest = std::abs(field[0]);
    for (std::size_t i = 1; i < field.size(); i += 2) largest = std::max(largest, std::abs(field[i]));
    return {field[0], largest, 10 * truncation * largest};
  };
  const ScaledPressure solved = solve();
  result.pressure = pressure * solved.value;
  result.largest = pressure * solved.largest;
  result.error = pressure * solved.error;
  return result;
}

PressureField finite_length_pressure(FiniteFilm film, const Bearing<double>& bearing, const Lubricant<double>& oil,
                                     const PolarFilmState<double>& state, int angles, int stations, FilmOnset onset) {
  require_between("angles", angles, 3, 10000);
  require_between("stations", stations, 3, 1000);
  const Scaled scaled = without_dimensions(bearing, state);
  const double pressure = scaled.pressure(bearing, oil);
  PressureField field;
  std::vector<double> theta, zeta;
  for (int i = 0; i < angles; ++i) {
    field.theta.push_back(2 * std::numbers::pi * i / (angles - 1));
    theta.push_back(scaled.mirror * field.theta.back());
  }
  for (int j = 0; j < stations; ++j) {
    // −1…1, exactly symmetric, so that the field is
    const double along = static_cast<double>(2 * j - (stations - 1)) / (stations - 1);
    field.z.push_back(along * bearing.length() / 2);
    zeta.push_back(along * scaled.film.slenderness);
  }
  field.pressure.assign(theta.size() * zeta.size(), 0.0);
  if (pressure == 0) return field;
  if (film == FiniteFilm::finite_reynolds) {
    field.pressure = cavitated_film_pressure(scaled.film, is_pinned(scaled.film, onset), theta, zeta);
  } else {
    field.pressure = smooth_film_pressure(extent_of(film), scaled.film, theta, zeta, truncation);
  }
  for (double& p : field.pressure) p *= pressure;
  return field;
}

}  // namespace lubjoint::oracle

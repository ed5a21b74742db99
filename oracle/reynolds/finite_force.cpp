#include "oracle/reynolds/finite_force.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "lubjoint/text/message.hpp"

namespace lubjoint::oracle {

double FiniteForce::relative_error() const {
  const double size = std::hypot(ratio.x(), ratio.y());
  return size > 0 ? error / size : std::numeric_limits<double>::infinity();
}

namespace {

void require_shape(double length_to_diameter) {
  if (length_to_diameter > 0 && std::isfinite(length_to_diameter)) return;
  Message message;
  message << "length over diameter is " << length_to_diameter << "; allowed is a finite number above 0";
  throw std::invalid_argument(message.str());
}

}  // namespace

FiniteForce finite_force(FiniteFilm film, double length_to_diameter, const FilmState<double>& state,
                         const FiniteLengthOptions& options) {
  require_shape(length_to_diameter);
  FiniteForce force{Vector2<double>(0, 0)};
  if (is_zero(state.velocity)) return force;
  // R = 1, so that L is twice L/D; with c = 1/2 and μ = 1/(4L) the scale μLR³/c² is one.
  const double length = 2 * length_to_diameter;
  const PolarView<double> view = polar_view(state);
  const FiniteLengthResult solved = finite_length_force(film, Bearing<double>(length, 1, 0.5),
                                                        Lubricant<double>(1 / (4 * length)), view.state, options);
  const Vector2<double> across = perpendicular(view.radial);
  force.ratio = Vector2<double>(solved.radial * view.radial + solved.tangential * across);
  force.error = std::hypot(solved.radial_error, solved.tangential_error);
  force.tolerance_met = solved.tolerance_met;
  return force;
}

FiniteFlow finite_side_flow(FiniteFilm film, double length_to_diameter, const FilmState<double>& state,
                            const FiniteLengthOptions& options) {
  require_shape(length_to_diameter);
  FiniteFlow flow;
  if (is_zero(state.velocity)) return flow;
  const Bearing<double> bearing(2 * length_to_diameter, 1, 0.5);
  const double unit = bearing.clearance() * bearing.radius() * bearing.length();
  const FiniteLengthFlow solved = finite_length_flow(film, bearing, polar_view(state).state, options);
  flow.ratio = solved.side_flow / unit;
  flow.error = solved.error / unit;
  flow.tolerance_met = solved.tolerance_met;
  return flow;
}

FiniteCouette finite_couette_integral(double length_to_diameter, const FilmState<double>& state,
                                      double relative_tolerance) {
  require_shape(length_to_diameter);
  const FiniteLengthCouette solved = finite_reynolds_couette(Bearing<double>(2 * length_to_diameter, 1, 0.5),
                                                             polar_view(state).state, relative_tolerance);
  return {solved.integral, solved.error, solved.tolerance_met};
}

FinitePressure finite_pressure(FiniteFilm film, double length_to_diameter, const PolarFilmState<double>& state,
                               double theta, double zeta, FilmOnset onset) {
  require_shape(length_to_diameter);
  // R = 1, c = 1/2 and μ = 1/4: μ(R/c)² is one.
  const FiniteLengthPressure solved = finite_length_pressure_at(film, Bearing<double>(2 * length_to_diameter, 1, 0.5),
                                                                Lubricant<double>(0.25), state, theta, zeta, onset);
  return {solved.pressure, solved.largest, solved.error};
}

}  // namespace lubjoint::oracle

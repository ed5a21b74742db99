#include "oracle/certified/finite_force.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/reynolds/cavitated_elements.hpp"
#include "oracle/reynolds/finite_force.hpp"

namespace lubjoint::certified {

namespace {

using oracle::FiniteFilm;
using oracle::SmoothFilmMethod;

FiniteGoldenForce solved(const FiniteGoldenState& at, double tolerance, SmoothFilmMethod method) {
  const oracle::FiniteForce force = oracle::finite_force(at.film, at.length_to_diameter, at.state.in_own_frame(),
                                                         {tolerance, oracle::FilmOnset::free, method});
  return {force.ratio.x(), force.ratio.y(), force.error};
}

FiniteGoldenForce by_elements(const FiniteGoldenState& at) {
  const double a = std::abs(at.state.slip_rate);
  const double b = at.state.squeeze_rate;
  const double rate = std::max(a, std::abs(b));
  const double epsilon = at.state.eccentricity_ratio;
  const oracle::ScaledForce force = oracle::cavitated_force_by_elements(
      {epsilon, at.state.q / (1 + epsilon), a / rate, b / rate, at.length_to_diameter});
  // p = 6μ(R/c)² P over an area of R² dθ dζ, and R/L = 1/(2Λ).
  const double unit = 3 * rate / at.length_to_diameter;
  const double across = unit * force.value.y();
  return {unit * force.value.x(), at.state.slip_rate < 0 ? -across : across, unit * force.error.norm()};
}

}  // namespace

FiniteGoldenForce first_solver(const FiniteGoldenState& at) {
  return solved(at, at.film == FiniteFilm::finite_reynolds ? 5e-5 : 1e-10, SmoothFilmMethod::axial_series);
}

FiniteGoldenForce second_solver(const FiniteGoldenState& at) {
  if (at.film == FiniteFilm::finite_reynolds) return by_elements(at);
  return solved(at, 1e-10, SmoothFilmMethod::circumferential_modes);
}

}  // namespace lubjoint::certified

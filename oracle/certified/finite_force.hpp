/// Golden forces of films of finite length, by two solvers that share no step.
#pragma once

#include <array>
#include <vector>

#include "oracle/reynolds/finite_length.hpp"

namespace lubjoint::certified {

/// L/D of the golden films; the fourth is that of the paper's bearings.
inline constexpr std::array finite_golden_shapes = {0.25, 0.5, 1.0, 0.04 / (2 * 0.0098), 4.0};

/// A state of a film.
struct FiniteGoldenState {
  oracle::FiniteFilm film;
  double length_to_diameter;
  PolarFilmState<double> state;
};

/// The force over S = μLR³/c² [1/s], radial and tangential, and a bound of its error in magnitude.
struct FiniteGoldenForce {
  double radial;
  double tangential;
  double uncertainty;
};

/// By the axial series; of finite_reynolds by finite volumes. The uncertainty is the solver's own bound.
FiniteGoldenForce first_solver(const FiniteGoldenState& state);
/// By the circumferential modes; of finite_reynolds by finite elements.
FiniteGoldenForce second_solver(const FiniteGoldenState& state);

}  // namespace lubjoint::certified

/// Golden places of rest, stiffness and damping of films of finite length, from forces of the solvers alone.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "oracle/certified/golden.hpp"
#include "oracle/reynolds/finite_length.hpp"

namespace lubjoint::certified {

/// A row of finite_film_coefficients.csv: a journal that turns with ω > 0 in a bearing at rest, at ε.
struct FiniteSteadyState {
  oracle::FiniteFilm film;
  double length_to_diameter;
  double eccentricity_ratio;
};

/// The four films at L/D ¼, ½, 1, the paper's 2.0408 and 4; ε 0.1, 0.3, 0.5, 0.7 and 0.9.
std::vector<FiniteSteadyState> finite_steady_states();

/// What holds there, with bounds of the errors. x along the load on the journal, y 90° counter-clockwise of it.
struct FiniteSteadyFilm {
  double load;                      ///< W/(Sω), S = μLR³/c²; the Sommerfeld number is 1/(π load)
  double attitude;                  ///< from the load to e, in the sense of the spin [rad]
  std::array<double, 4> stiffness;  ///< xx, xy, yx, yy of −∂F/∂e over Sω/c
  std::array<double, 4> damping;    ///< of −∂F/∂v over S/c
  double load_uncertainty, attitude_uncertainty;
  double stiffness_uncertainty, damping_uncertainty;  ///< of each entry
};

/// In (r, t), with F(ε, a, b)/S: K_rr, K_tr = −dF/dε along a = ε and C_rr, C_tr = −∂F/∂b by differences over five
/// points, whose truncation is seen by taking them twice as far; K_rt, K_tt = ±F/ε and C_rt, C_tt = 2F/a from the force
/// itself, which is homogeneous in (a, b). All of it twice, by two solvers that share no step. The uncertainties are
/// what the two differ by, the solvers' own bounds carried through, and what the wider differences change.
FiniteSteadyFilm finite_steady_film(const FiniteSteadyState& state);

inline constexpr const char* finite_coefficients_file = "finite_film_coefficients.csv";

/// The file's text.
std::string finite_coefficients_csv(const GoldenRun& run);

/// What of the file's text is not as it is made again, one row in run.every: beyond both uncertainties together.
std::vector<reports::GoldenDifference> check_finite_coefficients(const std::string& text, const GoldenRun& run);

}  // namespace lubjoint::certified

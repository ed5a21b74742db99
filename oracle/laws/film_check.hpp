/// A compiled film's stated error, held against solvers at as many random states as one likes.
#pragma once

#include <string>
#include <string_view>

#include "oracle/laws/film_compiler.hpp"

namespace lubjoint::reports {

/// What a table is off at random states, evenly up to its ratio_limit and in all directions of u; that of e makes no
/// difference, as force and state turn together.
struct FilmCheck {
  int states = 0;
  int beyond = 0;                 ///< states at which it is off by more than its stated error and the solver's bound
  double worst = 0;               ///< largest |F − F_solved|/|F_solved|
  double eccentricity_ratio = 0;  ///< of that state
  double direction = 0;           ///< from e to u there, −π…π [rad]
  double bound = 0;               ///< of the solver's error there, over |F|
};

/// Full, half and dynamic films are held against the solver that their table was not made with, the axial cosine
/// series, to 1e-8. finite_reynolds is held against the solver that made its table, grids to 1e-4, but at other places,
/// and in both components, of which the table was given W∥ alone. The states are the same in each run, the first of
/// many those of few.
/// @param states  1 or more
FilmCheck check_film(const CompiledFilm& film, int states, const CompilerOptions& options = {});

/// |F − F_solved|/|F_solved| at one state, and the solver's bound over |F|.
struct FilmDifference {
  double difference;
  double bound;
};
FilmDifference difference_from_solver(const CompiledFilm& film, double eccentricity_ratio, double direction);

inline constexpr std::string_view film_check_header =
    "film,length_over_diameter,states,beyond,worst,eccentricity_ratio,direction,solver_bound,stated_error";

/// A row under that header, without its end of line.
std::string film_check_row(const CompiledFilm& film, const FilmCheck& check);

}  // namespace lubjoint::reports

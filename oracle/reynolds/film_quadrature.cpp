#include "oracle/reynolds/film_integral.hpp"

namespace lubjoint::oracle {

// Apart from the default rule's: this one links GSL.
FilmForceEstimate film_force_by_quadrature(OneDimensionalFilm film, const Bearing<double>& bearing,
                                           const Lubricant<double>& lubricant, const PolarFilmState<double>& state,
                                           const FilmQuadratureOptions& options) {
  return film_force_by_rule(film, bearing, lubricant, state, {options.rule, &integrate_over_film},
                            options.relative_tolerance);
}

}  // namespace lubjoint::oracle

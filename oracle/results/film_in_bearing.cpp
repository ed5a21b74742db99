#include "oracle/results/film_in_bearing.hpp"

#include "lubjoint/film/compiled_coefficients.hpp"
#include "lubjoint/joint/chosen_film.hpp"

namespace lubjoint::reports {

namespace {

using Wide = SteadyLaw::Wide;

template <FilmLaw Law>
SteadyLaw steady_formula() {
  return {Law::limit, &polar_force_ratio<Law, Wide>, &coefficient_ratios<Law, Wide>,
          &differentiated_coefficients<Law, Wide>};
}

template <CompiledLaw Law>
SteadyLaw steady_table(const Law& law) {
  const auto force_ratio = [law](const PolarFilmState<Wide>& film) { return compiled_polar_force_ratio(law, film); };
  const auto differentiated = [law](const SteadyPlace<Wide>& place, int sign) {
    return differentiated_coefficients(law, place, sign);
  };
  const auto coefficients = [law](const SteadyPlace<Wide>& place, int sign) {
    return coefficient_ratios(law, place, sign);
  };
  return {Law::limit, force_ratio, coefficients, differentiated};
}

}  // namespace

SteadyLaw steady_law(std::string_view law, const CompiledFilm* table) {
  if (is_compiled_law(law)) {
    return with_film_law<CompiledLaws>(law, [&]<class Law>() { return steady_table(Law(table_of<Law>(table))); });
  }
  require_law_at_rest(law);
  return with_film_law(law, []<class Law>() { return steady_formula<Law>(); });
}

}  // namespace lubjoint::reports

/// The option that names a law, for a bearing or a state of rest.
#pragma once

#include <iostream>

#include "lubjoint/film/compiled_laws.hpp"
#include "oracle/cli/compiled_film.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/results/film_in_bearing.hpp"

namespace lubjoint::cli {

/// Accepts any law for a bearing; where it is a poor one for the bearing's shape, a warning says so.
/// @throws std::invalid_argument that names the option and what is allowed
inline void require_law_of_bearing(const std::string& law, const Bearing<double>& bearing) {
  require_name("--law", law, named_film_laws);
  with_film_law<NamedFilmLaws>(law, [&]<class Law>() {
    [[maybe_unused]] const double shape = length_to_diameter(bearing);
    if constexpr (CompiledLaw<Law>) {
      require_option("--length over twice --radius", shape,
                     shape >= least_compiled_shape && shape <= largest_compiled_shape,
                     fmt::format("a number from {} to {} with {}", least_compiled_shape, largest_compiled_shape, law));
    }
    if constexpr (ShapedFilmLaw<Law>) {
      require_shape<Law>(shape);
      const std::string warning = Law::warning(shape);
      if (!warning.empty()) std::cerr << "warning: " << warning << '\n';
    }
  });
}

/// Accepts a law whose film carries a journal at rest. @throws std::invalid_argument likewise
inline void require_law_with_rest(const std::string& law) {
  require_name("--law", law, named_film_laws);
  if (!is_compiled_law(law)) require_law_at_rest(law);
}

/// A law in a bearing, with its table if it is compiled.
inline reports::FilmInBearing film_in_bearing(const std::string& law, const Bearing<double>& bearing,
                                              const Lubricant<double>& oil) {
  reports::FilmInBearing film{law, bearing, oil};
  if (is_compiled_law(law)) {
    film.table = std::make_shared<const CompiledFilm>(film_for_user(law, length_to_diameter(bearing)));
    std::cerr << stated_error(*film.table) << '\n';
  }
  return film;
}

}  // namespace lubjoint::cli

/// The option that names a law, for a bearing or a state of rest.
#pragma once

#include <iostream>

#include "lubjoint/film/every_law.hpp"
#include "oracle/cli/name_option.hpp"

namespace lubjoint::cli {

/// Accepts any law for a bearing; where it is a poor one for the bearing's shape, a warning says so.
/// @throws std::invalid_argument that names the option and what is allowed
inline void require_law_of_bearing(const std::string& law, const Bearing<double>& bearing) {
  require_name("--law", law, every_law_names);
  with_film_law<EveryFilmLaw>(law, [&]<class Law>() {
    if constexpr (ShapedFilmLaw<Law>) {
      const double shape = length_to_diameter(bearing);
      require_shape<Law>(shape);
      const std::string warning = Law::warning(shape);
      if (!warning.empty()) std::cerr << "warning: " << warning << '\n';
    }
  });
}

/// Accepts a law whose film carries a journal at rest. @throws std::invalid_argument likewise
inline void require_law_with_rest(const std::string& law) {
  require_name("--law", law, every_law_names);
  require_law_at_rest(law);
}

}  // namespace lubjoint::cli

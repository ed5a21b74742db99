#include "oracle/reynolds/film_onset.hpp"

#include <algorithm>
#include <stdexcept>

namespace lubjoint::oracle {

std::string_view name_of(FilmOnset onset) { return film_onset_names[static_cast<std::size_t>(onset)]; }

FilmOnset film_onset_of(std::string_view film, const std::optional<std::string>& given, const std::string& what) {
  if (!given) return FilmOnset::free;
  if (film != name_of(FiniteFilm::finite_reynolds)) {
    throw std::invalid_argument(what + " has no effect on " + std::string(film) +
                                "; allowed with finite_reynolds alone");
  }
  const auto found = std::find(film_onset_names.begin(), film_onset_names.end(), *given);
  if (found != film_onset_names.end()) return static_cast<FilmOnset>(found - film_onset_names.begin());
  throw std::invalid_argument(what + " is \"" + *given + "\"; allowed are free, maximum_film");
}

}  // namespace lubjoint::oracle

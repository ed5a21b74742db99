#include "oracle/reynolds/film_name.hpp"

#include <stdexcept>
#include <string>

namespace lubjoint::oracle {

BearingLimit OneDimensionalFilmEntry::limit() const { return law_facts(name).limit; }

FilmExtent OneDimensionalFilmEntry::extent() const { return law_facts(name).extent; }

const OneDimensionalFilmEntry& entry_of(OneDimensionalFilm film) {
  for (const OneDimensionalFilmEntry& entry : one_dimensional_films) {
    if (entry.film == film) return entry;
  }
  throw std::invalid_argument("there is no one-dimensional film number " + std::to_string(static_cast<int>(film)));
}

OneDimensionalFilm one_dimensional_film(std::string_view name) {
  std::string names;
  for (const OneDimensionalFilmEntry& entry : one_dimensional_films) {
    if (entry.name == name) return entry.film;
    if (!names.empty()) names += ", ";
    names += entry.name;
  }
  throw std::invalid_argument("there is no film \"" + std::string(name) + "\"; allowed are " + names);
}

}  // namespace lubjoint::oracle

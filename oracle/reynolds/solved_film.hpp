/// The films whose force comes from no law: integrals of a known pressure, and solutions of Reynolds' equation.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "oracle/reynolds/film_name.hpp"
#include "oracle/reynolds/finite_length.hpp"

namespace lubjoint::oracle {

inline constexpr std::array<FiniteFilm, 4> finite_films = {FiniteFilm::finite_full, FiniteFilm::finite_half,
                                                           FiniteFilm::finite_dynamic, FiniteFilm::finite_reynolds};

inline bool is_one_dimensional(std::string_view film) {
  return std::ranges::find(one_dimensional_films, film, &OneDimensionalFilmEntry::name) != one_dimensional_films.end();
}

/// @param what  how the name is called in messages: "--film"
/// @throws std::invalid_argument that lists all films, of either kind
inline void require_solved_film(std::string_view film, const std::string& what) {
  if (is_one_dimensional(film)) return;
  std::string all;
  for (const auto& entry : one_dimensional_films) all += (all.empty() ? "" : ", ") + std::string(entry.name);
  for (const FiniteFilm each : finite_films) {
    if (name_of(each) == film) return;
    all += ", " + std::string(name_of(each));
  }
  throw std::invalid_argument(what + " is \"" + std::string(film) + "\"; allowed are " + all);
}

}  // namespace lubjoint::oracle

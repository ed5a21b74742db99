/// The films whose force is a one-dimensional integral.
#pragma once

#include <array>
#include <string_view>

#include "lubjoint/film/law_facts.hpp"

namespace lubjoint::oracle {

/// short_*, long_full, long_half_eq5: the pressure is known in closed form (eqs. 3 and 5), its integral is not assumed.
/// long_half, long_dynamic: the pressure is the solution of its differential equation with p = 0 at both ends.
enum class OneDimensionalFilm {
  short_full,
  short_half,
  short_dynamic,
  long_full,
  long_half,
  long_half_eq5,
  long_dynamic
};

struct OneDimensionalFilmEntry {
  OneDimensionalFilm film;
  std::string_view name;  ///< of the law whose force it is
  bool pressure_by_ode;   ///< p = 0 at both ends of the long film

  BearingLimit limit() const;  ///< as the law says
  FilmExtent extent() const;   ///< likewise
};

inline constexpr std::array<OneDimensionalFilmEntry, 7> one_dimensional_films = {{
    {OneDimensionalFilm::short_full, "short_full", false},
    {OneDimensionalFilm::short_half, "short_half", false},
    {OneDimensionalFilm::short_dynamic, "short_dynamic", false},
    {OneDimensionalFilm::long_full, "long_full", false},
    {OneDimensionalFilm::long_half, "long_half", true},
    {OneDimensionalFilm::long_half_eq5, "long_half_eq5", false},
    {OneDimensionalFilm::long_dynamic, "long_dynamic", true},
}};

/// What is known of a film by its enumerator.
const OneDimensionalFilmEntry& entry_of(OneDimensionalFilm film);

/// The film of that name.
/// @throws std::invalid_argument that lists the films there are
OneDimensionalFilm one_dimensional_film(std::string_view name);

}  // namespace lubjoint::oracle

/// Every law: those of law_list.hpp, which carry a journal that turns, those of the squeeze alone, which carry none,
/// and those of finite length, which depend on the bearing's L/D, too.
#pragma once

#include <string>

#include "lubjoint/film/butenschoen.hpp"
#include "lubjoint/film/law_list.hpp"
#include "lubjoint/film/moes_impedance.hpp"
#include "lubjoint/film/squeeze_long.hpp"
#include "lubjoint/film/squeeze_long_full.hpp"
#include "lubjoint/film/squeeze_short.hpp"
#include "lubjoint/film/squeeze_short_full.hpp"

namespace lubjoint {

/// The laws of the squeeze alone, in the order in which they are listed.
using SqueezeFilmLaws = std::tuple<SqueezeLongFull, SqueezeShortFull, SqueezeLong, SqueezeShort>;
/// The laws of the film's state alone, likewise.
using StateFilmLaws = decltype(std::tuple_cat(FilmLaws(), SqueezeFilmLaws()));
/// The laws of finite length, likewise.
using ShapedFilmLaws = std::tuple<MoesImpedance, Butenschoen>;
/// All laws that are formulas, in the order in which they are listed: with_film_law<EveryFilmLaw>(name, visitor).
/// compiled_laws.hpp has those that are tables, too.
using EveryFilmLaw = decltype(std::tuple_cat(StateFilmLaws(), ShapedFilmLaws()));

/// Their names.
inline constexpr auto every_law_names = names_of_laws<EveryFilmLaw>;

/// Accepts the name of a law whose film carries a journal at rest, and whose coefficients there are known.
/// @throws std::invalid_argument that says what keeps a law from it, and lists those that are allowed
inline void require_law_at_rest(std::string_view name) {
  const char* why = with_film_law<EveryFilmLaw>(name, []<class Law>() -> const char* {
    if constexpr (SqueezeOnlyLaw<Law>) return " leaves the wedge out: it carries no journal that stays in its place";
    if constexpr (ShapedFilmLaw<Law>) return " is a fit of forces: its slopes are no coefficients of a film";
    return nullptr;
  });
  if (why == nullptr) return;
  throw std::invalid_argument("the law " + std::string(name) + why + "; allowed are " + listed_film_laws());
}

}  // namespace lubjoint

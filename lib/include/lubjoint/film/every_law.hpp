/// Every law that answers a state of the film: those of law_list.hpp, which carry a journal that turns, and those of
/// the squeeze alone, which carry none.
#pragma once

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/film/squeeze_long.hpp"
#include "lubjoint/film/squeeze_long_full.hpp"
#include "lubjoint/film/squeeze_short.hpp"
#include "lubjoint/film/squeeze_short_full.hpp"

namespace lubjoint {

/// The laws of the squeeze alone, in the order in which they are listed.
using SqueezeFilmLaws = std::tuple<SqueezeLongFull, SqueezeShortFull, SqueezeLong, SqueezeShort>;
/// All laws, in the order in which they are listed: with_film_law<EveryFilmLaw>(name, visitor).
using EveryFilmLaw = decltype(std::tuple_cat(FilmLaws(), SqueezeFilmLaws()));

}  // namespace lubjoint

/// The laws whose film carries a journal that turns, by type and by name: a new one is a header of its own and a line
/// in FilmLaws. every_law.hpp has the other laws, too.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "lubjoint/film/long_dynamic.hpp"
#include "lubjoint/film/long_full.hpp"
#include "lubjoint/film/long_half.hpp"
#include "lubjoint/film/long_half_eq5.hpp"
#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "lubjoint/film/short_dynamic.hpp"
#include "lubjoint/film/short_full.hpp"
#include "lubjoint/film/short_half.hpp"
#include "lubjoint/film/squeeze_only.hpp"

namespace lubjoint {

/// The laws that carry a journal at rest in its place, by the state of the film alone; in the order in which they are
/// listed everywhere.
using FilmLaws =
    std::tuple<ShortFull, ShortHalf, ShortDynamic, LongFull, LongHalf, LongHalfEq5, LongDynamic, PinkusSternlicht>;

/// What each law's header says of it, in the order of a list.
template <class Laws>
inline constexpr auto facts_of_laws = []<class... Law>(std::type_identity<std::tuple<Law...>>) {
  return std::array<LawFacts, sizeof...(Law)>{
      LawFacts{Law::name, Law::words, Law::limit, Law::extent, Law::has_pressure, KinkedLaw<Law>,
               Law::extent == FilmExtent::half, SqueezeOnlyLaw<Law>, Law::potential}...};
}(std::type_identity<Laws>{});

/// Names of the laws of a list, in its order.
template <class Laws>
inline constexpr auto names_of_laws = []<class... Law>(std::type_identity<std::tuple<Law...>>) {
  return std::array<std::string_view, sizeof...(Law)>{Law::name...};
}(std::type_identity<Laws>{});

/// Is a law in a list?
template <class Law, class Laws>
inline constexpr bool is_law_of = []<class... Other>(std::type_identity<std::tuple<Other...>>) {
  return (std::is_same_v<Law, Other> || ...);
}(std::type_identity<Laws>{});

/// Names of the laws, in the order of FilmLaws.
inline constexpr auto film_law_names = names_of_laws<FilmLaws>;

/// Calls `visitor.template operator()<Law>()` for every law of a list.
template <class Laws = FilmLaws, class Visitor>
void for_each_film_law(Visitor&& visitor) {
  [&]<class... Law>(std::type_identity<std::tuple<Law...>>) {
    (visitor.template operator()<Law>(), ...);
  }(std::type_identity<Laws>{});
}

/// The laws' names as a sentence lists them.
template <class Laws = FilmLaws>
std::string listed_film_laws() {
  std::string list;
  for (const std::string_view name : names_of_laws<Laws>) {
    if (!list.empty()) list += ", ";
    list += name;
  }
  return list;
}

/// Place of a law in a list.
/// @throws std::invalid_argument that lists the laws there are
template <class Laws = FilmLaws>
constexpr std::size_t film_law_index(std::string_view name) {
  for (std::size_t i = 0; i < names_of_laws<Laws>.size(); ++i) {
    if (names_of_laws<Laws>[i] == name) return i;
  }
  throw std::invalid_argument("there is no law \"" + std::string(name) + "\"; allowed are " + listed_film_laws<Laws>());
}

/// Accepts the name of a law of a list.
/// @throws std::invalid_argument that lists the laws there are
template <class Laws = FilmLaws>
void require_film_law(std::string_view name) {
  film_law_index<Laws>(name);
}

/// Returns `visitor.template operator()<Law>()` for the law of that name: the one place where a name becomes a type.
/// @throws std::invalid_argument that lists the laws there are
template <class Laws = FilmLaws, class Visitor>
auto with_film_law(std::string_view name, Visitor&& visitor) {
  using Result = decltype(visitor.template operator()<std::tuple_element_t<0, Laws>>());
  film_law_index<Laws>(name);  // refuses
  if constexpr (std::is_void_v<Result>) {
    for_each_film_law<Laws>([&]<class Law>() {
      if (Law::name == name) visitor.template operator()<Law>();
    });
  } else {
    std::optional<Result> result;
    for_each_film_law<Laws>([&]<class Law>() {
      if (Law::name == name) result.emplace(visitor.template operator()<Law>());
    });
    return std::move(*result);
  }
}

}  // namespace lubjoint

/// Every law that answers a state of the film: those of law_list.hpp, which carry a journal that turns, and those of
/// the squeeze alone, which carry none.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/film/squeeze_long.hpp"
#include "lubjoint/film/squeeze_long_full.hpp"
#include "lubjoint/film/squeeze_short.hpp"
#include "lubjoint/film/squeeze_short_full.hpp"

namespace lubjoint {

/// The laws of the squeeze alone, in the order in which they are listed.
using SqueezeFilmLaws = std::tuple<SqueezeLongFull, SqueezeShortFull, SqueezeLong, SqueezeShort>;
/// All laws, in the order in which they are listed.
using EveryFilmLaw = decltype(std::tuple_cat(FilmLaws(), SqueezeFilmLaws()));

/// Their names, in that order.
inline constexpr auto every_film_law_name = []<class... Law>(std::type_identity<std::tuple<Law...>>) {
  return std::array<std::string_view, sizeof...(Law)>{Law::name...};
}(std::type_identity<EveryFilmLaw>{});

/// Calls `visitor.template operator()<Law>()` for every law of the squeeze alone.
template <class Visitor>
void for_each_squeeze_law(Visitor&& visitor) {
  [&]<class... Law>(std::type_identity<std::tuple<Law...>>) {
    (visitor.template operator()<Law>(), ...);
  }(std::type_identity<SqueezeFilmLaws>{});
}

/// Returns `visitor.template operator()<Law>()` for the law of that name.
/// @throws std::invalid_argument that lists the laws there are
template <class Visitor>
auto with_every_film_law(std::string_view name, Visitor&& visitor) {
  using Result = decltype(visitor.template operator()<ShortFull>());
  bool known_law = false;
  const auto meet = [&]<class Law>(auto&& found) {
    if (Law::name != name) return;
    known_law = true;
    found.template operator()<Law>();
  };
  const auto search = [&](auto&& found) {
    for_each_squeeze_law([&]<class Law>() { meet.template operator()<Law>(found); });
    for_each_film_law([&]<class Law>() { meet.template operator()<Law>(found); });
  };
  if constexpr (std::is_void_v<Result>) {
    search([&]<class Law>() { visitor.template operator()<Law>(); });
    if (known_law) return;
  } else {
    std::optional<Result> result;
    search([&]<class Law>() { result.emplace(visitor.template operator()<Law>()); });
    if (known_law) return std::move(*result);
  }
  std::string list;
  for (const std::string_view known : every_film_law_name) list += (list.empty() ? "" : ", ") + std::string(known);
  throw std::invalid_argument("there is no law \"" + std::string(name) + "\"; allowed are " + list);
}

}  // namespace lubjoint

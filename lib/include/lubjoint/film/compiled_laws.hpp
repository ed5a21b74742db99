/// The compiled laws, by type and by name.
#pragma once

#include <string>
#include <tuple>
#include <type_traits>

#include "lubjoint/film/finite_dynamic.hpp"
#include "lubjoint/film/finite_full.hpp"
#include "lubjoint/film/finite_half.hpp"
#include "lubjoint/film/finite_reynolds.hpp"

namespace lubjoint {

/// The laws that are compiled, in the order in which they are listed.
using CompiledLaws = std::tuple<FiniteFull, FiniteHalf, FiniteDynamic, FiniteReynolds>;

/// Calls `visitor.template operator()<Law>()` for every compiled law.
template <class Visitor>
void for_each_compiled_law(Visitor&& visitor) {
  [&]<class... Law>(std::type_identity<std::tuple<Law...>>) {
    (visitor.template operator()<Law>(), ...);
  }(std::type_identity<CompiledLaws>{});
}

/// Is it the name of one of them?
inline bool is_compiled_law(std::string_view name) {
  bool found = false;
  for_each_compiled_law([&]<class Law>() { found = found || Law::name == name; });
  return found;
}

/// The compiled laws' names as a sentence lists them.
inline std::string listed_compiled_laws() {
  std::string list;
  for_each_compiled_law([&]<class Law>() { list += (list.empty() ? "" : ", ") + std::string(Law::name); });
  return list;
}

/// Calls visitor(law) with the law that a table belongs to.
/// @throws std::invalid_argument if it belongs to none, or is not whole
template <class Visitor>
void with_compiled_law(const CompiledFilm& table, Visitor&& visitor) {
  if (!is_compiled_law(table.film)) {
    throw std::invalid_argument("there is no compiled law \"" + table.film + "\"; allowed are " +
                                listed_compiled_laws());
  }
  for_each_compiled_law([&]<class Law>() {
    if (Law::name == table.film) visitor(Law(table));
  });
}

}  // namespace lubjoint

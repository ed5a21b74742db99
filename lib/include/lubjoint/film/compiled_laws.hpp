/// The compiled laws, by type and by name.
#pragma once

#include <algorithm>
#include <string_view>
#include <tuple>

#include "lubjoint/film/finite_dynamic.hpp"
#include "lubjoint/film/finite_full.hpp"
#include "lubjoint/film/finite_half.hpp"
#include "lubjoint/film/finite_reynolds.hpp"
#include "lubjoint/film/law_list.hpp"

namespace lubjoint {

/// The laws that are compiled, in the order in which they are listed.
using CompiledLaws = std::tuple<FiniteFull, FiniteHalf, FiniteDynamic, FiniteReynolds>;

/// Is it the name of one of them?
inline bool is_compiled_law(std::string_view name) {
  const auto& names = names_of_laws<CompiledLaws>;
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Calls visitor(law) with the law that a table belongs to.
/// @throws std::invalid_argument if it belongs to none, or is not whole
template <class Visitor>
void with_compiled_law(const CompiledFilm& table, Visitor&& visitor) {
  with_film_law<CompiledLaws>(table.film, [&]<class Law>() { visitor(Law(table)); });
}

}  // namespace lubjoint

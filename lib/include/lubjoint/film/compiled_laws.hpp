/// The compiled laws, by type and by name; and all laws that a name can mean.
#pragma once

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/film/finite_dynamic.hpp"
#include "lubjoint/film/finite_full.hpp"
#include "lubjoint/film/finite_half.hpp"
#include "lubjoint/film/finite_reynolds.hpp"

namespace lubjoint {

/// The laws that are compiled, in the order in which they are listed.
using CompiledLaws = std::tuple<FiniteFull, FiniteHalf, FiniteDynamic, FiniteReynolds>;

namespace detail {
template <class Laws>
struct OneOfLaws;
template <class... Law>
struct OneOfLaws<std::tuple<Law...>> {
  using Type = std::variant<Law...>;
};
}  // namespace detail

/// Any of them, with its table.
using AnyCompiledLaw = detail::OneOfLaws<CompiledLaws>::Type;

/// All laws that a scene or an option can name: those that are formulas, then those that are tables.
using NamedFilmLaws = decltype(std::tuple_cat(std::declval<EveryFilmLaw>(), std::declval<CompiledLaws>()));

/// Their names.
inline constexpr auto named_film_laws = names_of_laws<NamedFilmLaws>;

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

/// @throws std::invalid_argument  L/D for which films are not compiled
inline void require_compiled_shape(std::string_view law, double shape) {
  if (shape >= least_compiled_shape && shape <= largest_compiled_shape) return;
  std::ostringstream message;
  message.precision(6);
  message << "length over diameter is " << shape << " for the law " << law << "; allowed is a number from "
          << least_compiled_shape << " to " << largest_compiled_shape;
  throw std::invalid_argument(message.str());
}

}  // namespace lubjoint

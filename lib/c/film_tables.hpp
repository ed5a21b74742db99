/// Tables of the compiled laws, as this process has been given them.
#pragma once

#include <memory>
#include <string_view>
#include <variant>

#include "guarded.hpp"
#include "lubjoint/film/compiled_laws.hpp"

namespace lubjoint::c {

/// A law with its table, and the table's statement.
struct FilmTable {
  AnyCompiledLaw law;
  double shape;        ///< L/D
  double ratio_limit;  ///< ε up to which the error was measured
  double error;        ///< over |F|
};

/// Keeps a table for all threads; one of the same law and L/D takes the place of the one before.
/// @throws CompiledFilmError, std::invalid_argument if the text is no table of a compiled law
void keep_table(std::string_view text);

/// The table of a law for a bearing; it stays valid when another takes its place. Null for a law that is a formula.
/// @throws NoTableError if none was kept; std::invalid_argument for an unknown law, or an L/D for which none is
/// compiled
std::shared_ptr<const FilmTable> table_of(std::string_view law, const Bearing<double>& bearing);

/// Calls visitor(law) with an object of the law of that name, for a bearing: the table's where it has one.
/// @throws as table_of
template <class Visitor>
void with_law(std::string_view name, const Bearing<double>& bearing, const Visitor& visitor) {
  if (const auto table = table_of(name, bearing)) {
    std::visit(visitor, table->law);
  } else {
    with_film_law<EveryFilmLaw>(name, [&]<class Law>() { visitor(Law{}); });
  }
}

}  // namespace lubjoint::c

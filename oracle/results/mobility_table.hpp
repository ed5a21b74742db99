/// Velocities that carry given forces, as rows of a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lubjoint/number/vector.hpp"
#include "oracle/results/film_in_bearing.hpp"

namespace lubjoint::reports {

/// What mobility_columns gives for a law, in its order: ux, uy [1/s] and status (found, none, two or many); for half
/// films also other_ux, other_uy, the second of two velocities.
std::vector<std::string> mobility_column_names(std::string_view law);

/// Those of a place ê and a force on the journal [N], each behind its comma; from the law in extended precision,
/// rounded once. What there is not is empty.
/// @throws FilmDomainError where there is no film, std::range_error if a velocity leaves the range of double
std::string mobility_columns(const FilmInBearing& film, const Vector2<double>& e_hat, const Vector2<double>& force);

/// Refuses a law that has no inverse. @throws std::invalid_argument
void require_mobility(std::string_view law);

/// What the table's reader should know of a law: where uniqueness is not proved. Empty for other laws.
std::string mobility_note(std::string_view law);

}  // namespace lubjoint::reports

/// Velocities that carry given forces, as a table.
#pragma once

#include <string>

#include "lubjoint/film/bearing.hpp"
#include "oracle/files/csv_table.hpp"

namespace lubjoint::reports {

/// The rows of a table with ex_over_c, ey_over_c [-] and fx, fy, the force on the journal [N], with ux, uy [1/s] and
/// status added: found, none, two or many; for half films also other_ux, other_uy, the second of two velocities. From
/// the law in extended precision, rounded once; what there is not is empty.
/// @throws CsvError that names file and line where there is no film or a velocity leaves the range of double
std::string mobility_csv(const CsvTable& states, std::string_view law, const Bearing<double>& bearing,
                         const Lubricant<double>& oil);

/// What the table's reader should know of a law: where uniqueness is not proved. Empty for other laws.
std::string mobility_note(std::string_view law);

}  // namespace lubjoint::reports

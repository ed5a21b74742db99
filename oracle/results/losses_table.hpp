/// Losses of a film at given motions, as a table.
#pragma once

#include <string>

#include "lubjoint/film/losses.hpp"
#include "oracle/files/csv_table.hpp"

namespace lubjoint::reports {

/// The rows of a table with ex, ey, vx, vy [m, m/s] and omega_bearing, omega_journal [rad/s], with fx, fy [N],
/// torque_journal, torque_bearing [N m], power [W] and side_flow [m³/s] added; all from the law in extended precision,
/// rounded once. What is not defined is empty: the side flow of a long bearing, and torques and power of striated shear
/// where the journal moves along e.
/// @throws CsvError that names file and line where there is no film or a number leaves the range of double
std::string losses_csv(const CsvTable& states, std::string_view law, const Bearing<double>& bearing,
                       const Lubricant<double>& oil, ShearExtent shear);

}  // namespace lubjoint::reports

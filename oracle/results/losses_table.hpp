/// Losses of a film at given motions, as rows of a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lubjoint/film/losses.hpp"
#include "oracle/results/film_in_bearing.hpp"

namespace lubjoint::reports {

/// What loss_columns gives, in its order.
inline const std::vector<std::string> loss_column_names = {"fx",    "fy",       "torque_journal", "torque_bearing",
                                                           "power", "side_flow"};

/// fx, fy [N], torque_journal, torque_bearing [N m], power [W] and side_flow [m³/s] of a motion, each behind its comma;
/// all from the law in extended precision, rounded once. What is not defined is empty: the side flow of a long bearing
/// and of a compiled law, which has the force of its film alone, and torques and power of striated shear where the
/// journal moves along e.
/// @throws FilmDomainError where there is no film, std::range_error if a number leaves the range of double
std::string loss_columns(const FilmInBearing& film, ShearExtent shear, const JournalMotion<double>& motion);

}  // namespace lubjoint::reports

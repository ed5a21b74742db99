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
/// all from the law in extended precision, rounded once. What is not defined is empty: the side flow of a long bearing,
/// and torques and power of striated shear where the journal moves along e.
/// A compiled law has the force of its film alone: its side flow is solved for, a millisecond or some each, to
/// solved_flow_tolerance; empty where the solver does not reach that.
/// @throws FilmDomainError where there is no film, std::range_error if a number leaves the range of double
std::string loss_columns(const FilmInBearing& film, ShearExtent shear, const JournalMotion<double>& motion);

/// Of the side flow of a compiled law, as a share of 2cRL|u|, all that the motion displaces.
constexpr double solved_flow_tolerance(bool has_free_boundary) { return has_free_boundary ? 1e-3 : 1e-6; }

}  // namespace lubjoint::reports

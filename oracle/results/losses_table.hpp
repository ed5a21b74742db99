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
/// solved_flow_tolerance, and so is what a film with a free boundary shears, I₁, to solved_couette_tolerance. Side
/// flow, or torques and power, are empty where the solver does not reach that.
/// @throws FilmDomainError where there is no film, std::range_error if a number leaves the range of double
std::string loss_columns(const FilmInBearing& film, ShearExtent shear, const JournalMotion<double>& motion);

/// Of the side flow of a compiled law, as a share of 2cRL|u|, all that the motion displaces.
constexpr double solved_flow_tolerance(bool has_free_boundary) { return has_free_boundary ? 1e-3 : 1e-6; }
/// Of I₁, where the bounds of the film are solved for: the torque of the shear is as far off, the rest of it is not.
inline constexpr double solved_couette_tolerance = 1e-3;

/// Is I₁ of a law solved for at each state?
template <class Law>
constexpr bool has_solved_couette(ShearExtent shear) {
  return FreeBoundaryLaw<Law> && shear == ShearExtent::film;
}

/// @throws std::invalid_argument if loss_columns has no such shear of the law
template <class Law>
void require_solvable_shear(ShearExtent shear) {
  if (has_solved_couette<Law>(shear)) return;
  if (FreeBoundaryLaw<Law> && shear == ShearExtent::striated) {
    throw std::invalid_argument("shear \"striated\" is not defined for the law " + std::string(Law::name) +
                                "; allowed is film or flooded, or a half film");
  }
  sheared_gap<Law>(shear);
}

}  // namespace lubjoint::reports

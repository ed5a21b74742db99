/// What a foreign program is asked for: columns of the states it gets and of the answers it gives.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lubjoint/film/shear_extent.hpp"

namespace lubjoint::verify {

/// cartesian: force from the motion in x and y.  polar: radial and tangential force from ε and rates.
/// wrench: cartesian, and the moments about the mass centres.  transition: cartesian, with film and dry contact.
/// extent: where the film carries pressure, θs and θe.  pressure: at a place (θ, z), zero outside the film.
/// dimensionless: cartesian for a journal that turns in a bearing at rest, lengths in clearances, time in 1/ω_J, force
/// in S ω_J with S = μRL³/c² of the short laws and μLR³/c² of the long ones: cartesian with the others such that
/// c = ω_J = S = 1.
/// coefficients: stiffness and damping of the film where a journal carries a load along −y in a bearing at rest,
/// without gravity, F = −K e − C v in inertial axes, and where that is: ε and the attitude angle, from the load to e,
/// positive in the sense of the spin.  equilibrium: that place alone. losses: torques on journal and bearing about
/// their own centres, power lost in the film, flow out of both its sides. contact: force of the dry wall alone, by one
/// of the laws of contact.
enum class Quantities {
  cartesian,
  polar,
  wrench,
  transition,
  extent,
  pressure,
  dimensionless,
  coefficients,
  equilibrium,
  losses,
  contact
};

inline constexpr std::array<std::string_view, 11> quantities_names = {
    "cartesian",     "polar",        "wrench",      "transition", "extent", "pressure",
    "dimensionless", "coefficients", "equilibrium", "losses",     "contact"};

/// Of these is the answer the film's force, at any thickness? A transition's film is never thinner than e₁; a pressure
/// and a film's ends say the same at any thickness.
constexpr bool is_film_force(Quantities q) {
  return q == Quantities::cartesian || q == Quantities::polar || q == Quantities::wrench ||
         q == Quantities::dimensionless;
}

/// True where a state is a load and a spin, and ε is what a law answers to them.
constexpr bool is_of_load(Quantities q) { return q == Quantities::coefficients || q == Quantities::equilibrium; }

/// True where answers are columns that stand each for itself, so that a program may give any of them.
constexpr bool is_table(Quantities q) { return is_of_load(q) || q == Quantities::losses; }

/// True where states are given by ε and rates.
constexpr bool is_polar(Quantities q) {
  return q == Quantities::polar || q == Quantities::extent || q == Quantities::pressure;
}

/// @throws std::invalid_argument that lists what there is
Quantities quantities_of(std::string_view name);
std::string_view name_of(Quantities quantities);

struct GoldenAnswers;
class SolvedFilms;

/// Everything that a state may say; a kind of quantities uses some of it. SI units, angles in radians.
struct State {
  double viscosity = 0;
  double length = 0;
  double radius = 0;
  double clearance = 0;
  double omega_bearing = 0;
  double omega_journal = 0;
  double ex = 0;
  double ey = 0;
  double vx = 0;
  double vy = 0;
  double eccentricity_ratio = 0;
  double squeeze_rate = 0;
  double omega = 0;          ///< ω_J − ω_B; of a load, the journal's in a bearing at rest
  double attitude_rate = 0;  ///< γ̇ relative to the bearing
  double sx_i = 0;           ///< arm from the mass centre of the bearing's body to the bearing's centre
  double sy_i = 0;
  double sx_j = 0;  ///< arm from the mass centre of the journal's body to the journal's centre
  double sy_j = 0;
  double e0 = 0;
  double e1 = 0;
  double contact_stiffness = 0;
  double restitution = 0;
  double impact_speed = 0;
  double theta = 0;                             ///< from the maximum film, counter-clockwise
  double z = 0;                                 ///< axial, from the middle
  double load = 0;                              ///< along −y [N]
  ShearExtent shear = ShearExtent::film;        ///< of losses: what is asked for, no column
  std::shared_ptr<const GoldenAnswers> golden;  ///< certified answers, where there are some
  std::shared_ptr<const SolvedFilms> films;     ///< what knows the films of the bearing's real length, where asked for
};

/// One column of the states.
struct StateColumn {
  std::string_view name;
  double State::*value;
};

/// Columns after `id`, in the order in which they are written.
const std::vector<StateColumn>& state_columns(Quantities quantities);

inline constexpr std::size_t most_answers = 10;

/// Columns of the answers after `id`; forces first.
const std::vector<std::string_view>& answer_columns(Quantities quantities);

/// Columns whose size is one: a force, a matrix. What an answer's error is compared with is the size of all of them.
struct ColumnGroup {
  std::size_t begin, end;
};
ColumnGroup group_of(Quantities quantities, std::size_t column);

/// The states as CSV, ids from 1; numbers are the shortest that read back as the same double.
std::string states_csv(Quantities quantities, const std::vector<State>& states);

/// One state as the row of states_csv.
std::string state_row(Quantities quantities, const State& state, std::size_t id);
/// Names of the columns with `id`, comma-separated.
std::string state_header(Quantities quantities);

}  // namespace lubjoint::verify

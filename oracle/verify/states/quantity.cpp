#include "oracle/verify/states/quantity.hpp"

#include <fmt/format.h>

#include <iterator>
#include <stdexcept>

namespace lubjoint::verify {

namespace {

std::vector<StateColumn> joined(std::vector<StateColumn> first, const std::vector<StateColumn>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

const std::vector<StateColumn> oil_and_bearing = {{"viscosity", &State::viscosity},
                                                  {"length", &State::length},
                                                  {"radius", &State::radius},
                                                  {"clearance", &State::clearance}};

}  // namespace

Quantities quantities_of(std::string_view name) {
  std::string list;
  for (std::size_t i = 0; i < quantities_names.size(); ++i) {
    if (quantities_names[i] == name) return static_cast<Quantities>(i);
    list += (i ? ", " : "") + std::string(quantities_names[i]);
  }
  throw std::invalid_argument("there are no quantities \"" + std::string(name) + "\"; allowed are " + list);
}

std::string_view name_of(Quantities quantities) { return quantities_names[static_cast<std::size_t>(quantities)]; }

const std::vector<StateColumn>& state_columns(Quantities quantities) {
  static const std::vector<StateColumn> cartesian = joined(oil_and_bearing, {{"omega_bearing", &State::omega_bearing},
                                                                             {"omega_journal", &State::omega_journal},
                                                                             {"ex", &State::ex},
                                                                             {"ey", &State::ey},
                                                                             {"vx", &State::vx},
                                                                             {"vy", &State::vy}});
  static const std::vector<StateColumn> polar =
      joined(oil_and_bearing, {{"eccentricity_ratio", &State::eccentricity_ratio},
                               {"squeeze_rate", &State::squeeze_rate},
                               {"omega", &State::omega},
                               {"attitude_rate", &State::attitude_rate}});
  static const std::vector<StateColumn> wrench = joined(
      cartesian, {{"sx_i", &State::sx_i}, {"sy_i", &State::sy_i}, {"sx_j", &State::sx_j}, {"sy_j", &State::sy_j}});
  static const std::vector<StateColumn> transition =
      joined(cartesian, {{"e0", &State::e0},
                         {"e1", &State::e1},
                         {"contact_stiffness", &State::contact_stiffness},
                         {"restitution", &State::restitution},
                         {"impact_speed", &State::impact_speed}});
  static const std::vector<StateColumn> dimensionless = {
      {"x", &State::ex}, {"y", &State::ey}, {"vx", &State::vx}, {"vy", &State::vy}};
  static const std::vector<StateColumn> extent(polar.begin() + 4, polar.end());  // neither oil nor bearing
  static const std::vector<StateColumn> pressure = joined(polar, {{"theta", &State::theta}, {"z", &State::z}});
  static const std::vector<StateColumn> of_load =
      joined(oil_and_bearing, {{"omega", &State::omega}, {"load", &State::load}});
  static const std::vector<StateColumn> contact = {{"clearance", &State::clearance},
                                                   {"contact_stiffness", &State::contact_stiffness},
                                                   {"restitution", &State::restitution},
                                                   {"impact_speed", &State::impact_speed},
                                                   {"ex", &State::ex},
                                                   {"ey", &State::ey},
                                                   {"vx", &State::vx},
                                                   {"vy", &State::vy}};
  switch (quantities) {
    case Quantities::contact:
      return contact;
    case Quantities::coefficients:
    case Quantities::equilibrium:
      return of_load;
    case Quantities::polar:
      return polar;
    case Quantities::extent:
      return extent;
    case Quantities::pressure:
      return pressure;
    case Quantities::wrench:
      return wrench;
    case Quantities::transition:
      return transition;
    case Quantities::dimensionless:
      return dimensionless;
    case Quantities::cartesian:
    case Quantities::losses:
      break;
  }
  return cartesian;
}

const std::vector<std::string_view>& answer_columns(Quantities quantities) {
  static const std::vector<std::string_view> plane = {"fx", "fy"};
  static const std::vector<std::string_view> polar = {"radial", "tangential"};
  static const std::vector<std::string_view> wrench = {"fx", "fy", "mz_bearing", "mz_journal"};
  static const std::vector<std::string_view> extent = {"theta_s", "theta_e"};
  static const std::vector<std::string_view> pressure = {"pressure"};
  static const std::vector<std::string_view> equilibrium = {"eccentricity_ratio", "attitude"};
  static const std::vector<std::string_view> coefficients = {
      "eccentricity_ratio", "attitude", "kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"};
  static const std::vector<std::string_view> losses = {"torque_journal", "torque_bearing", "power", "side_flow"};
  if (quantities == Quantities::coefficients) return coefficients;
  if (quantities == Quantities::equilibrium) return equilibrium;
  if (quantities == Quantities::losses) return losses;
  if (quantities == Quantities::polar) return polar;
  if (quantities == Quantities::extent) return extent;
  if (quantities == Quantities::pressure) return pressure;
  return quantities == Quantities::wrench ? wrench : plane;
}

ColumnGroup group_of(Quantities quantities, std::size_t column) {
  if (quantities == Quantities::coefficients && column >= 2) return column < 6 ? ColumnGroup{2, 6} : ColumnGroup{6, 10};
  const bool alone = is_table(quantities) || quantities == Quantities::pressure || column >= 2;
  return alone ? ColumnGroup{column, column + 1} : ColumnGroup{0, 2};
}

std::string state_header(Quantities quantities) {
  std::string header = "id";
  for (const StateColumn& column : state_columns(quantities)) header.append(",").append(column.name);
  return header;
}

std::string state_row(Quantities quantities, const State& state, std::size_t id) {
  std::string row = fmt::format("{}", id);
  for (const StateColumn& column : state_columns(quantities)) {
    fmt::format_to(std::back_inserter(row), ",{}", state.*column.value);
  }
  return row;
}

std::string states_csv(Quantities quantities, const std::vector<State>& states) {
  std::string csv = state_header(quantities) + '\n';
  for (std::size_t i = 0; i < states.size(); ++i) csv += state_row(quantities, states[i], i + 1) + '\n';
  return csv;
}

}  // namespace lubjoint::verify

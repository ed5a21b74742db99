/// The tables of the engine that ships: the gas's force over the crank's angle, and the big end's load diagram.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>

#include "oracle/mechanisms/engine_cycle.hpp"

namespace lubjoint::mechanisms {

inline constexpr int engine_table_step = 2;       ///< between rows, in degrees of the crank's angle
inline constexpr double engine_speed_rpm = 3000;  ///< of the load diagram

/// Speed of the crank of the load diagram [rad/s].
inline double engine_speed() { return engine_speed_rpm * boost::math::constants::pi<double>() / 30; }

namespace detail {

inline std::string table_row(const std::initializer_list<double>& values) {
  std::string row;
  char text[32];
  for (const double value : values) {
    // What rounding leaves of 0 is 0.
    std::snprintf(text, sizeof text, "%.12g", std::abs(value) < 1e-9 ? 0.0 : value);
    row += (row.empty() ? "" : ",") + std::string(text);
  }
  return row + "\n";
}

}  // namespace detail

/// CSV angle,fx of the gas's force on the piston; the last row has the first one's force.
inline std::string gas_force_table(const EngineCycle& engine) {
  std::string text =
      "# Force of the gas on the piston over the crank's angle from the outer dead centre at which the intake begins.\n"
      "# Computed from the cycle that engine.toml states.\n"
      "angle,fx\n";
  for (int degrees = 0; degrees <= 720; degrees += engine_table_step) {
    const double angle = EngineCycle::radians(degrees);
    text += detail::table_row({angle, engine.gas_force(degrees == 720 ? 0 : angle)});
  }
  return text;
}

/// CSV t,fx,fy of the rod's force on the crank pin, inertial; the last row has the first one's force.
inline std::string big_end_table(const EngineCycle& engine, const EngineMasses& masses) {
  std::string text =
      "# Load diagram of the big end of engine.toml's mechanism with ideal joints at 3000 rpm: force of the rod on "
      "the\n"
      "# crank pin in inertial axes, the cylinder along x.\n"
      "t,fx,fy\n";
  for (int degrees = 0; degrees <= 720; degrees += engine_table_step) {
    const double angle = EngineCycle::radians(degrees);
    const Vector2<double> force = big_end_load(engine, masses, engine_speed(), degrees == 720 ? 0 : angle);
    text += detail::table_row({angle / engine_speed(), force.x(), force.y()});
  }
  return text;
}

}  // namespace lubjoint::mechanisms

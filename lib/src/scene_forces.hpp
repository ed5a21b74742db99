/// Loads, springs and sensors of a scene file.
#pragma once

#include "lubjoint/scene/scene.hpp"
#include "table_reader.hpp"

namespace lubjoint {

/// Where an anchor is at t = 0, inertial [m].
Vector2<double> position_of(const SceneAnchor& anchor, const Scene& scene);

/// More periods in a run are a slip of the pen.
inline constexpr double most_periods = 1e6;

/// Rate and phase of what oscillates: keys speed or frequency, and phase. @param duration  of the run [s]
/// @throws SceneError  as do all below
SceneHarmonic read_oscillation(TableReader& table, double duration);
/// The swing of a load, in the plane or in space. @param acts  is any of its amplitudes other than 0?
SceneHarmonic read_harmonic(TableReader& table, double duration, bool acts);
SceneLoad read_load(TableReader table, const Scene& scene);

/// Stiffness, damping and free angle of a spring about an axis, in the plane or in space.
template <class Spring>
void read_rotational_terms(TableReader& table, Spring& spring) {
  spring.stiffness = table.number("stiffness", Allowed::not_negative, "N m/rad");
  spring.damping = table.number_or("damping", 0, Allowed::not_negative, "N m s/rad");
  if (spring.stiffness > 0) {
    spring.free_angle = table.number("free_angle", Allowed::any, "rad");
  } else if (table.has("free_angle")) {
    table.refuse("free_angle", "given where stiffness is 0", "none: a damper alone has no free angle");
  }
  if (spring.stiffness == 0 && spring.damping == 0)
    table.refuse("stiffness", "0 in a spring without damping or preload", "a spring that does something");
}

/// Those of a spring along a line, with its preload.
template <class Spring>
void read_translational_terms(TableReader& table, Spring& spring) {
  spring.stiffness = table.number("stiffness", Allowed::not_negative, "N/m");
  spring.damping = table.number_or("damping", 0, Allowed::not_negative, "N s/m");
  spring.preload = table.number_or("preload", 0, Allowed::any, "N");
  if (spring.stiffness > 0) {
    spring.free_length = table.number("free_length", Allowed::not_negative, "m");
  } else if (table.has("free_length")) {
    table.refuse("free_length", "given where stiffness is 0", "none: a force that does not depend on the length");
  }
  if (spring.stiffness == 0 && spring.damping == 0 && spring.preload == 0)
    table.refuse("stiffness", "0 in a spring without damping or preload", "a spring that does something");
}

/// A spring between points needs a direction. @param place  of an end at the start as the file has it, which may be
/// moved onto its constraints: what is left to rounding there is looked at again before the run
template <class Spring, class Place>
void require_two_ends(const TableReader& table, const Spring& spring, const Place& place) {
  if (spring.first.body == spring.second.body) table.refuse("second", "on the same body as first", "another body");
  if (place(spring.first) == place(spring.second)) {
    table.refuse("second", "where first is: the spring has length 0, and so no direction",
                 "a point at a distance above 0 at t = 0");
  }
}

/// A spring of a scene whose constraints are known.
SceneSpring read_spring(TableReader table, const Scene& scene);
/// A sensor of a scene whose constraints and springs are known.
Sensor read_sensor(TableReader table, const Scene& scene);

}  // namespace lubjoint

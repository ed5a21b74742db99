/// Drivers of a scene file.
#pragma once

#include "lubjoint/scene/scene.hpp"
#include "table_reader.hpp"

namespace lubjoint {

/// The keys of a motion that differ between one that turns and one that slides.
struct MotionWords {
  const char* quantity;  ///< key of the constant term, and column of a table
  const char* unit;
  const char* speed_unit;
  const char* acceleration_unit;
};

/// What the keys of a driver's table say of its motion: a table of time; or a start, speed, acceleration and a swing.
/// @param duration  of the run [s];  @param here  where the bodies of the scene are at its start
/// @throws SceneError, as does what follows
PrescribedMotion<double> read_motion(TableReader& table, double duration, const MotionWords& words, double here);

/// A driver that turns a body, or moves one along a guide that stands before it in the file.
AnyConstraint<double> read_driver(TableReader& table, const Scene& scene);

}  // namespace lubjoint

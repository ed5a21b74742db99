/// Running a scene in space, and what a run leaves.
#pragma once

#include "lubjoint/motion/spatial_results.hpp"
#include "lubjoint/scene/spatial_scene.hpp"
#include "lubjoint/scene/trajectory_table.hpp"

namespace lubjoint {

/// Trajectory and extremes of a scene in space.
struct SpatialTrajectory {
  RunOutcome outcome;                        ///< how it ended, and its counts
  StartCorrection<double> correction;        ///< what bringing the start onto the constraints has changed
  std::size_t rows = 0;                      ///< of the constraints
  std::size_t rank = 0;                      ///< independent ones of them
  std::vector<std::string> left_out;         ///< constraints with rows that the run does without, one entry a row
  std::vector<SpatialSample> samples;        ///< one each output interval, and the last state
  std::vector<SpatialJointExtremes> joints;  ///< in the scene's order
  std::vector<std::string> driver_names;     ///< in the scene's order
  std::vector<bool> driver_turns;            ///< is it a moment, and not a force?
  std::vector<DriverExtremes> drivers;       ///< their moments or forces, in the same order
  std::vector<ReactionExtremes> reactions;   ///< of the constraints that are no drivers, in the scene's order
  std::vector<SensorExtremes> sensors;       ///< of every value of every sensor, in the scene's order
  std::vector<ContactEvent> events;          ///< when a journal met or left its wall
  std::vector<JointSlide> slides;            ///< when half films slid along a = 0
  SpatialDrift drift;                        ///< how far constraints and Euler parameters were off
  std::optional<double> energy_residual;     ///< largest |E − E₀ − work| at the end of a step [J]
  double energy_scale = 0;                   ///< largest kinetic energy or work [J]
  double wall_seconds = 0;                   ///< that the run took
};

/// A system in space that is ready to run, and its start on the constraints.
struct PreparedSpatialScene {
  SpatialSystem<double> system;  ///< bodies, constraints, drivers, joints, forces
  std::vector<double> start;     ///< (q, v, work) on the constraints
  SpatialStart<double> found;    ///< correction, rows left out, rank
};

/// Brings a scene's start onto its constraints, and refuses what can't start.
/// @throws SceneError  constraints that repeat or contradict each other, a journal that starts outside its bearing or
///   across it, a film whose edge is at its wall, a spring of length 0
PreparedSpatialScene prepare_spatial(const SpatialScene& scene);

/// Integrates a scene in space.
/// @throws SceneError as prepare_spatial
SpatialTrajectory simulate_spatial(const SpatialScene& scene);

/// A run's samples: t; x, y, z, e0 … e3, vx, vy, vz, wx, wy, wz of all bodies (w in the body's axes); ex, ey, ez,
/// eccentricity_ratio, tilt, sliding, fx, fy, fz, film_thickness of all joints, and losses where they have a shear;
/// NAME.moment or NAME.force of the drivers, the ledger's energies and works, and the sensors' quantities.
TrajectoryTable trajectory_table(const SpatialScene& scene, const SpatialTrajectory& run);

}  // namespace lubjoint

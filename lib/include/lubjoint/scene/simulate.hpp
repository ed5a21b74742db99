/// Running a scene with the law and the integrator that it names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lubjoint/motion/journal_recorder.hpp"
#include "lubjoint/motion/multibody_results.hpp"
#include "lubjoint/multibody/start_correction.hpp"
#include "lubjoint/run/outcome.hpp"
#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

/// Trajectory and extremes of a journal in its bearing.
struct JournalTrajectory {
  RunOutcome outcome;                    ///< how it ended, and its counts
  std::vector<JournalSample> samples;    ///< one each output interval, and the last state
  std::vector<SlidingInterval> sliding;  ///< when a half film slid along a = 0
  double max_eccentricity_ratio = 0;     ///< largest ε
  double t_max_eccentricity_ratio = 0;   ///< when [s]
  double max_force = 0;                  ///< [N]
  double t_max_force = 0;                ///< when [s]
  double min_film_thickness = 0;         ///< c(1 − ε) [m]
  double wall_seconds = 0;               ///< that the run took
};

/// A position that a run passed although its constraints are not independent there.
struct PassedPosition {
  double t;                ///< [s]
  std::string constraint;  ///< that repeats others there
};

/// Trajectory and extremes of a multibody scene.
struct MultibodyTrajectory {
  RunOutcome outcome;                       ///< how it ended, and its counts
  StartCorrection<double> correction;       ///< what bringing the start onto the constraints has changed
  std::vector<MultibodySample> samples;     ///< one each output interval, and the last state
  std::vector<JointExtremes> joints;        ///< in the scene's order
  std::vector<std::string> driver_names;    ///< in the order of scene_drivers
  std::vector<DriverExtremes> drivers;      ///< their moments or forces, in the same order
  std::vector<ReactionExtremes> reactions;  ///< of the constraints that are no drivers, in the scene's order
  std::vector<SensorExtremes> sensors;      ///< of every value of every sensor, in the scene's order
  std::vector<PassedPosition> passed;       ///< singular positions, in a scene that passes them
  std::vector<ContactEvent> events;         ///< when a journal met or left its wall
  std::vector<JointSlide> slides;           ///< when half films slid along a = 0
  ConstraintDrift drift;                    ///< how far the constraints were off
  std::optional<double> energy_residual;    ///< largest |E − E₀ − work| at the end of a step [J]
  double energy_scale = 0;                  ///< largest kinetic energy or work [J]
  double wall_seconds = 0;                  ///< that the run took
};

/// Integrates any scene by constrained equations of motion.
/// @throws SceneError  constraints that repeat or contradict each other, a journal that starts outside its bearing
MultibodyTrajectory simulate_multibody(const Scene& scene);

/// Integrates a scene of one free journal, with or without mass.
/// @throws SceneError if the scene is none; std::invalid_argument for an unknown law or integrator
JournalTrajectory simulate_journal(const Scene& scene);

}  // namespace lubjoint

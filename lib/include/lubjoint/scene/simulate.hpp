/// Running a scene with the law and the integrator that it names.
#pragma once

#include <optional>
#include <vector>

#include "lubjoint/dynamics/journal_recorder.hpp"
#include "lubjoint/dynamics/outcome.hpp"
#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

/// Trajectory and extremes of a journal in its bearing.
struct JournalTrajectory {
  RunOutcome outcome;
  std::vector<JournalSample> samples;  ///< one each output interval, and the last state
  std::vector<SlidingInterval> sliding;
  double max_eccentricity_ratio = 0;
  double max_force = 0;           ///< [N]
  double min_film_thickness = 0;  ///< c(1 − ε) [m]
  double wall_seconds = 0;
};

/// Integrates a scene of one free journal.
/// @throws SceneError if the scene is none; std::invalid_argument for an unknown law or integrator
JournalTrajectory simulate_journal(const Scene& scene);

}  // namespace lubjoint

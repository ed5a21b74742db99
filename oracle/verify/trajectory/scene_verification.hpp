/// Verification of a trajectory of a scene, against our own simulation of it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oracle/verify/trajectory/deviation.hpp"

namespace lubjoint::verify {

/// A trajectory of the scene by its own integrator settings, as CSV would have it.
/// @throws UnjudgedError if the run stops; SceneError
Trajectory simulated(const Scene& scene);

/// Our own runs of a scene: one far below the accuracy that is asked for, and one at that accuracy, whose distance is
/// how much the scene enlarges errors.
struct SceneReference {
  Scene scene;
  double tolerance;              ///< that is asked for: of places in clearances, of the rest in the largest value
  double reference_tolerance;    ///< of the reference's integrator
  double sensitivity_tolerance;  ///< of the other run
  Trajectory run;
  std::vector<Yardstick> yardsticks;
};

/// @param tolerance  1e-6 to 0.1
SceneReference scene_reference(const Scene& scene, double tolerance);

/// What is wrong with a trajectory as a whole.
struct Suspect {
  std::string words;
  double share;  ///< of the failing signals' error, each over what is allowed
};

struct TrajectoryVerification {
  std::string scene;
  std::string law;  ///< of the joints; "none" without
  double tolerance, reference_tolerance, sensitivity_tolerance;
  std::vector<Deviation> deviations;
  std::vector<std::optional<Explanation>> explanations;  ///< of the failing ones; one a deviation
  std::vector<Suspect> suspects;                         ///< the likeliest first
  std::vector<std::string> not_read;                     ///< columns that say nothing about this scene
  std::vector<std::string> not_given;                    ///< signals that were not given
  double duration = 0;                                   ///< of the scene [s]

  bool agrees() const;
};

/// @param progress  called before each run that looks for the mistake; may be empty
/// @throws UnjudgedError if no column names a signal, or the scene is too sensitive to be judged
TrajectoryVerification verify_trajectory(const SceneReference& reference, std::string_view csv, const std::string& name,
                                         const std::function<void()>& progress = {});

}  // namespace lubjoint::verify

/// What may be wrong with a trajectory as a whole.
#pragma once

#include <functional>
#include <vector>

#include "oracle/verify/trajectory/scene_verification.hpp"

namespace lubjoint::verify {

/// The likeliest first, at most five: what the failing signals' errors have in common; and where that leaves more than
/// a fiftieth of the error, scenes with one number fitted or one change made, whose runs are the given trajectory.
/// If neither: the integrator's tolerance at which our own run is as wrong.
std::vector<Suspect> suspects(const SceneReference& reference, const TrajectoryVerification& verification,
                              const std::function<void()>& progress);

/// Runs that a search takes at most, for progress.
std::size_t runs_of_search(const Scene& scene);

}  // namespace lubjoint::verify

/// The checks of example 2. They take what was found and what it is held against, so that a test can falsify either.
#pragma once

#include <vector>

#include "lubjoint/scene/simulate.hpp"
#include "oracle/results/check.hpp"
#include "oracle/trajectories/slider_crank_reference.hpp"

namespace lubjoint::reports {

/// Relative and absolute tolerance of the runs that are checked, whose reasons rest on it.
inline constexpr double run_tolerance = 1e-10;

/// A run of a scene against the same mechanism in minimal coordinates: e/c, joint force, driving moment
/// and film thickness at all output times, and the peaks with their times.
std::vector<Check> compare_with_minimal_coordinates(const Scene& scene, const MultibodyTrajectory& run,
                                                    const ReferenceRun& reference);

/// The energy ledger of a run.
Check energy_check(const MultibodyTrajectory& run, double tolerance);

/// A run with bearing and journal exchanged against minimal coordinates with the bearing on the slider: e/c and peak
/// force.
Check swapped_check(const Scene& swapped, const MultibodyTrajectory& run, const ReferenceRun& reference);

}  // namespace lubjoint::reports

/// What people and programs read about the run of a scene in space: JSON, a few lines of text, warnings.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lubjoint/scene/spatial_simulate.hpp"
#include "oracle/results/squeeze_reynolds.hpp"

namespace lubjoint::reports {

/// The summary that scripts read; keys as of multibody scenes, and tilt, sliding, rank and rows left out.
nlohmann::ordered_json summary_json(const SpatialScene& scene, const SpatialTrajectory& run);
std::string summary_text(const SpatialScene& scene, const SpatialTrajectory& run);

/// Sizes and speeds that can hardly be meant, as in the plane.
std::vector<std::string> unit_warnings(const SpatialScene& scene);

/// What bringing the start onto the constraints has moved, as in the plane.
std::vector<std::string> correction_warnings(const SpatialScene& scene, const SpatialTrajectory& run);

/// The journal of a joint in its bearing at the samples of a run.
std::vector<SeenMotion> seen_motions(const SpatialScene& scene, std::size_t joint, const SpatialTrajectory& run);

/// Rows of constraints that the run does without, and what that means for reactions; a start that was moved; films that
/// were thinner than is safe, or whose edge the tilt took more than a tenth of, or all of. A sentence each.
std::vector<std::string> run_warnings(const SpatialScene& scene, const SpatialTrajectory& run);

}  // namespace lubjoint::reports

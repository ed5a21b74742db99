/// What people and programs read about the run of a multibody scene: CSV, JSON, a few lines of text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::reports {

/// Trajectory as CSV: t; of each body x, y, phi, vx, vy, omega; of each joint ex, ey, eccentricity_ratio, attitude
/// (from the x axis to e), fx, fy, film_thickness; of each driver its moment; the ledger's energies and works. SI
/// units.
std::string trajectory_csv(const Scene& scene, const MultibodyTrajectory& run);

/// The summary that scripts read; keys as documented for `simulate`, and what only such scenes have.
nlohmann::ordered_json summary_json(const Scene& scene, const MultibodyTrajectory& run);
std::string summary_text(const Scene& scene, const MultibodyTrajectory& run);

}  // namespace lubjoint::reports

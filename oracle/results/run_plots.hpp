/// What a run of any scene looks like: orbits, forces and film thickness of its joints.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::reports {

/// Draws SCENE-orbit, SCENE-force and SCENE-film as SVG and PNG, a panel a joint; without the film where no joint has
/// one.
/// @returns the files written
/// @throws OutputError if gnuplot is missing
std::vector<std::string> write_run_plots(const Scene& scene, const JournalTrajectory& run,
                                         const std::filesystem::path& folder);
std::vector<std::string> write_run_plots(const Scene& scene, const MultibodyTrajectory& run,
                                         const std::filesystem::path& folder);

}  // namespace lubjoint::reports

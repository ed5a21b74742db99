/// What people and programs read about the run of a multibody scene: CSV, JSON, a few lines of text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::reports {

/// The summary that scripts read; keys as documented for `simulate`, and what only such scenes have.
nlohmann::ordered_json summary_json(const Scene& scene, const MultibodyTrajectory& run);
std::string summary_text(const Scene& scene, const MultibodyTrajectory& run);

}  // namespace lubjoint::reports

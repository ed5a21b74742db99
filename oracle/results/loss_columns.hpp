/// What a summary says of a joint's friction.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lubjoint/motion/multibody_results.hpp"

namespace lubjoint::reports {

/// Adds the four to the final state of a joint; what is not defined is null.
void add_losses(nlohmann::ordered_json& final_state, const LossSample& losses);

/// A line of a summary.
std::string loss_text(const LossSample& losses);

}  // namespace lubjoint::reports

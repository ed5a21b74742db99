/// What a trajectory and a summary say of a joint's friction.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lubjoint/motion/multibody_results.hpp"

namespace lubjoint::reports {

/// ",NAME.torque_journal,NAME.torque_bearing,NAME.power,NAME.side_flow"
std::string loss_header(const std::string& joint);

/// The four numbers, each behind its comma; what is not defined is an empty field.
std::string loss_fields(const LossSample& losses);

/// Adds the four to the final state of a joint; what is not defined is null.
void add_losses(nlohmann::ordered_json& final_state, const LossSample& losses);

/// A line of a summary.
std::string loss_text(const LossSample& losses);

}  // namespace lubjoint::reports

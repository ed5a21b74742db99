/// What a user is told about a trajectory.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "oracle/verify/trajectory/golden_trajectory.hpp"

namespace lubjoint::verify {

std::string text_report(const TrajectoryVerification& verification, const std::optional<GoldenAgreement>& golden);
nlohmann::ordered_json json_report(const TrajectoryVerification& verification,
                                   const std::optional<GoldenAgreement>& golden);

}  // namespace lubjoint::verify

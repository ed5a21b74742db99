#include "oracle/results/loss_columns.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lubjoint/scene/trajectory_table.hpp"

namespace lubjoint::reports {

void add_losses(nlohmann::ordered_json& final_state, const LossSample& losses) {
  for (const auto& [name, value] : named_losses(losses)) {
    final_state[name] = value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
  }
}

std::string loss_text(const LossSample& losses) {
  if (!losses.power) return "  losses     none: dry contact\n";
  std::string text =
      fmt::format("  losses     torque {:.6g} N m on the journal, {:.6g} N m on the bearing, power {:.6g} W",
                  *losses.torque_journal, *losses.torque_bearing, *losses.power);
  if (losses.side_flow) text += fmt::format(", side flow {:.6g} m^3/s", *losses.side_flow);
  return text + "\n";
}

}  // namespace lubjoint::reports

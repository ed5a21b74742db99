#include "oracle/results/loss_columns.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "oracle/files/files.hpp"

namespace lubjoint::reports {

namespace {

std::array<std::pair<const char*, std::optional<double>>, 4> named(const LossSample& losses) {
  return {{{"torque_journal", losses.torque_journal},
           {"torque_bearing", losses.torque_bearing},
           {"power", losses.power},
           {"side_flow", losses.side_flow}}};
}

}  // namespace

std::string loss_header(const std::string& joint) {
  std::string header;
  for (const auto& [name, value] : named({})) header += "," + joint + "." + name;
  return header;
}

std::string loss_fields(const LossSample& losses) {
  std::string fields;
  for (const auto& [name, value] : named(losses)) fields += "," + (value ? number(*value) : std::string());
  return fields;
}

void add_losses(nlohmann::ordered_json& final_state, const LossSample& losses) {
  for (const auto& [name, value] : named(losses)) {
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

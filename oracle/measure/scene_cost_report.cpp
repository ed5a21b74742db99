#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "oracle/measure/scene_cost.hpp"

namespace lubjoint::reports {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* no_solve = "a free journal: no constraint, so no multipliers and no linear solve";

std::string films_of(const SceneCost& cost) {
  std::string text;
  for (const auto& [law, count] : cost.films) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, law);
  return text.empty() ? "no film" : text;
}

std::string events_of(const SceneCost& cost) {
  std::string text;
  if (cost.contact_seams > 0) text += fmt::format("{} seams of contact", cost.contact_seams);
  if (cost.film_jumps > 0) text += fmt::format("{}{} jump of a half film", text.empty() ? "" : ", ", cost.film_jumps);
  return text.empty() ? "none" : text;
}

}  // namespace

Json cost_json(const SceneCost& cost) {
  Json films = Json::object();
  for (const auto& [law, count] : cost.films) films[law] = count;
  Json parts = Json::array();
  for (const CostPart& part : cost.parts) {
    parts.push_back({{"name", part.name}, {"ns", part.nanoseconds}, {"share", part.share}});
  }
  const auto variants = [&](bool in_scene) {
    Json list = Json::array();
    for (const CostVariant& variant : cost.variants) {
      if (variant.in_scene != in_scene) continue;
      list.push_back({{"feature", variant.feature},
                      {"change", variant.change},
                      {"rhs_ns", variant.nanoseconds},
                      {"ratio", variant.ratio}});
    }
    return list;
  };
  const auto others = [](const std::vector<OtherCost>& costs) {
    Json list = Json::array();
    for (const OtherCost& each : costs) {
      list.push_back({{"what", each.what}, {"ns", each.nanoseconds}, {"ratio", each.ratio}});
    }
    return list;
  };
  Json force_terms{{"films", films}, {"contacts", cost.contacts}, {"loads", cost.loads}, {"weights", cost.weights}};
  if (cost.springs > 0) force_terms["springs"] = cost.springs;
  return {{"scene", cost.scene},
          {"equations", cost.free_journal ? "free journal"
                        : cost.in_space   ? "constrained bodies in space"
                                          : "constrained bodies"},
          {"message", cost.free_journal ? no_solve : ""},
          {"bodies", cost.bodies},
          {"coordinates", cost.coordinates},
          {"states", cost.states},
          {"constraints", cost.constraints},
          {"constraint_rows", cost.constraint_rows},
          {"multipliers", cost.constraint_rows},
          {"constraint_jacobian_nonzeros", cost.constraint_nonzeros},
          {"rhs_jacobian_nonzeros", cost.rate_nonzeros},
          {"schur_stored", cost.schur_stored},
          {"force_terms", force_terms},
          {"events", {{"contact_seams", cost.contact_seams}, {"film_jumps", cost.film_jumps}}},
          {"ledger_terms", cost.ledger_terms},
          {"rhs_ns", cost.nanoseconds},
          {"parts", parts},
          {"jacobian",
           {{"passes", cost.jacobian_passes}, {"ns", cost.jacobian_nanoseconds}, {"ratio", cost.jacobian_ratio}}},
          {"runs_in", cost.runs_in},
          {"runs_in_reason", cost.runs_in_reason},
          {"independent_coordinates", others(cost.independent)},
          {"left_out", variants(false)},
          {"in_use", variants(true)},
          {"phases", others(cost.phases)},
          {"by_step", others(cost.steps)}};
}

std::string cost_text(const SceneCost& cost) {
  std::string text = fmt::format("scene          {}\nbodies         {}: {} coordinates, {} states\n", cost.scene,
                                 cost.bodies, cost.coordinates, cost.states);
  if (!cost.runs_in.empty()) {
    text += fmt::format("runs in        {} coordinates{}\n", cost.runs_in,
                        cost.runs_in_reason.empty() ? "" : ": " + cost.runs_in_reason);
  }
  if (cost.free_journal) {
    text += fmt::format("constraints    none; {}\n", no_solve);
  } else {
    const std::size_t full = cost.constraint_rows * (cost.constraint_rows + 1) / 2;
    text += fmt::format(
        "constraints    {}: {} rows and multipliers, Jacobian {} non-zeros of {}, Schur envelope {} numbers of {}\n",
        cost.constraints, cost.constraint_rows, cost.constraint_nonzeros, cost.constraint_rows * cost.velocities,
        cost.schur_stored, full);
  }
  const std::string springs = cost.springs > 0 ? fmt::format(", {} springs", cost.springs) : "";
  text += fmt::format(
      "force terms    {}, {} contacts, {} loads, {} weights{}\nevents         {}\nledger         {} terms\n",
      films_of(cost), cost.contacts, cost.loads, cost.weights, springs, events_of(cost), cost.ledger_terms);
  text += fmt::format("\n{:<50} {:>9.1f} ns\n", "one right-hand side", cost.nanoseconds);
  for (const CostPart& part : cost.parts) {
    text += fmt::format("  {:<48} {:>9.1f} ns {:>7.1f} %\n", part.name, part.nanoseconds, 100 * part.share);
  }
  text += fmt::format("{:<50} {:>9.1f} ns {:>7.2f} x, {} passes, {} non-zeros of {}\n", "its exact Jacobian",
                      cost.jacobian_nanoseconds, cost.jacobian_ratio, cost.jacobian_passes, cost.rate_nonzeros,
                      cost.states * cost.states);
  for (const OtherCost& step : cost.steps) {
    text += fmt::format("{:<50} {:>9.1f} ns {:>7.2f} x, once a step if asked for\n", step.what, step.nanoseconds,
                        step.ratio);
  }
  for (const OtherCost& each : cost.independent) {
    text += fmt::format("{:<50} {:>9.1f} ns {:>7.2f} x\n", each.what, each.nanoseconds, each.ratio);
  }
  for (const OtherCost& phase : cost.phases) {
    text +=
        fmt::format("{:<50} {:>9.1f} ns {:>7.2f} x\n", "right-hand side " + phase.what, phase.nanoseconds, phase.ratio);
  }
  for (const bool in_scene : {false, true}) {
    text +=
        in_scene ? "\nin use, and the right-hand side without it\n" : "\nleft out, and the right-hand side with it\n";
    if (std::ranges::none_of(cost.variants, [&](const CostVariant& each) { return each.in_scene == in_scene; })) {
      text += "  nothing of what is measured here\n";
    }
    for (const CostVariant& variant : cost.variants) {
      if (variant.in_scene != in_scene) continue;
      text += fmt::format("  {:<48} {:>9.1f} ns {:>7.2f} x  ({})\n", variant.feature, variant.nanoseconds,
                          variant.ratio, variant.change);
    }
  }
  return text;
}

}  // namespace lubjoint::reports

#include "oracle/results/assembly_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lubjoint::reports {

namespace {

/// How the other branches were looked for.
std::string search_words(const SceneAssembly& assembly) {
  if (assembly.freedoms > 0) {
    return fmt::format(
        "{} coordinates are free: one position of many, near the guesses; other branches are not looked for "
        "(--angle NAME=VALUE holds a body)",
        assembly.freedoms);
  }
  return fmt::format("{} {} from the guesses and {} other starts", assembly.branches.size(),
                     assembly.branches.size() == 1 ? "branch" : "branches", assembly.other_starts);
}

}  // namespace

std::string sign_words(const AssemblySign& sign, int value) {
  if (value == 0) return sign.of_guide ? "across" : "aligned";
  if (sign.of_guide) return value > 0 ? "forwards" : "backwards";
  return value > 0 ? "counter-clockwise" : "clockwise";
}

nlohmann::ordered_json assembly_json(const Scene& scene, const SceneAssembly& assembly) {
  using Json = nlohmann::ordered_json;
  Json branches = Json::array();
  for (std::size_t i = 0; i < assembly.branches.size(); ++i) {
    const AssemblyBranch& branch = assembly.branches[i];
    Json signs = Json::object();
    for (std::size_t k = 0; k < assembly.signs.size(); ++k)
      signs[assembly.signs[k].name] = sign_words(assembly.signs[k], branch.signs[k]);
    Json bodies = Json::array();
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const double* q = &branch.state[3 * b];
      const double* v = q + branch.state.size() / 2;
      bodies.push_back({{"name", scene.bodies[b].name},
                        {"position", {q[0], q[1]}},
                        {"angle", q[2]},
                        {"velocity", {v[0], v[1]}},
                        {"spin", v[2]}});
    }
    branches.push_back({{"number", i + 1},
                        {"moves", branch.correction.position},
                        {"turns", branch.correction.angle},
                        {"velocity", branch.correction.velocity},
                        {"spin", branch.correction.spin},
                        {"signs", signs},
                        {"bodies", bodies}});
  }
  return {{"scene", scene.name},
          {"freedoms", assembly.freedoms},
          {"guesses_lead", assembly.guesses_lead},
          {"other_starts", assembly.other_starts},
          {"arrived", assembly.arrived},
          {"branches", branches}};
}

std::string assembly_text(const Scene& scene, const SceneAssembly& assembly) {
  std::string text = fmt::format("scene        {}\nassembly     {}\n", scene.name, search_words(assembly));
  if (!assembly.guesses_lead)
    text += "guesses      lead nowhere: the nearest of the branches that other starts led to is first\n";
  text += fmt::format("\n{:<8} {:>10} {:>12} {:>15} {:>14}", "branch", "moves [m]", "turns [rad]", "velocity [m/s]",
                      "spin [rad/s]");
  for (const AssemblySign& sign : assembly.signs) text += "  " + sign.name;
  text += '\n';
  for (std::size_t i = 0; i < assembly.branches.size(); ++i) {
    const AssemblyBranch& branch = assembly.branches[i];
    const StartCorrection<double>& c = branch.correction;
    text +=
        fmt::format("{:<8} {:>10.4g} {:>12.4g} {:>15.4g} {:>14.4g}", i + 1, c.position, c.angle, c.velocity, c.spin);
    for (std::size_t k = 0; k < assembly.signs.size(); ++k) {
      const std::string words = sign_words(assembly.signs[k], branch.signs[k]);
      const bool last = k + 1 == assembly.signs.size();
      text += "  " + (last ? words : fmt::format("{:<{}}", words, assembly.signs[k].name.size()));
    }
    text += '\n';
  }
  return text;
}

}  // namespace lubjoint::reports

#include "oracle/verify/trajectory/golden_trajectory.hpp"

#include <algorithm>
#include <cmath>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::verify {

namespace {

namespace fs = std::filesystem;

/// Name of the golden file for a scene that ships; empty for others.
std::string golden_file(const Scene& scene, const fs::path& scenes) {
  const fs::path shipped = scenes / (scene.name + ".toml");
  if (!fs::exists(shipped) || reports::read_input(scene.file) != reports::read_input(shipped.string())) return {};
  if (is_free_journal(scene)) return scene.name + "-" + scene.joints.front().film + ".csv";
  const Scene as_shipped = load_scene(shipped);
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    if (scene.joints[j].film != as_shipped.joints[j].film) return {};
  }
  return scene.name + ".csv";
}

/// The columns as trajectories of scenes have them: e in metres, all with the joint's name.
void rename_columns(const Scene& scene, Trajectory& golden) {
  for (const SceneJoint& joint : scene.joints) {
    for (const char* axis : {"x", "y"}) {
      const std::string name = joint.name + ".";
      if (golden.has(std::string("f") + axis))
        golden.columns[name + "f" + axis] = golden.columns[std::string("f") + axis];
      for (const std::string& prefix : {std::string(), name}) {
        const auto found = golden.columns.find(prefix + "e" + axis + "_over_c");
        if (found == golden.columns.end()) continue;
        std::vector<double> e = found->second;
        for (double& value : e) value *= joint.clearance;
        golden.columns[name + "e" + axis] = std::move(e);
      }
    }
  }
}

}  // namespace

std::optional<GoldenAgreement> golden_agreement(const SceneReference& reference, const fs::path& scenes,
                                                const fs::path& golden) {
  const std::string name = golden_file(reference.scene, scenes);
  const fs::path file = golden / "trajectories" / name;
  if (name.empty() || !fs::exists(file)) return {};
  Trajectory table = read_trajectory(reports::read_input(file.string()), file.string());
  rename_columns(reference.scene, table);
  end_films_in_contact(reference.scene, table);
  GoldenAgreement agreement{name, 0, 0, 1e-2 * reference.tolerance};
  const std::vector<double>& t = reference.run.t;
  for (std::size_t i = 0; i < table.t.size(); ++i) {
    // Only at the run's own times: between them its samples say less than it knows.
    const auto place = std::ranges::lower_bound(t, table.t[i] * (1 - 1e-12));
    if (place == t.end() || *place > table.t[i] * (1 + 1e-12)) continue;
    ++agreement.times;
    const auto k = static_cast<std::size_t>(place - t.begin());
    for (const Yardstick& yardstick : reference.yardsticks) {
      double squared = 0;
      for (const std::string& column : yardstick.signal.columns) {
        if (!table.has(column)) continue;
        squared += std::pow(table.columns.at(column)[i] - reference.run.columns.at(column)[k], 2);
      }
      agreement.worst = std::max(agreement.worst, std::sqrt(squared) / yardstick.signal.scale);
    }
  }
  return agreement.times > 0 ? std::optional(agreement) : std::nullopt;
}

}  // namespace lubjoint::verify

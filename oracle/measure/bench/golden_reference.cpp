#include "oracle/measure/bench/golden_reference.hpp"

#include <algorithm>
#include <filesystem>

#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/data_folder.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::reports {

namespace {

namespace fs = std::filesystem;

/// Is the scene's file one of those that ship, to the byte?
bool ships(const Scene& scene) {
  const fs::path file(scene.file);
  const fs::path shipped = data_folder() / "scenes" / file.filename();
  return fs::is_regular_file(file) && fs::is_regular_file(shipped) &&
         read_input(file.string()) == read_input(shipped.string());
}

}  // namespace

std::optional<GoldenReference> golden_reference(const Scene& scene) {
  if (!ships(scene)) return std::nullopt;
  const bool journal = is_free_journal(scene);
  std::string name = fs::path(scene.file).stem().string();
  if (journal) name += "-" + scene.joints[0].film;
  const fs::path file = data_folder() / "golden" / "trajectories" / (name + ".csv");
  if (!fs::is_regular_file(file)) return std::nullopt;
  const CsvTable table(read_input(file.string()), file.string());
  GoldenReference golden{{}, {}, 0};
  const double size = scene_units(scene).mechanism;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = [&](const std::string& column) { return table.number(row, table.column(column)); };
    golden.times.push_back(value("t"));
    golden.disagreement = std::max(golden.disagreement, value("disagreement"));
    if (journal) golden.seen.emplace_back(value("ex_over_c"), value("ey_over_c"));
    for (const SceneJoint& joint : scene.joints) {
      if (!journal) golden.seen.emplace_back(value(joint.name + ".ex_over_c"), value(joint.name + ".ey_over_c"));
    }
    if (!scene.joints.empty()) continue;
    for (const SceneBody& body : scene.bodies) {
      golden.seen.emplace_back(value(body.name + ".x") / size, value(body.name + ".y") / size);
      golden.seen.emplace_back(value(body.name + ".phi"), 0.0);
    }
  }
  return golden;
}

}  // namespace lubjoint::reports

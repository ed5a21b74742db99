#include <iostream>
#include <nlohmann/json.hpp>

#include "lubjoint/scene/spatial_scene_file.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/cli/scene_options.hpp"
#include "oracle/files/files.hpp"
#include "oracle/laws/scene_run.hpp"
#include "oracle/results/journal_report.hpp"
#include "oracle/results/multibody_report.hpp"
#include "oracle/results/run_plots.hpp"
#include "oracle/results/spatial_report.hpp"
#include "oracle/results/trajectory_csv.hpp"

namespace lubjoint::cli {

namespace {

/// Where a run is to go, and how.
struct Output {
  std::optional<std::string> folder;  ///< of the trajectory and the plots
  bool plot = false;
  bool json = false;
};

/// Trajectory to a file if asked for, summary to standard output.
template <class SceneType, class Trajectory>
void report(const SceneType& scene, const Trajectory& run, const std::optional<reports::LateExtremes>& late,
            const Output& output) {
  if (output.folder) {
    const auto file = std::filesystem::path(*output.folder) / (scene.name + ".csv");
    reports::write_file(file, reports::trajectory_csv(trajectory_table(scene, run)));
    std::cerr << "trajectory written to " << file.string() << '\n';
  }
  if (output.json) {
    nlohmann::ordered_json summary = reports::summary_json(scene, run);
    if constexpr (std::is_same_v<SceneType, Scene>) {
      if (late) reports::add_late_extremes(summary, scene, *late);
    }
    std::cout << summary.dump(2) << '\n';
  } else {
    std::cout << reports::summary_text(scene, run);
    if constexpr (std::is_same_v<SceneType, Scene>) {
      if (late) std::cout << reports::late_extremes_text(scene, *late);
    }
  }
}

/// Last of all: gnuplot may be missing or fail, and the run is not to be lost.
template <class Trajectory>
void plot(const Scene& scene, const Trajectory& run, const Output& output) {
  if (!output.plot) return;
  std::string files;
  for (const std::string& name : reports::write_run_plots(scene, run, *output.folder)) files += " " + name;
  std::cerr << "plots:" << files << '\n';
}

void warn(const std::string& warning) { std::cerr << warning << '\n'; }

template <class SceneType>
int simulate(const SceneType& scene, const std::optional<double>& after, const Output& output) {
  reports::warn_before(scene, warn);
  return reports::with_run(scene, [&](const auto& run) {
    std::optional<reports::LateExtremes> late;
    if constexpr (std::is_same_v<SceneType, Scene>) late = reports::late_extremes_of(scene, run.outcome, after, warn);
    report(scene, run, late, output);
    reports::warn_after(scene, run, warn);
    if constexpr (std::is_same_v<SceneType, Scene>) plot(scene, run, output);
    return run.outcome.status == RunStatus::finished ? 0 : 1;
  });
}

/// What is for scenes in the plane alone. @throws std::invalid_argument
void require_none_in_space(const LateOptions& late, const Output& output) {
  late.require_none_in_space();
  if (output.plot) {
    throw std::invalid_argument("--plot is for scenes in the plane, and this one is in space; allowed without it");
  }
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  struct SimulateOptions : SceneOptions, LateOptions, Output {};
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = app.add_subcommand("simulate", words_of("simulate"));
  options->add_file(*command);
  options->add_law(*command);
  options->add_run(*command);
  options->add_late(*command);
  CLI::Option* out = command->add_option("--out", options->folder, "Folder for the trajectory, SCENE.csv");
  command->add_flag("--plot", options->plot, "Orbit, forces and film thickness as SVG and PNG beside the trajectory")
      ->needs(out);
  command->add_flag("--json", options->json, "Summary as one JSON object");
  command->callback([options, &action] {
    action = [options] {
      options->LateOptions::require();
      const SceneFile file(options->file);
      if (scene_dimension(file) == 3) require_none_in_space(*options, *options);
      const reports::SceneToRun scene = reports::scene_to_run(file, *options, scene_films());
      std::optional<double> after;
      if (const auto* plane = std::get_if<Scene>(&scene)) {
        after = options->start(*plane);
        if (options->plot && plane->joints.empty()) {
          throw std::invalid_argument(
              "--plot draws joints, and the scene has none; allowed is a scene with [[joints]]");
        }
      }
      if (options->folder) reports::prepare_folder(*options->folder);
      return std::visit([&](const auto& each) { return simulate(each, after, *options); }, scene);
    };
  });
}

}  // namespace lubjoint::cli

#include <iostream>
#include <nlohmann/json.hpp>

#include "lubjoint/scene/journal_scene.hpp"
#include "oracle/cli/scene_options.hpp"
#include "oracle/files/files.hpp"
#include "oracle/laws/model_error.hpp"
#include "oracle/results/film_resolution.hpp"
#include "oracle/results/journal_report.hpp"
#include "oracle/results/multibody_report.hpp"
#include "oracle/results/trajectory_csv.hpp"

namespace lubjoint::cli {

namespace {

/// Trajectory to a file if asked for, summary to standard output.
template <class Trajectory>
void report(const Scene& scene, const Trajectory& run, const std::optional<std::string>& out, bool json) {
  if (out) {
    const auto file = std::filesystem::path(*out) / (scene.name + ".csv");
    reports::write_file(file, reports::trajectory_csv(scene, run));
    std::cerr << "trajectory written to " << file.string() << '\n';
  }
  if (json) {
    std::cout << reports::summary_json(scene, run).dump(2) << '\n';
  } else {
    std::cout << reports::summary_text(scene, run);
  }
}

/// Where the film model itself is in doubt, or the tolerance too coarse for the film.
void warn(const Scene& scene, const SceneJoint& joint, const RunOutcome& outcome, double thinnest_film,
          const reports::VisitedModelError& error) {
  for (const std::string& warning :
       {reports::resolution_warning(scene, joint, thinnest_film),
        reports::kink_warning(scene, joint, outcome.integrator), reports::model_warning(joint, error)}) {
    if (!warning.empty()) std::cerr << warning << '\n';
  }
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  struct Options : SceneOptions {
    std::optional<std::string> out;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("simulate", "Run one scene: trajectory as CSV, and a summary");
  options->add_file(*command);
  options->add_law(*command);
  options->add_run(*command);
  command->add_option("--out", options->out, "Folder for the trajectory, SCENE.csv");
  command->add_flag("--json", options->json, "Summary as one JSON object");
  command->callback([options, &action] {
    action = [options] {
      const Scene scene = options->load();
      if (is_free_journal(scene)) journal_scene(scene);  // refuses what it can before a folder is made
      if (options->out) reports::prepare_folder(*options->out);
      if (is_free_journal(scene)) {
        const JournalTrajectory run = simulate_journal(scene);
        report(scene, run, options->out, options->json);
        warn(scene, scene.joints[0], run.outcome, reports::thinnest_film(scene, run),
             reports::visited_model_error(scene, run));
        return run.outcome.status == RunStatus::finished ? 0 : 1;
      }
      const MultibodyTrajectory run = simulate_multibody(scene);
      report(scene, run, options->out, options->json);
      for (std::size_t j = 0; j < scene.joints.size(); ++j) {
        warn(scene, scene.joints[j], run.outcome, reports::thinnest_film(scene, j, run),
             reports::visited_model_error(scene, j, run));
      }
      return run.outcome.status == RunStatus::finished ? 0 : 1;
    };
  });
}

}  // namespace lubjoint::cli

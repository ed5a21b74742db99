#include <iostream>
#include <nlohmann/json.hpp>

#include "lubjoint/scene/journal_scene.hpp"
#include "oracle/cli/scene_options.hpp"
#include "oracle/reports/files.hpp"
#include "oracle/reports/journal_report.hpp"
#include "oracle/reports/model_error.hpp"

namespace lubjoint::cli {

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
      journal_scene(scene);  // refuses what is no journal before a folder is made
      if (options->out) reports::prepare_folder(*options->out);
      const JournalTrajectory run = simulate_journal(scene);
      if (options->out) {
        const auto file = std::filesystem::path(*options->out) / (scene.name + ".csv");
        reports::write_file(file, reports::trajectory_csv(scene, run));
        std::cerr << "trajectory written to " << file.string() << '\n';
      }
      if (options->json) {
        std::cout << reports::summary_json(scene, run).dump(2) << '\n';
      } else {
        std::cout << reports::summary_text(scene, run);
      }
      const std::string warning = reports::model_warning(scene, reports::visited_model_error(scene, run));
      if (!warning.empty()) std::cerr << warning << '\n';
      return run.outcome.status == RunStatus::finished ? 0 : 1;
    };
  });
}

}  // namespace lubjoint::cli

#include "oracle/certified/golden.hpp"

#include <filesystem>
#include <iostream>
#include <memory>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/reports/csv_table.hpp"
#include "oracle/reports/files.hpp"
#include "oracle/reports/golden_files.hpp"
#include "oracle/reports/trajectories/journal_trajectory.hpp"
#include "oracle/reports/progress.hpp"

namespace lubjoint::cli {

namespace {

struct GoldenOptions {
  std::string out = LUBJOINT_GOLDEN;
  bool check = false;
  bool trajectories = false;
  bool fresh = false;
  certified::GoldenRun run;
};

int run_golden(const GoldenOptions& options) {
  std::unique_ptr<reports::ProgressBar> bar;  // made when the number of rows is known
  certified::GoldenRun run = options.run;
  run.progress = [&bar](std::size_t, std::size_t all) {
    if (!bar) bar = std::make_unique<reports::ProgressBar>("golden data", all);
    bar->advance();
  };
  if (!options.check) {
    certified::write_golden(options.out, run);
    bar.reset();
    std::cerr << "golden data written to " << options.out << '\n';
    return 0;
  }
  const auto differences = certified::check_golden(options.out, run);
  bar.reset();
  for (const reports::GoldenDifference& difference : differences) std::cout << difference.text() << '\n';
  if (differences.empty()) std::cout << options.out << ": every byte as regenerated\n";
  return differences.empty() ? 0 : 1;
}

/// Trajectories: one file a law, each written when it is done, so that an interrupted run goes on where it was.
int run_trajectories(const GoldenOptions& options) {
  namespace fs = std::filesystem;
  const Scene scene = load_scene(fs::path(LUBJOINT_SCENES) / "journal.toml");
  const SceneBody& body = scene.bodies.front();
  const SceneJoint& joint = scene.joints.front();
  const Vector2<double>& load = scene.loads.front().force;
  const reports::JournalCase journal{joint.length,
                                     joint.journal_radius,
                                     joint.clearance,
                                     joint.viscosity,
                                     body.mass,
                                     {load.x(), load.y()},
                                     {scene.gravity.x(), scene.gravity.y()},
                                     body.spin,
                                     reports::reference_times(scene.run.duration)};
  constexpr double tolerance = 1e-17;  // the two integrators then agree to about 16 digits
  const fs::path folder = fs::path(options.out) / "trajectories";
  if (!options.check) reports::prepare_folder(folder);
  bool same = true;
  for (const std::string_view law : film_law_names) {
    const fs::path file = folder / ("journal-" + std::string(law) + ".csv");
    if (!options.check && fs::exists(file) && !options.fresh) {
      std::cerr << file.string() << " is there already (--fresh makes it anew)\n";
      continue;
    }
    const auto trajectory = reports::reference_trajectory(std::string(law), journal, tolerance);
    const std::string csv = reports::trajectory_reference_csv(trajectory);
    std::cerr << file.string() << ": two integrators agree to " << trajectory.agreed_digits << " digits\n";
    if (!options.check) {
      reports::write_file(file, csv);
      continue;
    }
    const reports::CsvTable expected(csv, "regenerated");
    std::vector<std::string> rows;
    for (std::size_t i = 0; i < expected.rows(); ++i) rows.push_back(expected.line(i));
    for (const auto& difference : reports::csv_differences(file.filename().string(), expected.header(), rows,
                                                           reports::read_input(file.string()))) {
      std::cout << difference.text() << '\n';
      same = false;
    }
  }
  if (!options.check) {
    std::vector<reports::GoldenFile> files;
    for (const std::string_view law : film_law_names) {
      const std::string name = "journal-" + std::string(law) + ".csv";
      files.push_back({name, reports::read_input((folder / name).string())});
    }
    reports::write_file(folder / reports::golden_manifest_name, reports::golden_manifest(files));
    return 0;
  }
  for (const auto& difference : reports::manifest_differences(folder)) {
    std::cout << difference.text() << '\n';
    same = false;
  }
  if (same) std::cout << folder.string() << ": every byte as regenerated\n";
  return same ? 0 : 1;
}

}  // namespace

void add_golden(CLI::App& app, Action& action) {
  auto options = std::make_shared<GoldenOptions>();
  CLI::App* command = app.add_subcommand("golden", "Regenerate the certified golden data, or compare with it");
  command->add_flag("--check", options->check, "Compare byte for byte instead of writing; exit status 1 if different");
  command->add_option("--out", options->out, "Folder of the golden data")->capture_default_str();
  command->add_option("--threads", options->run.threads, "Threads; 0: one a core")->check(CLI::Range(0, 256));
  command
      ->add_option("--every", options->run.every,
                   "With --check: only every so manyth row of the files whose checksum is right")
      ->check(CLI::Range(1, 1000000));
  command->add_flag("--trajectories", options->trajectories, "The trajectories, a step of its own: some 20 minutes");
  command->add_flag("--fresh", options->fresh, "With --trajectories: also those that are there");
  command->callback([options, &action] {
    action = [options] {
      if (options->run.every > 1 && !options->check) {
        throw std::invalid_argument("--every is for --check; allowed is to write all rows or none");
      }
      return options->trajectories ? run_trajectories(*options) : run_golden(*options);
    };
  });
}

}  // namespace lubjoint::cli

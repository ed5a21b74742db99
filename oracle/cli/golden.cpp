#include "oracle/certified/golden.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "oracle/certified/finite_length.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/files/golden_files.hpp"
#include "oracle/files/progress.hpp"
#include "oracle/trajectories/golden_trajectories.hpp"

namespace lubjoint::cli {

namespace {

struct GoldenOptions {
  std::string out = golden_folder();
  bool check = false;
  bool trajectories = false;
  bool finite_length = false;
  bool fresh = false;
  certified::GoldenRun run;
};

int run_golden(const GoldenOptions& options) {
  std::unique_ptr<reports::ProgressBar> bar;  // made when the number of rows is known
  certified::GoldenRun run = options.run;
  std::size_t rows = 0;  // that are made again
  run.progress = [&bar, &rows](std::size_t, std::size_t all) {
    rows = all;
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
  if (differences.empty() && run.every == 1) std::cout << options.out << ": every byte as regenerated\n";
  if (differences.empty() && run.every > 1) {
    std::cout << options.out << ": every checksum is that of the manifest; of the rows one in " << run.every << " ("
              << rows << " rows) was made again, and is the same\n";
  }
  return differences.empty() ? 0 : 1;
}

int run_finite_length(const GoldenOptions& options) {
  const std::filesystem::path folder = std::filesystem::path(options.out) / "finite_length";
  std::unique_ptr<reports::ProgressBar> bar;
  certified::GoldenRun run = options.run;
  run.progress = [&bar](std::size_t, std::size_t all) {
    if (!bar) bar = std::make_unique<reports::ProgressBar>("films of finite length", all);
    bar->advance();
  };
  if (!options.check) {
    certified::write_finite_golden(folder, run);
    bar.reset();
    std::cerr << "films of finite length written to " << folder.string() << '\n';
    return 0;
  }
  const auto differences = certified::check_finite_golden(folder, run);
  bar.reset();
  for (const reports::GoldenDifference& difference : differences) std::cout << difference.text() << '\n';
  if (differences.empty()) std::cout << folder.string() << ": every number made again is within the uncertainties\n";
  return differences.empty() ? 0 : 1;
}

int run_trajectories(const GoldenOptions& options) {
  const std::filesystem::path folder = std::filesystem::path(options.out) / "trajectories";
  const auto trajectories = reports::golden_trajectories(scenes_folder());
  reports::TrajectoryRun run{options.run.threads, options.fresh,
                             [](const std::string& line) { std::cerr << line << std::endl; }};
  if (!options.check) {
    reports::write_golden_trajectories(folder, trajectories, run);
    std::cerr << "trajectories written to " << folder.string() << '\n';
    return 0;
  }
  const auto differences = reports::check_golden_trajectories(folder, trajectories, run);
  for (const reports::GoldenDifference& difference : differences) std::cout << difference.text() << '\n';
  if (differences.empty()) std::cout << folder.string() << ": every byte as regenerated\n";
  return differences.empty() ? 0 : 1;
}

}  // namespace

void add_golden(CLI::App& app, Action& action) {
  auto options = std::make_shared<GoldenOptions>();
  CLI::App* command = app.add_subcommand("golden", words_of("golden"));
  command->add_flag("--check", options->check, "Compare byte for byte instead of writing; exit status 1 if different");
  command->add_option("--out", options->out, "Folder of the golden data")->capture_default_str();
  command->add_option("--threads", options->run.threads, "Threads; 0: one a core")->check(CLI::Range(0, 256));
  command
      ->add_option("--every", options->run.every,
                   "With --check: makes one row in N again, of the files whose checksum is right")
      ->check(CLI::Range(1, 1000000));
  command->add_flag("--trajectories", options->trajectories, "The trajectories, a step of its own: some 7 minutes");
  command->add_flag("--finite-length", options->finite_length,
                    "The films of finite length, a step of its own: some minutes");
  command->add_flag("--fresh", options->fresh, "With --trajectories: also those that are there");
  command->callback([options, &action] {
    action = [options] {
      if (options->fresh && (options->check || !options->trajectories)) {
        throw std::invalid_argument("--fresh is for writing the trajectories; allowed is with --trajectories alone");
      }
      if (options->run.every > 1 && options->trajectories) {
        throw std::invalid_argument("--every is for the certified data; allowed with --trajectories is to check all");
      }
      if (options->run.every > 1 && !options->check) {
        throw std::invalid_argument("--every is for --check; allowed is to write all rows or none");
      }
      if (options->finite_length && options->trajectories) {
        throw std::invalid_argument("--finite-length and --trajectories are given; allowed is one of them");
      }
      if (options->finite_length) return run_finite_length(*options);
      return options->trajectories ? run_trajectories(*options) : run_golden(*options);
    };
  });
}

}  // namespace lubjoint::cli

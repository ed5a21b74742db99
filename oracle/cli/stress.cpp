#include "oracle/measure/stress/stress.hpp"

#include <algorithm>
#include <iostream>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/files/data_folder.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/kept_rows.hpp"
#include "oracle/measure/stress/stress_report.hpp"

namespace lubjoint::cli {

namespace {

struct StressOptions {
  std::string scenes = scenes_folder();
  std::optional<std::string> out;
  std::optional<std::string> references;
  std::string against = (reports::data_folder() / "measured").string();
  std::vector<std::string> cases, laws, integrators;
  unsigned jobs = 0;
  bool quick = false;
};

std::vector<reports::StressCase> wanted_cases(const StressOptions& options) {
  std::vector<reports::StressCase> all = reports::stress_cases(options.scenes);
  if (options.cases.empty()) return all;
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const reports::StressCase& each : all) names.push_back(each.name);
  for (const std::string& name : options.cases) require_name("--case", name, names);
  std::vector<reports::StressCase> wanted;
  for (reports::StressCase& each : all) {
    const auto& list = options.cases;
    if (std::find(list.begin(), list.end(), each.name) != list.end()) wanted.push_back(std::move(each));
  }
  return wanted;
}

reports::StressSettings settings_of(const StressOptions& options) {
  reports::StressSettings settings = reports::stress_settings(options.quick);
  for (const std::string& name : options.laws) {
    require_name("--law", name, every_law_names);
    if (std::find(film_law_names.begin(), film_law_names.end(), name) == film_law_names.end()) {
      throw std::invalid_argument("--law " + name +
                                  " has no stored motions of other methods to be judged by; allowed are " +
                                  listed_film_laws());
    }
  }
  for (const std::string& name : options.integrators) require_name("--integrator", name, integrator_names());
  if (!options.laws.empty()) settings.laws = options.laws;
  if (!options.integrators.empty()) settings.integrators = options.integrators;
  settings.references = reports::StressReferences::read(options.against);
  if (options.jobs) settings.threads = options.jobs;
  if (options.out) settings.resume_file = std::filesystem::path(*options.out) / "stress.part";
  return settings;
}

}  // namespace

void add_stress(CLI::App& app, Action& action) {
  auto options = std::make_shared<StressOptions>();
  CLI::App* command = app.add_subcommand("stress", words_of("stress"));
  command->add_option("--out", options->out,
                      "Folder for stress.csv and the heat map; a run that was interrupted goes on from what is there");
  CLI::Option* references = command->add_option(
      "--references", options->references,
      "Makes the reference motions that this folder does not have to their end, in extended precision; runs nothing");
  command
      ->add_option("--against", options->against,
                   "Folder with the reference motions that runs are compared with (data/measured)")
      ->excludes(references);
  command->add_flag("--quick", options->quick, "Two laws and few steps: less than a minute");
  command->add_option("--case", options->cases, "These cases alone");
  command->add_option("--law", options->laws, "These laws alone");
  command->add_option("--integrator", options->integrators, "These integrators alone");
  command->add_option("--jobs", options->jobs, "Threads; all cores if left out")->check(CLI::Range(1u, 4096u));
  command->add_option("--scenes", options->scenes, "Folder with journal.toml, impact.toml and slider-crank.toml");
  command->callback([options, &action] {
    action = [options] {
      const std::vector<reports::StressCase> cases = wanted_cases(*options);
      if (options->references) {
        if (options->out || !options->integrators.empty()) {
          throw std::invalid_argument(
              "--out and --integrator have no effect with --references, whose methods are its own; allowed are --case, "
              "--law, --quick, --jobs and --scenes");
        }
        const reports::StressSettings all = reports::stress_settings(options->quick);
        reports::prepare_folder(*options->references);
        reports::make_stress_references(cases, options->laws.empty() ? all.laws : options->laws, *options->references,
                                        options->jobs ? options->jobs : all.threads);
        std::cerr << "written: " << reports::reference_table_name << ", " << reports::reference_motions_name << " in "
                  << *options->references << '\n';
        return 0;
      }
      const reports::StressSettings settings = settings_of(*options);
      if (options->out) reports::prepare_folder(*options->out);
      const std::vector<reports::StressCell> cells = reports::run_stress(cases, settings);
      if (options->out) {
        const std::filesystem::path folder = *options->out;
        reports::write_file(folder / "stress.csv", reports::stress_csv(cells));
        reports::draw_stress(cells, folder);
        reports::discard_kept_rows(settings.resume_file);
        std::cerr << "written: " << (folder / "stress.csv").string() << ", stress.svg and stress.png beside it\n";
      }
      std::cout << reports::stress_table(cases, cells);
      return std::any_of(cells.begin(), cells.end(),
                         [](const auto& cell) { return cell.status == reports::StressStatus::wrong; })
                 ? 1
                 : 0;
    };
  });
}

}  // namespace lubjoint::cli

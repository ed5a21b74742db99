#include <filesystem>
#include <iostream>

#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/compiled_film.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/files/data_folder.hpp"
#include "oracle/files/files.hpp"
#include "oracle/measure/bench/bench_manifest.hpp"
#include "oracle/page/page.hpp"

namespace lubjoint::cli {

namespace {

namespace fs = std::filesystem;
namespace page = reports::page;

struct ReproduceOptions {
  std::string out = "out/reproduce";
  std::string scenes = scenes_folder();
  std::optional<std::string> data;
};

/// What `bench` and `stress` have left in a folder, if anything.
void read_data(const fs::path& folder, page::Content& content) {
  const fs::path run_times = folder / "bench-scenes.csv";
  const fs::path stability = folder / "stress.csv";
  std::error_code unreadable;  // then there is nothing to be read
  const bool timed = fs::exists(run_times, unreadable);
  const bool stressed = fs::exists(stability, unreadable);
  if (!timed && !stressed) {
    throw std::invalid_argument(
        "--data \"" + folder.string() +
        "\" holds neither bench-scenes.csv nor stress.csv; allowed is a folder with one or both");
  }
  if (timed) {
    const std::string csv = reports::read_input(run_times.string());
    content.run_times = page::read_run_times(csv, run_times.string());
    const fs::path manifest = folder / "bench-scenes.json";
    if (fs::exists(manifest, unreadable)) {
      content.run_times->measured_by =
          reports::measured_by(reports::read_input(manifest.string()), csv, manifest.string());
    }
  }
  if (stressed) content.stability = page::read_stability(reports::read_input(stability.string()), stability.string());
}

int reproduce(const ReproduceOptions& options) {
  const Scene scene = load_scene(fs::path(options.scenes) / "journal.toml");
  journal_scene(scene);  // refuses what is no journal before a folder is made
  page::Content content;
  const fs::path measured = reports::data_folder() / "measured";  // ships with the project
  if (options.data || fs::is_directory(measured)) read_data(options.data.value_or(measured), content);
  reports::prepare_folder(options.out);

  content.journal = reports::run_example_1(scene);
  std::cout << reports::example_1_table(content.journal) << '\n';
  content.model_error = page::bearing_model_error(content.journal);
  std::vector<SceneJoint> joints;
  for (const auto& law : content.journal.laws) joints.push_back(law.scene.joints[0]);
  const std::string warning = reports::model_warning(joints, content.model_error.visited);
  if (!warning.empty()) std::cout << warning << '\n';
  content.slider_crank = reports::run_example_2(options.scenes);
  std::cout << '\n' << reports::example_2_table(content.slider_crank);
  content.space =
      page::run_space_example(load_spatial_scene(fs::path(options.scenes) / "space" / "spatial-slider-crank.toml"));
  std::cout << '\n' << page::space_example_table(content.space);
  content.real_films = reports::run_real_films(options.scenes, scene_films());
  std::cout << '\n' << reports::real_films_table(*content.real_films);
  content.laws = reports::check_laws({});
  std::cout << '\n' << reports::law_check_table(content.laws);
  const fs::path ledger = reports::data_folder() / "proofs" / "ledger.json";
  if (fs::exists(ledger)) content.proofs = page::read_ledger(reports::read_input(ledger.string()), ledger.string());
  content.provenance = page::provenance(LUBJOINT_VERSION, {{"CLI11", CLI11_VERSION}});

  auto files = reports::write_example_1(content.journal, options.out);
  for (const std::string& file : reports::write_example_2(content.slider_crank, options.out)) files.push_back(file);
  files.push_back(page::write_page(content, options.out));
  std::cerr << files.size() << " files written to " << options.out << ":";
  for (const std::string& file : files) std::cerr << ' ' << file;
  std::cerr << '\n';
  return content.passed() ? 0 : 1;
}

}  // namespace

void add_reproduce(CLI::App& app, Action& action) {
  auto options = std::make_shared<ReproduceOptions>();
  CLI::App* command = app.add_subcommand("reproduce", words_of("reproduce"));
  command->add_option("--out", options->out, "Folder for report.html, CSV files and plots")->capture_default_str();
  command->add_option("--scenes", options->scenes, "Folder of the scenes that ship with the project");
  command->add_option(
      "--data", options->data,
      "Folder with bench-scenes.csv and stress.csv, which bench and stress write, for the report; left out: those "
      "that ship");
  command->callback([options, &action] { action = [options] { return reproduce(*options); }; });
}

}  // namespace lubjoint::cli

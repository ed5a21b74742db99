#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <vector>

#include "lubjoint/scene/spatial_scene_file.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/compiled_film.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/kept_rows.hpp"
#include "oracle/measure/bench/bench_manifest.hpp"
#include "oracle/measure/bench/bench_tables.hpp"
#include "oracle/measure/bench/compiled_law_bench.hpp"
#include "oracle/measure/bench/law_bench.hpp"
#include "oracle/measure/bench/scene_bench.hpp"
#include "oracle/measure/bench/simbody_case.hpp"
#include "oracle/measure/bench/sundials_method.hpp"
#include "oracle/measure/quadrature_bench.hpp"
#include "oracle/page/provenance.hpp"

namespace lubjoint::cli {

namespace {

struct BenchOptions {
  std::vector<std::string> tables;
  std::vector<std::string> scene_files;
  std::vector<Scene> scenes;           ///< of these files
  std::vector<SpatialScene> in_space;  ///< those of them with dimension = 3
  std::vector<std::string> integrators;
  std::optional<std::filesystem::path> out;
  std::optional<std::filesystem::path> data;    ///< folder with rows measured before
  std::optional<std::filesystem::path> readme;  ///< text with a table of them
  std::optional<int> repeats;
  std::optional<double> seconds;
  bool quick = false;

  /// Writes a file into the folder, if one was named.
  void save(const std::string& name, const std::string& content) const {
    if (!out) return;
    reports::write_file(*out / name, content);
    std::cerr << "written: " << (*out / name).string() << '\n';
  }
};

/// One table of error against run time: printed, and saved where the options say.
struct BenchTable {
  std::string_view name;
  std::string_view about;
  void (*run)(const BenchOptions&);
};

/// The tables of the paper's bearing, and its slider-crank with each of them.
void bench_compiled_laws(const BenchOptions& options) {
  const Scene published = load_scene(std::filesystem::path(scenes_folder()) / "slider-crank.toml");
  const SceneJoint& joint = published.joints.front();
  const double shape = joint.length / (2 * joint.journal_radius);
  std::vector<CompiledFilm> films;
  std::vector<Scene> runs{published};
  for (const std::string_view law : names_of_laws<CompiledLaws>) {
    films.push_back(film_for_user(std::string(law), shape));
    Scene scene = published;
    scene.joints.front().film = law;
    scene.joints.front().table = std::make_shared<const CompiledFilm>(films.back());
    runs.push_back(std::move(scene));
  }
  const auto rows = reports::time_compiled_laws(
      films, std::filesystem::path(golden_folder()) / "finite_length" / "finite_film_force.csv", runs, options.quick);
  std::cout << '\n' << reports::compiled_law_table(rows, shape);
  options.save("bench-compiled-laws.csv", reports::compiled_law_csv(rows));
}

void bench_laws(const BenchOptions& options) {
  const auto bench = reports::time_laws(std::filesystem::path(golden_folder()) / "film_force.csv", options.quick);
  std::cout << reports::law_bench_table(bench);
  options.save("bench-laws.csv", reports::law_bench_csv(bench));
  options.save("bench-batch.csv", reports::batch_csv(bench));
  bench_compiled_laws(options);
}

void bench_quadrature(const BenchOptions& options) {
  const auto rows = reports::time_quadrature(options.quick);
  std::cout << reports::quadrature_table(rows);
  options.save("bench-quadrature.csv", reports::quadrature_csv(rows));
}

void bench_finite_length(const BenchOptions& options) {
  const auto rows = reports::time_finite_length(options.quick);
  std::cout << reports::quadrature_table(rows);
  options.save("bench-finite-length.csv", reports::quadrature_csv(rows));
}

/// One scene of each kind.
std::vector<std::string_view> quick_scenes() {
  return {"journal",
          "slider-crank",
          "slider-crank-c0.5-mu0.04",
          "slider-crank-torque",
          "impact",
          "space/spatial-slider-crank"};
}

std::vector<std::string_view> shipped_scenes() {
  return {"journal",
          "slider-crank",
          "slider-crank-c0.1-mu0.4",
          "slider-crank-c0.5-mu0.4",
          "slider-crank-c0.2-mu0.04",
          "slider-crank-c0.5-mu0.04",
          "slider-crank-ideal",
          "slider-crank-torque",
          "impact",
          "space/spatial-slider-crank"};
}

/// The tables of rows that were measured before.
void show_measured_scenes(const BenchOptions& options) {
  const std::string file = (*options.data / "bench-scenes.csv").string();
  const auto rows = reports::read_bench_rows(reports::CsvTable(reports::read_input(file), file));
  if (options.readme) {
    const std::string text = reports::read_input(options.readme->string());
    reports::write_file(*options.readme, reports::with_bench_block(text, reports::scene_bench_markdown(rows)));
    std::cerr << "written: " << options.readme->string() << '\n';
  }
  std::cout << "scenes\n" << reports::scene_bench_table(rows);
}

void bench_scenes(const BenchOptions& options) {
  if (options.data) return show_measured_scenes(options);
  auto settings = reports::scene_bench_settings(options.quick);
  settings.integrators = options.integrators;
  settings.limits.repeats = options.repeats.value_or(settings.limits.repeats);
  settings.limits.seconds = options.seconds.value_or(settings.limits.seconds);
  if (options.out) settings.resume_file = *options.out / "bench-scenes.part";
  const auto bench = reports::bench_scenes(options.scenes, settings, options.in_space);
  std::cout << reports::scene_bench_table(bench.rows, bench.references);
  const std::string csv = reports::scene_bench_csv(bench.rows);
  options.save("bench-scenes.csv", csv);
  const reports::page::Provenance made = reports::page::provenance(LUBJOINT_VERSION, {{"CLI11", CLI11_VERSION}});
  options.save("bench-scenes.json",
               reports::bench_manifest(
                   csv, settings, {{"sundials", reports::sundials_version()}, {"simbody", reports::simbody_version()}},
                   made.software, made.machine));
  if (options.out) reports::draw_scene_bench(bench.rows, *options.out);
  reports::discard_kept_rows(settings.resume_file);
}

constexpr std::array bench_tables = {
    BenchTable{"laws", "force laws: scalar, batch, long double, quadrature, finite length; those that are tables",
               bench_laws},
    BenchTable{"quadrature", "quadrature rules on the one-dimensional films", bench_quadrature},
    BenchTable{"finite-length", "films of finite length by tolerance", bench_finite_length},
    BenchTable{"scenes", "scenes by formulation, integrator and tolerance (those of --scene, or those that ship)",
               bench_scenes}};

std::string described_tables() {
  std::string text = "Which tables; none named: scenes if --scene is given, otherwise all.";
  for (const BenchTable& table : bench_tables) text += "\n" + std::string(table.name) + ": " + std::string(table.about);
  return text;
}

/// @throws std::invalid_argument that lists the tables there are, or says that scenes and --scene go together
void require_tables(const BenchOptions& options) {
  for (const std::string& name : options.tables) {
    if (std::ranges::find(bench_tables, name, &BenchTable::name) != bench_tables.end()) continue;
    std::string list;
    for (const BenchTable& table : bench_tables) list.append(list.empty() ? "" : ", ").append(table.name);
    throw std::invalid_argument("there is no table \"" + name + "\"; allowed are " + list);
  }
  const bool named = std::ranges::find(options.tables, "scenes") != options.tables.end();
  if (!named && !options.tables.empty() && !options.scene_files.empty()) {
    throw std::invalid_argument("--scene is given without the table scenes; allowed are both or neither");
  }
}

/// @throws std::invalid_argument for limits that are none, or that nothing would obey
void require_limits(const BenchOptions& options) {
  if (options.repeats && *options.repeats < 1) {
    throw std::invalid_argument("--repeats is " + std::to_string(*options.repeats) + "; allowed are numbers from 1 on");
  }
  if (options.seconds && !(*options.seconds > 0 && std::isfinite(*options.seconds))) {
    throw std::invalid_argument("--seconds is " + reports::number(*options.seconds) + "; allowed are numbers above 0");
  }
  const bool scenes = options.tables.empty() || std::ranges::find(options.tables, "scenes") != options.tables.end();
  if ((options.repeats || options.seconds || !options.integrators.empty()) && !scenes) {
    throw std::invalid_argument(
        "--repeats, --seconds and --integrator are of the table scenes; allowed are they and it, or none of them");
  }
}

/// @throws std::invalid_argument that says what --data and --readme go with
void require_data_options(const BenchOptions& options) {
  if (options.readme && !options.data) {
    throw std::invalid_argument("--readme is given without --data; allowed are both or neither");
  }
  if (!options.data) return;
  const bool scenes_alone = options.tables.size() == 1 && options.tables[0] == "scenes";
  const bool measures = options.quick || options.out || options.repeats || options.seconds ||
                        !options.scene_files.empty() || !options.integrators.empty();
  if (!scenes_alone || measures) {
    throw std::invalid_argument(
        "--data shows what was measured before; allowed beside it are the table scenes and --readme alone");
  }
}

bool is_wanted(const BenchTable& table, const BenchOptions& options) {
  if (options.tables.empty()) return table.name == "scenes" || options.scene_files.empty();
  return std::ranges::find(options.tables, table.name) != options.tables.end();
}

void load(const std::filesystem::path& path, BenchOptions& options) {
  const SceneFile file(path);
  if (scene_dimension(file) == 3) {
    options.in_space.push_back(spatial_scene(file));
  } else {
    options.scenes.push_back(file.scene());
  }
}

int run_bench(BenchOptions options) {
  for (const std::string& file : options.scene_files) load(file, options);
  for (Scene& each : options.scenes) scene_films().provide(each);
  require_tables(options);
  require_limits(options);
  require_data_options(options);
  for (const std::string& name : options.integrators) require_name("--integrator", name, reports::raced_methods());
  if (options.scene_files.empty() && !options.data) {
    for (const std::string_view name : options.quick ? quick_scenes() : shipped_scenes()) {
      load(std::filesystem::path(scenes_folder()) / (std::string(name) + ".toml"), options);
    }
  }
  if (options.out) reports::prepare_folder(*options.out);
  for (const BenchTable& table : bench_tables) {
    if (!is_wanted(table, options)) continue;
    if (!options.data) std::cout << table.name << '\n';
    table.run(options);
    std::cout << std::endl;
  }
  return 0;
}

}  // namespace

void add_bench(CLI::App& app, Action& action) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = app.add_subcommand("bench", words_of("bench"));
  command->add_option("tables", options->tables, described_tables());
  command->add_option("--scene", options->scene_files, "Scene files in place of those that ship");
  command->add_option("--integrator", options->integrators, "These integrators alone (of scenes)");
  command->add_option("--out", options->out, "Folder for the tables as CSV");
  command->add_option("--repeats", options->repeats, "Of scenes: runs whose median counts (9; with --quick 3)");
  command->add_option("--seconds", options->seconds,
                      "Of scenes: processor time after which a run is given up, and is not repeated a fourth time (1)");
  command->add_option("--data", options->data, "Of scenes: what bench --out wrote into this folder, not a new run");
  command->add_option("--readme", options->readme, "With --data: a text whose table between its marks is replaced");
  command->add_flag("--quick", options->quick, "Fewer cases and repeats: about a minute");
  command->callback([options, &action] { action = [options] { return run_bench(*options); }; });
}

}  // namespace lubjoint::cli

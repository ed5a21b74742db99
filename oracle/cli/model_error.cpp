#include "oracle/laws/model_error.hpp"

#include <cmath>
#include <iostream>

#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/files/files.hpp"
#include "oracle/laws/model_error_lookup.hpp"

namespace lubjoint::cli {

namespace {

struct ModelErrorOptions {
  std::optional<std::string> scene;
  std::optional<double> length;
  std::optional<double> radius;
  std::optional<double> clearance;
  std::optional<double> viscosity;
  std::optional<double> load;
  std::optional<double> spin;
  std::optional<std::string> out;
  bool lookup = false;
};

/// A bearing, and what loads it if that is known.
struct Question {
  Bearing<double> bearing;
  std::optional<Lubricant<double>> oil;
  double load = 0;
  double spin_sum = 0;
};

Question question_of(const ModelErrorOptions& options) {
  if (options.scene) {
    if (options.length || options.radius || options.clearance || options.viscosity || options.load || options.spin) {
      throw std::invalid_argument(
          "model-error takes a scene, or --length, --radius and so on; not both: allowed beside a scene is --out");
    }
    const JournalScene parts = journal_scene(load_scene(*options.scene));
    return {parts.bearing, parts.oil, parts.drive.load.norm(), std::abs(2 * parts.drive.mean_spin())};
  }
  if (!options.length || !options.radius) {
    throw std::invalid_argument("model-error needs a scene, or --length and --radius [m]");
  }
  require_option("--radius", *options.radius, *options.radius > 0, "a finite number above 0 [m]");
  // The map depends on L/D alone: without a load any clearance does.
  const double clearance = options.clearance.value_or(1e-3 * *options.radius);
  require_option("--clearance", clearance, clearance > 0, "a finite number above 0 [m]");
  Question question{Bearing<double>(*options.length, *options.radius, clearance), {}};
  const bool any = options.load || options.spin || options.viscosity || options.clearance;
  const bool all = options.load && options.spin && options.viscosity && options.clearance;
  if (any && !all) {
    throw std::invalid_argument(
        "the equilibrium needs --clearance [m], --viscosity [Pa s], --load [N] and --spin [rad/s], all four or none");
  }
  if (all) {
    require_option("--load", *options.load, *options.load > 0, "a finite number above 0 [N]");
    require_option("--spin", *options.spin, *options.spin > 0, "a finite number above 0 [rad/s]");
    question.oil = Lubricant<double>(*options.viscosity);
    question.load = *options.load;
    question.spin_sum = *options.spin;
  }
  return question;
}

}  // namespace

void add_model_error(CLI::App& app, Action& action) {
  auto options = std::make_shared<ModelErrorOptions>();
  CLI::App* command = app.add_subcommand("model-error", words_of("model-error"));
  command->add_option("scene", options->scene, "Scene file (TOML)");
  command->add_option("--length", options->length, "Bearing length [m]");
  command->add_option("--radius", options->radius, "Journal radius [m]");
  command->add_option("--clearance", options->clearance, "Radial clearance [m], for the equilibrium");
  command->add_option("--viscosity", options->viscosity, "Dynamic viscosity [Pa s], for the equilibrium");
  command->add_option("--load", options->load, "Constant load [N], for the equilibrium");
  command->add_option("--spin", options->spin, "Sum of the absolute spins of journal and bearing [rad/s]");
  command->add_option("--out", options->out, "Folder for model-error.csv and the maps");
  command->add_flag("--lookup", options->lookup,
                    "Every law's error by L/D and eccentricity ratio, as CSV, and no more: data/model-error.csv");
  command->callback([options, &action] {
    action = [options] {
      if (options->lookup) {
        if (options->scene || options->length || options->radius || options->clearance || options->viscosity ||
            options->load || options->spin || options->out) {
          throw std::invalid_argument("--lookup is the same for all bearings; allowed is it alone");
        }
        std::cout << reports::model_error_lookup();
        return 0;
      }
      const Question question = question_of(*options);
      if (options->out) reports::prepare_folder(*options->out);
      const auto map = reports::model_error_map(question.bearing, reports::ModelErrorGrid::standard());
      std::vector<reports::LoadedState> loaded;
      if (question.oil && question.load > 0 && question.spin_sum > 0) {
        loaded = reports::loaded_states(question.bearing, *question.oil, question.load, question.spin_sum);
      }
      std::cout << reports::model_error_table(question.bearing, reports::summaries_of(map), loaded);
      if (options->out) {
        reports::write_file(std::filesystem::path(*options->out) / "model-error.csv", reports::model_error_csv(map));
        std::cerr << "written to " << *options->out << ": model-error.csv";
        for (const std::string& file : reports::draw_model_error(map, *options->out)) std::cerr << ' ' << file;
        std::cerr << '\n';
      }
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

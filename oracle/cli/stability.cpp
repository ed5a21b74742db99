#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/law_option.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/files/files.hpp"
#include "oracle/results/stability_map.hpp"
#include "oracle/sweep/sweep_grid.hpp"

namespace lubjoint::cli {

namespace {

struct StabilityOptions {
  std::optional<std::string> scene;
  std::optional<std::string> law;
  std::optional<double> viscosity, length, radius, clearance, load, omega, mass;
  std::optional<std::string> speeds, loads, masses;
  std::optional<std::string> out;
  bool json = false;
};

double required(const std::string& name, const std::optional<double>& given, const char* unit) {
  if (!given) throw std::invalid_argument(name + " is missing; required is a scene, or " + name + " [" + unit + "]");
  require_option(name, *given, *given > 0, std::string("a finite number above 0 [") + unit + "]");
  return *given;
}

reports::RotorQuestion of_scene(const StabilityOptions& options) {
  const std::optional<double> numbers[] = {options.viscosity, options.length, options.radius, options.clearance,
                                           options.load,      options.omega,  options.mass};
  if (std::any_of(std::begin(numbers), std::end(numbers), [](const auto& given) { return given.has_value(); })) {
    throw std::invalid_argument(
        "stability takes a scene, or --viscosity, --length, --radius, --clearance, --load, --omega and --mass; not "
        "both: allowed beside a scene are --law and the map's options");
  }
  Scene scene = load_scene(*options.scene);
  if (options.law) {
    for (SceneJoint& joint : scene.joints) joint.film = *options.law;
  }
  scene_films().provide(scene);
  // An unbalance makes an orbit about the place of rest; whether that is stable it does not say.
  std::erase_if(scene.loads, [](const SceneLoad& load) { return load.unbalance.has_value(); });
  const JournalScene parts = journal_scene(scene);
  require_law_with_rest(scene.joints.front().film);
  const double load = parts.drive.load.norm();
  if (!(load > 0)) throw std::invalid_argument(*options.scene + ": the load is 0; allowed is one above 0 [N]");
  if (parts.drive.journal_spin == 0) {
    throw std::invalid_argument(*options.scene + ": bodies[0].spin is 0; allowed is a spin other than 0 [rad/s]");
  }
  std::optional<double> mass;
  if (parts.drive.mass > 0) mass = parts.drive.mass;
  return {{scene.joints.front().film, parts.bearing, parts.oil, parts.table}, load, parts.drive.journal_spin, mass};
}

reports::RotorQuestion of_numbers(const StabilityOptions& options) {
  if (!options.law) throw std::invalid_argument("--law is missing; required is a scene, or --law and a bearing");
  const double length = required("--length", options.length, "m");
  const double radius = required("--radius", options.radius, "m");
  const double clearance = required("--clearance", options.clearance, "m");
  require_option("--clearance", clearance, clearance < radius, "less than --radius, the journal's");
  const double viscosity = required("--viscosity", options.viscosity, "Pa s");
  const double load = required("--load", options.load, "N");
  if (!options.omega) throw std::invalid_argument("--omega is missing; required is a scene, or --omega [rad/s]");
  require_option("--omega", *options.omega, *options.omega != 0, "a finite spin other than 0 [rad/s]");
  if (options.mass) require_option("--mass", *options.mass, *options.mass > 0, "a finite number above 0 [kg]");
  const Bearing<double> bearing(length, radius, clearance);
  require_law_of_bearing(*options.law, bearing);
  return {film_in_bearing(*options.law, bearing, Lubricant<double>(viscosity)), load, *options.omega, options.mass};
}

std::vector<double> positive_range(const std::string& option, const std::string& text) {
  std::vector<double> values = reports::parse_range(option, text);
  require_option("a value of " + option, values.front(), values.front() > 0, "above 0");
  require_option("a value of " + option, values.back(), values.back() > values.front(), "a range that rises");
  return values;
}

std::optional<reports::StabilityMap> map_of(const StabilityOptions& options) {
  if (!options.out) {
    if (options.speeds || options.loads || options.masses) {
      throw std::invalid_argument("--speeds, --loads and --masses have no effect without --out; required is a folder");
    }
    return std::nullopt;
  }
  if (options.speeds.has_value() == options.loads.has_value() || !options.masses) {
    throw std::invalid_argument("--out needs a map; required is --masses with either --speeds or --loads");
  }
  const bool by_speed = options.speeds.has_value();
  reports::StabilityMap map{
      by_speed ? reports::MapAxis::speed : reports::MapAxis::load,
      by_speed ? positive_range("--speeds", *options.speeds) : positive_range("--loads", *options.loads),
      positive_range("--masses", *options.masses)};
  if (map.values.size() * map.masses.size() > 1'000'000) {
    throw std::invalid_argument("the map has more than 1000000 points; allowed are fewer");
  }
  return map;
}

}  // namespace

void add_stability(CLI::App& app, Action& action) {
  auto options = std::make_shared<StabilityOptions>();
  CLI::App* command = app.add_subcommand("stability", words_of("stability"));
  command->add_option("scene", options->scene, "Scene file of a journal in a bearing (TOML), or a bearing by options");
  command->add_option("--law", options->law, "Film law; in place of the scene's");
  command->add_option("--viscosity", options->viscosity, "Dynamic viscosity [Pa s]");
  command->add_option("--length", options->length, "Bearing length [m]");
  command->add_option("--radius", options->radius, "Journal radius [m]");
  command->add_option("--clearance", options->clearance, "Radial clearance [m]");
  command->add_option("--load", options->load, "Load on the journal [N]");
  command->add_option("--omega", options->omega, "Spin of the journal, of either sign [rad/s]");
  command->add_option("--mass", options->mass,
                      "Mass of the rotor per bearing [kg]: is it stable, and at which speeds?");
  command->add_option("--speeds", options->speeds, "Spins of the map, LO:HI:N or log:LO:HI:N [rad/s]");
  command->add_option("--loads", options->loads, "Loads of the map, in place of spins [N]");
  command->add_option("--masses", options->masses, "Masses of the map [kg]. The load is held, whatever the mass");
  command->add_option("--out", options->out, "Folder for stability.csv, .svg and .png");
  command->add_flag("--json", options->json, "One JSON object");
  command->callback([options, &action] {
    action = [options] {
      if (options->law) require_law_with_rest(*options->law);
      const std::optional<reports::StabilityMap> map = map_of(*options);
      const reports::RotorQuestion question = options->scene ? of_scene(*options) : of_numbers(*options);
      const reports::RotorAnswer answer = reports::rotor_answer(question);
      if (map) {
        reports::prepare_folder(*options->out);
        reports::draw_map(question, *map, *options->out, "stability");
        reports::write_file(std::filesystem::path(*options->out) / "stability.csv", reports::map_csv(question, *map));
      }
      const std::string warning = reports::stability_warning(question.film.law, question.film.table.get());
      if (!warning.empty()) std::cerr << "warning: " << warning << '\n';
      const std::string beyond = reports::beyond_table_note(question.film, answer.rest.eccentricity_ratio);
      if (!beyond.empty()) std::cerr << "warning: " << beyond << '\n';
      if (options->json) {
        std::cout << reports::rotor_json(question, answer).dump(2) << '\n';
      } else {
        std::cout << reports::rotor_text(question, answer);
      }
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

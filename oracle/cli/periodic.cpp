#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "lubjoint/scene/periodic_orbit.hpp"
#include "lubjoint/scene/scene_period.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/compiled_film.hpp"
#include "oracle/cli/programs.hpp"

namespace lubjoint::cli {

namespace {

const char* growth_words(const PeriodicOrbit& orbit) {
  switch (orbit.growth()) {
    case -1:
      return "small deviations die out";
    case 1:
      return "small deviations grow";
    default:
      return "it can't be told from 1, and so not whether small deviations die out or grow";
  }
}

}  // namespace

void add_periodic(CLI::App& app, Action& action) {
  struct Options {
    std::string file;
    std::optional<double> period, tolerance;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("periodic", words_of("periodic"));
  command->add_option("scene", options->file, "Scene file (TOML)")->required();
  command->add_option("--period", options->period,
                      "Period [s]; without it, what drivers, tables and harmonic loads have in common");
  command->add_option("--tolerance", options->tolerance,
                      "What a period may leave between its ends, in clearances; 100 times the scene's relative "
                      "tolerance");
  command->add_flag("--json", options->json, "One JSON object in place of the scene");
  command->callback([options, &action] {
    action = [options] {
      if (options->period) require_option("--period", *options->period, *options->period > 0, "a time above 0 [s]");
      if (options->tolerance)
        require_option("--tolerance", *options->tolerance, *options->tolerance > 0, "a number above 0");
      const SceneFile file(options->file);
      Scene scene = file.scene();
      scene_films().provide(scene);
      const std::optional<double> period = options->period ? options->period : scene_period(scene);
      if (!period) {
        throw std::invalid_argument(
            "--period is missing, and nothing in the scene says how long one is; required is --period [s]");
      }
      const double tolerance = options->tolerance.value_or(100 * scene.run.relative_tolerance);
      const PeriodicOrbit orbit = periodic_orbit(scene, *period, tolerance);
      if (options->json) {
        const nlohmann::ordered_json json{{"scene", scene.name},
                                          {"period", orbit.period},
                                          {"miss", orbit.miss},
                                          {"iterations", orbit.iterations},
                                          {"runs", orbit.runs},
                                          {"largest_multiplier", orbit.largest_multiplier},
                                          {"multiplier_doubt", orbit.multiplier_doubt},  // null: unknown
                                          {"state", orbit.state}};
        std::cout << json.dump(2) << '\n';
        return 0;
      }
      std::cout << with_start(file, scene, orbit.state);
      std::cerr << fmt::format(
          "period       {:.10g} s\nmiss         {:.2g} clearances after {} iterations, {} runs of a period\n"
          "multiplier   {:.4g}, the largest, from differences good to {:.1g}: {}\n",
          orbit.period, orbit.miss, orbit.iterations, orbit.runs, orbit.largest_multiplier, orbit.multiplier_doubt,
          growth_words(orbit));
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

/// The options that change a scene on the command line.
#pragma once

#include <optional>
#include <stdexcept>

#include "lubjoint/scene/scene_file.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/compiled_film.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/laws/scene_settings.hpp"
#include "oracle/results/late_extremes.hpp"

namespace lubjoint::cli {

struct SceneOptions : reports::SceneSettings {
  std::string file;

  void add_file(CLI::App& command) { command.add_option("scene", file, "Scene file (TOML)")->required(); }
  void add_law(CLI::App& command) { command.add_option("--law", law, "Film law in place of the scene's"); }
  void add_run(CLI::App& command) {
    command.add_option(
        "--integrator", integrator,
        "radau_iia5, rosenbrock4, dopri5, fehlberg78, bulirsch_stoer,\nadams_bashforth_moulton, or auto");
    command.add_option("--rtol", rtol, "Relative tolerance; also the absolute one, in clearances");
    command.add_option("--duration", duration, "Time to simulate [s]");
  }

  /// The scene, read and changed. @throws SceneError, std::invalid_argument
  Scene load() const {
    require();
    Scene scene = load_scene(file);
    change(scene);
    return scene;
  }

  /// Changes a scene, and gives compiled laws their tables. @throws std::invalid_argument
  void change(Scene& scene) const { SceneSettings::change(scene, scene_films()); }
};

/// The options that ask for extremes of the later part of a run.
struct LateOptions {
  std::optional<double> after;
  bool last_revolution = false;

  void add_late(CLI::App& command) {
    command.add_option("--after", after,
                       "Extremes from this time on, too [s], beside those of the whole run: a start has its own. Runs "
                       "the\nscene once more, to that time and from it");
    command.add_flag("--last-revolution", last_revolution,
                     "The same of the last revolution of the scene's driver, or of its journal");
  }
  /// @throws std::invalid_argument
  void require() const {
    if (after && last_revolution) {
      throw std::invalid_argument("--after and --last-revolution are given; allowed is one of them");
    }
  }
  /// From when on extremes of the scene are wanted, if at all. @throws std::invalid_argument
  std::optional<double> start(const Scene& scene) const {
    if (last_revolution) return reports::start_of_last_revolution(scene);
    if (after) reports::require_after(scene, *after, "--after");
    return after;
  }
};

}  // namespace lubjoint::cli

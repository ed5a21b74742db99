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
        "radau_iia5, radau_iia9, rosenbrock4, dopri5, fehlberg78,\nbulirsch_stoer, adams_bashforth_moulton, or auto");
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
struct LateOptions : reports::LateChoice {
  void add_late(CLI::App& command) {
    command.add_option("--after", after,
                       "Extremes from this time on, too [s], beside those of the whole run: a start has its own. Runs "
                       "the\nscene once more, to that time and from it");
    command.add_flag("--last-revolution", last_revolution,
                     "The same of the last revolution of the scene's driver, or of its journal");
  }
};

}  // namespace lubjoint::cli

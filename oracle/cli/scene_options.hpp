/// The options that change a scene on the command line.
#pragma once

#include <optional>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/name_option.hpp"

namespace lubjoint::cli {

struct SceneOptions {
  std::string file;
  std::optional<std::string> law;
  std::optional<std::string> integrator;
  std::optional<double> rtol;
  std::optional<double> duration;

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

  /// Refuses names and numbers that no scene takes. @throws std::invalid_argument
  void require() const {
    if (law) require_name("--law", *law, film_law_names);
    if (integrator) require_name("--integrator", *integrator, integrator_names());
    if (rtol) require_option("--rtol", *rtol, *rtol >= 1e-14 && *rtol < 1, "a number from 1e-14 to below 1");
    if (duration) require_option("--duration", *duration, *duration > 0, "a finite number of seconds above 0");
  }

  /// Changes a scene. @throws std::invalid_argument
  void change(Scene& scene) const {
    if (law) {
      for (SceneJoint& joint : scene.joints) {
        if (joint.film != no_film) joint.film = *law;
      }
    }
    if (integrator) scene.integrator = *integrator;
    if (rtol) scene.run.relative_tolerance = scene.run.absolute_tolerance = *rtol;
    if (duration) {
      scene.run.duration = *duration;
      require_option("--duration", *duration, *duration / scene.run.output_interval <= 1e7,
                     "at most ten million output intervals of the scene");
    }
  }
};

}  // namespace lubjoint::cli

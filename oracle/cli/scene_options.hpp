/// The options that change a scene on the command line.
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/compiled_film.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/files/files.hpp"
#include "oracle/results/late_extremes.hpp"

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
    if (law) require_name("--law", *law, named_film_laws);
    if (integrator) require_name("--integrator", *integrator, integrator_names());
    if (rtol) require_option("--rtol", *rtol, *rtol >= 1e-14 && *rtol < 1, "a number from 1e-14 to below 1");
    if (duration) require_option("--duration", *duration, *duration > 0, "a finite number of seconds above 0");
  }

  /// Changes a scene, and gives compiled laws their tables. @throws std::invalid_argument
  void change(Scene& scene) const {
    if (law) {
      const auto has_film = [](const SceneJoint& joint) { return joint.film != no_film; };
      if (std::none_of(scene.joints.begin(), scene.joints.end(), has_film)) {
        throw std::invalid_argument("--law has no effect on \"" + scene.name +
                                    "\", which has no joint with a film; allowed without it");
      }
      for (SceneJoint& joint : scene.joints) {
        if (joint.film == no_film) continue;
        joint.film = *law;
        with_film_law<NamedFilmLaws>(*law, [&]<class Law>() {
          if constexpr (ShapedFilmLaw<Law>) require_shape<Law>(joint.length / (2 * joint.journal_radius));
        });
      }
    }
    if (integrator) scene.integrator = *integrator;
    if (rtol) scene.run.relative_tolerance = scene.run.absolute_tolerance = *rtol;
    if (duration) {
      scene.run.duration = *duration;
      require_option("--duration", *duration, *duration / scene.run.output_interval <= 1e7,
                     "at most ten million output intervals of the scene");
    }
    scene_films().provide(scene);
  }
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
    if (after) {
      require_option("--after", *after, *after >= 0 && *after < scene.run.duration,
                     "a time from 0 to below the duration, " + reports::number(scene.run.duration) + " s");
    }
    return after;
  }
};

}  // namespace lubjoint::cli

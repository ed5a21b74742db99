#include "oracle/laws/scene_settings.hpp"

#include <algorithm>
#include <stdexcept>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/require.hpp"

namespace lubjoint::reports {

void SceneSettings::require() const {
  if (law) require_name(prefix + "law", *law, named_film_laws);
  if (integrator) require_name(prefix + "integrator", *integrator, integrator_names());
  if (rtol) require_option(prefix + "rtol", *rtol, *rtol >= 1e-14 && *rtol < 1, "a number from 1e-14 to below 1");
  if (duration) require_option(prefix + "duration", *duration, *duration > 0, "a finite number of seconds above 0");
}

void SceneSettings::change(Scene& scene, SceneFilms& films) const {
  if (law) {
    const auto has_film = [](const SceneJoint& joint) { return joint.film != no_film; };
    if (std::none_of(scene.joints.begin(), scene.joints.end(), has_film)) {
      throw std::invalid_argument(prefix + "law has no effect on \"" + scene.name +
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
    require_option(prefix + "duration", *duration, *duration / scene.run.output_interval <= 1e7,
                   "at most ten million output intervals of the scene");
  }
  films.provide(scene);
}

}  // namespace lubjoint::reports

/// What commands and other languages may say of a run beside its scene's file.
#pragma once

#include <optional>
#include <string>

#include "lubjoint/scene/scene.hpp"
#include "oracle/laws/scene_films.hpp"

namespace lubjoint {
struct SpatialScene;
}

namespace lubjoint::reports {

/// What is said of a run beside its scene's file.
struct SceneSettings {
  std::optional<std::string> law;         ///< in place of the scene's, in all joints with a film
  std::optional<std::string> integrator;  ///< likewise
  std::optional<double> rtol;             ///< relative tolerance; also the absolute one, in clearances
  std::optional<double> duration;         ///< [s]
  std::string prefix = "--";              ///< of their names in messages

  /// Refuses names and numbers that no scene takes. @throws std::invalid_argument
  void require() const;
  /// Changes a scene, and gives compiled laws their tables. @throws std::invalid_argument
  void change(Scene& scene, SceneFilms& films) const;
  void change(SpatialScene& scene, SceneFilms& films) const;  ///< likewise (library scene_runs)
};

}  // namespace lubjoint::reports

/// Mistakes in how a scene was set up, each as another scene: what a trajectory is compared with when it is wrong.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lubjoint/scene/scene.hpp"

namespace lubjoint::verify {

/// A number of a scene that may have been another, by a factor that is fitted.
struct SceneNumber {
  std::string words;  ///< "the clearance of gudgeon-pin"
  std::function<void(Scene&, double factor)> scale;
};

/// A change that was made or not.
struct SceneVariant {
  std::string words;  ///< completes "as if"
  std::function<void(Scene&)> apply;
};

/// Clearances, viscosities, lengths, radii, stiffness, restitution, masses, inertias, speeds, loads.
std::vector<SceneNumber> numbers_of(const Scene& scene);

/// Another law, bearing and journal exchanged, diameter for radius, gravity, spins the other way, start at rest.
std::vector<SceneVariant> changes_of(const Scene& scene);

}  // namespace lubjoint::verify

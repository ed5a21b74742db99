/// Extreme cases, made from the scenes that ship.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lubjoint/scene/scene.hpp"

namespace lubjoint::reports {

/// A scene that is hard in one respect.
struct StressCase {
  std::string name;
  std::string what;  ///< the respect, in words
  Scene scene;
};

/// All cases, in their order.
/// @param scenes  folder with journal.toml, impact.toml and slider-crank.toml
/// @throws SceneError
std::vector<StressCase> stress_cases(const std::filesystem::path& scenes);

}  // namespace lubjoint::reports

/// Scene files (TOML).
#pragma once

#include <filesystem>
#include <stdexcept>

#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

/// A scene file that can't be used: the message names file, line, key, what was given and what is allowed.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads and checks a scene. Unknown and missing keys, wrong types and impossible values are refused.
/// @throws SceneError
Scene load_scene(const std::filesystem::path& file);

}  // namespace lubjoint

/// Scene files of mechanisms in space (dimension = 3).
#pragma once

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_scene.hpp"

namespace lubjoint {

/// 3 where the file says dimension = 3, else 2: then the plane's reader judges what it says.
/// @throws SceneError if the file is no TOML
int scene_dimension(const SceneFile& file);

/// The scene, checked as if the file held the changed values. Unknown and missing keys, wrong types and impossible
/// values are refused.
/// @throws SceneError
SpatialScene spatial_scene(const SceneFile& file, const std::vector<SceneChange>& changes = {});

/// Reads and checks a scene in space.
/// @throws SceneError
inline SpatialScene load_spatial_scene(const std::filesystem::path& file) { return spatial_scene(SceneFile(file)); }

/// The same for text in memory.
/// @param text  TOML 1.0;  @param name  of its source, for messages
/// @throws SceneError
inline SpatialScene parse_spatial_scene(std::string_view text, std::string name) {
  return spatial_scene(SceneFile(std::string(text), std::move(name)));
}

}  // namespace lubjoint

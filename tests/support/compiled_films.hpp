/// The compiled films that ship, and scenes with them.
#pragma once

#include <memory>
#include <string>

#include "lubjoint/film/compiled_film_file.hpp"
#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/scene/scene.hpp"
#include "support/temporary_folder.hpp"

namespace lubjoint::test {

/// The L/D of the scenes that ship, as its files are called.
inline constexpr const char* shipped_scenes_shape = "2.0408163265306123";

/// The table of a law for an L/D that ships: 0.25, 0.5, 1 or that of the scenes.
inline std::shared_ptr<const CompiledFilm> shipped_film(std::string_view law, const std::string& shape) {
  const std::string file = LUBJOINT_SOURCE_DIR "/data/films/" + std::string(law) + "-" + shape + ".txt";
  return std::make_shared<const CompiledFilm>(read_compiled_film(read_text(file)));
}

/// A scene of the shipped bearings' L/D, with a compiled law in its first joint.
inline Scene with_compiled_film(Scene scene, std::string_view law) {
  scene.joints[0].film = law;
  scene.joints[0].table = shipped_film(law, shipped_scenes_shape);
  return scene;
}

}  // namespace lubjoint::test

/// Values of a parsed scene file, found by dotted path and replaced.
#pragma once

#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>

#include <string>

#include "lubjoint/scene/scene_file.hpp"

namespace lubjoint {

/// Puts a value where a key leads; tables on the way that are not there are made, and left to the reader to judge.
/// @param file  for messages
/// @returns the key with numbers in place of names
/// @throws SceneError  the key leads to no single value
std::string change_value(toml::table& root, const SceneChange& change, const std::string& file);

/// @returns the key with numbers in place of names
/// @throws SceneError  the key leads to no single value
std::string find_value(toml::table& root, const std::string& key, const std::string& file);

}  // namespace lubjoint

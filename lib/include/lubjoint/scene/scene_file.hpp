/// Scene files (TOML).
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

/// A scene file that can't be used: the message names file, line, key, what was given and what is allowed.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a scene file may hold at a key: a number, a truth value, a name.
using SceneValue = std::variant<double, bool, std::string>;

/// A value in place of one that a scene file has, or leaves out.
struct SceneChange {
  std::string key;   ///< as messages name it: joints[0].clearance, bodies[2].position[1]; or joints.NAME.clearance
  SceneValue value;  ///< what it is to be
};

/// The text of a scene file, read once: what happens to the file later changes no scene made from it.
class SceneFile {
 public:
  /// @throws SceneError if the file can't be read
  explicit SceneFile(const std::filesystem::path& file);
  /// Text in memory and the name of its source, for messages.
  SceneFile(std::string text, std::string name) : name_(std::move(name)), text_(std::move(text)) {}

  const std::string& name() const { return name_; }  ///< of the file, as it was given
  const std::string& text() const { return text_; }  ///< all of it

  /// The scene, checked as if the file held the changed values. Unknown and missing keys, wrong types and impossible
  /// values are refused.
  /// @throws SceneError
  Scene scene(const std::vector<SceneChange>& changes = {}) const;

  /// The same of a file whose places are guesses: a journal may be outside its bearing.
  /// @throws SceneError
  Scene rough_scene() const;

  /// A change's key with numbers in place of names: joints[0].clearance for joints.gudgeon-pin.clearance.
  /// @throws SceneError if it leads nowhere
  std::string numbered_key(const std::string& key) const;

 private:
  std::string name_;
  std::string text_;
};

/// Reads and checks a scene.
/// @throws SceneError
inline Scene load_scene(const std::filesystem::path& file) { return SceneFile(file).scene(); }

/// The same for text in memory.
/// @param text  TOML 1.0;  @param name  of its source, for messages
/// @throws SceneError
inline Scene parse_scene(std::string_view text, std::string name) {
  return SceneFile(std::string(text), std::move(name)).scene();
}

}  // namespace lubjoint

/// Scenes in space that must be refused, and by what words.
#pragma once

#include <catch2/catch.hpp>
#include <span>
#include <string>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"

namespace lubjoint::test {

/// A part of a scene's text, what replaces it, and what the message must say.
struct Refused {
  const char* part;
  const char* by;
  const char* line_and_key;
  const char* allowed;
};

/// A text with one part of it replaced.
inline std::string changed(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  INFO(part);
  REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), by);
}

/// What is said against a scene. @param file  beside which its tables lie
inline std::string refusal(const std::string& text, const std::string& file = "any.toml") {
  try {
    prepare_spatial(parse_spatial_scene(text, file));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "accepted";
}

/// The text is accepted, and with each replacement refused by its words.
inline void check_refusals(const std::string& text, const std::string& file, std::span<const Refused> all) {
  using Catch::Matchers::Contains;
  REQUIRE(refusal(text, file) == "accepted");
  for (const Refused& each : all) {
    INFO(each.part << " -> " << each.by);
    CHECK_THAT(refusal(changed(text, each.part, each.by), file), Contains(each.line_and_key) && Contains(each.allowed));
  }
}

}  // namespace lubjoint::test

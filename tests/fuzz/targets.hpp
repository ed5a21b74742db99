/// What must hold for any bytes that the readers are given. Run by libFuzzer (libfuzzer_main.cpp) and, on the inputs
/// kept in this folder, by tests/fuzz_test.cpp.
#pragma once

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lubjoint::fuzz {

/// A reader broke its promise.
class Finding : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void require(bool holds, const std::string& promise) {
  if (!holds) throw Finding(promise);
}

/// A refusal is one line, fit for a terminal.
inline void require_one_line(std::string_view message) {
  require(!message.empty(), "a message says something");
  const bool plain = std::none_of(message.begin(), message.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 || code == 0x7f;
  });
  require(plain, "a message has no control characters: " + std::string(message));
}

/// A refused file: its name, the line if there is one, and what is allowed.
inline void require_refusal(std::string_view message, std::string_view file) {
  require_one_line(message);
  const std::string words(message);
  require(message.starts_with(std::string(file) + ":"), "a message names the file: " + words);
  const auto says = [&](const char* word) { return message.find(word) != std::string_view::npos; };
  require(says("allowed") || says("required") || says("expected"), "a message says what is allowed: " + words);
}

/// Each throws only what its reader should have prevented; the input may be anything.
void scene(std::string_view bytes);         ///< a scene file
void states(std::string_view bytes);        ///< the CSV of `force --states`
void answers(std::string_view bytes);       ///< first byte: which quantities; then the CSV of `verify`
void command_line(std::string_view bytes);  ///< one argument a line; parsed, not run

}  // namespace lubjoint::fuzz

/// Running a program that is not ours: text to its standard input, text from its standard output.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lubjoint::verify {

/// How long a program may take, and who is told how far it is.
struct ProgramLimits {
  std::optional<std::chrono::duration<double>> in_all = std::chrono::duration<double>(60);
  std::optional<std::chrono::duration<double>> between_lines = {};  ///< also to the first
  std::function<void(std::size_t lines)> on_lines = {};             ///< whole lines printed so far, when there are more
};

/// What a program printed on its standard output. Its standard error is kept for the message if it fails.
/// The program may answer while it still reads, or stop reading early.
/// @param command  program and arguments; looked up in PATH
/// @throws UnjudgedError if it can't be started, ends with another status than 0 or by a signal, or is not done in time
/// (it and the processes that it started are then killed)
std::string run_program(const std::vector<std::string>& command, std::string_view input, const ProgramLimits& limits);

}  // namespace lubjoint::verify

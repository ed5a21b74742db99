/// Running a program that is not ours: text to its standard input, text from its standard output.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace lubjoint::verify {

/// What a program printed on its standard output. Its standard error is kept for the message if it fails.
/// The program may answer while it still reads, or stop reading early.
/// @param command  program and arguments; looked up in PATH
/// @throws UnjudgedError if it can't be started, ends with another status than 0 or by a signal, or is not done in time
/// (it and the processes that it started are then killed)
std::string run_program(const std::vector<std::string>& command, std::string_view input,
                        std::chrono::duration<double> timeout);

}  // namespace lubjoint::verify

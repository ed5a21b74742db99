/// The programs' parsers.
#pragma once

#include "oracle/cli/command.hpp"

namespace lubjoint::cli {

/// One command must be given; and --version.
void prepare(CLI::App& app);

/// What is wrong with the arguments, in one line.
std::string refusal(const CLI::App& app, const CLI::ParseError& error, int argc, const char* const* argv);

/// A program: parses, acts. @returns the exit status: 0 done; 1 the answer is no (a run stopped, a check failed); 2 bad
/// usage or input
int run_program(int argc, char** argv, void (*add)(CLI::App&, Action&));

}  // namespace lubjoint::cli

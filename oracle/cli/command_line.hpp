/// The program's parser: all commands.
#pragma once

#include "oracle/cli/command.hpp"

namespace lubjoint::cli {

/// Adds every command and --version. Parsing sets the action of the command that was named and touches nothing else.
void add_commands(CLI::App& app, Action& action);

/// What is wrong with the arguments, in one line.
std::string refusal(const CLI::App& app, const CLI::ParseError& error, int argc, const char* const* argv);

}  // namespace lubjoint::cli

/// The programs' parsers.
#pragma once

#include "oracle/cli/command.hpp"

namespace lubjoint::cli {

/// One command must be given; and --version.
void prepare(CLI::App& app);

/// What is wrong with the arguments, in one line.
std::string refusal(const CLI::App& app, const CLI::ParseError& error, int argc, const char* const* argv);

}  // namespace lubjoint::cli

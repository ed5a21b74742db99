/// What every file of this folder offers: one command, added to the program's parser.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "lubjoint/version.hpp"
#include "oracle/cli/run_program.hpp"
#include "oracle/files/data_folder.hpp"
#include "oracle/files/require.hpp"

namespace lubjoint::cli {

/// Folder of the scenes that ship with the program.
inline std::string scenes_folder() { return reports::data_folder() / "scenes"; }
/// Folder of the golden data that ship with it.
inline std::string golden_folder() { return reports::data_folder() / "golden"; }

using reports::require_option;

}  // namespace lubjoint::cli

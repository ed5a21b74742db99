/// Files in and out: output is written beside and renamed, so that a reader never sees half of one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "oracle/files/temporary_file.hpp"

namespace lubjoint::reports {

/// Makes a folder if it is not there, checks that files can be made in it, and removes what killed processes left
/// unfinished there.
/// @throws OutputError
void prepare_folder(const std::filesystem::path& folder);

/// Checks that a file of that name can be written, and makes its folder if it is not there. Devices and pipes are
/// files.
/// @throws OutputError
void prepare_file(const std::filesystem::path& file);

/// Replaces a file by this content, all of it or nothing; devices and pipes are written to.
/// @throws OutputError
void write_file(const std::filesystem::path& file, std::string_view content);

/// Content of a file, or of standard input for "-".
/// @throws std::invalid_argument if it can't be read
std::string read_input(const std::string& name);

/// What messages call it.
std::string input_name(const std::string& name);

/// The shortest decimal form that reads back as the same number, whatever the locale.
std::string number(double value);

}  // namespace lubjoint::reports

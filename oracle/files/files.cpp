#include "oracle/files/files.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <iostream>
#include <system_error>

namespace lubjoint::reports {

namespace fs = std::filesystem;

namespace {
/// What is no place for a file beside it: a device, a pipe.
bool takes_what_comes(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}
}  // namespace

void prepare_folder(const fs::path& folder) {
  const auto refuse = [&](const std::string& what, const std::string& why) {
    throw OutputError("output folder \"" + folder.string() + "\" " + what + ": " + why +
                      "; allowed is a folder that can be written to");
  };
  std::error_code error;
  const bool is_new = fs::create_directories(folder, error);
  if (error) refuse("can't be made", error.message());
  if (!fs::is_directory(folder, error)) refuse("can't be made", "a file of that name is there");
  try {
    TemporaryFile(folder / "probe").write("?");
  } catch (const OutputError& probe) {
    if (is_new) fs::remove(folder, error);
    refuse("can't be written to", probe.reason());
  }
  remove_unfinished_files(folder);
}

void prepare_file(const fs::path& file) {
  std::error_code error;
  if (file.filename().empty() || fs::is_directory(file, error)) {
    throw OutputError("output file \"" + file.string() + "\" is a folder; allowed is the name of a file");
  }
  if (!takes_what_comes(file)) prepare_folder(file.has_parent_path() ? file.parent_path() : fs::path("."));
}

void write_file(const fs::path& file, std::string_view content) {
  if (takes_what_comes(file)) {
    errno = 0;
    std::ofstream stream(file, std::ios::binary);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.close();
    if (stream) return;
    throw OutputError(file, std::generic_category().message(errno));
  }
  TemporaryFile temporary(file);
  temporary.write(content);
  temporary.keep();
}

namespace {
std::string read_all(std::istream& stream) {
  std::string text;
  std::array<char, 65536> piece{};
  while (stream.read(piece.data(), piece.size()) || stream.gcount() > 0) {
    text.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return text;
}
}  // namespace

std::string read_input(const std::string& name) {
  if (name == "-") return read_all(std::cin);
  std::error_code error;
  std::ifstream stream(name, std::ios::binary);
  std::string text = read_all(stream);
  if (fs::is_directory(name, error) || !stream.is_open() || stream.bad()) {
    throw std::invalid_argument("\"" + name + "\" can't be read; allowed is a file, or - for standard input");
  }
  return text;
}

std::string input_name(const std::string& name) { return name == "-" ? "standard input" : name; }

std::string number(double value) { return fmt::format("{}", value); }

}  // namespace lubjoint::reports

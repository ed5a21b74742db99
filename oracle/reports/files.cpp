#include "oracle/reports/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <iostream>

namespace lubjoint::reports {

namespace fs = std::filesystem;

namespace {
fs::path beside(const fs::path& file) {
  fs::path temporary = file;
  temporary += ".part-" + std::to_string(::getpid());
  return temporary;
}
}  // namespace

void prepare_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error)) {
    throw OutputError("output folder \"" + folder.string() +
                      "\" can't be made: " + (error ? error.message() : std::string("a file of that name is there")) +
                      "; allowed is a folder that can be written to");
  }
  const fs::path probe = beside(folder / "probe");
  std::ofstream stream(probe);
  const bool writable = static_cast<bool>(stream);
  stream.close();
  fs::remove(probe, error);
  if (!writable) throw OutputError("output folder \"" + folder.string() + "\" is not writable; allowed is one that is");
}

void prepare_file(const fs::path& file) {
  std::error_code error;
  if (file.filename().empty() || fs::is_directory(file, error)) {
    throw OutputError("output file \"" + file.string() + "\" is a folder; allowed is the name of a file");
  }
  prepare_folder(file.has_parent_path() ? file.parent_path() : fs::path("."));
}

void write_file(const fs::path& file, std::string_view content) {
  const fs::path temporary = beside(file);
  std::error_code error;
  {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.close();
    if (!stream) {
      fs::remove(temporary, error);
      throw OutputError("\"" + file.string() + "\" can't be written");
    }
  }
  fs::rename(temporary, file, error);
  if (error) {
    const std::string why = error.message();
    fs::remove(temporary, error);
    throw OutputError("\"" + file.string() + "\" can't be written: " + why);
  }
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
  const std::string text = read_all(stream);
  if (fs::is_directory(name, error) || !stream.is_open() || stream.bad()) {
    throw std::invalid_argument("\"" + name + "\" can't be read; allowed is a file, or - for standard input");
  }
  return text;
}

std::string number(double value) { return fmt::format("{}", value); }

}  // namespace lubjoint::reports

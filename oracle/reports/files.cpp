#include "oracle/reports/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <fstream>
#include <iostream>
#include <utility>

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

namespace {

/// Paths for a signal handler, which may call unlink and nothing that allocates.
constexpr std::size_t slots = 16;
constexpr std::size_t longest_path = 4096;
char pending[slots][longest_path];
std::atomic<bool> used[slots];

void remove_pending_and_end(int signal) {
  for (std::size_t i = 0; i < slots; ++i) {
    if (used[i]) ::unlink(pending[i]);
  }
  ::_exit(128 + signal);
}

}  // namespace

TemporaryFile::TemporaryFile(fs::path path) : path_(std::move(path)), slot_(slots) {
  const std::string name = path_.string();
  if (name.size() >= longest_path) throw OutputError("path \"" + name + "\" is too long");
  for (std::size_t i = 0; i < slots && slot_ == slots; ++i) {
    bool free = false;
    if (!used[i].compare_exchange_strong(free, true)) continue;
    name.copy(pending[i], name.size());
    pending[i][name.size()] = '\0';
    slot_ = i;
  }
}

TemporaryFile::~TemporaryFile() {
  std::error_code error;
  fs::remove(path_, error);
  if (slot_ < slots) used[slot_] = false;
}

void TemporaryFile::rename_to(const fs::path& file) {
  std::error_code error;
  fs::rename(path_, file, error);
  if (error) throw OutputError("\"" + file.string() + "\" can't be written: " + error.message());
}

void remove_temporary_files_on_interrupt() {
  std::signal(SIGINT, remove_pending_and_end);
  std::signal(SIGTERM, remove_pending_and_end);
}

void write_file(const fs::path& file, std::string_view content) {
  TemporaryFile temporary(beside(file));
  std::ofstream stream(temporary.path(), std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) throw OutputError("\"" + file.string() + "\" can't be written");
  temporary.rename_to(file);
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

/// Output files: written beside and renamed, so that a reader never sees half of one.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lubjoint::reports {

/// A place that can't be written: names it and says why.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes a folder if it is not there, and checks that files can be made in it.
/// @throws OutputError
void prepare_folder(const std::filesystem::path& folder);

/// Checks that a file of that name can be written, and makes its folder if it is not there.
/// @throws OutputError
void prepare_file(const std::filesystem::path& file);

/// Replaces a file by this content, all of it or nothing.
/// @throws OutputError
void write_file(const std::filesystem::path& file, std::string_view content);

/// A file that is removed again when it goes out of scope, or when the program is interrupted: what is being written.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::filesystem::path path);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Gives the file its final name. @throws OutputError
  void rename_to(const std::filesystem::path& file);

 private:
  std::filesystem::path path_;
  std::size_t slot_;
};

/// From now on SIGINT and SIGTERM remove the temporary files before they end the program.
void remove_temporary_files_on_interrupt();

/// Content of a file, or of standard input for "-".
/// @throws std::invalid_argument if it can't be read
std::string read_input(const std::string& name);

/// The shortest decimal form that reads back as the same number, whatever the locale.
std::string number(double value);

}  // namespace lubjoint::reports

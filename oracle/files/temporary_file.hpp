/// A file that gets its name when it is whole.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lubjoint::reports {

/// A place that can't be written: names it and says why.
class OutputError : public std::runtime_error {
 public:
  explicit OutputError(const std::string& text) : std::runtime_error(text) {}
  OutputError(const std::filesystem::path& file, const std::string& reason)
      : std::runtime_error("\"" + file.string() + "\" can't be written: " + reason), reason_(reason) {}

  /// The system's, such as "No space left on device"; empty where there is none.
  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

/// What a file is written as, until it is whole: beside its target, as TARGET.unfinished-PROCESS-NUMBER. Gone when this
/// goes out of scope, or when the program is interrupted. What a process that was killed leaves behind is known by not
/// being locked, and is removed by the next one that writes to the folder (remove_unfinished_files).
class TemporaryFile {
 public:
  /// @param target  where it is a symbolic link, what it points to is meant
  /// @throws OutputError if it can't be made
  explicit TemporaryFile(const std::filesystem::path& target);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// Its content, all of it, on the disk when this returns. @throws OutputError
  void write(std::string_view content);
  /// Gives it the target's name, in place of what is there. @throws OutputError
  void keep();

 private:
  bool make(const std::filesystem::path& path);
  [[noreturn]] void refuse(int error) const;

  std::filesystem::path target_;
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::size_t slot_;
};

/// Removes from a folder what killed processes left unfinished there; whatever a running one writes stays.
void remove_unfinished_files(const std::filesystem::path& folder) noexcept;

/// From now on the signals that end a program (interrupt, termination, hang-up, quit) remove its temporary files first,
/// and a file that would grow beyond the process's limit is an error, not an end.
void remove_temporary_files_on_interrupt();

}  // namespace lubjoint::reports

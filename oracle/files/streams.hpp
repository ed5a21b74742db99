/// Input and output that are too long for memory.
#pragma once

#include <cstddef>
#include <fstream>
#include <ostream>
#include <string>
#include <string_view>

namespace lubjoint::reports {

/// A file, or standard input for "-", to be read piece by piece.
class InputStream {
 public:
  /// @throws std::invalid_argument if it can't be read
  explicit InputStream(const std::string& name);

  std::istream& stream();
  /// Bytes in all; 0 where nobody knows, as of a pipe.
  std::size_t size() const { return size_; }

 private:
  std::ifstream file_;
  bool is_standard_input_;
  std::size_t size_ = 0;
};

/// Lines for a stream. The first few megabytes are held back until there are more or the end is reached, so that an
/// error among them leaves no half of an answer behind; memory does not grow with what is written.
class HeldOutput {
 public:
  explicit HeldOutput(std::ostream& stream) : stream_(stream) {}

  /// @throws std::runtime_error if the stream takes no more
  void write(std::string_view text);
  /// Writes what is held. @throws as write
  void finish();

 private:
  std::ostream& stream_;
  std::string held_;
  std::size_t limit_ = std::size_t{4} << 20;
};

}  // namespace lubjoint::reports

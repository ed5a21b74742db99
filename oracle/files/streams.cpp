#include "oracle/files/streams.hpp"

#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <system_error>

namespace lubjoint::reports {

namespace fs = std::filesystem;

InputStream::InputStream(const std::string& name) : is_standard_input_(name == "-") {
  std::error_code error;
  if (is_standard_input_) return;
  file_.open(name, std::ios::binary);
  if (fs::is_directory(name, error) || !file_.is_open()) {
    throw std::invalid_argument("\"" + name + "\" can't be read; allowed is a file, or - for standard input");
  }
  if (fs::is_regular_file(name, error)) size_ = static_cast<std::size_t>(fs::file_size(name, error));
}

std::istream& InputStream::stream() { return is_standard_input_ ? std::cin : file_; }

void HeldOutput::write(std::string_view text) {
  held_ += text;
  if (held_.size() < limit_) return;
  finish();
  limit_ = std::size_t{1} << 16;  // begun: from now on in pieces
}

void HeldOutput::finish() {
  stream_.write(held_.data(), static_cast<std::streamsize>(held_.size()));
  held_.clear();
  if (!stream_.flush()) throw std::runtime_error("standard output can't be written; allowed is one that takes all");
}

}  // namespace lubjoint::reports

/// Progress on a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace lubjoint::reports {

/// A bar on standard error, only if that is a terminal and the work takes more than a second. Removed when done.
class ProgressBar {
 public:
  ProgressBar(std::string label, std::size_t total);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void advance();
  /// Rows of a stream that were answered, and bytes of it that were read, of `total`; 0: nobody knows how many there
  /// are.
  void reach(std::size_t rows, std::size_t bytes);

 private:
  bool is_due();
  void show(const std::string& counted);

  using Clock = std::chrono::steady_clock;
  std::string label_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool shown_ = false;
  bool on_terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace lubjoint::reports

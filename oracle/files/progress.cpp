#include "oracle/files/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace lubjoint::reports {

ProgressBar::ProgressBar(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), on_terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::advance() {
  ++done_;
  if (is_due()) show(fmt::format("{}/{}", done_, total_));
}

void ProgressBar::reach(std::size_t rows, std::size_t bytes) {
  done_ = bytes;
  if (is_due()) show(fmt::format("{} rows", rows));
}

bool ProgressBar::is_due() {
  if (!on_terminal_) return false;
  const auto now = Clock::now();
  using namespace std::chrono_literals;
  if (now - start_ < 1s || now - last_ < 100ms) return false;
  last_ = now;
  return true;
}

void ProgressBar::show(const std::string& counted) {
  shown_ = true;
  std::string line = fmt::format("\r\033[K{} {}", label_, counted);
  if (total_ > 0) {
    constexpr std::size_t width = 30;
    const std::size_t filled = std::min(width, width * done_ / total_);
    const double elapsed = std::chrono::duration<double>(last_ - start_).count();
    const double left = elapsed * static_cast<double>(total_ - std::min(done_, total_)) / static_cast<double>(done_);
    line = fmt::format("\r\033[K{} [{:#<{}}{:.<{}}] {}, {:.0f} s left", label_, "", filled, "", width - filled, counted,
                       left);
  }
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace lubjoint::reports

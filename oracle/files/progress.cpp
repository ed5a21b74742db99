#include "oracle/files/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

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
  if (!on_terminal_) return;
  const auto now = Clock::now();
  using namespace std::chrono_literals;
  if (now - start_ < 1s || now - last_ < 100ms) return;
  last_ = now;
  shown_ = true;
  constexpr std::size_t width = 30;
  const std::size_t filled = total_ ? width * done_ / total_ : width;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = elapsed * static_cast<double>(total_ - done_) / static_cast<double>(done_);
  std::fputs(fmt::format("\r\033[K{} [{:#<{}}{:.<{}}] {}/{}, {:.0f} s left", label_, "", filled, "", width - filled,
                         done_, total_, left)
                 .c_str(),
             stderr);
  std::fflush(stderr);
}

}  // namespace lubjoint::reports

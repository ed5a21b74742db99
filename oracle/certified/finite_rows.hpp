/// What the files of films of finite length share: how numbers are printed, and how rows are made.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>

#include "oracle/certified/golden.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/parallel.hpp"

namespace lubjoint::certified {

/// Shortest text that reads back as the same double.
inline std::string exact(double value) { return reports::number(value); }

inline std::string rounded(double value, int digits) { return fmt::format("{:.{}g}", value, digits); }

/// To a hundredth of an uncertainty; no minus before a zero.
inline std::string rounded_to(double value, double uncertainty) {
  const int decimals = std::max(0, 2 - static_cast<int>(std::floor(std::log10(uncertainty))));
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.find_first_of("123456789") == std::string::npos ? "0" : text;
}

/// The first fields of a row, with the comma behind them.
inline std::string first_fields(const std::string& row, int count) {
  std::size_t end = 0;
  for (int comma = 0; comma < count; ++comma) end = row.find(',', end) + 1;
  return row.substr(0, end);
}

/// Calls work(i) for all i on run.threads threads, and tells of each that is done.
template <class Work>
void in_parallel(const GoldenRun& run, std::size_t count, const Work& work) {
  std::mutex mutex;
  std::size_t done = 0;
  reports::run_parallel(count, run.threads ? run.threads : reports::available_cores(), [&](std::size_t i) {
    work(i);
    const std::lock_guard lock(mutex);
    run.progress(++done, count);
  });
}

}  // namespace lubjoint::certified

#include "oracle/reports/bench/timing.hpp"

#include <algorithm>
#include <chrono>

namespace lubjoint::reports {

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> interleaved_medians(int repeats, const std::vector<std::function<void()>>& work) {
  using Clock = std::chrono::steady_clock;
  std::vector<std::vector<double>> times(work.size());
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t i = 0; i < work.size(); ++i) {
      const auto begin = Clock::now();
      work[i]();
      times[i].push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
    }
  }
  std::vector<double> medians;
  for (std::vector<double>& column : times) medians.push_back(median_of(std::move(column)));
  return medians;
}

}  // namespace lubjoint::reports

#include "oracle/measure/timing.hpp"

#include <algorithm>
#include <chrono>

namespace lubjoint::reports {

using Clock = std::chrono::steady_clock;

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> interleaved_medians(int repeats, const std::vector<std::function<void()>>& work) {
  std::vector<std::vector<double>> times(work.size());
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t i = 0; i < work.size(); ++i) {
      const auto begin = Clock::now();
      work[i]();
      times[i].push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
    }
  }
  std::vector<double> medians;
  medians.reserve(times.size());
  for (std::vector<double>& column : times) medians.push_back(median_of(std::move(column)));
  return medians;
}

std::vector<Timing> time_in_turn(std::vector<TimedPiece>& pieces, std::size_t rounds, double batch_seconds) {
  const auto seconds = [](TimedPiece& piece, std::size_t count) {
    const auto begin = Clock::now();
    piece(count);
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  std::vector<std::size_t> counts;
  for (TimedPiece& piece : pieces) {  // the first call warms caches, the rest find the length of a batch
    seconds(piece, 1);
    std::size_t count = 1;
    while (count < (std::size_t{1} << 24) && seconds(piece, count) < batch_seconds / 2) count *= 2;
    counts.push_back(count);
  }
  std::vector<Timing> timings(pieces.size());
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      timings[i].rounds.push_back(1e9 * seconds(pieces[i], counts[i]) / static_cast<double>(counts[i]));
    }
  }
  return timings;
}

}  // namespace lubjoint::reports

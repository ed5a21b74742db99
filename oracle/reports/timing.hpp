/// Times of short pieces of code on a machine that does other things as well.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <vector>

#include "oracle/reports/bench/timing.hpp"

namespace lubjoint::reports {

/// A piece of code, so many times in a row.
using TimedPiece = std::function<void(std::size_t)>;

/// The piece that calls f; the compiler can neither leave a call out nor move it out of the loop.
template <class F>
TimedPiece repeated(F f) {
  return [f = std::move(f)](std::size_t count) mutable {
    for (std::size_t i = 0; i < count; ++i) {
      f();
      asm volatile("" ::: "memory");
    }
  };
}

/// Nanoseconds of one call of a piece, one number a round.
struct Timing {
  std::vector<double> rounds;

  double nanoseconds() const { return median_of(rounds); }
  /// Median over the rounds of this one's time over another's of the same call: what slows the machine slows both.
  double ratio_to(const Timing& other) const {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < rounds.size(); ++i) ratios.push_back(rounds[i] / other.rounds[i]);
    return median_of(ratios);
  }
};

/// Times pieces in turn, round after round; in each a piece runs for about so long [s], and at least once.
inline std::vector<Timing> time_in_turn(std::vector<TimedPiece>& pieces, std::size_t rounds, double batch_seconds) {
  using Clock = std::chrono::steady_clock;
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

/// Times of short pieces of code on a machine that does other things as well.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace lubjoint::reports {

/// The middle value; of an even number of them, the upper of the two.
double median_of(std::vector<double> values);

/// Median time of each long piece of work [ns]. A repeat runs all of them once, one after the other, so that what slows
/// the machine down for a while slows all of them, and ratios stay.
std::vector<double> interleaved_medians(int repeats, const std::vector<std::function<void()>>& work);

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
std::vector<Timing> time_in_turn(std::vector<TimedPiece>& pieces, std::size_t rounds, double batch_seconds);

}  // namespace lubjoint::reports

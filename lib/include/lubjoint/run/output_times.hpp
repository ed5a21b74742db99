/// When a run leaves a sample.
#pragma once

#include <cstddef>
#include <limits>

#include "lubjoint/run/outcome.hpp"

namespace lubjoint {

/// The multiples of a run's output interval after its start and before its end, one after another: the samples at
/// start and end are the caller's.
class OutputTimes {
 public:
  /// Of a run from 0.
  explicit OutputTimes(const RunSettings& settings) : settings_(settings) {}

  /// take(t) for each that is due and has not been taken.
  template <class Take>
  void up_to(double t, const Take& take) {
    for (double at = time(next_); at <= t && at < settings_.duration; at = time(++next_)) take(at);
  }

 private:
  /// i intervals; within rounding of the end it is the end.
  double time(std::size_t i) const {
    const double t = static_cast<double>(i) * settings_.output_interval;
    return t >= settings_.duration * (1 - 4 * std::numeric_limits<double>::epsilon()) ? settings_.duration : t;
  }

  RunSettings settings_;
  std::size_t next_ = 1;
};

}  // namespace lubjoint

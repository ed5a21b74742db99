/// What a run of Simbody's integrator leaves. In plain numbers, and C++17: Simbody's headers are no C++20.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lubjoint::mechanisms {

/// How a run ended, and what it cost.
struct SimbodyOutcome {
  bool finished = false;
  bool out_of_time = false;  ///< it was given up
  std::string message;       ///< why it stopped otherwise
  double seconds = 0;        ///< of processor time, the integration alone
  std::size_t steps = 0;
  std::size_t rejected = 0;     ///< steps that failed the error test
  std::size_t evaluations = 0;  ///< of all accelerations
};

/// A run, and where the journal was.
template <class Pin>
struct SimbodyRun : SimbodyOutcome {
  std::vector<Pin> pins;  ///< at the times that were asked for
};

/// "3.7.0"
std::string simbody_version();

}  // namespace lubjoint::mechanisms

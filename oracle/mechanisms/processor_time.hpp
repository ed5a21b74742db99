/// What a computation costs on a machine that others use too.
#pragma once

#include <time.h>

namespace lubjoint::mechanisms {

/// Processor time of this process so far [s]: what others run at the same time does not count, threads of its own do.
inline double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace lubjoint::mechanisms

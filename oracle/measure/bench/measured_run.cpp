#include <algorithm>

#include "oracle/measure/bench/bench_case.hpp"
#include "oracle/mechanisms/processor_time.hpp"

namespace lubjoint::reports {

MethodRun measured_run(const BenchLimits& limits, const Reference& reference,
                       const std::function<MethodRun(Reference* seen)>& once) {
  Reference seen;
  MethodRun result = once(&seen);
  if (!result.finished) return result;
  if (seen.size() != reference.size()) {
    result.finished = false;
    result.message = "did not say where it was at every output time";
    return result;
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    result.error = std::max(result.error, (seen[i] - reference[i]).norm());
  }
  std::vector<double> seconds;
  const double begin = mechanisms::processor_seconds();
  const auto pace = [&] { return limits.pace ? limits.pace() : 1.0; };
  double before = pace();
  for (int i = 0; i < limits.repeats; ++i) {
    MethodRun timed = once(nullptr);
    if (!timed.finished) return timed;  // at the edge of its share of time: no time of it is known
    const double after = pace();
    seconds.push_back(timed.seconds * 2 / (before + after));
    before = after;
    result.rhs_evaluations = timed.rhs_evaluations;
    if (i >= 2 && mechanisms::processor_seconds() - begin > limits.seconds) break;
  }
  std::sort(seconds.begin(), seconds.end());
  const std::size_t last = seconds.size() - 1;
  result.seconds = seconds[seconds.size() / 2];
  if (result.seconds > 0) result.spread = (seconds[last - last / 4] - seconds[last / 4]) / result.seconds;
  return result;
}

}  // namespace lubjoint::reports

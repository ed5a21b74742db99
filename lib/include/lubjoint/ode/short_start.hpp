/// How long a first step may be, before which nothing is known of a motion.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include "lubjoint/ode/integrator.hpp"

namespace lubjoint {

/// The time [s] in which the fastest of the states that control steps changes by its tolerance: min_i T_i / |f_i|,
/// T_i = absolute_i + relative |y_i|. Infinity where nothing moves, or where f has no value, which the step says.
template <class R, std::size_t N>
R time_of_a_tolerance(OdeSystem<R, N>& system, const StepTolerance<R, N>& tolerance, const StateOf<R, N>& y,
                      const R& t) {
  using std::abs;
  const R never = std::numeric_limits<R>::infinity();
  StateOf<R, N> rate = y;
  try {
    system.rate(y, rate, t);
  } catch (const std::domain_error&) {
    return never;
  }
  R fastest(0);
  for (std::size_t i = 0; i < tolerance.controlled(); ++i) {
    const R each = abs(rate[i]) / (tolerance.absolute[i] + tolerance.relative * abs(y[i]));
    if (each > fastest) fastest = each;
  }
  return fastest > 0 ? R(1 / fastest) : never;
}

/// The longest first step [s] of a method whose estimate looks at its stages: no state changes by more than a
/// thousandth of its unit, nominal tolerance 1. A film at rest, or a half film where it begins, has a force without
/// derivatives, and no estimate is to be trusted of a step in which rates change by more than a little. A journal at
/// rest under 1 MN, its film half, first step 1e-6 of the run: 3e-4 clearances off whatever the tolerance without this,
/// within it with this.
template <class R, std::size_t N>
R short_start(OdeSystem<R, N>& system, const StepTolerance<R, N>& tolerance, const StateOf<R, N>& y, const R& t) {
  const R thousandth = R(1) / 1000;
  return thousandth / tolerance.nominal * time_of_a_tolerance(system, tolerance, y, t);
}

}  // namespace lubjoint

/// Roots that are enclosed because the function changes its sign.
#pragma once

#include "oracle/certified/ball.hpp"

namespace lubjoint::certified {

/// A ball that contains a root of a continuous function: bisection, each sign certain, until a sign can't be told at
/// the working precision or the bracket has shrunk by 2^(−bits).
/// @param below, above  places where f is negative and positive (not checked: evaluate them before if in doubt)
template <class Function>
Ball enclosed_root(const Function& f, Ball below, Ball above) {
  const slong bits = working_bits();
  {
    const WorkingPrecision exact(4 * bits);  // the places are dyadic, and stay exact
    for (slong step = 0; step < bits; ++step) {
      Ball middle = (below + above) / 2;
      Ball value;
      {
        const WorkingPrecision working(bits);
        value = f(middle);
      }
      if (arb_is_negative(value.get())) {
        below = middle;
      } else if (arb_is_positive(value.get())) {
        above = middle;
      } else {
        break;
      }
    }
  }
  Ball root;
  arb_union(root.get(), below.get(), above.get(), bits);
  return root;
}

}  // namespace lubjoint::certified

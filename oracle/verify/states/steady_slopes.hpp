/// The slopes of a film's force at rest, twice: in closed form, as programs have them, and from the pressure.
#pragma once

#include "oracle/verify/states/solution.hpp"
#include "oracle/verify/states/steady_film.hpp"

namespace lubjoint::verify {

/// True for laws that carry a load at rest.
bool has_rest(Law law);

/// The published forms and their derivatives. @param law  one with has_rest
SteadySlopes published_slopes(Law law, Real ratio, Real gap);

/// The derivatives taken under the integral over the pressure, quadrature over θ: what answers are judged by. Of Pinkus
/// and Sternlicht's law, which is no integral, the law itself is differentiated, exactly but for rounding.
/// Short: F_r/S = ½∫g cosθ/H³ dθ, F_t/S = ½∫g sinθ/H³ dθ, g = a sinθ − 2b cosθ. Long: H³ dp/dθ ∝ a cosθ + 2b sinθ + C
/// with C such that p is zero at both ends (long_full: periodic; long_half_eq5: that C). The ends of the long dynamic
/// film, where dp/dθ is not zero, move with b by dθ/db = 2/a, and what the integrand is there is added.
/// Accuracy: 1e-17 of the largest slope over 1 − ε
SteadySlopes slopes_by_quadrature(Law law, Real ratio, Real gap);

}  // namespace lubjoint::verify

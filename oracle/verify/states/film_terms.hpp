/// The laws' formulas as programs work them out, term by term: verify's own, in more digits than any program has.
#pragma once

#include "oracle/verify/states/solution.hpp"

namespace lubjoint::verify {

/// F_r/S and F_t/S, each as a wedge term (of a) and a squeeze term (of b); needs ε, a and b. NaN where no film exists.
void find_terms(Solution& solution);

/// Sum of the magnitudes of what the film force is the sum of, over S [1/s], the parts that a term hides included.
Real size_of_film_terms(const Solution& solution);

}  // namespace lubjoint::verify

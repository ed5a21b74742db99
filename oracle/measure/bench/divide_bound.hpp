/// The least that a force law of two square roots and a division can cost on this machine.
#pragma once

#include <cstddef>

#include "lubjoint/film/batch.hpp"

namespace lubjoint::reports {

/// out[i] = √a[i] + √b[i] + c[i]/d[i], with the vector width of the instruction set: the units that divide and take
/// roots are busy all the time, everything else waits for them.
void two_roots_and_a_quotient(std::size_t n, const double* a, const double* b, const double* c, const double* d,
                              double* out, InstructionSet set);

}  // namespace lubjoint::reports

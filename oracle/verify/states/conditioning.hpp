/// How far the true answer to a state moves when its inputs move by their rounding.
#pragma once

#include "oracle/verify/states/solution.hpp"

namespace lubjoint::verify {

/// Σ |∂answer/∂x · x| over the inputs x of a state, for each number of the answer. For forces of a film the derivatives
/// are exact (dual numbers through the law, in extended precision), so that they hold up to the wall; the two
/// components of a force share the size of their vector, because programs work in other frames than ours. For a
/// transition, a film's ends and a pressure, whose films are never that thin, they are forward differences of 2⁻²⁴.
/// @param solution  solve(quantities, law, state)
/// Zero where there is no answer.
std::array<double, most_answers> input_conditioning(const State& state, const Solution& solution);

}  // namespace lubjoint::verify

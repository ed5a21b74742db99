/// SUNDIALS' linear systems of equations of motion at half their size, as Radau solves its own.
#pragma once

#include <sundials/sundials_linearsolver.h>

namespace lubjoint::reports {

/// Solves [αI βI; C D] x = r, which is what CVODE (I − γJ) and IDA (cI − J) make of J = [0 I; A B]:
///   (D − (β/α) C) x₂ = r₂ − C r₁/α,   x₁ = (r₁ − β x₂)/α.
/// For a dense SUNMatrix of an even size.
/// @throws std::bad_alloc
SUNLinearSolver half_size_solver(sunindextype size, SUNContext context);

}  // namespace lubjoint::reports

/// Friction torques, power and side flow of a film by quadrature of wall shear, dissipation and axial flow.
#pragma once

#include "oracle/verify/states/solution.hpp"

namespace lubjoint::verify {

/// What a program should answer, from sums over the film in extended precision:
///   T_J = −∬(μωR/h)R² − ½R∬h ∂p/∂θ, T_B = +… − …, steps of p at the film's ends included;
///   power ∬[μ(ωR)²/h + h³|∇p|²/12μ];  side flow, short bearings: ½cRL∫(a sinθ − 2b cosθ)dθ, NaN for long ones.
/// The power of long_half_eq5, whose pressure has a step, is ωT_C − cF·u with F from that pressure. Pinkus and
/// Sternlicht's law has no pressure: its torques and power are defined by its force and by ∬μωR/h over the dynamic
/// film. Beyond the film, flooded shear adds ∬μωR/h of the cavity, striated that of the oil that left at the minimum
/// film.
/// @param solution  of the right work: ε, 1 − ε, rates; force of Pinkus and Sternlicht's law alone
/// Accuracy: losses_quadrature_error
std::array<Real, 4> losses_by_quadrature(const Solution& solution);

/// Rounding of those sums: 1e-17 over √(1 − ε) of the largest that torques (T_C, c|F|), power and flow could be with
/// rates of this size. It matters where they vanish.
std::array<double, most_answers> losses_quadrature_error(const Solution& solution);

}  // namespace lubjoint::verify

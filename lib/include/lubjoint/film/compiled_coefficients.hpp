/// Stiffness and damping of a compiled law's film.
#pragma once

#include "lubjoint/film/coefficients.hpp"
#include "lubjoint/film/compiled_law.hpp"

namespace lubjoint {

/// K and C of a compiled law over their units, in (r, t), by differentiation throughout, exact to rounding.
template <CompiledLaw Law, class R>
CoefficientRatios<R> differentiated_coefficients(const Law& law, const SteadyPlace<R>& place, int spin_sign) {
  return differentiated_coefficients_of([&law](const auto& film) { return compiled_force_ratio(law, film); }, place,
                                        spin_sign);
}

/// The same, with K_rt = F_t/(cε) and K_tt = −F_r/(cε) from the force alone.
/// Accuracy: that of the table's slopes. Its stated error is of |F|; that of an entry is larger by what
/// differentiation costs, more towards the wall (tests).
template <CompiledLaw Law, class R>
CoefficientRatios<R> coefficient_ratios(const Law& law, const SteadyPlace<R>& place, int spin_sign) {
  CoefficientRatios<R> ratios = differentiated_coefficients(law, place, spin_sign);
  const PolarForce<R> force = compiled_polar_force_ratio(law, place.film(spin_sign));
  ratios.stiffness(0, 1) = force.tangential / place.eccentricity_ratio;
  ratios.stiffness(1, 1) = -force.radial / place.eccentricity_ratio;
  return ratios;
}

}  // namespace lubjoint

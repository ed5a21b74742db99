/// Finite-length films without a free boundary: full, half and dynamic.
#pragma once

#include <vector>

#include "lubjoint/film/extent.hpp"
#include "oracle/reynolds/scaled_film.hpp"

namespace lubjoint::oracle {

/// Force of a film whose bounds do not depend on z.
///
/// H does not depend on z, so P = Σ_k cos(κ_k ζ) f_k(θ) with κ_k = (2k+1)π/(2Λ), and each f_k obeys an ordinary
/// differential equation of its own:
///   (H³ f_k')' − κ_k² H³ f_k = −c_k s,   c_k = 2(−1)^k/(κ_k Λ)
/// It is solved by spectral elements (Gauss–Lobatto–Legendre), graded towards the pressure spike and towards the cut
/// ends, where f_k has layers of width 1/κ_k. What is summed over k is the difference from the short bearing, whose sum
/// is known: it falls like k^−6 (k^−5 where s ≠ 0 at a cut end).
/// The error estimate is the change from the next lower degree plus the remainder of the sum.
ScaledForce smooth_film_force(FilmExtent extent, const ScaledFilm& film, double relative_tolerance);

/// Its side flow: −∂ζP at ζ = Λ is Σ_k κ_k (−1)^k f_k. By the equation itself
///   ∫ H³ f_k dx = c_k (∫ s dx + [H³ f̂_k'])/κ_k²,   f_k = c_k f̂_k,
/// of which the first term, summed, is the short bearing's flow Λ ∫ s dx, and the second what passes through cut ends.
/// It falls like κ^−4 in the sum: at an end, H³ f̂_k' tends to ∓s/κ, and these cancel, as the ends are half a turn
/// apart, where s has opposite values; the next term is κ^−2.
/// Of a full film it is zero, and nothing is solved.
ScaledFlow smooth_film_flow(FilmExtent extent, const ScaledFilm& film, double relative_tolerance);

/// P at the product of the given angles (θ, from the maximum film) and ζ; row-major, one row per angle.
std::vector<double> smooth_film_pressure(FilmExtent extent, const ScaledFilm& film, const std::vector<double>& theta,
                                         const std::vector<double>& zeta, double relative_tolerance);

}  // namespace lubjoint::oracle

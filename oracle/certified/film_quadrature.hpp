/// Film forces and pressures once more, by rigorous quadrature along the film: no antiderivative is used.
#pragma once

#include "oracle/certified/film_laws.hpp"

namespace lubjoint::certified {

/// F_r/S and F_t/S of a law that has a pressure, as the integral of that pressure, enclosed.
///   short: P = ½ (a sinθ − 2b cosθ)/H³, the integral over z being L³/6;
///   long_full, long_half_eq5: P = 6 [a sinθ (2 + ε cosθ)/(D H²) + b (1 − cosθ)(2 + ε + ε cosθ)/(H²(1+ε)²)];
///     F_r/S = ∫ P cosθ dθ, F_t/S = ∫ P sinθ dθ;
///   long_half, long_dynamic: (H³P')' = −6 (a sinθ − 2b cosθ), P = 0 at both ends: P' = 6 (g + C)/H³ with
///     g = a cosθ + 2b sinθ and C = −∫ g/H³ / ∫ 1/H³, F_r/S = −∫ P' sinθ dθ, F_t/S = ∫ P' cosθ dθ;
///   squeeze_*: short_full, long_full, short_dynamic's and long_dynamic's fields at a = 0.
/// Quadrature: Petras' algorithm as in acb_calc_integrate (F. Johansson, Numerical integration in arbitrary-precision
/// ball arithmetic, ICMS 2018), in θ.
/// @throws std::invalid_argument for a law without a pressure
PolarBalls force_ratio_by_quadrature(Law law, const FilmBalls& film);

/// P(θ) of the long film with P = 0 at both ends, over 6μ(R/c)², by quadrature of P' from the film's start.
/// @param theta  inside of the film
Ball long_pressure_by_quadrature(Extent extent, const FilmBalls& film, double theta);

}  // namespace lubjoint::certified

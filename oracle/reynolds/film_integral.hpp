/// Force and pressure of the one-dimensional films, by quadrature: what the closed-form laws are judged by.
#pragma once

#include "lubjoint/film/bearing.hpp"
#include "lubjoint/film/film_state.hpp"
#include "oracle/quadrature/estimate.hpp"
#include "oracle/reynolds/film_name.hpp"
#include "oracle/reynolds/film_rule.hpp"

namespace lubjoint::oracle {

struct FilmQuadratureOptions {
  FilmQuadratureRule rule = FilmQuadratureRule::gauss_legendre;
  double relative_tolerance = 1e-13;  ///< of |F|, for the truncation of the rule; rounding comes on top
};

/// Force on the journal, with the film it was integrated over.
struct FilmForceEstimate {
  Estimate radial;      ///< along the eccentricity [N]
  Estimate tangential;  ///< 90° counter-clockwise of it [N]
  double theta_s;       ///< begin of the film, in (−π, π] for the dynamic film [rad from the maximum film]
  double theta_e;       ///< its end, not reduced [rad]
};

/// Force of the film on the journal, F_r = R∬ p cosθ dθ dz and F_t = R∬ p sinθ dθ dz, by quadrature of the pressure.
///   short: p = 3μ/(c²H³) (L²/4 − z²)(a sinθ − 2b cosθ); the integral over z is L³/6
///   long_full, long_half_eq5: p of eq. 5
///   long_half, long_dynamic: d/dθ(H³ dp/dθ) = −6μ(R/c)²(a sinθ − 2b cosθ), p = 0 at both ends. One integration gives
///     dp/dθ = −k (G + C)/H³ with G = ∫(a sinθ − 2b cosθ)dθ, k = 6μ(R/c)², and C from ∫ dp = 0; by parts
///     F_r = −RL ∫ p' sinθ dθ and F_t = RL ∫ p' cosθ dθ, in which sinθ and cosθ may be counted from any origin: they
///     are counted from their weighted means, so that nothing large is left to cancel.
/// Half films are mirrored where a < 0. A state at rest has no force. Source of the fields: Flores et al. (2009), eqs.
/// 3, 5.
/// @param state  q ≥ 1e-40; a known q is used as it is
/// @throws FilmDomainError for a smaller q; std::invalid_argument for a tolerance that is negative or not a number, and
/// for
///         the trapezoid rule on a film that is not full; QuadratureError with film and state if the rule fails
/// Accuracy (gauss_legendre, default tolerance): measured error at most 5e-15 |F| for ε up to 1 − 1e-15, and with a
/// known q beyond. Where the two terms of a half film cancel, |F| is small against them, at worst by √(1 − ε), and the
/// error is 5e-15 of the terms; the estimate shows it. Cost: 3 to 15 µs.
FilmForceEstimate film_force_by_quadrature(OneDimensionalFilm film, const Bearing<double>& bearing,
                                           const Lubricant<double>& lubricant, const PolarFilmState<double>& state,
                                           const FilmQuadratureOptions& options = {});

/// The same by the default rule alone, in which there is no GSL.
/// @param relative_tolerance  of |F|
FilmForceEstimate film_force_by_gauss_legendre(OneDimensionalFilm film, const Bearing<double>& bearing,
                                               const Lubricant<double>& lubricant, const PolarFilmState<double>& state,
                                               double relative_tolerance = FilmQuadratureOptions().relative_tolerance);

/// The same by a rule and what applies it.
FilmForceEstimate film_force_by_rule(OneDimensionalFilm film, const Bearing<double>& bearing,
                                     const Lubricant<double>& lubricant, const PolarFilmState<double>& state,
                                     const FilmRule& rule, double relative_tolerance);

/// Pressure [Pa] at θ [rad from the maximum film] and, for short films, at z [m from the middle], by the fields and the
/// differential equation above; zero outside the film.
/// @throws std::domain_error if |z| > L/2; otherwise as above
Estimate film_pressure_by_quadrature(OneDimensionalFilm film, const Bearing<double>& bearing,
                                     const Lubricant<double>& lubricant, const PolarFilmState<double>& state,
                                     double theta, double z = 0);

}  // namespace lubjoint::oracle

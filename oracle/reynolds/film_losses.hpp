/// Torques, dissipation and side flow of the one-dimensional films, by quadrature of the wall shear and of the
/// dissipation: what the closed forms of the losses are judged by.
#pragma once

#include <optional>

#include "lubjoint/film/bearing.hpp"
#include "lubjoint/film/film_state.hpp"
#include "oracle/quadrature/estimate.hpp"
#include "oracle/reynolds/film_name.hpp"

namespace lubjoint::oracle {

/// Each of them is an integral of its own: none is made of another.
struct FilmLossEstimate {
  Estimate torque_journal;            ///< R²∬τ_J, on the journal about its centre [N m]
  Estimate torque_bearing;            ///< R²∬τ_B, on the bearing about its centre [N m]
  Estimate couette_power;             ///< ∬μ(ωR)²/h [W]
  Estimate pressure_power;            ///< ∬h³|∇p|²/(12μ) [W]
  std::optional<Estimate> side_flow;  ///< out of both sides, net [m³/s]; long films have none
};

/// Losses of the film where it carries pressure.
///   τ_J = −μωR/h − (h/2R) ∂p/∂θ,  τ_B = μωR/h − (h/2R) ∂p/∂θ,  the steps of p at the ends of the film being a part of
///   ∂p/∂θ. Short: p = 3μ/(c²H³)(L²/4 − z²)g, g = a sinθ − 2b cosθ, and the dissipation is that of ∂p/∂z; long:
///   H³ ∂p/∂θ = 6μ(R/c)²(a cosθ + 2b sinθ + C), C from p = 0 at both ends (long_full: p periodic; long_half_eq5: C of
///   the full film, whose p at π is an integral of its slope).
/// @param relative_spin  ω = ω_J − ω_B [rad/s]
/// Accuracy: the error is the change from one rung of Gauss and Legendre's ladder to the next, and rounding. For ε up
/// to 0.999 it is below 1e-12 of the terms.
FilmLossEstimate film_losses_by_quadrature(OneDimensionalFilm film, const Bearing<double>& bearing,
                                           const Lubricant<double>& lubricant, const PolarFilmState<double>& state,
                                           double relative_spin);

}  // namespace lubjoint::oracle

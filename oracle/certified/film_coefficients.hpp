/// Stiffness and damping of a film about a steady state, in balls: by closed forms, and by rigorous quadrature of the
/// derivatives of the pressure.
#pragma once

#include "oracle/certified/film_laws.hpp"

namespace lubjoint::certified {

struct SteadyState {
  double viscosity, length, radius, clearance;
  double epsilon;  ///< 0 < ε < 1
  double omega;    ///< of the journal; the bearing is at rest [rad/s]
};

/// K over Sω/c and C over S/c in (r, t) for ω > 0.
struct CoefficientBalls {
  Ball krr, krt, ktr, ktt, crr, crt, ctr, ctt;
};

/// −F_r′, F_t/ε, −F_t′, −F_r/ε and −∂_bF_r, 2∂_aF_r, −∂_bF_t, 2∂_aF_t, each law's in closed form.
CoefficientBalls coefficients(Law law, const Ball& epsilon);

/// The same with the derivatives of F taken under the integral over the film; ends of the dynamic film that move with b
/// add what the integrand is there.
/// @throws std::invalid_argument for a law without a pressure
CoefficientBalls coefficients_by_quadrature(Law law, const Ball& epsilon);

/// In the frame of the load: x along the load on the journal, y 90° counter-clockwise of it.
struct SteadyBalls {
  Ball load, attitude;
  Ball kxx, kxy, kyx, kyy, cxx, cxy, cyx, cyy;
  Ball kappa_ratio, whirl_square;  ///< κc/(S|ω|) and (ν/ω)² of Routh's condition
  Ball critical_mass;              ///< κ/ν² [kg]: of use where both are positive
};
SteadyBalls steady_state(const LawEntry& law, const SteadyState& state);

/// A journal under a load in a bearing at rest.
struct LoadedJournal {
  double viscosity, length, radius, clearance;
  double omega;  ///< of the journal, not 0 [rad/s]
  double load;   ///< along −y, above 0 [N]
};

/// ε of such a journal: the enclosed root of equilibrium.hpp.
Ball loaded_ratio(const LawEntry& law, const LoadedJournal& journal);

/// The same at that ε, in inertial axes: x is the y of the load's frame, and y minus its x.
SteadyBalls loaded_state(const LawEntry& law, const LoadedJournal& journal, const Ball& epsilon);

}  // namespace lubjoint::certified

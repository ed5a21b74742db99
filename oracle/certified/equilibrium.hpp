/// Steady states of a journal under a constant load, enclosed.
#pragma once

#include "oracle/certified/film_laws.hpp"

namespace lubjoint::certified {

struct EquilibriumState {
  double viscosity, length, radius, clearance;
  double omega_sum;       ///< ω_J + ω_B, not 0 [rad/s]
  double load_x, load_y;  ///< not both 0 [N]
};

struct EquilibriumBalls {
  Ball eccentricity_ratio;
  Ball ex_over_c, ey_over_c;
  Ball attitude;  ///< from the load's direction to e, positive in the sense of the spin [rad]
};

/// The steady state F = −W with a = ε(ω_J + ω_B), b = 0: |F| = |W| by a bracket across which |F|² − |W|² changes its
/// sign, then the direction of e from F's direction in its own frame.
EquilibriumBalls equilibrium(const LawEntry& law, const EquilibriumState& state);

}  // namespace lubjoint::certified

/// Friction torques, power and side flow in balls: by closed forms, and by rigorous quadrature of wall shear,
/// dissipation and axial flow.
#pragma once

#include <optional>

#include "oracle/certified/joint_forces.hpp"

namespace lubjoint::certified {

struct LossBalls {
  Ball torque_journal;            ///< about the journal's centre [N m]
  Ball torque_bearing;            ///< about the bearing's centre [N m]
  Ball power;                     ///< lost in the film [W]
  std::optional<Ball> side_flow;  ///< out of both sides of a short bearing, net [m³/s]
};

/// T_C = (μωR³L/c)∫dθ/H, T_J = −T_C − ½e×F, T_B = T_C − ½e×F, power ωT_C − cF·u; cRL times 0 (full), |a| (half), 2|u|
/// (dynamic). ∫dθ/H is 2π/√q (full), π/√q (half), (2/√q) atan2(√q, −ε sinθs) (dynamic; π/√q at rest).
LossBalls film_losses(const LawEntry& law, const JointState& state);

/// The same from the film: R²∬τ with τ = ∓μωR/h − (h/2R)∂p/∂θ, steps of p included, and for films with p = 0 at their
/// edges ∬[μ(ωR)²/h + h³|∇p|²/12μ]; the power of long_half_eq5, whose pressure has a step, is −(F·v + T_J ω_J + T_B
/// ω_B) which is its couette part and −cF·u, F by quadrature of its pressure.
/// @throws std::invalid_argument for a law without a pressure
LossBalls film_losses_by_quadrature(const LawEntry& law, const JointState& state);

}  // namespace lubjoint::certified

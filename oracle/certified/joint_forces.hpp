/// Forces and moments of a joint in Cartesian components, in balls: film, dry contact and the transition between them.
#pragma once

#include "oracle/certified/film_laws.hpp"

namespace lubjoint::certified {

/// A bearing, its oil and the motion of its journal, inertial, SI: the columns of the golden files.
struct JointState {
  double viscosity, length, radius, clearance;
  double omega_bearing, omega_journal;
  double ex, ey;  ///< journal's centre minus bearing's centre
  double vx, vy;  ///< inertial rate of it
};

/// From the mass centres to the centres of bearing (body i) and journal (body j), inertial [m].
struct JointArms {
  double sx_i, sy_i, sx_j, sy_j;
};

/// Tolerances of the transition, and dry contact after Lankarani and Nikravesh.
struct ContactState {
  double e0, e1;        ///< 0 < e₀ < e₁ [m]
  double stiffness;     ///< K [N/m^1.5]
  double restitution;   ///< c_r
  double impact_speed;  ///< δ̇₀ > 0 [m/s]
};

struct PlaneBalls {
  Ball x;
  Ball y;
};

/// Film state from vectors, without an angle: ε = |e|/c, b = (v·r)/c, a = ε(ω_J + ω_B) − 2(v·t)/c. At e = 0 r lies
/// along v. Zeros of a and b are exact.
struct FilmFrame {
  FilmBalls film;
  PlaneBalls radial;
};
FilmFrame film_frame(const JointState& state, const Ball& clearance);

/// F = F_r r + F_t t of a law on the journal [N], with the film in the clearance given.
struct FilmForce {
  PlaneBalls force;
  Ball tangential;  ///< F_t
};
FilmForce film_force(const LawEntry& law, const JointState& state, const Ball& clearance);

/// Force on the journal and moments about the mass centres, page "wrench": body j: s_j × F; body i: s_i × (−F) and
/// the transport moment e × (−F) = −|e| F_t.
struct WrenchBalls {
  PlaneBalls force;
  Ball moment_bearing;
  Ball moment_journal;
};
WrenchBalls joint_wrench(const LawEntry& law, const JointState& state, const JointArms& arms);

/// Force of dry contact on the journal [N]: −r K δ^{3/2} [1 + (3(1 − c_r²)/4) δ̇/δ̇₀], δ = |e| − c > 0; never towards
/// the wall.
PlaneBalls dry_force(const JointState& state, const ContactState& contact);

/// The transition, Flores et al. (2009), eq. 20:
///   F_film for |e| ≤ c, F_dry for |e| ≥ c + e₀, ((c + e₀ − |e|) F_film + (|e| − c) F_dry)/e₀ between;
/// the film has the clearance c + e₁ throughout.
PlaneBalls transition_force(const LawEntry& law, const JointState& state, const ContactState& contact);

/// K = (4/3) √(R_B R_J/(R_B − R_J))/((1 − ν_B²)/E_B + (1 − ν_J²)/E_J), R_B = R_J + c [N/m^1.5].
Ball contact_stiffness(double radius, double clearance, double modulus_bearing, double poisson_bearing,
                       double modulus_journal, double poisson_journal);

/// Exit speed of a free impact with d = 3(1 − c_r²)/(4δ̇₀): the root v₁ of d δ̇₀ − ln(1 + d δ̇₀) = −d v₁ − ln(1 − d v₁).
/// @param restitution  0 ≤ c_r < 1
Ball exit_speed(double impact_speed, double restitution);

}  // namespace lubjoint::certified

/// The states at which golden values are given. All are exact doubles, made without library functions whose last bit
/// depends on the machine.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "oracle/certified/equilibrium.hpp"
#include "oracle/certified/film_coefficients.hpp"
#include "oracle/certified/joint_forces.hpp"

namespace lubjoint::certified {

/// Seeded doubles, the same on every machine.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : generator_(seed) {}
  /// Uniform in [0, 1), a multiple of 2^(−53).
  double part() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
  /// Uniform in [−1, 1).
  double sign_part() { return 2 * part() - 1; }
  /// A random size over so many binary decades around 1, with a random sign.
  double size(int binary_decades);

 private:
  std::mt19937_64 generator_;
};

struct BearingValues {
  double viscosity, length, radius, clearance;
};
/// The journal of Flores et al. (2009); one whose values are short in binary; a thick short one with thin oil.
inline constexpr std::array<BearingValues, 3> bearings = {
    {{0.4, 0.04, 0.0098, 0.0002}, {0.375, 0.03125, 0.015625, 0.0001220703125}, {0.012, 0.025, 0.05, 5e-05}}};

struct PolarState {
  double epsilon, a, b;
};
/// Grid, near-concentric (ε to 1e-300), thin (1 − ε to 1e-12), kinks (a or b near 0), rest, extreme rates, random.
std::vector<PolarState> polar_states();

struct WrenchState {
  JointState joint;
  JointArms arms;
};
std::vector<WrenchState> wrench_states();

struct TransitionState {
  JointState joint;
  ContactState contact;
};
/// Below, at and just beside both seams, between them and beyond, at all motions.
std::vector<TransitionState> transition_states();

std::vector<EquilibriumState> equilibrium_states();

/// Light, moderate and heavy loads, both senses of the spin.
std::vector<LoadedJournal> loaded_journals();

}  // namespace lubjoint::certified

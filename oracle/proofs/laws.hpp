/// Every force law in polar and in vector form, for the proofs that go through all of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/proofs/formulas.hpp"

namespace lubjoint::proofs {

/// ê and u with the scalars that the laws take from them: ε = |ê|, s = √(1 − ε²), |u|, σ = sgn(a) = −sgn(ê × u),
/// δ = atan2(s, −ê·u/|u|), and the products of ê and u.
struct PlaneState {
  Planar e_hat;
  Planar u;
  ex eps;
  ex s;
  ex speed;
  ex sigma;
  ex delta;
  ex e_e;        ///< ê·ê
  ex e_dot_u;    ///< ê·u
  ex e_cross_u;  ///< ê × u

  /// The same scalars with other vectors, and the products computed from those.
  PlaneState with(const Planar& new_e_hat, const Planar& new_u) const;
};

struct Law {
  std::string name;
  std::string source;
  Polar polar;  ///< in a = 2|u| cosθs and b = |u| sinθs
  std::function<Planar(const PlaneState&)> vector;
};
const std::vector<Law>& laws();

/// Pinkus and Sternlicht in vectors, K = s|u|.
Planar pinkus_sternlicht_vector(const PlaneState& state, bool closing);

/// A state with components ê_x, ê_y, u_x, u_y.
struct FreeState {
  symbol e_x{"e_x"}, e_y{"e_y"}, u_x{"u_x"}, u_y{"u_y"};
  PlaneState state;
  Algebra algebra;  ///< s² = 1 − |ê|², ε² = |ê|², |u|² = u·u, σ² = 1, and the angle
  symbol angle{"angle"};

  FreeState();
};

}  // namespace lubjoint::proofs

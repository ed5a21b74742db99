/// Steady state of a journal under a constant load, found on the law itself.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>

#include "lubjoint/number/vector.hpp"
#include "lubjoint/scene/scene.hpp"

namespace lubjoint {

/// What a small displacement from the steady state does.
enum class Stability { decays, grows, neutral };

/// A journal at rest on its film, and its linearisation there.
struct JournalEquilibrium {
  Vector2<double> eccentricity;   ///< ê [-]
  double eccentricity_ratio = 0;  ///< ε
  double attitude = 0;            ///< from the load's direction to e, positive in the sense of the spin [rad]
  Vector2<double> force;          ///< of the film on the journal [N]
  Eigen::Matrix2d stiffness;      ///< −∂F/∂e [N/m], inertial frame
  Eigen::Matrix2d damping;        ///< −∂F/∂v [N s/m]
  std::array<std::complex<double>, 4> eigenvalues;  ///< of the journal on its film [1/s], largest real part first
  double eigenvalue_rounding = 0;                   ///< what rounding can do to them [1/s]

  /// Fate of a small displacement: the largest real part against its rounding.
  Stability stability() const;
};

/// Equilibrium under the scene's loads with the law that it names: |F(ε)| = |W| by bracketed root finding, exact
/// derivatives by automatic differentiation, eigenvalues in extended precision.
/// @throws SceneError if the scene is no free journal, or nothing carries its load because both spins cancel
JournalEquilibrium journal_equilibrium(const Scene& scene);

}  // namespace lubjoint

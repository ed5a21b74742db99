/// Stability of a rigid rotor on the stiffness and damping of its films, m ẍ + C ẋ + K x = 0, m the mass per bearing.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <optional>

#include "lubjoint/number/scalar.hpp"

namespace lubjoint {

/// The mass from which on a rotor is unstable, and its whirl there.
template <class R>
struct RotorThreshold {
  R critical_mass;                   ///< [kg]; infinite: every mass is stable; 0: none is
  std::optional<R> whirl_frequency;  ///< at that mass [rad/s]; none where it is infinite

  /// Is every mass stable?
  bool always_stable() const { return critical_mass == std::numeric_limits<R>::infinity(); }
};

/// The threshold by the conditions of Routh and Hurwitz:
///   κ = (K_xx C_yy + K_yy C_xx − K_xy C_yx − K_yx C_xy)/tr C,  ν² = det(K − κ)/det C,  m_c = κ/ν².
/// Stable are the masses m with κ > m ν², if κ, det K, tr C and det C are positive: for ν² ≤ 0 all of them.
/// Invariant under a turn of the axes (proved in oracle/proofs).
template <class R>
RotorThreshold<R> routh_threshold(const Eigen::Matrix<R, 2, 2>& k, const Eigen::Matrix<R, 2, 2>& c) {
  using std::sqrt;
  const auto det = [](const Eigen::Matrix<R, 2, 2>& m) { return R(m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0)); };
  const R trace = c(0, 0) + c(1, 1);
  const R determinant = det(c);
  const R kappa = (k(0, 0) * c(1, 1) + k(1, 1) * c(0, 0) - k(0, 1) * c(1, 0) - k(1, 0) * c(0, 1)) / trace;
  const R whirl = ((k(0, 0) - kappa) * (k(1, 1) - kappa) - k(0, 1) * k(1, 0)) / determinant;
  const bool never = !(trace > 0 && determinant > 0 && kappa > 0 && det(k) > 0);
  if (!never && !(whirl > 0)) return {std::numeric_limits<R>::infinity(), std::nullopt};
  const std::optional<R> frequency = whirl > 0 ? std::optional<R>(sqrt(whirl)) : std::nullopt;
  if (never) return {R(0), frequency};
  return {R(kappa / whirl), frequency};
}

}  // namespace lubjoint

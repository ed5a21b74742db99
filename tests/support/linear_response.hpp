/// The orbit of a rotor with an unbalance in its film, by the linear coefficients of its steady state.
#pragma once

#include <Eigen/LU>
#include <complex>

#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/scene.hpp"

namespace lubjoint::test {

/// Z of the orbit e₀ + Re(Z exp(iωt)) that a small unbalance U makes [m]: (K − mω² + iωC) Z = Uω² (1, −i).
/// @param factor  of K
inline Eigen::Vector2cd linear_response(const Scene& scene, const JournalEquilibrium& rest, double unbalance,
                                        double factor) {
  using Complex = std::complex<double>;
  const double omega = scene.bodies[0].spin;
  const Complex i(0, 1);
  const Eigen::Matrix2cd matrix = factor * rest.stiffness.cast<Complex>() + i * omega * rest.damping.cast<Complex>() -
                                  scene.bodies[0].mass * omega * omega * Eigen::Matrix2cd::Identity();
  return matrix.inverse() * Eigen::Vector2cd(unbalance * omega * omega, -i * unbalance * omega * omega);
}

/// e on that orbit at a time [m].
inline Vector2<double> on_linear_orbit(const Scene& scene, const JournalEquilibrium& rest, const Eigen::Vector2cd& z,
                                       double t) {
  return scene.joints[0].clearance * rest.eccentricity + (z * std::polar(1.0, scene.bodies[0].spin * t)).real();
}

}  // namespace lubjoint::test

/// The finite-length film without dimensions, as both of its solvers see it.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace lubjoint::oracle {

/// Reynolds' equation with p = 6μ(R/c)² P, ζ = z/R and the coordinate x = θ − π, which is zero at the minimum film:
///   ∂x(H³ ∂xP) + H³ ∂ζζP = −s,   s = −a sin x + 2b cos x,   P = 0 at |ζ| = Λ = L/D
/// a ≥ 0 here: the other sign is the mirror image.
struct ScaledFilm {
  double epsilon;      ///< ε [-]
  double thinnest;     ///< 1 − ε
  double slip;         ///< a, scaled with the larger rate
  double squeeze;      ///< b, scaled with the same
  double slenderness;  ///< Λ = L/D

  /// H = (1 − ε) + 2ε sin²(x/2): a sum of positive terms, so nothing cancels at the minimum film.
  double thickness(double x) const {
    const double half = std::sin(x / 2);
    return thinnest + 2 * epsilon * half * half;
  }
  double source(double x) const { return 2 * squeeze * std::cos(x) - slip * std::sin(x); }
  /// Angle over which the film doubles its thickness: the width of the pressure spike, √(2(1 − ε)/ε).
  double spike_width() const { return std::sqrt(2 * thinnest / epsilon); }
};

/// ∬ P (cosθ, sinθ) dθ dζ over |ζ| ≤ Λ, with its error estimate.
struct ScaledForce {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();  ///< radial, tangential
  Eigen::Vector2d error = Eigen::Vector2d::Zero();  ///< bounds of the components' errors
  double observed_order = 0;
  int unknowns = 0;  ///< of the largest system solved
};

}  // namespace lubjoint::oracle

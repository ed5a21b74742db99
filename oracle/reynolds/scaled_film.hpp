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
  /// ∬ s⁺ dx dζ over half the length, 2Λ √(a² + 4b²): no film loses more by a side, and a short one as much.
  double displacement() const { return 2 * slenderness * std::hypot(slip, 2 * squeeze); }
  /// Angle over which the film doubles its thickness: the width of the pressure spike, √(2(1 − ε)/ε).
  double spike_width() const { return std::sqrt(2 * thinnest / epsilon); }
};

/// N integrals of P, with their error estimates.
template <int N>
struct ScaledResult {
  using Values = Eigen::Matrix<double, N, 1>;
  Values value = Values::Zero();
  Values error = Values::Zero();  ///< bounds of the values' errors
  double observed_order = 0;
  int unknowns = 0;  ///< of the largest system solved
};

/// ∬ P (cosθ, sinθ) dθ dζ over |ζ| ≤ Λ: radial, tangential.
using ScaledForce = ScaledResult<2>;

/// ∫ −H³ ∂ζP dθ at ζ = Λ: what leaves the film by one side, over cR²/2 times the rate that a and b were divided by;
/// net, what is drawn in counts against it. As P is even in ζ, as much leaves by the other side. Where P = ∂P/∂n = 0
/// along the film's other bounds, or there are none, it is what the motion displaces, ∬ s dθ dζ/2 over the film;
/// through cut ends, at which P alone vanishes, oil passes, too. Tolerances are shares of ScaledFilm::displacement(),
/// as the net flow may vanish.
using ScaledFlow = ScaledResult<1>;

/// ∬ dθ dζ/H over the part of |ζ| ≤ Λ that carries pressure, over 2Λ.
using ScaledCouette = ScaledResult<1>;

/// P at a place, and the film's largest.
struct ScaledPressure {
  double value = 0;
  double largest = 0;
  double error = 0;  ///< bound of the value's error
};

}  // namespace lubjoint::oracle

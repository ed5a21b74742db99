#pragma once

#include "lubjoint/film/dynamic_moments.hpp"
#include "lubjoint/film/law.hpp"

namespace lubjoint {

/// Film force of the infinitely long bearing, dynamic film: Reynolds' equation on θs…θs + π with p = 0 at both ends.
///   F = −12 S|u| [Var(d₂) û − Cov(d₁, d₂) û⊥],   covariances of the wall's direction d with weight 1/H³,
///     = −(12 S|u|/q^{3/2}) V/(A + q e₂²V/N²) [N²A û + e₂E û⊥],   S = μLR³/c²   (dynamic_moments.hpp)
/// What Pinkus and Sternlicht's eqs. 14 to 18 approximate. Smooth away from u = 0; one arctangent. A film that opens
/// keeps its digits as ε → 1.
/// Accuracy: data/accuracy.csv
struct LongDynamic {
  static constexpr std::string_view name = "long_dynamic";                 ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;        ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::dynamic;                ///< θs…θs + π
  static constexpr std::string_view words = "long bearing, dynamic film";  ///< for people
  static constexpr bool has_pressure = true;                               ///< the force is its integral
  static constexpr Potential potential = Potential::none;                  ///< ∂F/∂u is not symmetric

  /// F/S [1/s] in the frame of the film state, as above; u ≠ 0.
  template <class T>
  static Vector2<T> force_ratio(const FilmState<T>& film) {
    return detail::resistance_of<LongDynamic>(film);
  }

  /// Its parts in the film's own frame, where the film opens narrowly.
  template <class T>
  static detail::FrameForce<T> narrow(const detail::DynamicFrame<T>& frame) {
    const T& e2 = frame.e2;
    const T& n2 = frame.n2;
    const T rho = detail::arc_remainder(frame.y);
    const T m = -frame.e1;
    const T v = RealOf<T>(2) / 3 + frame.y * rho;
    const T a = (3 - frame.y) * rho - RealOf<T>(2) / 3;
    const T factor = 12 * v / (n2 * (a + e2 * e2 * v));
    const T across = e2 * (2 * n2 - 3 * m * m * rho) / n2;
    return {T(factor * m * a), T(factor * across)};
  }

  /// And elsewhere.
  template <class T>
  static detail::FrameForce<T> wide(const detail::DynamicFrame<T>& frame, const T& q) {
    using std::sqrt;
    const T& e1 = frame.e1;
    const T& e2 = frame.e2;
    const T& n2 = frame.n2;
    const T root = sqrt(q);
    const T delta = detail::half_length(frame, root);
    const T squares = 3 * e1 * e1;
    const T v = delta + e1 * root / n2;
    const T a = ((2 * q + squares) * delta + e1 * root * (4 * q + squares) / n2) / n2;
    const T e = 3 * e1 * delta + root * (2 * q + squares) / n2;
    const T factor = 12 * v / (q * root * (a + frame.y * e2 * e2 * v));
    return {T(factor * n2 * a), T(factor * e2 * e)};
  }
};

}  // namespace lubjoint

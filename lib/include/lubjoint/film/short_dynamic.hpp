#pragma once

#include "lubjoint/film/dynamic_moments.hpp"
#include "lubjoint/film/law.hpp"

namespace lubjoint {

/// Film force of the infinitely short bearing, dynamic film: the positive part of the pressure, exactly.
///   F_r = (S/2) ∫ (a sinθ − 2b cosθ) cosθ/H³ dθ,  F_t = (S/2) ∫ (a sinθ − 2b cosθ) sinθ/H³ dθ  over θs…θs + π,
///   F = −(S|u|/q^{5/2}) [W û + e₂E û⊥],   S = μRL³/c²   (W, E, e₂: dynamic_moments.hpp)
/// Smooth away from u = 0; one arctangent. A film that opens keeps its digits as ε → 1.
/// Accuracy: data/accuracy.csv
struct ShortDynamic {
  static constexpr std::string_view name = "short_dynamic";                 ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::short_bearing;        ///< S = μRL³/c²
  static constexpr FilmExtent extent = FilmExtent::dynamic;                 ///< θs…θs + π
  static constexpr std::string_view words = "short bearing, dynamic film";  ///< for people
  static constexpr bool has_pressure = true;                                ///< the force is its integral
  static constexpr Potential potential = Potential::convex;                 ///< of the dissipation

  /// F/S [1/s] in the frame of the film state, as above; u ≠ 0.
  template <class T>
  static Vector2<T> force_ratio(const FilmState<T>& film) {
    return detail::resistance_of<ShortDynamic>(film);
  }

  /// Its parts in the film's own frame, where the film opens narrowly.
  template <class T>
  static detail::FrameForce<T> narrow(const detail::DynamicFrame<T>& frame) {
    const T& n2 = frame.n2;
    const T rho = detail::arc_remainder(frame.y);
    const T m = -frame.e1;
    const T n4 = n2 * n2;
    const T along = m / n4 * ((3 - 2 * frame.y) * rho - RealOf<T>(4) / 3);
    const T across = frame.e2 / (n4 * n2) * (2 * n2 - 3 * m * m * rho);
    return {along, across};
  }

  /// And elsewhere.
  template <class T>
  static detail::FrameForce<T> wide(const detail::DynamicFrame<T>& frame, const T& q) {
    using std::sqrt;
    const T& e1 = frame.e1;
    const T& n2 = frame.n2;
    const T root = sqrt(q);
    const T delta = detail::half_length(frame, root);
    const T squares = 3 * e1 * e1;
    const T w = (q + squares) * delta + 3 * e1 * root;
    const T e = 3 * e1 * delta + root * (2 * q + squares) / n2;
    const T q52 = q * q * root;
    return {T(w / q52), T(frame.e2 * e / q52)};
  }
};

}  // namespace lubjoint

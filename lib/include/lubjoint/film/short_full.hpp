#pragma once

#include "lubjoint/film/law.hpp"

namespace lubjoint {

/// Film force of the infinitely short bearing, full (Sommerfeld) film.
///   F_r = −S π b (1+2ε²)/q^{5/2},   F_t = S π a/(2 q^{3/2}),   S = μRL³/c²
///   F = −(πS/q^{5/2}) [q u + 3(ê·u) ê]
/// Source: Flores et al. (2009), eqs. 6 and 7. Linear in u.
/// Accuracy: data/accuracy.csv
struct ShortFull {
  static constexpr std::string_view name = "short_full";                 ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::short_bearing;     ///< S = μRL³/c²
  static constexpr FilmExtent extent = FilmExtent::full;                 ///< 0…2π, negative pressure kept
  static constexpr std::string_view words = "short bearing, full film";  ///< for people
  static constexpr bool has_pressure = true;                             ///< the force is its integral
  static constexpr Potential potential = Potential::convex;              ///< of the dissipation

  /// F/S [1/s] in the frame of the film state, as above; u ≠ 0.
  template <class T>
  static Vector2<T> force_ratio(const FilmState<T>& film) {
    using std::sqrt;
    const T s = dot(film.eccentricity, film.velocity);
    const T root = sqrt(film.q);
    const T factor = -pi<T>() / (film.q * film.q * root);
    const T s3 = 3 * s;
    return Vector2<T>(T(factor * (film.q * film.velocity.x() + s3 * film.eccentricity.x())),
                      T(factor * (film.q * film.velocity.y() + s3 * film.eccentricity.y())));
  }
};

}  // namespace lubjoint

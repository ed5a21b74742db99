#pragma once

#include "lubjoint/film/law.hpp"

namespace lubjoint {

/// Film force of the infinitely long bearing, full (Sommerfeld) film.
///   F_r = −12 S π b/q^{3/2},   F_t = 12 S π a/(D q^{1/2}),   S = μLR³/c²,   D = 2 + ε²
///   F = −(12πS/(D q^{3/2})) [2q u + 3(ê·u) ê]
/// Source: Flores et al. (2009), eqs. 10 and 11. Linear in u.
/// Accuracy: data/accuracy.csv
struct LongFull {
  static constexpr std::string_view name = "long_full";                 ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;     ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::full;                ///< 0…2π, negative pressure kept
  static constexpr std::string_view words = "long bearing, full film";  ///< for people
  static constexpr bool has_pressure = true;                            ///< the force is its integral
  static constexpr Potential potential = Potential::convex;             ///< of the dissipation

  /// F/S [1/s] in the frame of the film state, as above; u ≠ 0.
  template <class T>
  static Vector2<T> force_ratio(const FilmState<T>& film) {
    using std::sqrt;
    const T s = dot(film.eccentricity, film.velocity);
    const T d = 2 + dot(film.eccentricity, film.eccentricity);
    const T root = sqrt(film.q);
    const T factor = -12 * pi<T>() / (d * film.q * root);
    const T q2 = 2 * film.q;
    const T s3 = 3 * s;
    return Vector2<T>(T(factor * (q2 * film.velocity.x() + s3 * film.eccentricity.x())),
                      T(factor * (q2 * film.velocity.y() + s3 * film.eccentricity.y())));
  }
};

}  // namespace lubjoint

#pragma once

#include "lubjoint/film/law.hpp"

namespace lubjoint {

/// Film force of the dynamically loaded long bearing after Pinkus and Sternlicht.
///   F_r = −(6S/(D q^{3/2})) [4εK + πDbφ],   F_t = (6πSa/(D q^{1/2})) φ,   S = μLR³/c²,   D = 2 + ε²
///   K = √(q (a²/4 + b²)),   φ = (K + 3B)/(K + 3B/2) for b ≥ 0, K/(K + 3B/2) for b < 0,   B = ε|b|
/// In vectors, with s = ê·u, K = √q|u|, t = K + 3|s|/2, n = K + 3 max(s, 0):
///   F = −(6S/(D q^{3/2})) [(4K + 3πφs) ê + 2πφq u],  φ = n/t
/// Source: Flores et al. (2009), eqs. 14 to 18, multiplied through by ε̇ so that nothing is singular at ε̇ = 0 or
/// ε = 0; for ε̇ < 0 the printed bracket has the wrong sign. Once continuously differentiable across b = 0. An
/// approximation of the long dynamic film, not the integral of any pressure field.
/// Accuracy: data/accuracy.csv
struct PinkusSternlicht {
  static constexpr std::string_view name = "pinkus_sternlicht";      ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;  ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::dynamic;          ///< the film it approximates: θs…θs + π
  static constexpr std::string_view words = "Pinkus–Sternlicht";     ///< for people
  static constexpr bool has_pressure = false;                        ///< no pressure field has this force
  static constexpr bool kinks = true;                                ///< where b changes sign, φ has two slopes
  static constexpr Potential potential = Potential::none;            ///< ∂F/∂u is not symmetric

  /// F/S [1/s] in the frame of the film state, as above; u ≠ 0.
  template <class T>
  static Vector2<T> force_ratio(const FilmState<T>& film) {
    using std::abs;
    using std::sqrt;
    const Vector2<T>& e = film.eccentricity;
    const Vector2<T>& u = film.velocity;
    const T s = dot(e, u);
    const T d = 2 + dot(e, e);
    const T root = sqrt(film.q);
    const T k = root * detail::norm_in_range(u);
    const T size = abs(s);
    const RealOf<T> three_halves(1.5);  // of T's own precision: a float stays one
    const T t = k + three_halves * size;
    const T n = k + three_halves * (size + s);      // the sum is exact: 2s or 0
    const T over_t = -6 / (d * film.q * root * t);  // the one division; products of two rates would leave the range
    const T factor = over_t * t;
    const T factor_phi = over_t * n;
    const T along_e = factor * (4 * k) + factor_phi * (3 * pi<T>() * s);
    const T along_u = factor_phi * (2 * pi<T>() * film.q);
    return Vector2<T>(T(along_e * e.x() + along_u * u.x()), T(along_e * e.y() + along_u * u.y()));
  }
};

}  // namespace lubjoint

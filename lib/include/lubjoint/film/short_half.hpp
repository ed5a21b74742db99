#pragma once

#include "lubjoint/film/law.hpp"

namespace lubjoint {

/// Film force of the infinitely short bearing, half (Gümbel) film, mirrored where a < 0.
///   F_r = −(S/2) [2ε|a|/q² + πb(1+2ε²)/q^{5/2}]
///   F_t =  (S/2) [πa/(2q^{3/2}) + sgn(a) 4εb/q²],   S = μRL³/c²,   sgn(0) = +1
/// Source: Flores et al. (2009), eqs. 8 and 9, printed for a ≥ 0. F_t jumps at a = 0 where εb ≠ 0.
/// Accuracy: data/accuracy.csv
struct ShortHalf {
  static constexpr std::string_view name = "short_half";                 ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::short_bearing;     ///< S = μRL³/c²
  static constexpr FilmExtent extent = FilmExtent::half;                 ///< 0…π, or π…2π where a < 0
  static constexpr std::string_view words = "short bearing, half film";  ///< for people
  static constexpr bool has_pressure = true;                             ///< the force is its integral
  static constexpr Potential potential = Potential::on_each_side;        ///< of a = 0

  /// F/S [1/s], radial and tangential, as above.
  /// @param side  the half that carries pressure: given, since a motion that slides along a = 0 asks for both
  template <class T>
  static PolarForce<T> force_ratio(const PolarFilmState<T>& state, HalfFilmSide side) {
    using std::sqrt;
    const T& epsilon = state.eccentricity_ratio;
    const T& a = state.slip_rate;
    const T& b = state.squeeze_rate;
    const T& q = state.q;
    const T root = sqrt(q);
    const T film_side = T(side == HalfFilmSide::converging ? 1 : -1);
    const T growth = 1 + 2 * epsilon * epsilon;
    const T over = 1 / (q * q * root);  // the one division; no product of a rate and q, which might leave the range
    const T sided = film_side * (over * root);
    const T radial = -(sided * (epsilon * a) + over * (pi<T>() / 2 * b * growth));
    const T tangential = over * q * (pi<T>() / 4 * a) + sided * (2 * epsilon * b);
    return {radial, tangential};
  }
};

}  // namespace lubjoint

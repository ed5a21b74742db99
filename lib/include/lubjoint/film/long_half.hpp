#pragma once

#include "lubjoint/film/law.hpp"

namespace lubjoint {

/// Film force of the infinitely long bearing, half (Gümbel) film with p(0) = p(π) = 0, mirrored where a < 0.
///   F_r = −S [12ε|a|/(Dq) + (6b/q^{3/2})(π − 16/(πD))]
///   F_t =  S [6πa/(D q^{1/2}) + sgn(a) 24εb/(Dq)],   S = μLR³/c²,   D = 2 + ε²,   sgn(0) = +1
/// Source: Flores et al. (2009), eqs. 12 and 13, printed for a ≥ 0. F_t jumps at a = 0 where εb ≠ 0. At e = 0 the
/// force on a radial velocity, −6(π − 8/π)Su, is not the one on a tangential velocity, −6πSu.
/// Accuracy: data/accuracy.csv
struct LongHalf {
  static constexpr std::string_view name = "long_half";                 ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;     ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::half;                ///< 0…π, or π…2π where a < 0
  static constexpr std::string_view words = "long bearing, half film";  ///< for people
  static constexpr bool has_pressure = true;                            ///< the force is its integral
  static constexpr Potential potential = Potential::on_each_side;       ///< of a = 0

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
    const T d = 2 + epsilon * epsilon;
    const T film_side = T(side == HalfFilmSide::converging ? 1 : -1);
    const T squeeze = pi<T>() * d - 16 / pi<T>();
    const T over = 6 / (d * q * root);  // the one division; no product of a rate and q, which might leave the range
    const T sided = film_side * (over * root);
    const T radial = -(sided * (2 * epsilon * a) + over * (b * squeeze));
    const T tangential = over * q * (pi<T>() * a) + sided * (4 * epsilon * b);
    return {radial, tangential};
  }
};

}  // namespace lubjoint

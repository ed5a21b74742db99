#pragma once

#include "lubjoint/film/law.hpp"

namespace lubjoint {

/// Film force of the infinitely long bearing, the full film's pressure (eq. 5, p(0) = 0) cut off at θ = π, where it
/// is not zero; mirrored where a < 0.
///   F_r = −S [12ε|a|/(Dq) + 6πb/q^{3/2}]
///   F_t =  S [6πa/(D q^{1/2}) + sgn(a) 24b/((1+ε)q)],   S = μLR³/c²,   D = 2 + ε²,   sgn(0) = +1
/// A law of its own so that its difference from the published half film can be shown: it answers a radial velocity
/// at e = 0 with a tangential force.
/// Accuracy: data/accuracy.csv
struct LongHalfEq5 {
  static constexpr std::string_view name = "long_half_eq5";                  ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;          ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::half;                     ///< 0…π, or π…2π where a < 0
  static constexpr std::string_view words = "long bearing, eq. 5 cut at π";  ///< for people
  static constexpr bool has_pressure = true;                                 ///< the force is its integral
  static constexpr Potential potential = Potential::none;                    ///< ∂F/∂u is not symmetric

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
    const T widest = 1 + epsilon;
    const T over = 6 / (d * q * root * widest);  // the one division; no product of a rate and q
    const T wide = over * widest;
    const T sided = film_side * root;
    const T radial = -(wide * sided * (2 * epsilon * a) + wide * d * (pi<T>() * b));
    const T tangential = wide * q * (pi<T>() * a) + over * d * sided * (4 * b);
    return {radial, tangential};
  }
};

}  // namespace lubjoint

#pragma once

#include "lubjoint/film/law.hpp"

namespace lubjoint {

/// Squeeze film of the infinitely short bearing, full film; neither wedge nor spin enters.
///   F_r = −πS b(1 + 2ε²)/q^{5/2},   F_t = 0,   S = μRL³/c²
/// The b-part of eq. 6. At ê = 0 it has no limit, since r has none: r is taken along u there.
/// Accuracy: data/accuracy.csv
struct SqueezeShortFull {
  static constexpr std::string_view name = "squeeze_short_full";      ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::short_bearing;  ///< S = μRL³/c²
  static constexpr FilmExtent extent = FilmExtent::full;              ///< 0…2π, negative pressure kept
  static constexpr bool squeeze_only = true;                          ///< the wedge is left out: a is read as 0
  static constexpr std::string_view words = "short bearing, squeeze alone, full film";  ///< for people
  static constexpr bool has_pressure = true;                                            ///< the force is its integral
  static constexpr Potential potential = Potential::convex;                             ///< of the dissipation

  /// F/S [1/s], radial and tangential, as above.
  template <class T>
  static PolarForce<T> force_ratio(const PolarFilmState<T>& state, HalfFilmSide) {
    using std::sqrt;
    const T growth = 1 + 2 * state.eccentricity_ratio * state.eccentricity_ratio;
    return {T(-pi<T>() * state.squeeze_rate * growth / (state.q * state.q * sqrt(state.q))), T(0)};
  }
};

}  // namespace lubjoint

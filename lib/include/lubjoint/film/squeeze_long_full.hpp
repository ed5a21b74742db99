#pragma once

#include "lubjoint/film/law.hpp"

namespace lubjoint {

/// Squeeze film of the infinitely long bearing, full film; neither wedge nor spin enters.
///   F_r = −12πS b/q^{3/2},   F_t = 0,   S = μLR³/c²
/// The b-part of eq. 10; the film of the hybrid of squeeze and contact, 12πμLR³ė/(c³q^{3/2}) with ė = cε̇ (Flores,
/// Ambrósio and Claro). At ê = 0 it has no limit, since r has none: r is taken along u there.
/// Accuracy: data/accuracy.csv
struct SqueezeLongFull {
  static constexpr std::string_view name = "squeeze_long_full";      ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::long_bearing;  ///< S = μLR³/c²
  static constexpr FilmExtent extent = FilmExtent::full;             ///< 0…2π, negative pressure kept
  static constexpr bool squeeze_only = true;                         ///< the wedge is left out: a is read as 0
  static constexpr std::string_view words = "long bearing, squeeze alone, full film";  ///< for people
  static constexpr bool has_pressure = true;                                           ///< the force is its integral
  static constexpr Potential potential = Potential::convex;                            ///< of the dissipation

  /// F/S [1/s], radial and tangential, as above.
  template <class T>
  static PolarForce<T> force_ratio(const PolarFilmState<T>& state, HalfFilmSide) {
    using std::sqrt;
    return {T(-12 * pi<T>() * state.squeeze_rate / (state.q * sqrt(state.q))), T(0)};
  }
};

}  // namespace lubjoint

#pragma once

#include "lubjoint/film/squeeze_film.hpp"

namespace lubjoint {

/// Squeeze film of the infinitely short bearing where its pressure is positive: π/2…3π/2 for b ≥ 0, −π/2…π/2 for
/// b < 0; neither wedge nor spin enters.
///   F_r = −(S b/q²) [(1 + 2ε²)(π − arccos ε)/√q + 3ε] for b ≥ 0,  −(S b/q²) [(1 + 2ε²) arccos ε/√q − 3ε] for b < 0,
///   F_t = 0,   S = μRL³/c²   (evaluated as squeeze_film.hpp says)
/// Both together are the full film; each is the short dynamic film at a = 0. A film that opens keeps its digits as
/// ε → 1. At ê = 0 it has no limit, since r has none: r is taken along u there.
/// Accuracy: data/accuracy.csv
struct SqueezeShort {
  static constexpr std::string_view name = "squeeze_short";           ///< in scenes and options
  static constexpr BearingLimit limit = BearingLimit::short_bearing;  ///< S = μRL³/c²
  static constexpr FilmExtent extent = FilmExtent::dynamic;           ///< θs…θs + π of the squeeze alone
  static constexpr bool squeeze_only = true;                          ///< the wedge is left out: a is read as 0
  static constexpr std::string_view words = "short bearing, squeeze alone, film where p > 0";  ///< for people
  static constexpr bool has_pressure = true;                 ///< the force is its integral
  static constexpr bool kinks = true;                        ///< it opens with another resistance than it closes with
  static constexpr Potential potential = Potential::convex;  ///< of the dissipation

  /// F/S [1/s], radial and tangential, as above.
  template <class T>
  static PolarForce<T> force_ratio(const PolarFilmState<T>& state, HalfFilmSide) {
    return detail::squeeze_force<SqueezeShort>(state);
  }

  /// −F_r/(S b) of a film that opens narrowly.
  template <class T>
  static T narrow_resistance(const PolarFilmState<T>& state) {
    const T& q = state.q;
    return T(state.eccentricity_ratio * ((3 - 2 * q) * detail::arc_remainder(q) - RealOf<T>(4) / 3));
  }

  /// And of another.
  template <class T>
  static T wide_resistance(const PolarFilmState<T>& state) {
    using std::sqrt;
    const T& q = state.q;
    const T x = detail::along_squeeze(state);
    const T root = sqrt(q);
    return T(((q + 3 * x * x) * detail::angle_above(root, T(-x)) + 3 * x * root) / (q * q * root));
  }
};

}  // namespace lubjoint

/// Where the film carries pressure (cavitation), and its bounds θs and θe.
#pragma once

#include <cmath>

#include "lubjoint/film/film_state.hpp"

namespace lubjoint {

/// full: 0…2π, negative pressure kept (Sommerfeld).  half: 0…π for a ≥ 0, π…2π for a < 0 (Gümbel).
/// dynamic: where the short bearing's pressure is positive, θs…θs + π.
enum class FilmExtent { full, half, dynamic };

/// The half of the bearing in which the wedge builds pressure: a ≥ 0 (film on 0…π) or a < 0 (film on π…2π).
enum class HalfFilmSide { converging, mirrored };

/// By the sign of a; a = 0 counts as a ≥ 0.
template <class T>
HalfFilmSide side_of(const PolarFilmState<T>& state) {
  return value_of(state.slip_rate) < 0 ? HalfFilmSide::mirrored : HalfFilmSide::converging;
}

/// The same: a = −2u·t, and ε u·t = ê × u, so that no direction of e is needed.
template <class T>
HalfFilmSide side_of(const FilmState<T>& film) {
  return value_of(cross(film.eccentricity, film.velocity)) > 0 ? HalfFilmSide::mirrored : HalfFilmSide::converging;
}

/// Bounds of the film [rad], counter-clockwise from the maximum film; θe is not reduced to (−π, π].
template <class T>
struct FilmBounds {
  T start;  ///< θs
  T end;    ///< θe
};

/// Film bounds. The dynamic film: θs = atan2(2b, a) in (−π, π], θe = θs + π; at u = 0: 0 and π.
/// Source: Flores et al. (2009), "the angles θs and θe" before eq. 14.
template <class T>
FilmBounds<T> film_bounds(FilmExtent extent, const PolarFilmState<T>& state) {
  const RealOf<T> half_turn = pi<T>();
  switch (extent) {
    case FilmExtent::full:
      return {T(0), T(2 * half_turn)};
    case FilmExtent::half:
      if (side_of(state) == HalfFilmSide::converging) return {T(0), T(half_turn)};
      return {T(half_turn), T(2 * half_turn)};
    case FilmExtent::dynamic:
      break;
  }
  const bool at_rest = value_of(state.slip_rate) == 0 && value_of(state.squeeze_rate) == 0;
  const T start = at_rest ? T(0) : polar_angle(T(2 * state.squeeze_rate), state.slip_rate);
  return {start, T(start + half_turn)};
}

}  // namespace lubjoint

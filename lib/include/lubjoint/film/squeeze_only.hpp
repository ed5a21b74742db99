/// Laws that leave the wedge out, and the state that their film sees.
#pragma once

#include "lubjoint/film/film_state.hpp"

namespace lubjoint {

/// A law of the squeeze alone: it leaves the wedge out, so that its film, and what it shears, is that of a = 0.
template <class Law>
concept SqueezeOnlyLaw = requires {
  requires Law::squeeze_only;
};

/// The state as a law's film sees it: without its slip where the law leaves the wedge out.
template <class Law, class T>
PolarFilmState<T> state_of_film(const PolarFilmState<T>& state) {
  if constexpr (SqueezeOnlyLaw<Law>) {
    return PolarFilmState<T>(state.eccentricity_ratio, T(0), state.squeeze_rate, state.q, Unchecked());
  } else {
    return state;
  }
}

/// A state whose u is cut down to its part along ê; at ê = 0 it is all along r.
template <class T>
FilmState<T> without_wedge(const FilmState<T>& film) {
  if (is_zero(film.eccentricity)) return film;
  const Vector2<T> r = direction(film.eccentricity);
  const T b = dot(film.velocity, r);
  return FilmState<T>(film.eccentricity, Vector2<T>(T(b * r.x()), T(b * r.y())), film.q, Unchecked());
}

/// The same in any frame.
template <class Law, class T>
FilmState<T> state_of_film(const FilmState<T>& film) {
  if constexpr (SqueezeOnlyLaw<Law>) {
    return without_wedge(film);
  } else {
    return film;
  }
}

}  // namespace lubjoint

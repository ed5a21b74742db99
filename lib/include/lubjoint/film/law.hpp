/// What a film force law is, and how one is evaluated.
///
/// A law gives F/S, the force on the journal over the force scale, as a function of the film state alone. It is
/// homogeneous of degree one in u and turns with (ê, u). Two ways to write one:
/// - vector law: `template <class T> static Vector2<T> force_ratio(const FilmState<T>&);`
/// - polar law: `template <class T> static PolarForce<T> force_ratio(const PolarFilmState<T>&, HalfFilmSide);`
/// A vector law needs no direction of e and stays smooth at e = 0. The half films depend on that direction and on the
/// sign of a; they are polar laws. Neither ever sees u = 0, or in the plane max |u_i| outside of 1e-60 … 1e60: the
/// functions below take care of that.
#pragma once

#include <concepts>
#include <string_view>

#include "lubjoint/film/bearing.hpp"
#include "lubjoint/film/extent.hpp"
#include "lubjoint/film/film_state.hpp"
#include "lubjoint/film/law_facts.hpp"
#include "lubjoint/number/dual.hpp"

namespace lubjoint {

/// Radial (along e) and tangential (90° counter-clockwise of it) components of a force on the journal.
template <class T>
struct PolarForce {
  T radial;      ///< [N], or as the ratio F/S [1/s]
  T tangential;  ///< likewise
};

/// A law written in polar components, as half films are.
template <class Law>
concept PolarLaw = requires(const PolarFilmState<double>& state) {
  { Law::force_ratio(state, HalfFilmSide::converging) } -> std::same_as<PolarForce<double>>;
};

/// A law written in vectors.
template <class Law>
concept VectorLaw = requires(const FilmState<double>& state) {
  { Law::force_ratio(state) } -> std::same_as<Vector2<double>>;
};

/// A law of either kind, with its name, force scale and film extent.
template <class Law>
concept FilmLaw = (PolarLaw<Law> || VectorLaw<Law>)&&requires {
  { Law::name } -> std::convertible_to<std::string_view>;
  { Law::limit } -> std::convertible_to<BearingLimit>;
  { Law::extent } -> std::convertible_to<FilmExtent>;
};

/// A law whose header says that it kinks where b changes sign.
template <class Law>
concept KinkedLaw = requires {
  requires Law::kinks;
};

/// A half film: its force jumps where a changes sign, and what it does on either side can be asked for.
template <class Law>
concept HalfFilmLaw = PolarLaw<Law> && requires {
  requires Law::extent == FilmExtent::half;
};

namespace detail {

/// A polar force as a vector; r is its radial direction.
template <class T>
Vector2<T> in_plane(const PolarForce<T>& force, const Vector2<T>& r) {
  const Vector2<T> t = perpendicular(r);
  return Vector2<T>(T(force.radial * r.x() + force.tangential * t.x()),
                    T(force.radial * r.y() + force.tangential * t.y()));
}

template <PolarLaw Law, class T>
Vector2<T> polar_law_in_plane(const PolarView<T>& view, HalfFilmSide side) {
  return in_plane(Law::force_ratio(view.state, side), view.radial);
}

/// evaluate(film) for a function of degree one in u, also where |u| is so small or large that products of rates, or
/// derivatives of their quotients, would leave the range: then F(ê, u) = σF(ê, u/σ) with σ = max |u_i|, ∂F/∂u at u is
/// that at u/σ, and ∂F/∂ê is σ times that at u/σ. The derivatives of u are passed on as they are, those of ê multiplied
/// by σ.
template <class T, class Evaluate>
Vector2<T> in_range_of_rates(const FilmState<T>& film, const Evaluate& evaluate) {
  using R = RealOf<T>;
  const R size = larger_magnitude<R>(value_of(film.velocity.x()), value_of(film.velocity.y()));
  if (size > R(1e-60) && size < R(1e60)) return evaluate(film);
  if constexpr (ScalarTraits<T>::carries_derivatives) {
    const auto slow = [&size](const T& v) { return T(value_of(v) / size, v.derivatives()); };
    const auto weighted = [&size](const T& x) { return T(value_of(x), size * x.derivatives()); };
    const Vector2<T> e_hat(weighted(film.eccentricity.x()), weighted(film.eccentricity.y()));
    const Vector2<T> u(slow(film.velocity.x()), slow(film.velocity.y()));
    Vector2<T> force = evaluate(FilmState<T>(e_hat, u, weighted(film.q), Unchecked()));
    force.x().value() *= size;
    force.y().value() *= size;
    return force;
  } else {
    const Vector2<T> u(T(film.velocity.x() / size), T(film.velocity.y() / size));
    const Vector2<T> force = evaluate(FilmState<T>(film.eccentricity, u, film.q, Unchecked()));
    return Vector2<T>(T(size * force.x()), T(size * force.y()));
  }
}

template <FilmLaw Law, class T>
Vector2<T> force_ratio_in_motion(const FilmState<T>& film) {
  return in_range_of_rates(film, [](const FilmState<T>& state) -> Vector2<T> {
    if constexpr (PolarLaw<Law>) {
      return polar_law_in_plane<Law>(polar_view(state), side_of(state));
    } else {
      return Law::force_ratio(state);
    }
  });
}

/// Value zero, derivatives J du: every law is homogeneous in u, so at u = 0 its derivative in ê vanishes, and the one
/// in u is a choice of direction, taken as the limit b → 0, a → 0+ (at ê = 0: u → 0 along x, where every law is
/// isotropic or, for long_half_eq5, linear).
/// @param in_motion  F/S of any scalar at a state with u ≠ 0
template <class T, class InMotion>
Vector2<T> force_ratio_at_rest(const FilmState<T>& film, [[maybe_unused]] const InMotion& in_motion) {
  Vector2<T> ratio(T(0), T(0));
  if constexpr (ScalarTraits<T>::carries_derivatives) {
    using R = RealOf<T>;
    using Inner = Dual<R, 2>;
    const Vector2<R> e_hat(value_of(film.eccentricity.x()), value_of(film.eccentricity.y()));
    Vector2<R> along(R(1), R(0));
    if (!is_zero(e_hat)) along = -perpendicular(direction(e_hat));
    const Vector2<Inner> u(Inner::variable(along.x(), 0), Inner::variable(along.y(), 1));
    const Vector2<Inner> e_fixed(Inner(e_hat.x()), Inner(e_hat.y()));
    const Vector2<Inner> slope = in_motion(FilmState<Inner>(e_fixed, u, Inner(value_of(film.q))));
    ratio.x() = slope.x().derivatives().x() * film.velocity.x() + slope.x().derivatives().y() * film.velocity.y();
    ratio.y() = slope.y().derivatives().x() * film.velocity.x() + slope.y().derivatives().y() * film.velocity.y();
  }
  return ratio;
}

}  // namespace detail

/// F/S of a law at any state of the film, u = 0 included [1/s].
template <FilmLaw Law, class T>
Vector2<T> force_ratio(const FilmState<T>& film) {
  if (is_zero(film.velocity)) {
    return detail::force_ratio_at_rest(film,
                                       [](const auto& state) { return detail::force_ratio_in_motion<Law>(state); });
  }
  return detail::force_ratio_in_motion<Law>(film);
}

/// F/S of a law in polar components [1/s]; the radial direction is the caller's, also at ε = 0.
template <FilmLaw Law, class T>
PolarForce<T> polar_force_ratio(const PolarFilmState<T>& state) {
  if constexpr (PolarLaw<Law>) {
    return Law::force_ratio(state, side_of(state));
  } else {
    const Vector2<T> ratio = force_ratio<Law>(state.in_own_frame());
    return {ratio.x(), ratio.y()};
  }
}

/// Force of the film on the journal [N], in the frame of the state.
/// @param film  0 ≤ ε < 1 (checked where the state is made)
template <FilmLaw Law, class T>
Vector2<T> film_force(const Bearing<RealOf<T>>& bearing, const Lubricant<RealOf<T>>& oil, const FilmState<T>& film) {
  const RealOf<T> scale = force_scale(Law::limit, bearing, oil);
  const Vector2<T> ratio = force_ratio<Law>(film);
  return Vector2<T>(T(scale * ratio.x()), T(scale * ratio.y()));
}

/// Force of the film on the journal in polar components [N].
template <FilmLaw Law, class T>
PolarForce<T> film_force(const Bearing<RealOf<T>>& bearing, const Lubricant<RealOf<T>>& oil,
                         const PolarFilmState<T>& state) {
  const RealOf<T> scale = force_scale(Law::limit, bearing, oil);
  const PolarForce<T> ratio = polar_force_ratio<Law>(state);
  return {T(scale * ratio.radial), T(scale * ratio.tangential)};
}

}  // namespace lubjoint

/// Laws of a bearing of finite length: the force depends on L/D, too.
#pragma once

#include <concepts>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "lubjoint/film/law.hpp"

namespace lubjoint {

/// A law whose F/S takes the bearing's length over its diameter beside the state: a vector law or a polar law of
/// law.hpp with one argument more.
template <class Law>
concept ShapedVectorLaw = requires(const FilmState<double>& state) {
  { Law::force_ratio(state, 1.0) } -> std::same_as<Vector2<double>>;
};
/// The same in polar components; the radial direction is the caller's, also at ε = 0.
template <class Law>
concept ShapedPolarLaw = requires(const PolarFilmState<double>& state) {
  { Law::force_ratio(state, 1.0) } -> std::same_as<PolarForce<double>>;
};
/// A law of either kind, with its name, force scale, film extent and the L/D that it is made for.
template <class Law>
concept ShapedFilmLaw = (ShapedVectorLaw<Law> || ShapedPolarLaw<Law>)&&requires {
  { Law::name } -> std::convertible_to<std::string_view>;
  { Law::limit } -> std::convertible_to<BearingLimit>;
  { Law::extent } -> std::convertible_to<FilmExtent>;
  { Law::longest } -> std::convertible_to<double>;
  { Law::warning(1.0) } -> std::convertible_to<std::string>;
};

/// L/(2R) of a bearing.
template <class R>
R length_to_diameter(const Bearing<R>& bearing) {
  return R(bearing.length() / (2 * bearing.radius()));
}

/// @throws std::invalid_argument if a law is not made for bearings of this shape
template <ShapedFilmLaw Law, class R>
void require_shape(const R& shape) {
  if (shape > 0 && shape <= Law::longest) return;
  std::ostringstream message;
  message.precision(6);
  message << "length over diameter is " << shape << " for the law " << Law::name << "; allowed is a number above 0";
  if (Law::longest < std::numeric_limits<double>::infinity()) message << " and at most " << Law::longest;
  throw std::invalid_argument(message.str());
}

namespace detail {

template <ShapedFilmLaw Law, class T>
Vector2<T> shaped_force_ratio_in_motion(const FilmState<T>& film, const RealOf<T>& shape) {
  return in_range_of_rates(film, [&shape](const FilmState<T>& state) -> Vector2<T> {
    if constexpr (ShapedPolarLaw<Law>) {
      const PolarView<T> view = polar_view(state);
      const PolarForce<T> ratio = Law::force_ratio(view.state, shape);
      const Vector2<T> t = perpendicular(view.radial);
      return Vector2<T>(T(ratio.radial * view.radial.x() + ratio.tangential * t.x()),
                        T(ratio.radial * view.radial.y() + ratio.tangential * t.y()));
    } else {
      return Law::force_ratio(state, shape);
    }
  });
}

}  // namespace detail

/// F/S of a law at any state, u = 0 included [1/s]. @throws std::invalid_argument as require_shape
template <ShapedFilmLaw Law, class T>
Vector2<T> shaped_force_ratio(const FilmState<T>& film, const RealOf<T>& shape) {
  require_shape<Law>(shape);
  if (is_zero(film.velocity)) {
    return detail::force_ratio_at_rest(
        film, [&](const auto& state) { return detail::shaped_force_ratio_in_motion<Law>(state, shape); });
  }
  return detail::shaped_force_ratio_in_motion<Law>(film, shape);
}

/// Force of the film on the journal [N], in the frame of the state. @throws std::invalid_argument as require_shape
template <ShapedFilmLaw Law, class T>
Vector2<T> film_force(const Bearing<RealOf<T>>& bearing, const Lubricant<RealOf<T>>& oil, const FilmState<T>& film) {
  const RealOf<T> scale = force_scale(Law::limit, bearing, oil);
  const Vector2<T> ratio = shaped_force_ratio<Law>(film, length_to_diameter(bearing));
  return Vector2<T>(T(scale * ratio.x()), T(scale * ratio.y()));
}

/// The same in polar components.
template <ShapedFilmLaw Law, class T>
PolarForce<T> film_force(const Bearing<RealOf<T>>& bearing, const Lubricant<RealOf<T>>& oil,
                         const PolarFilmState<T>& state) {
  if constexpr (ShapedPolarLaw<Law>) {
    const RealOf<T> shape = length_to_diameter(bearing);
    require_shape<Law>(shape);
    const RealOf<T> scale = force_scale(Law::limit, bearing, oil);
    const PolarForce<T> ratio = Law::force_ratio(state, shape);
    return {T(scale * ratio.radial), T(scale * ratio.tangential)};
  } else {
    const Vector2<T> force = film_force<Law>(bearing, oil, state.in_own_frame());
    return {force.x(), force.y()};
  }
}

/// A law of any kind: force_scale(Law::limit, …) and film_force<Law>(…) are all that a user needs.
template <class Law>
concept AnyFilmLaw = FilmLaw<Law> || ShapedFilmLaw<Law>;

}  // namespace lubjoint

/// Laws of a bearing of finite length: the force depends on L/D, too.
#pragma once

#include <concepts>
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
/// The same in polar components.
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

/// F/S of a law at any state, u = 0 included [1/s]. @throws std::invalid_argument as require_shape
template <ShapedFilmLaw Law, class R>
Vector2<R> shaped_force_ratio(const FilmState<R>& film, const R& shape) {
  require_shape<Law>(shape);
  if (is_zero(film.velocity)) return Vector2<R>(R(0), R(0));
  return detail::in_range_of_rates(film, [&shape](const FilmState<R>& state) -> Vector2<R> {
    if constexpr (ShapedPolarLaw<Law>) {
      const PolarView<R> view = polar_view(state);
      const PolarForce<R> ratio = Law::force_ratio(view.state, shape);
      return ratio.radial * view.radial + ratio.tangential * perpendicular(view.radial);
    } else {
      return Law::force_ratio(state, shape);
    }
  });
}

/// Force of the film on the journal [N], in the frame of the state. @throws std::invalid_argument as require_shape
template <ShapedFilmLaw Law, class R>
Vector2<R> shaped_film_force(const Bearing<R>& bearing, const Lubricant<R>& oil, const FilmState<R>& film) {
  return force_scale(Law::limit, bearing, oil) * shaped_force_ratio<Law>(film, length_to_diameter(bearing));
}

}  // namespace lubjoint

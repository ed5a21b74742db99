/// A bearing filled with oil, as a force element between two bodies.
#pragma once

#include "lubjoint/film/law.hpp"
#include "lubjoint/joint/wrench.hpp"

namespace lubjoint {

/// One law, one bearing, one oil. R is the scalar of the parameters; the motion may carry derivatives.
template <FilmLaw Law, class R>
class LubricatedJoint {
 public:
  /// Forms the force scale, once.
  LubricatedJoint(const Bearing<R>& bearing, const Lubricant<R>& oil)
      : bearing_(bearing), scale_(lubjoint::force_scale(Law::limit, bearing, oil)) {}

  const Bearing<R>& bearing() const { return bearing_; }  ///< L, R, c
  const R& force_scale() const { return scale_; }         ///< S [N s]

  /// Force on the journal [N], inertial.
  /// @throws FilmDomainError where |e| ≥ c
  template <class T>
  Vector2<T> force(const FilmState<T>& film) const {
    return scaled(force_ratio<Law>(film));
  }

  /// Force of a half film whose side is given, not read off the sign of a: what a solver needs on either side of the
  /// jump at a = 0. Needs u ≠ 0.
  template <class T>
  requires PolarLaw<Law> Vector2<T> force(const FilmState<T>& film, HalfFilmSide side)
  const {
    if (is_zero(film.velocity)) return scaled(force_ratio<Law>(film));
    const auto on_side = [side](const FilmState<T>& state) {
      return detail::polar_law_in_plane<Law>(polar_view(state), side);
    };
    return scaled(detail::in_range_of_rates(film, on_side));
  }

 private:
  template <class T>
  Vector2<T> scaled(const Vector2<T>& ratio) const {
    return Vector2<T>(T(scale_ * ratio.x()), T(scale_ * ratio.y()));
  }

  Bearing<R> bearing_;
  R scale_;
};

}  // namespace lubjoint

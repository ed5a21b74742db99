/// A bearing filled with oil, as a force element between two bodies.
#pragma once

#include "lubjoint/film/compiled_law.hpp"
#include "lubjoint/film/law.hpp"
#include "lubjoint/joint/wrench.hpp"

namespace lubjoint {

/// A half film of either kind: a formula or a table.
template <class Law>
concept JumpingLaw = HalfFilmLaw<Law> || CompiledHalfFilmLaw<Law>;

/// What a half film can do on its jump, at a = 0, to a journal on a line through the bearing's centre.
template <class T>
struct JumpForce {
  T along;  ///< its force along the line [N], the same from either side
  T reach;  ///< X, its tangential force on the side a > 0; on the other −X. Filippov's force is one in between [N]
};

/// One law, one bearing, one oil. R is the scalar of the parameters; the motion may carry derivatives.
template <class Law, class R>
requires FilmLaw<Law> || CompiledLaw<Law>
class LubricatedJoint {
 public:
  static constexpr bool jumps = JumpingLaw<Law>;            ///< where a changes sign
  static constexpr bool kinks() { return KinkedLaw<Law>; }  ///< is it at most once differentiable where b changes sign?

  /// Forms the force scale, once.
  LubricatedJoint(const Bearing<R>& bearing, const Lubricant<R>& oil) requires FilmLaw<Law>
      : bearing_(bearing), scale_(lubjoint::force_scale(Law::limit, bearing, oil)) {}

  /// The same of a law that is a table.
  /// @throws std::invalid_argument if it was compiled for another L/D
  LubricatedJoint(const Law& law, const Bearing<R>& bearing, const Lubricant<R>& oil) requires CompiledLaw<Law>
      : law_(law), bearing_(bearing), scale_(lubjoint::force_scale(Law::limit, bearing, oil)) {
    require_shape_of(law, bearing);
  }

  const Bearing<R>& bearing() const { return bearing_; }  ///< L, R, c
  const R& force_scale() const { return scale_; }         ///< S [N s]

  /// Force on the journal [N], inertial.
  /// @throws FilmDomainError where |e| ≥ c
  template <class T>
  Vector2<T> force(const FilmState<T>& film) const {
    return scaled(ratio_at(film));
  }

  /// Force of a half film whose side is given, not read off the sign of a: what a solver needs on either side of the
  /// jump at a = 0. Needs u ≠ 0.
  template <class T>
  requires JumpingLaw<Law> Vector2<T> force(const FilmState<T>& film, HalfFilmSide side)
  const {
    if (is_zero(film.velocity)) return scaled(ratio_at(film));
    const auto on_side = [this, side](const FilmState<T>& state) {
      const PolarView<T> view = polar_view(state);
      return detail::in_plane(law_.force_ratio(view.state, side), view.radial);
    };
    return scaled(detail::in_range_of_rates(film, on_side));
  }

  /// The half film at ê = ρn and u = βn: there a = 0. ρ < 0 is a journal beyond the centre; smooth across ρ = 0.
  /// @throws FilmDomainError where |ρ| ≥ 1
  template <class T>
  requires JumpingLaw<Law> JumpForce<T> on_jump(const T& rho, const T& beta)
  const {
    const bool beyond = value_of(rho) < 0;
    const PolarFilmState<T> state(beyond ? T(-rho) : rho, T(0), beyond ? T(-beta) : beta);
    const PolarForce<T> ratio = law_.force_ratio(state, HalfFilmSide::converging);
    // Beyond the centre both components change sign seen along n; the reach belongs to the side, whatever the line.
    return {T(scale_ * (beyond ? T(-ratio.radial) : ratio.radial)), T(scale_ * ratio.tangential)};
  }

 private:
  template <class T>
  Vector2<T> ratio_at(const FilmState<T>& film) const {
    if constexpr (CompiledLaw<Law>) {
      return compiled_force_ratio(law_, film);
    } else {
      return force_ratio<Law>(film);
    }
  }

  template <class T>
  Vector2<T> scaled(const Vector2<T>& ratio) const {
    return Vector2<T>(T(scale_ * ratio.x()), T(scale_ * ratio.y()));
  }

  [[no_unique_address]] Law law_;  ///< nothing where it is a formula
  Bearing<R> bearing_;
  R scale_;
};

}  // namespace lubjoint

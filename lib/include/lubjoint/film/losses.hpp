/// Friction torque, power and side flow of a film.
///
/// With ω = ω_J − ω_B and the film's force F on the journal, each torque about its body's own centre:
///   T_C = (μωR³L/c) I₁,   T_J = −T_C − ½ e×F,   T_B = T_C − ½ e×F,   T_J + T_B + e×F = 0
///   power lost in the film = −(F·v + T_J ω_J + T_B ω_B) = ω T_C − c F·u ≥ 0
/// I₁ = ∫dθ/H over the film that is sheared. Source: the wall shear ∓μωR/h − (h/2R) ∂p/∂θ, integrated (proved in
/// oracle/proofs); terms of order c/R are left out, as in Reynolds' equation. The power is the dissipation
/// ∬[μ(ωR)²/h + h³|∇p|²/12μ] where the pressure vanishes at the edges of the film: not so for long_half_eq5 and, having
/// no pressure field, pinkus_sternlicht, moes_impedance and butenschoen, where torques and power hold by their
/// definition. Butenschön's own friction is that of the flooded gap.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "lubjoint/film/arc_series.hpp"
#include "lubjoint/film/compiled_law.hpp"
#include "lubjoint/film/shaped_law.hpp"
#include "lubjoint/film/shear_extent.hpp"
#include "lubjoint/film/squeeze_only.hpp"

namespace lubjoint {

/// The part of the gap that a law and a shear extent make out: all that the Couette torque needs to know of a law.
enum class ShearedGap { whole, half, dynamic, striated };

/// A film that ruptures along bounds of its own, which its law does not know.
template <class Law>
concept FreeBoundaryLaw = requires {
  requires Law::has_free_boundary;
};

/// Does a law have this shear? Striated is for half films; of a film with a free boundary flooded alone is known.
template <class Law>
constexpr bool has_shear(ShearExtent shear) {
  if (FreeBoundaryLaw<Law>) return shear == ShearExtent::flooded;
  return shear != ShearExtent::striated || Law::extent == FilmExtent::half;
}

/// The part of the gap that a law's film shears.
/// @throws std::invalid_argument if the law has not this shear
template <class Law>
requires AnyFilmLaw<Law> || CompiledLaw<Law> ShearedGap sheared_gap(ShearExtent shear) {
  if (FreeBoundaryLaw<Law> && !has_shear<Law>(shear)) {
    throw std::invalid_argument("shear \"" + std::string(shear_extent_names[static_cast<std::size_t>(shear)]) +
                                "\" is not known for the law " + std::string(Law::name) +
                                ", which has the force of its film and not its bounds; allowed is flooded");
  }
  if (!has_shear<Law>(shear)) {
    throw std::invalid_argument("shear \"striated\" is not defined for the law " + std::string(Law::name) +
                                "; allowed is film or flooded, or a half film");
  }
  if (shear == ShearExtent::flooded || Law::extent == FilmExtent::full) return ShearedGap::whole;
  if (shear == ShearExtent::striated) return ShearedGap::striated;
  return Law::extent == FilmExtent::half ? ShearedGap::half : ShearedGap::dynamic;
}

/// I₁ = ∫dθ/H over the gap that is sheared [-]: whole 2π/√q, half π/√q, dynamic (2/√q) atan2(√q, −ê·u/|u|) (π/√q at
/// u = 0, as film_bounds has it); striated (π/√q)(1 + 1/(1+ε)).
/// Accuracy: 4 roundings.
template <class T>
T couette_integral(const FilmState<T>& film, ShearedGap gap) {
  using std::sqrt;
  const T root = sqrt(film.q);
  switch (gap) {
    case ShearedGap::whole:
      return T(2 * pi<T>() / root);
    case ShearedGap::half:
      break;
    case ShearedGap::striated: {
      const T epsilon = is_zero(film.eccentricity) ? T(0) : norm(film.eccentricity);
      return T(pi<T>() / root * (1 + 1 / (1 + epsilon)));
    }
    case ShearedGap::dynamic: {
      if (is_zero(film.velocity)) break;
      const T square = dot(film.velocity, film.velocity);
      const bool in_range = value_of(square) > 1e-280 && value_of(square) < 1e280;
      const T speed = in_range ? T(sqrt(square)) : norm(film.velocity);
      return T(2 * detail::angle_above(T(root * speed), T(-dot(film.eccentricity, film.velocity))) / root);
    }
  }
  return T(pi<T>() / root);
}

/// The same of a law. @throws std::invalid_argument if the law has not this shear
template <class Law, class T>
T couette_integral(const FilmState<T>& film, ShearExtent shear) {
  return couette_integral(state_of_film<Law>(film), sheared_gap<Law>(shear));
}

/// μR³L/c [N m s], rounded once: T_C = scale · ω · I₁.
template <class R>
R couette_scale(const Bearing<R>& bearing, const Lubricant<R>& oil) {
  using Wide = typename ExtendedFor<R>::Type;
  const Wide radius(bearing.radius());
  return static_cast<R>(Wide(oil.viscosity()) * radius * radius * radius * Wide(bearing.length()) /
                        Wide(bearing.clearance()));
}

/// What the film does to both bodies, and what it takes from them.
template <class T>
struct FilmLosses {
  Vector2<T> force;  ///< on the journal, in the frame of the state [N]
  T torque_journal;  ///< T_J, on the journal about its centre [N m]
  T torque_bearing;  ///< T_B, on the bearing about its centre [N m]
  T couette_power;   ///< ω T_C [W]
  T pressure_power;  ///< −c F·u [W]

  /// Power lost in the film [W]; not negative.
  T power() const { return T(couette_power + pressure_power); }
};

/// Losses of a force that is already known.
/// @param torque_rate  couette_scale · I₁ [N m s];  @param relative_spin  ω = ω_J − ω_B [rad/s]
template <class T>
FilmLosses<T> losses_of(const Vector2<T>& force, const FilmState<T>& film, const RealOf<T>& clearance,
                        const T& torque_rate, const T& relative_spin) {
  const T couette = torque_rate * relative_spin;
  const T half_moment = clearance * cross(film.eccentricity, force) / 2;
  return {force, T(-couette - half_moment), T(couette - half_moment), T(relative_spin * couette),
          T(-clearance * dot(force, film.velocity))};
}

/// Force, torques and power of a film [N, N m, W]; formulas above.
/// @param relative_spin  ω = ω_J − ω_B [rad/s];  @param shear  which part of the gap is sheared
/// @throws std::invalid_argument for striated shear of a film that is not a half film
template <AnyFilmLaw Law, class T>
FilmLosses<T> film_losses(const Bearing<RealOf<T>>& bearing, const Lubricant<RealOf<T>>& oil, const FilmState<T>& film,
                          const T& relative_spin, ShearExtent shear = ShearExtent::film) {
  const T rate = couette_scale(bearing, oil) * couette_integral<Law>(film, shear);
  return losses_of<T>(film_force<Law>(bearing, oil, film), film, bearing.clearance(), rate, relative_spin);
}

/// Oil that leaves by both sides of a short bearing, net [m³/s]: cRL ∫u·m dθ = 0 full, cRL|a| half, 2cRL|u| dynamic.
/// @returns nothing for a long bearing, whose film has no flow along the axis
template <class T>
std::optional<T> side_flow(const Bearing<RealOf<T>>& bearing, const FilmState<T>& film, BearingLimit limit,
                           FilmExtent extent) {
  using std::abs;
  if (limit == BearingLimit::long_bearing) return std::nullopt;
  if (extent == FilmExtent::full || is_zero(film.velocity)) return T(0);
  const RealOf<T> scale = bearing.clearance() * bearing.radius() * bearing.length();
  if (extent == FilmExtent::dynamic) return T(2 * scale * norm(film.velocity));
  if (is_zero(film.eccentricity)) return T(0);
  return T(2 * scale * abs(cross(direction(film.eccentricity), film.velocity)));
}

/// The same of a law. A compiled law has the force of its film alone: nothing is returned.
template <class Law, class T>
std::optional<T> side_flow(const Bearing<RealOf<T>>& bearing, const FilmState<T>& film) {
  if constexpr (CompiledLaw<Law>) {
    return std::nullopt;
  } else {
    return side_flow(bearing, state_of_film<Law>(film), Law::limit, Law::extent);
  }
}

}  // namespace lubjoint

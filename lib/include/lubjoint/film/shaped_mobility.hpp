/// The velocity at which a law of finite length carries a force.
#pragma once

#include "lubjoint/film/mobility.hpp"
#include "lubjoint/film/moes_impedance.hpp"

namespace lubjoint {

/// Inverse of Moes' impedance by Newton's method with exact derivatives, as for long_dynamic (mobility.hpp). That its
/// load's direction turns with u one way alone, so that the velocity is the only one, is measured, not proved. Moes'
/// own mobility, of which the impedance is made, is another fit: for ε ≤ 0.9 it is off
/// this inverse by up to 2.8 %, 6.4 % and 10.5 % at L/D = ¼, ½ and 1.
/// @param e_hat  ê, and q = 1 − ê·ê;  @param force  F/S on the journal [1/s];  @param shape  L/D > 0
/// @throws FilmDomainError if ε ≥ 1 or the force is not finite; std::invalid_argument as require_shape
/// Accuracy: as of mobility.
template <class R>
Vector2<R> moes_velocity(const Vector2<R>& e_hat, const R& q, const Vector2<R>& force, const R& shape) {
  require_shape<MoesImpedance>(shape);
  detail::require_mobility_state(e_hat, q, force);
  if (is_zero(force)) return Vector2<R>(R(0), R(0));
  const Vector2<R> load = -direction(force);
  const auto resistance = [&](const Vector2<R>& n) {
    return detail::differentiated_resistance(e_hat, q, n,
                                             [&](const auto& film) { return MoesImpedance::force_ratio(film, shape); });
  };
  const Vector2<R> start = detail::first_direction(BearingLimit::long_bearing, e_hat, load);
  return norm(force) * detail::velocity_against(q, load, start, MoesImpedance::name, resistance);
}

}  // namespace lubjoint

/// The velocity at which a compiled law's film carries a force.
#pragma once

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/film/mobility.hpp"

namespace lubjoint {

/// The velocities at which a compiled law's film carries a force, as mobility.hpp has them for laws that are formulas.
/// finite_full is linear and finite_reynolds has a strictly convex potential: one velocity. finite_dynamic is
/// continuous and passive, so that every force has one; that it has no other is measured (tests), not proved.
/// finite_half has one, two or none.
/// @param e_hat  ê, and q = 1 − ê·ê;  @param force  F/S on the journal [1/s]
/// @throws FilmDomainError if ε ≥ 1 or the force is not finite
/// Accuracy: F(ê, u) is the force to a few roundings times the film's condition, about 6/q; of finite_reynolds beyond
/// its table, where the force's slopes jump, as well.
template <CompiledLaw Law, class R>
Mobility<R> compiled_mobility(const Law& law, const Vector2<R>& e_hat, const R& q, const Vector2<R>& force) {
  detail::require_mobility_state(e_hat, q, force);
  if (is_zero(force)) return {MobilityStatus::found, Vector2<R>(R(0), R(0))};
  const R size = norm(force);
  const Vector2<R> unit = direction(force);
  if constexpr (CompiledHalfFilmLaw<Law>) {
    return detail::half_film_mobility(law, e_hat, q, unit).scaled(size);
  } else {
    const Vector2<R> load = -unit;
    const auto resistance = [&](const Vector2<R>& n) {
      return detail::differentiated_resistance(e_hat, q, n, [&law](const auto& film) { return law.force_ratio(film); });
    };
    const Vector2<R> start = detail::first_direction(Law::limit, e_hat, load);
    return {MobilityStatus::found, Vector2<R>(size * detail::velocity_against(q, load, start, Law::name, resistance))};
  }
}

}  // namespace lubjoint

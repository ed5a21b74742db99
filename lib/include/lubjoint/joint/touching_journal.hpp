/// A journal that may leave its film and touch the wall, at any eccentricity.
#pragma once

#include "lubjoint/film/shaped_law.hpp"
#include "lubjoint/joint/dry_contact.hpp"
#include "lubjoint/joint/transition.hpp"
#include "lubjoint/text/message.hpp"

namespace lubjoint {

/// Checks what a contact needs.
/// @throws std::invalid_argument that names the field, the value and what is allowed
template <class R>
void require_contact(const ContactSurface<R>& surface, const R& impact_speed) {
  detail::require_positive("contact_stiffness", surface.stiffness, "N/m^1.5");
  detail::require_positive("impact_speed", impact_speed, "m/s");
  if (surface.restitution >= 0 && surface.restitution <= 1) return;
  Message message;
  message << "restitution is " << surface.restitution << "; allowed is a number from 0 to 1";
  throw std::invalid_argument(message.str());
}

/// Force on a journal that may touch its bearing's wall [N], inertial; the couple of friction is not in it.
///   F = F_film, |e| ≤ c;   F = ((c + e₀ − |e|) F_film + (|e| − c) F_dry)/e₀, c ≤ |e| ≤ c + e₀;   F = F_dry beyond
/// The film inside sees the clearance c + e₁ (also for |e| ≤ c) and is never asked for its force at ε ≥ 1.
/// Source: Flores et al. (2009), eq. 20. Continuous at both seams for every law and velocity: F_dry, too, is zero at
/// |e| = c.
/// @param impact_speed  δ̇₀ > 0, the speed at which the journal last crossed |e| = c outwards [m/s]
/// @param film_force_in  F_film [N] in a bearing, at a film state
template <class T, class FilmForce>
Vector2<T> touching_journal_force_of(const Bearing<RealOf<T>>& bearing,
                                     const TransitionTolerances<RealOf<T>>& tolerances,
                                     const ContactSurface<RealOf<T>>& surface, const JournalMotion<T>& motion,
                                     const RealOf<T>& impact_speed, const FilmForce& film_force_in) {
  using R = RealOf<T>;
  const T distance = is_zero(motion.eccentricity) ? T(0) : norm(motion.eccentricity);
  const ContactPhase phase = contact_phase<R>(value_of(distance), bearing.clearance(), tolerances);
  if (phase == ContactPhase::dry) return dry_contact_force(motion, bearing, surface, impact_speed).force;
  const Bearing<R> wide(bearing.length(), bearing.radius(), bearing.clearance() + tolerances.e1);
  const Vector2<T> film = film_force_in(wide, film_state(motion, wide.clearance()));
  if (phase == ContactPhase::film) return film;
  const Vector2<T> dry = dry_contact_force(motion, bearing, surface, impact_speed).force;
  const TransitionShares<T> share = transition_shares<T>(distance, bearing.clearance(), tolerances);
  return Vector2<T>(T(share.film * film.x() + share.contact * dry.x()),
                    T(share.film * film.y() + share.contact * dry.y()));
}

/// The same of a law that is a formula.
template <AnyFilmLaw Law, class T>
Vector2<T> touching_journal_force(const Bearing<RealOf<T>>& bearing, const Lubricant<RealOf<T>>& oil,
                                  const TransitionTolerances<RealOf<T>>& tolerances,
                                  const ContactSurface<RealOf<T>>& surface, const JournalMotion<T>& motion,
                                  const RealOf<T>& impact_speed) {
  return touching_journal_force_of<T>(
      bearing, tolerances, surface, motion, impact_speed,
      [&oil](const auto& wide, const auto& film) { return film_force<Law>(wide, oil, film); });
}

}  // namespace lubjoint

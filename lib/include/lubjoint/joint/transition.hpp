/// From film to dry contact and back, without a jump.
#pragma once

#include "lubjoint/film/law.hpp"
#include "lubjoint/joint/dry_contact.hpp"

namespace lubjoint {

/// Tolerances of the transition: e₀, over which the film hands over to the contact, and e₁, by which the film's
/// clearance is widened so that the film stays finite while it does; 0 < e₀ < e₁ [m].
template <class R>
class TransitionBand {
 public:
  /// @throws std::invalid_argument that names the values and what is allowed
  TransitionBand(const R& e0, const R& e1) : blend_(e0), widening_(e1) {
    detail::require_positive("e0", e0, "m");
    detail::require_positive("e1", e1, "m");
    if (e0 < e1) return;
    std::ostringstream message;
    message.precision(17);
    message << "e0 is " << e0 << " m and e1 is " << e1 << " m; allowed is e0 below e1";
    throw std::invalid_argument(message.str());
  }

  const R& blend() const { return blend_; }        ///< e₀ [m]
  const R& widening() const { return widening_; }  ///< e₁ [m]

  /// The bearing that the film sees, with clearance c + e₁ (also for |e| ≤ c).
  Bearing<R> film_bearing(const Bearing<R>& bearing) const {
    return Bearing<R>(bearing.length(), bearing.radius(), bearing.clearance() + widening_);
  }

 private:
  R blend_;
  R widening_;
};

/// Force on a journal that may touch its bearing's wall [N], inertial.
///   F = F_film                                            |e| ≤ c
///   F = ((c + e₀ − |e|) F_film + (|e| − c) F_dry) / e₀    c ≤ |e| ≤ c + e₀
///   F = F_dry                                             |e| ≥ c + e₀
/// Source: Flores et al. (2009), eq. 20. Continuous at both seams for every law and velocity: F_dry, too, is zero at
/// |e| = c. The film is never asked for its force at ε ≥ 1.
/// @param impact_speed  δ̇₀ [m/s], above 0
template <FilmLaw Law, class T>
Vector2<T> transition_force(const Bearing<RealOf<T>>& bearing, const Lubricant<RealOf<T>>& oil,
                            const TransitionBand<RealOf<T>>& band, const DryContact<RealOf<T>>& contact,
                            const JournalMotion<T>& motion, const RealOf<T>& impact_speed) {
  using R = RealOf<T>;
  const R& c = bearing.clearance();
  const T distance = is_zero(motion.eccentricity) ? T(0) : norm(motion.eccentricity);
  if (value_of(distance) >= c + band.blend()) return dry_contact_force(contact, motion, c, impact_speed);
  const Bearing<R> wide = band.film_bearing(bearing);
  const Vector2<T> film = film_force<Law>(wide, oil, film_state(motion, wide.clearance()));
  if (value_of(distance) <= c) return film;
  const Vector2<T> dry = dry_contact_force(contact, motion, c, impact_speed);
  const T of_dry = (distance - c) / band.blend();
  const T of_film = 1 - of_dry;
  return Vector2<T>(T(of_film * film.x() + of_dry * dry.x()), T(of_film * film.y() + of_dry * dry.y()));
}

}  // namespace lubjoint

/// Contact of a journal with the wall of its bearing, without oil.
#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "lubjoint/film/bearing.hpp"
#include "lubjoint/film/film_state.hpp"

namespace lubjoint {

/// Hertzian contact with a loss at impact, without friction.
///   F_N = K δ^{3/2} [1 + (3(1 − c_r²)/4) δ̇/δ̇₀], never negative: contact does not pull
/// Source: Lankarani and Nikravesh (1990).
template <class R>
class DryContact {
 public:
  /// @param stiffness  K [N/m^{3/2}], above 0;  @param restitution  c_r [-], in [0, 1]
  /// @throws std::invalid_argument that names the field, the value and what is allowed
  DryContact(const R& stiffness, const R& restitution) : stiffness_(stiffness), restitution_(restitution) {
    detail::require_positive("contact_stiffness", stiffness, "N/m^1.5");
    if (restitution >= 0 && restitution <= 1) return;
    std::ostringstream message;
    message.precision(17);
    message << "restitution is " << restitution << "; allowed is a number from 0 to 1";
    throw std::invalid_argument(message.str());
  }

  const R& stiffness() const { return stiffness_; }      ///< K [N/m^{3/2}]
  const R& restitution() const { return restitution_; }  ///< c_r [-]

  /// F_N [N]; 0 where δ ≤ 0.
  /// @param penetration  δ [m];  @param rate  δ̇ [m/s];
  /// @param impact_speed  δ̇₀ [m/s], above 0: the speed at which the journal last crossed e = c outwards
  template <class T>
  T normal_force(const T& penetration, const T& rate, const R& impact_speed) const {
    using std::sqrt;
    if (!(value_of(penetration) > 0)) return T(0);
    const R loss = 3 * (1 - restitution_) * (1 + restitution_) / (4 * impact_speed);
    const T resistance = 1 + loss * rate;
    if (!(value_of(resistance) > 0)) return T(0);
    return T(stiffness_ * penetration * sqrt(penetration) * resistance);
  }

 private:
  R stiffness_;
  R restitution_;
};

/// K of two cylinders' walls treated as spheres, one inside the other [N/m^{3/2}].
///   K = (4/3) √(R_B R_J/(R_B − R_J)) / ((1 − ν_B²)/E_B + (1 − ν_J²)/E_J),   R_B = R_J + c
/// @param bearing_modulus, journal_modulus  E [Pa];  the ratios are Poisson's, ν
template <class R>
R contact_stiffness(const Bearing<R>& bearing, const R& bearing_modulus, const R& bearing_ratio,
                    const R& journal_modulus, const R& journal_ratio) {
  using std::sqrt;
  detail::require_positive("bearing's Young's modulus", bearing_modulus, "Pa");
  detail::require_positive("journal's Young's modulus", journal_modulus, "Pa");
  const R outer = bearing.radius() + bearing.clearance();
  const R curvature = outer * bearing.radius() / bearing.clearance();
  const R compliance =
      (1 - bearing_ratio * bearing_ratio) / bearing_modulus + (1 - journal_ratio * journal_ratio) / journal_modulus;
  return 4 * sqrt(curvature) / (3 * compliance);
}

/// Force of the contact on the journal [N], inertial: −F_N r with δ = |e| − c and δ̇ = v·r; zero where |e| ≤ c.
template <class T>
Vector2<T> dry_contact_force(const DryContact<RealOf<T>>& contact, const JournalMotion<T>& motion,
                             const RealOf<T>& clearance, const RealOf<T>& impact_speed) {
  if (is_zero(motion.eccentricity)) return Vector2<T>(T(0), T(0));
  const T penetration = norm(motion.eccentricity) - clearance;
  const Vector2<T> r = direction(motion.eccentricity);
  const T force = contact.normal_force(penetration, dot(motion.velocity, r), impact_speed);
  return Vector2<T>(T(-force * r.x()), T(-force * r.y()));
}

}  // namespace lubjoint

/// Dry contact of a journal with the wall of its bearing.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "lubjoint/film/bearing.hpp"
#include "lubjoint/film/film_state.hpp"

namespace lubjoint {

/// Elasticity of one of the two surfaces.
template <class R>
struct Elasticity {
  R modulus;        ///< E, Young's [Pa]
  R poisson_ratio;  ///< ν [-]
};

namespace detail {

/// 1/E* = (1 − ν_B²)/E_B + (1 − ν_J²)/E_J [1/Pa].
template <class R>
R compliance_of(const Elasticity<R>& bearing, const Elasticity<R>& journal) {
  const auto of = [](const Elasticity<R>& e) { return R((1 - e.poisson_ratio) * (1 + e.poisson_ratio) / e.modulus); };
  return R(of(bearing) + of(journal));
}

}  // namespace detail

/// K = (4/3) √(R_B R_J/(R_B − R_J)) / ((1 − ν_B²)/E_B + (1 − ν_J²)/E_J), R_B = R_J + c [N/m^{3/2}].
/// Source: Lankarani and Nikravesh (1990). That is Hertz's contact of a sphere in a spherical hollow, a point contact:
/// the length of the bearing does not enter.
template <class R>
R contact_stiffness(const R& journal_radius, const R& clearance, const Elasticity<R>& bearing,
                    const Elasticity<R>& journal) {
  using std::sqrt;
  const R bearing_radius = journal_radius + clearance;
  return R(4) / 3 * sqrt(bearing_radius * journal_radius / clearance) / detail::compliance_of(bearing, journal);
}

/// K = π L E*/√(8c) [N/m^{3/2}] of ContactForm::cylinder; the radii do not enter.
/// Source: Liu, Zhang and Yang (2007), Mech. Mach. Theory 42, 183–197, F_N = ½ π L E* δ √(δ/(2(c + δ))), with
/// K δ^{3/2} = its limit for δ ≪ c. Their text was not at hand; the form is the one that reviews of clearance joints
/// repeat, such as Pereira, Ramalho and Ambrósio (2011), Nonlinear Dyn. 63, 681–697.
template <class R>
R cylinder_contact_stiffness(const R& length, const R& clearance, const Elasticity<R>& bearing,
                             const Elasticity<R>& journal) {
  using std::sqrt;
  return boost::math::constants::pi<R>() * length / (sqrt(8 * clearance) * detail::compliance_of(bearing, journal));
}

/// How the elastic force of a contact grows with the indentation δ.
enum class ContactForm {
  point,    ///< K δ^{3/2}: sphere in spherical hollow
  cylinder  ///< K δ^{3/2} √(c/(c + δ)): cylinder in a bush that encloses it the more, the deeper it sinks in
};

/// What a dry contact needs to know of its surfaces.
template <class R>
struct ContactSurface {
  R stiffness;                            ///< K [N/m^{3/2}]
  R restitution;                          ///< c_r in [0, 1]
  R friction = R(0);                      ///< Coulomb's coefficient; 0: smooth surfaces
  R slow_sliding = R(1) / 1000;           ///< sliding speed below which friction fades [m/s]
  ContactForm form = ContactForm::point;  ///< that K belongs to
};

/// Force on the journal at its centre, and the couple that friction, which acts at the wall, adds to it.
template <class T>
struct ContactForce {
  Vector2<T> force;  ///< on the journal [N], inertial
  T couple;          ///< on the journal's body; the bearing's body gets its opposite [N m]
};

/// Normal force F_N = K δ^{3/2} [1 + (3(1 − c_r²)/4) δ̇/δ̇₀] along −r, never negative; δ = |e| − c, δ̇ = v·r.
/// Friction: −f F_N s/√(s² + s₀²) along t, s the sliding speed at the wall; it acts at R_J r from the journal's centre.
/// Source: Lankarani and Nikravesh (1990). Zero where δ ≤ 0. In the cylindrical form δ^{3/2} is multiplied by √(c/|e|).
/// @param impact_speed  δ̇₀ > 0, the speed at which the journal last crossed |e| = c outwards [m/s]
template <class T>
ContactForce<T> dry_contact_force(const JournalMotion<T>& motion, const Bearing<RealOf<T>>& bearing,
                                  const ContactSurface<RealOf<T>>& surface, const RealOf<T>& impact_speed) {
  using std::sqrt;
  using R = RealOf<T>;
  ContactForce<T> none{Vector2<T>(T(0), T(0)), T(0)};
  if (is_zero(motion.eccentricity)) return none;
  const T distance = norm(motion.eccentricity);
  const T depth = distance - bearing.clearance();
  if (!(value_of(depth) > 0)) return none;
  const Vector2<T> r(T(motion.eccentricity.x() / distance), T(motion.eccentricity.y() / distance));
  const R loss = 3 * (1 - surface.restitution) * (1 + surface.restitution) / (4 * impact_speed);
  const T damping = 1 + loss * dot(motion.velocity, r);
  if (!(value_of(damping) > 0)) return none;
  T normal = surface.stiffness * (depth * sqrt(depth)) * damping;
  if (surface.form == ContactForm::cylinder) normal = T(normal * sqrt(T(bearing.clearance() / distance)));
  if (surface.friction == 0) return {Vector2<T>(T(-normal * r.x()), T(-normal * r.y())), T(0)};
  const Vector2<T> t = perpendicular(r);
  const T wall = distance + bearing.radius();
  const T sliding = dot(motion.velocity, t) + motion.journal_spin * bearing.radius() - motion.bearing_spin * wall;
  const R slow = surface.slow_sliding;
  const T smooth = sqrt(T(sliding * sliding + slow * slow));
  const T along_t = -surface.friction * normal * (sliding / smooth);
  return {Vector2<T>(T(along_t * t.x() - normal * r.x()), T(along_t * t.y() - normal * r.y())),
          T(bearing.radius() * along_t)};
}

}  // namespace lubjoint

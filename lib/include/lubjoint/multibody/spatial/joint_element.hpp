/// A joint with clearance between two bodies in space, as a force element.
#pragma once

#include "lubjoint/joint/spatial_kinematics.hpp"
#include "lubjoint/multibody/joint_element.hpp"
#include "lubjoint/multibody/spatial/body.hpp"

namespace lubjoint {

/// Force and moment about the mass centre, inertial.
template <class T>
struct SpatialWrench {
  Vector3<T> force;   ///< [N]
  Vector3<T> moment;  ///< [N m]
};

/// A journal seen in its bearing's frame, in which it is turned by θ about n.
template <class T>
PlanarFrame<T> turned_journal(const JournalMotion<T>& seen, const T& turn) {
  return PlanarFrame<T>(PlanarMotion<T>{seen.eccentricity, turn, seen.velocity, seen.journal_spin});
}

/// What a joint in space does to its two bodies: film and contact apart, in the film's middle plane.
template <class T>
struct SpatialJointForce {
  SpatialJointKinematics<T> kinematics;  ///< where the journal is
  JointForce<T> plane;                   ///< the same as forces in the plane of t₁ and t₂
  T shear_torque;                        ///< on the journal about n; 0 without shear [N m]

  /// F on the journal, inertial [N].
  Vector3<T> force() const { return kinematics.in_space(plane.total()); }
  /// About n, on the journal's body: friction of the contact, and shear [N m].
  T couple() const { return T(plane.contact.couple + shear_torque); }

  /// F at X on body j, and the couple about n.
  SpatialWrench<T> on_journal() const {
    const Vector3<T> f = force();
    return {f, sum(cross(kinematics.journal_arm, f), scaled(couple(), kinematics.axis))};
  }
  /// −F at the same point on body i, and the opposite couple.
  SpatialWrench<T> on_bearing() const {
    const Vector3<T> f = negative(force());
    return {f, difference(cross(kinematics.bearing_arm, f), scaled(couple(), kinematics.axis))};
  }

  /// Power of a force F in the plane on both bodies: F·v_B + σ̇ F·n_J, the material points at X moving against each
  /// other by v_B + σ̇ n_J [W].
  T power(const Vector2<T>& in_plane) const {
    return T(dot(in_plane, kinematics.motion.velocity) +
             kinematics.sliding_rate * dot(kinematics.in_space(in_plane), kinematics.journal_axis));
  }
  /// Of the film on both bodies, shear included [W].
  T film_power() const { return T(power(plane.film) + shear_torque * kinematics.motion.journal_spin); }
  /// Of the contact on both bodies, its couple included [W].
  T contact_power() const {
    return T(power(plane.contact.force) + plane.contact.couple * kinematics.motion.journal_spin);
  }
};

/// A joint with clearance in space. Seen from the bearing it is the plane's: a journal of eccentricity e and velocity
/// v_B that turns by ω in a bearing at rest. Laws, contact and transition are those of JointElement.
/// Nothing resists sliding along n or tilting.
template <class R>
struct SpatialJointElement {
  JointElement<R> plane;   ///< the joint in its plane: its two anchors are not looked at
  BodyAxes<R> bearing_at;  ///< the bearing's centre P_i and axis n
  BodyAxes<R> journal_at;  ///< the journal's centre P_j and axis n_J

  const std::string& name() const { return plane.name; }  ///< in messages and results
  bool kinks() const { return plane.kinks(); }            ///< is its force at most once differentiable where ε̇ = 0?

  /// Where the journal is, seen from the bearing. @throws JournalAcross
  template <class T>
  SpatialJointKinematics<T> kinematics(const SpatialFrame<T>& bearing_body, const SpatialFrame<T>& journal_body) const {
    return spatial_joint_kinematics(bearing_body, bearing_at, journal_body, journal_at);
  }

  /// Force on the journal, of the piece that the memory names; of a journal that slides on the jump of its half film,
  /// what lies along its line.
  /// @param turn  of journal against bearing, which a journal that slides asks for
  /// @throws FilmDomainError where there is no film, and the phase asks for one; JournalAcross
  template <class T>
  SpatialJointForce<T> force(const SpatialFrame<T>& bearing_body, const SpatialFrame<T>& journal_body,
                             const JointMemory<R>& memory, const T& turn = T(0)) const {
    return force_at(kinematics(bearing_body, journal_body), memory, turn);
  }
  /// The same of known kinematics. @param known  as of JointElement::force_at, of a journal that does not slide
  template <class T>
  SpatialJointForce<T> force_at(const SpatialJointKinematics<T>& at, const JointMemory<R>& memory, const T& turn = T(0),
                                const JointForce<T>* known = nullptr) const {
    SpatialJointForce<T> result{at, {}, T(0)};
    const JournalMotion<T>& seen = result.kinematics.motion;
    const PlanarFrame<T> bearing(ground_motion<T>());
    const PlanarFrame<T> journal = turned_journal(seen, turn);
    result.plane = plane.force_at(plane.kinematics(bearing, journal), bearing, journal, memory, known);
    if (plane.shear) result.shear_torque = plane.shear_torque(result.plane, memory);
    return result;
  }

  /// ψL/2: how far the film's edge lies off its middle [m].
  R edge_shift(const R& tilt) const { return R(tilt * plane.bearing.length() / 2); }
};

/// A joint whose anchors are not looked at, for SpatialJointElement::plane.
/// @param film  with a transition, of clearance c + e₁
template <class R>
JointElement<R> joint_in_its_plane(const std::string& name, const Bearing<R>& bearing,
                                   std::optional<AnyFilm<R>> film = std::nullopt,
                                   std::optional<JointContact<R>> contact = std::nullopt,
                                   std::optional<JointShear<R>> shear = std::nullopt) {
  return {name, {}, {}, bearing, std::move(film), std::move(contact), std::move(shear)};
}

}  // namespace lubjoint

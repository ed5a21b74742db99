/// Forces and moments that a joint puts on its two bodies.
#pragma once

#include "lubjoint/joint/kinematics.hpp"

namespace lubjoint {

/// Force [N] and moment about the mass centre [N m], counter-clockwise positive.
template <class T>
struct Wrench {
  Vector2<T> force;  ///< [N]
  T moment;          ///< [N m]
};

/// What a joint puts on its two bodies.
template <class T>
struct JointWrenches {
  Wrench<T> bearing;  ///< on body i
  Wrench<T> journal;  ///< on body j
};

/// Wrenches of the force F that a joint puts on its journal.
///   body j: F, s_j × F;   body i: −F, s_i × (−F) + e × (−F)
/// −F acts on body i at the journal's centre: the term with e is the transport moment, without which the pair would
/// have a resultant moment of e × F.
/// So it matters which body carries the bearing: that one takes all of e × F. Example 1 with the bearing on the free
/// body, around a pin on the ground: the moment slows its spin, which a free journal would keep, and after 1 s the
/// eccentricity ratio is 0.181 instead of 0.167. With the film's shear it does not matter: the torques on journal and
/// bearing differ by e × F themselves (losses.hpp).
/// Source: Flores et al. (2009), eqs. 33 and 34.
template <class T>
JointWrenches<T> joint_wrenches(const JointKinematics<T>& joint, const Vector2<T>& force_on_journal) {
  const Vector2<T>& f = force_on_journal;
  const Vector2<T> reaction(T(-f.x()), T(-f.y()));
  const Vector2<T>& e = joint.motion.eccentricity;
  const Vector2<T> arm(T(joint.bearing_arm.x() + e.x()), T(joint.bearing_arm.y() + e.y()));
  return {{reaction, cross(arm, reaction)}, {f, cross(joint.journal_arm, f)}};
}

}  // namespace lubjoint

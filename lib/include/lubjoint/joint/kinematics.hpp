/// Where the journal is in its bearing, from the motions of the two bodies.
#pragma once

#include "lubjoint/film/film_state.hpp"
#include "lubjoint/joint/planar_motion.hpp"

namespace lubjoint {

/// Arms of a joint and the motion of its journal, all in the inertial frame.
template <class T>
struct JointKinematics {
  Vector2<T> bearing_arm;   ///< s_i, from the mass centre of the bearing's body to the bearing's centre [m]
  Vector2<T> journal_arm;   ///< s_j, from the mass centre of the journal's body to the journal's centre [m]
  JournalMotion<T> motion;  ///< e, v and both spins
};

/// Kinematics of a lubricated joint.
///   P_k = r_k + A_k s'_k,  e = P_j − P_i,  v = Ṗ_j − Ṗ_i   (bearing on body i, journal on body j)
/// Source: Flores et al. (2009), eqs. 21 to 24. e may exceed the clearance.
/// @param bearing_centre  s'_i, fixed to body i [m];  @param journal_centre  s'_j, fixed to body j [m]
/// @tparam Body  PlanarMotion, or PlanarFrame where the same body has more points
template <template <class> class Body, class T>
JointKinematics<T> joint_kinematics(const Body<T>& bearing_body, const Vector2<RealOf<T>>& bearing_centre,
                                    const Body<T>& journal_body, const Vector2<RealOf<T>>& journal_centre) {
  const Vector2<T> s_i = inertial_vector(bearing_body, bearing_centre);
  const Vector2<T> s_j = inertial_vector(journal_body, journal_centre);
  const Vector2<T> turn_i = perpendicular(s_i);
  const Vector2<T> turn_j = perpendicular(s_j);
  const T ex = (journal_body.position.x() - bearing_body.position.x()) + (s_j.x() - s_i.x());
  const T ey = (journal_body.position.y() - bearing_body.position.y()) + (s_j.y() - s_i.y());
  const T vx = (journal_body.velocity.x() - bearing_body.velocity.x()) +
               (journal_body.spin * turn_j.x() - bearing_body.spin * turn_i.x());
  const T vy = (journal_body.velocity.y() - bearing_body.velocity.y()) +
               (journal_body.spin * turn_j.y() - bearing_body.spin * turn_i.y());
  return {s_i, s_j, {Vector2<T>(ex, ey), Vector2<T>(vx, vy), bearing_body.spin, journal_body.spin}};
}

}  // namespace lubjoint

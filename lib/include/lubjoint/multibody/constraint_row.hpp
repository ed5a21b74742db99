/// What the equations of motion need of one scalar constraint.
#pragma once

#include "lubjoint/multibody/planar_body.hpp"

namespace lubjoint {

/// One row of Φ(q, t) = 0 between a first body i and a second body j. A column that belongs to the ground is ignored.
template <class T>
struct ConstraintRow {
  T value;                  ///< Φ
  T time_rate;              ///< Φ_t
  T gamma;                  ///< γ = −(Φq q̇)q q̇ − 2Φqt q̇ − Φtt (eq. 40)
  std::array<T, 3> first;   ///< Φq, columns x, y, φ of body i
  std::array<T, 3> second;  ///< those of body j
};

/// Position, velocity and body-fixed arm of a point of a body.
template <class T>
struct PointMotion {
  Vector2<T> arm;       ///< s, from the mass centre [m]
  Vector2<T> position;  ///< r + s
  Vector2<T> velocity;  ///< ṙ + φ̇ s⊥
};

/// Motion of a body-fixed point.
/// @param point  from the mass centre, in the body's frame [m]
template <class T>
PointMotion<T> point_motion(const PlanarFrame<T>& body, const Vector2<RealOf<T>>& point) {
  const Vector2<T> s = inertial_vector(body, point);
  return {s, Vector2<T>(T(body.position.x() + s.x()), T(body.position.y() + s.y())),
          Vector2<T>(T(body.velocity.x() - body.spin * s.y()), T(body.velocity.y() + body.spin * s.x()))};
}

}  // namespace lubjoint

/// Motion of a rigid body in the plane, and of the points fixed to it.
#pragma once

#include <cmath>

#include "lubjoint/number/vector.hpp"

namespace lubjoint {

/// Position and velocity of a body's mass centre and of its frame, inertial.
template <class T>
struct PlanarMotion {
  Vector2<T> position;  ///< r [m]
  T angle;              ///< φ [rad], counter-clockwise
  Vector2<T> velocity;  ///< ṙ [m/s]
  T spin;               ///< φ̇ [rad/s]
};

/// s = A(φ) s', a body-fixed vector seen in the inertial frame [m].
template <class T>
Vector2<T> inertial_vector(const PlanarMotion<T>& body, const Vector2<RealOf<T>>& body_fixed) {
  using std::cos;
  using std::sin;
  const T c = cos(body.angle);
  const T s = sin(body.angle);
  return Vector2<T>(T(c * body_fixed.x() - s * body_fixed.y()), T(s * body_fixed.x() + c * body_fixed.y()));
}

/// A motion with the cosine and sine of its angle: formed once for all points of the body.
template <class T>
struct PlanarFrame : PlanarMotion<T> {
  T cosine;  ///< cos φ
  T sine;    ///< sin φ

  /// Forms cosine and sine.
  explicit PlanarFrame(const PlanarMotion<T>& motion) : PlanarMotion<T>(motion) {
    using std::cos;
    using std::sin;
    cosine = cos(this->angle);
    sine = sin(this->angle);
  }
};

/// s = A(φ) s' of a frame.
template <class T>
Vector2<T> inertial_vector(const PlanarFrame<T>& body, const Vector2<RealOf<T>>& body_fixed) {
  return Vector2<T>(T(body.cosine * body_fixed.x() - body.sine * body_fixed.y()),
                    T(body.sine * body_fixed.x() + body.cosine * body_fixed.y()));
}

/// Motion of a body that never moves, and that is no body of the system.
template <class T>
PlanarMotion<T> ground_motion() {
  return {Vector2<T>(T(0), T(0)), T(0), Vector2<T>(T(0), T(0)), T(0)};
}

}  // namespace lubjoint

/// Motion of a rigid body in space, by Euler parameters, and of the points fixed to it.
#pragma once

#include "lubjoint/number/vector3.hpp"

namespace lubjoint {

/// Euler parameters p = (e₀, e): cos(θ/2) and sin(θ/2) times the axis of a turn by θ; |p| = 1. −p is the same turn.
template <class T>
using EulerParameters = Eigen::Matrix<T, 4, 1>;

/// A(p) = (2e₀² − 1) I + 2(e eᵀ + e₀ ẽ), which takes body-fixed components to inertial ones.
/// Source: Flores et al. (2009), section 6; Nikravesh (1988), Computer-Aided Analysis of Mechanical Systems.
/// Orthogonal where |p| = 1; nothing is divided by |p|.
template <class T>
Matrix3<T> rotation_matrix(const EulerParameters<T>& p) {
  const T diagonal = 2 * p(0) * p(0) - 1;
  Matrix3<T> a;
  for (Eigen::Index i = 0; i < 3; ++i) a(i, i) = T(diagonal + 2 * p(i + 1) * p(i + 1));
  a(0, 1) = T(2 * (p(1) * p(2) - p(0) * p(3)));
  a(1, 0) = T(2 * (p(1) * p(2) + p(0) * p(3)));
  a(0, 2) = T(2 * (p(1) * p(3) + p(0) * p(2)));
  a(2, 0) = T(2 * (p(1) * p(3) - p(0) * p(2)));
  a(1, 2) = T(2 * (p(2) * p(3) - p(0) * p(1)));
  a(2, 1) = T(2 * (p(2) * p(3) + p(0) * p(1)));
  return a;
}

/// ½ Lᵀ w with L = [−e, −ẽ + e₀ I]: ṗ of the angular velocity w = ω′ (body's frame), or the change of p by a small
/// turn. Source: Flores et al. (2009), eqs. 36 and 37; its inverse is ω′ = 2Lṗ.
template <class T>
EulerParameters<T> euler_rate(const EulerParameters<T>& p, const Vector3<T>& w) {
  const T half(0.5);
  return EulerParameters<T>(
      T(-half * (p(1) * w(0) + p(2) * w(1) + p(3) * w(2))), T(half * (p(0) * w(0) + p(2) * w(2) - p(3) * w(1))),
      T(half * (p(0) * w(1) + p(3) * w(0) - p(1) * w(2))), T(half * (p(0) * w(2) + p(1) * w(1) - p(2) * w(0))));
}

/// p/|p|. Needs p ≠ 0.
template <class R>
EulerParameters<R> normalised(const EulerParameters<R>& p) {
  using std::sqrt;
  const R size = sqrt(R(p(0) * p(0) + p(1) * p(1) + p(2) * p(2) + p(3) * p(3)));
  return EulerParameters<R>(R(p(0) / size), R(p(1) / size), R(p(2) / size), R(p(3) / size));
}

/// Euler parameters of a turn about an axis.
/// @param axis  a unit vector;  @param angle  [rad]
template <class R>
EulerParameters<R> euler_parameters(const Vector3<R>& axis, const R& angle) {
  using std::cos;
  using std::sin;
  const R s = sin(R(angle / 2));
  return EulerParameters<R>(R(cos(R(angle / 2))), R(s * axis(0)), R(s * axis(1)), R(s * axis(2)));
}

/// Euler parameters of a rotation matrix, the largest of them first, so that nothing is lost where another vanishes;
/// that one is positive.
template <class R>
EulerParameters<R> euler_parameters(const Matrix3<R>& a) {
  const R trace = a(0, 0) + a(1, 1) + a(2, 2);
  // 4 p pᵀ, whose diagonal says which of them is largest.
  Eigen::Matrix<R, 4, 4> squares;
  squares(0, 0) = 1 + trace;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Index j = (i + 1) % 3;
    const Eigen::Index k = (i + 2) % 3;
    squares(i + 1, i + 1) = 1 + 2 * a(i, i) - trace;
    squares(0, i + 1) = squares(i + 1, 0) = a(k, j) - a(j, k);
    squares(i + 1, j + 1) = squares(j + 1, i + 1) = a(i, j) + a(j, i);
  }
  Eigen::Index largest = 0;
  for (Eigen::Index i = 1; i < 4; ++i) {
    if (squares(i, i) > squares(largest, largest)) largest = i;
  }
  return normalised<R>(squares.col(largest));
}

/// Position and velocity of a body's mass centre and of its frame.
template <class T>
struct SpatialMotion {
  Vector3<T> position;            ///< r, inertial [m]
  EulerParameters<T> parameters;  ///< p, |p| = 1
  Vector3<T> velocity;            ///< ṙ, inertial [m/s]
  Vector3<T> body_spin;           ///< ω′, the angular velocity in the body's frame [rad/s]
};

/// A motion with what follows from it for all points of the body.
template <class T>
struct SpatialFrame : SpatialMotion<T> {
  Matrix3<T> rotation;  ///< A(p)
  Vector3<T> spin;      ///< ω = A ω′, inertial [rad/s]
  bool moves = true;    ///< false of the ground, where much is known to be zero

  SpatialFrame() = default;  ///< of nothing yet
  /// Forms A and ω.
  explicit SpatialFrame(const SpatialMotion<T>& motion)
      : SpatialMotion<T>(motion),
        rotation(rotation_matrix(motion.parameters)),
        spin(product(rotation, motion.body_spin)) {}

  /// On another scalar, as a constant.
  template <class S>
  SpatialFrame<S> cast() const {
    SpatialFrame<S> frame;
    frame.position = this->position.template cast<S>();
    frame.parameters = this->parameters.template cast<S>();
    frame.velocity = this->velocity.template cast<S>();
    frame.body_spin = this->body_spin.template cast<S>();
    frame.rotation = rotation.template cast<S>();
    frame.spin = spin.template cast<S>();
    frame.moves = moves;
    return frame;
  }
};

/// A s′, a body-fixed vector seen in the inertial frame.
template <class T>
Vector3<T> inertial_vector(const SpatialFrame<T>& body, const Vector3<RealOf<T>>& body_fixed) {
  return product(body.rotation, body_fixed);
}

/// Motion of a body that never moves, and that is no body of the system.
template <class T>
SpatialMotion<T> spatial_ground_motion() {
  return {zero_vector<T>(), EulerParameters<T>(T(1), T(0), T(0), T(0)), zero_vector<T>(), zero_vector<T>()};
}

/// Its frame.
template <class T>
SpatialFrame<T> spatial_ground_frame() {
  SpatialFrame<T> frame(spatial_ground_motion<T>());
  frame.moves = false;
  return frame;
}

/// Position, velocity and arm of a body-fixed point.
template <class T>
struct SpatialPoint {
  Vector3<T> arm;       ///< s = A s′, from the mass centre [m]
  Vector3<T> position;  ///< r + s
  Vector3<T> turning;   ///< ω × s, its velocity from the mass centre's
  Vector3<T> velocity;  ///< ṙ + ω × s
};

/// Motion of a body-fixed point.
/// @param point  s′, from the mass centre, in the body's frame [m]
template <class T>
SpatialPoint<T> point_motion(const SpatialFrame<T>& body, const Vector3<RealOf<T>>& point) {
  if (!body.moves) {
    const Vector3<T> at = point.template cast<T>();
    return {at, at, zero_vector<T>(), zero_vector<T>()};
  }
  const Vector3<T> s = inertial_vector(body, point);
  const Vector3<T> turning = cross(body.spin, s);
  return {s, sum(body.position, s), turning, sum(body.velocity, turning)};
}

}  // namespace lubjoint

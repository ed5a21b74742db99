/// How a body is turned against another about an axis that both have.
#pragma once

#include "lubjoint/multibody/spatial/constraint_row.hpp"

namespace lubjoint {

/// Turn of body j against body i about the axis n_i.
///   C = t₁i·t₁j,  S = t₂i·t₁j,  ρ² = C² + S²;  θ = atan2(S, C),  θ̇ = (CṠ − SĊ)/ρ² = (ω_j − ω_i)·a,
///   a = t₁j × (C t₂i − S t₁i)/ρ², which is n where the axes coincide
template <class T>
struct Turn {
  T cosine;         ///< C
  T sine;           ///< S
  T square;         ///< ρ²: 1 where the axes coincide, 0 where they lie across each other
  Vector3<T> axis;  ///< a
};

/// Of t₁i, t₂i and t₁j, inertial.
template <class T>
Turn<T> turn_of(const Vector3<T>& x_i, const Vector3<T>& y_i, const Vector3<T>& x_j) {
  const T cosine = dot(x_i, x_j);
  const T sine = dot(y_i, x_j);
  const T square = cosine * cosine + sine * sine;
  return {cosine, sine, square, cross(x_j, difference(scaled(T(cosine / square), y_i), scaled(T(sine / square), x_i)))};
}

/// The angle that differs from another by whole turns and is nearest to a place.
template <class T>
T nearest_turn(const T& angle, const RealOf<T>& place) {
  using std::round;
  using R = RealOf<T>;
  const R turn = 2 * pi<R>();
  return T(angle + turn * R(round(R((place - value_of(angle)) / turn))));
}

/// An angle, its rate, and the axis that a moment M on body j acts about where its power is M θ̇; −M acts on body i.
template <class T>
struct AngleMotion {
  T angle;          ///< θ [rad]
  T rate;           ///< θ̇ [rad/s]
  Vector3<T> axis;  ///< a: θ̇ = (ω_j − ω_i)·a
};

/// The angle of body j against body i about the axis of a revolute or cylindrical joint, counted through revolutions.
template <class R>
struct CountedAngle {
  BodyAxes<R> first;   ///< fixed to body i
  BodyAxes<R> second;  ///< fixed to body j
  R zero;              ///< the angle where t₁i and t₁j coincide [rad]

  /// On another scalar.
  template <class S>
  CountedAngle<S> cast() const {
    return {first.template cast<S>(), second.template cast<S>(), S(zero)};
  }
  /// From the motions of its two bodies. @param near  a place less than half a turn from the angle
  template <class T>
  AngleMotion<T> motion(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const R& near) const {
    const Turn<T> turn = turn_of(inertial_vector(body_i, first.across), inertial_vector(body_i, first.third()),
                                 inertial_vector(body_j, second.across));
    const T angle = nearest_turn(T(zero + polar_angle(turn.sine, turn.cosine)), near);
    return {angle, dot(difference(body_j.spin, body_i.spin), turn.axis), turn.axis};
  }
};

}  // namespace lubjoint

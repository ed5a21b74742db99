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

/// The row of the turn θ of body j against body i about n_i, up to whole revolutions: θ̇ = (ω_j − ω_i)·a,
///   γ = −(C S̈₀ − S C̈₀)/ρ² + 2(CĊ + SṠ)(CṠ − SĊ)/ρ⁴,  S̈₀ and C̈₀ without ω̇.
/// @param first, second  axes fixed to the bodies
template <class R, class T>
void fill_turn_between(const AxisFrame<R>& first, const AxisFrame<R>& second, const SpatialFrame<T>& body_i,
                       const SpatialFrame<T>& body_j, SpatialRow<T>& row) {
  const TurningVector<T> x_i = turning_vector(body_i, first.across);
  const TurningVector<T> y_i = turning_vector(body_i, first.third());
  const TurningVector<T> x_j = turning_vector(body_j, second.across);
  const Turn<T> turn = turn_of(x_i.now, y_i.now, x_j.now);
  const T cosine_rate = dot(x_i.rate, x_j.now) + dot(x_i.now, x_j.rate);
  const T sine_rate = dot(y_i.rate, x_j.now) + dot(y_i.now, x_j.rate);
  const T cosine_second = dot(x_i.second, x_j.now) + 2 * dot(x_i.rate, x_j.rate) + dot(x_i.now, x_j.second);
  const T sine_second = dot(y_i.second, x_j.now) + 2 * dot(y_i.rate, x_j.rate) + dot(y_i.now, x_j.second);
  const T rate = (turn.cosine * sine_rate - turn.sine * cosine_rate) / turn.square;
  const T change = 2 * (turn.cosine * cosine_rate + turn.sine * sine_rate) / turn.square;
  const Vector3<T> none = zero_vector<T>();
  row.value = polar_angle(turn.sine, turn.cosine);
  row.time_rate = T(0);
  row.gamma = T(change * rate - (turn.cosine * sine_second - turn.sine * cosine_second) / turn.square);
  if (detail::has_columns(body_i)) row.first = detail::columns(none, detail::in_body(body_i, negative(turn.axis)));
  if (detail::has_columns(body_j)) row.second = detail::columns(none, detail::in_body(body_j, turn.axis));
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

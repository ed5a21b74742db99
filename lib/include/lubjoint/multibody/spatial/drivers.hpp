/// Motors in space: prescribed turns about an axis, and prescribed ways along one.
#pragma once

#include "lubjoint/multibody/driven_motion.hpp"
#include "lubjoint/multibody/spatial/joints.hpp"

namespace lubjoint {

/// What a driver prescribes: f = f₀ + f₁ t + ½ f₂ t².
template <class R>
struct PrescribedMotion {
  R start;         ///< f₀ [rad or m]
  R speed;         ///< f₁ [rad/s or m/s]
  R acceleration;  ///< f₂ [rad/s² or m/s²]

  /// f
  template <class Time>
  Time place(const Time& t) const {
    return Time(start + t * (speed + t * acceleration / 2));
  }
  /// ḟ
  template <class Time>
  Time rate(const Time& t) const {
    return Time(speed + t * acceleration);
  }
  /// Sum of the sizes of the terms of f.
  R size_of_terms(const R& t) const { return lubjoint::size_of_terms<R>(start, speed, acceleration, nullptr, t); }
  /// On another scalar.
  template <class S>
  PrescribedMotion<S> cast() const {
    return {S(start), S(speed), S(acceleration)};
  }
};

/// A motor that turns body j against body i about the axis n_i of a revolute or cylindrical joint.
///   θ = atan2(S, C),  C = t₁i·t₁j,  S = t₂i·t₁j;   Φ = θ − f(t), of the revolution that is nearest to f: θ is counted
/// through revolutions, not reduced, as long as the motor is off by less than half a turn.
///   Φ̇ = (CṠ − SĊ)/ρ² − ḟ,  ρ² = C² + S²:  with m = (C t₂i − S t₁i) × t₁j/ρ², which is −n where the axes coincide,
///   CṠ − SĊ = ρ² (ω_i − ω_j)·m;
///   γ = f̈ − (C S̈₀ − S C̈₀)/ρ² + 2(CĊ + SṠ)(CṠ − SĊ)/ρ⁴,  S̈₀ and C̈₀ without ω̇
/// The driving moment on body j about n is −λ.
template <class R>
struct RotationalDriver : detail::BetweenAxes<R> {
  static constexpr std::size_t rows = 1;  ///< scalar equations
  PrescribedMotion<R> motion;             ///< f
  /// Is Φ of a row a length? It is an angle.
  static constexpr bool is_length(std::size_t) { return false; }

  /// On another scalar.
  template <class S>
  RotationalDriver<S> cast() const {
    return {{this->first.template cast<S>(), this->second.template cast<S>()}, motion.template cast<S>()};
  }
  /// Fills the row from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const Time& t, SpatialRow<T>* row) const {
    using std::round;
    const TurningVector<T> x_i = turning_vector(body_i, this->first.across);
    const TurningVector<T> y_i = turning_vector(body_i, this->first.third());
    const TurningVector<T> x_j = turning_vector(body_j, this->second.across);
    const T cosine = dot(x_i.now, x_j.now);
    const T sine = dot(y_i.now, x_j.now);
    const T cosine_rate = dot(x_i.rate, x_j.now) + dot(x_i.now, x_j.rate);
    const T sine_rate = dot(y_i.rate, x_j.now) + dot(y_i.now, x_j.rate);
    const T cosine_second = dot(x_i.second, x_j.now) + 2 * dot(x_i.rate, x_j.rate) + dot(x_i.now, x_j.second);
    const T sine_second = dot(y_i.second, x_j.now) + 2 * dot(y_i.rate, x_j.rate) + dot(y_i.now, x_j.second);
    const T square = cosine * cosine + sine * sine;
    const T angle_rate = (cosine * sine_rate - sine * cosine_rate) / square;
    const T change = 2 * (cosine * cosine_rate + sine * sine_rate) / square;
    const Vector3<T> m =
        cross(difference(scaled(T(cosine / square), y_i.now), scaled(T(sine / square), x_i.now)), x_j.now);
    T value = T(polar_angle(sine, cosine) - motion.place(t));
    const R turn = 2 * pi<R>();
    value = T(value - turn * R(round(R(value_of(value) / turn))));
    const Vector3<T> none = zero_vector<T>();
    row[0].value = value;
    row[0].time_rate = T(-motion.rate(t));
    row[0].gamma =
        T(motion.acceleration - (cosine * sine_second - sine * cosine_second) / square + change * angle_rate);
    if (detail::has_columns(body_i)) row[0].first = detail::columns(none, detail::in_body(body_i, m));
    if (detail::has_columns(body_j)) row[0].second = detail::columns(none, detail::in_body(body_j, negative(m)));
  }
};

/// A motor that moves body j along the axis n_i of a prismatic or cylindrical joint: Φ = n_i·d − f(t), with γ of the
/// block perpendicular₂ and f̈. The driving force on body j along n is −λ.
template <class R>
struct TranslationalDriver : detail::BetweenAxes<R> {
  static constexpr std::size_t rows = 1;  ///< scalar equations
  PrescribedMotion<R> motion;             ///< f
  /// Is Φ of a row a length? It is a length.
  static constexpr bool is_length(std::size_t) { return true; }

  /// On another scalar.
  template <class S>
  TranslationalDriver<S> cast() const {
    return {{this->first.template cast<S>(), this->second.template cast<S>()}, motion.template cast<S>()};
  }
  /// Fills the row from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const Time& t, SpatialRow<T>* row) const {
    fill_across(body_i, turning_vector(body_i, this->first.axis), body_j,
                point_pair(body_i, this->first.point, body_j, this->second.point), row[0]);
    row[0].value = T(row[0].value - motion.place(t));
    row[0].time_rate = T(-motion.rate(t));
    row[0].gamma = T(row[0].gamma + motion.acceleration);
  }
};

}  // namespace lubjoint

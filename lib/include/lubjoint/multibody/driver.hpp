#pragma once

#include "lubjoint/multibody/constraint_row.hpp"
#include "lubjoint/multibody/driven_motion.hpp"

namespace lubjoint {

/// A motor that turns body j against body i: Φ = φ_j − φ_i − f(t), f = φ₀ + ωt + ½αt² and its shape (rheonomic); γ = f̈.
/// The driving moment on body j, counter-clockwise positive, is −λ.
template <class R>
struct Driver {
  static constexpr std::size_t rows = 1;                  ///< scalar equations
  static constexpr bool turns = true;                     ///< f is an angle
  std::size_t first;                                      ///< body i; may be the ground
  std::size_t second;                                     ///< body j, which is turned
  R angle;                                                ///< φ₀ [rad]
  R speed;                                                ///< ω [rad/s]
  R acceleration;                                         ///< α [rad/s²]
  std::shared_ptr<const MotionShape<R>> shape = nullptr;  ///< none: f is what φ₀, ω and α say

  std::size_t first_body() const { return first; }    ///< i
  std::size_t second_body() const { return second; }  ///< j

  /// On another scalar.
  template <class S>
  Driver<S> cast() const {
    return {first, second, S(angle), S(speed), S(acceleration), cast_shape<S>(shape)};
  }
  /// Calls visit(point) for each point that it fixes to a body.
  template <class Visit>
  void visit_points(Visit&&) {}

  /// f with its rate and acceleration [rad].
  template <class Time>
  DrivenMotion<Time> motion(const Time& t) const {
    return driven_motion(angle, speed, acceleration, shape, t);
  }
  /// Of f: see there.
  R size_of_terms(const R& t) const { return lubjoint::size_of_terms(angle, speed, acceleration, shape, t); }

  /// Fills the rows of the constraint from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j, const Time& t,
                ConstraintRow<T>* row) const {
    const DrivenMotion<Time> f = motion(t);
    const T zero(0);
    row[0] = {T((body_j.angle - body_i.angle) - f.value),
              T(-f.rate),
              T(f.acceleration),
              {zero, zero, T(-1)},
              {zero, zero, T(1)}};
  }
};

/// A motor that moves a point P_j along an axis u of body i: Φ = u·(P_j − P_i) − f(t) (rheonomic).
///   d = P_j − P_i, n = u⊥:  γ = φ̇_i² u·d − 2φ̇_i n·ḋ + u·(φ̇_j² s_j − φ̇_i² s_i) + f̈
/// The driving force on body j along u is −λ.
template <class R>
struct SlideDriver {
  static constexpr std::size_t rows = 1;                  ///< scalar equations
  static constexpr bool turns = false;                    ///< f is a way
  BodyPoint<R> first;                                     ///< P_i, from which the way is measured
  Vector2<R> axis;                                        ///< u, fixed to body i; a unit vector
  BodyPoint<R> second;                                    ///< P_j, which is moved
  R position;                                             ///< at t = 0, without the shape [m]
  R speed;                                                ///< [m/s]
  R acceleration;                                         ///< [m/s²]
  std::shared_ptr<const MotionShape<R>> shape = nullptr;  ///< none: f is what the three before it say

  std::size_t first_body() const { return first.body; }    ///< i
  std::size_t second_body() const { return second.body; }  ///< j

  /// On another scalar.
  template <class S>
  SlideDriver<S> cast() const {
    return {first.template cast<S>(), axis.template cast<S>(), second.template cast<S>(), S(position), S(speed),
            S(acceleration),          cast_shape<S>(shape)};
  }
  /// Calls visit(point) for each point that it fixes to a body.
  template <class Visit>
  void visit_points(Visit&& visit) {
    visit(first);
    visit(second);
  }

  /// f with its rate and acceleration [m].
  template <class Time>
  DrivenMotion<Time> motion(const Time& t) const {
    return driven_motion(position, speed, acceleration, shape, t);
  }
  /// Of f: see there.
  R size_of_terms(const R& t) const { return lubjoint::size_of_terms(position, speed, acceleration, shape, t); }

  /// Fills the rows of the constraint from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j, const Time& t,
                ConstraintRow<T>* row) const {
    const DrivenMotion<Time> f = motion(t);
    const PointMotion<T> p_i = point_motion(body_i, first.point);
    const PointMotion<T> p_j = point_motion(body_j, second.point);
    const Vector2<T> u = inertial_vector(body_i, axis);
    const Vector2<T> n = perpendicular(u);
    const Vector2<T> d(T(p_j.position.x() - p_i.position.x()), T(p_j.position.y() - p_i.position.y()));
    const Vector2<T> rate(T(p_j.velocity.x() - p_i.velocity.x()), T(p_j.velocity.y() - p_i.velocity.y()));
    const T spin_i = body_i.spin * body_i.spin;
    const T spin_j = body_j.spin * body_j.spin;
    const T along = dot(u, d);
    // u·s⊥ = −n·s, and u turns with body i: ∂(u·d)/∂φ_i = n·d + n·s_i.
    row[0] = {T(along - f.value),
              T(-f.rate),
              T(spin_i * along - 2 * body_i.spin * dot(n, rate) + spin_j * dot(u, p_j.arm) - spin_i * dot(u, p_i.arm) +
                f.acceleration),
              {T(-u.x()), T(-u.y()), T(dot(n, d) + dot(n, p_i.arm))},
              {u.x(), u.y(), T(-dot(n, p_j.arm))}};
  }
};

}  // namespace lubjoint

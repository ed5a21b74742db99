#pragma once

#include "lubjoint/multibody/constraint_row.hpp"

namespace lubjoint {

/// A slider j on a straight guide of body i, which keeps its angle to it.
///   d = P_j − P_i, u along the guide, n = u⊥:  Φ = (n·d, φ_j − φ_i − φ₀)
///   γ₁ = n·(φ̇_j² s_j − φ̇_i² s_i) + 2φ̇_i u·ḋ + φ̇_i² n·d,  γ₂ = 0
template <class R>
struct Translational {
  static constexpr std::size_t rows = 2;  ///< scalar equations
  BodyPoint<R> first;                     ///< a point of the guide
  Vector2<R> axis;                        ///< its direction, fixed to body i; a unit vector
  BodyPoint<R> second;                    ///< a point of the slider, kept on the guide
  R angle;                                ///< φ₀ [rad]

  std::size_t first_body() const { return first.body; }    ///< i
  std::size_t second_body() const { return second.body; }  ///< j

  /// On another scalar.
  template <class S>
  Translational<S> cast() const {
    return {first.template cast<S>(), axis.template cast<S>(), second.template cast<S>(), S(angle)};
  }
  /// Calls visit(point) for each point that it fixes to a body.
  template <class Visit>
  void visit_points(Visit&& visit) {
    visit(first);
    visit(second);
  }

  /// Fills the rows of the constraint from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j, const Time&, ConstraintRow<T>* row) const {
    const PointMotion<T> p_i = point_motion(body_i, first.point);
    const PointMotion<T> p_j = point_motion(body_j, second.point);
    const Vector2<T> u = inertial_vector(body_i, axis);
    const Vector2<T> n = perpendicular(u);
    const Vector2<T> d(T(p_j.position.x() - p_i.position.x()), T(p_j.position.y() - p_i.position.y()));
    const Vector2<T> rate(T(p_j.velocity.x() - p_i.velocity.x()), T(p_j.velocity.y() - p_i.velocity.y()));
    const T across = dot(n, d);
    const T spin_i = body_i.spin * body_i.spin;
    const T spin_j = body_j.spin * body_j.spin;
    const T gamma =
        spin_j * dot(n, p_j.arm) - spin_i * dot(n, p_i.arm) + 2 * body_i.spin * dot(u, rate) + spin_i * across;
    const T zero(0);
    const T one(1);
    const T minus(-1);
    // n·s⊥ = u·s, and n turns with body i: ∂(n·d)/∂φ_i = −u·s_i − u·d.
    row[0] = {
        across, zero, gamma, {T(-n.x()), T(-n.y()), T(-dot(u, p_i.arm) - dot(u, d))}, {n.x(), n.y(), dot(u, p_j.arm)}};
    row[1] = {T(body_j.angle - body_i.angle - angle), zero, zero, {zero, zero, minus}, {zero, zero, one}};
  }
};

}  // namespace lubjoint

#pragma once

#include "lubjoint/multibody/constraint_row.hpp"

namespace lubjoint {

/// An ideal pin: Φ = P_j − P_i, γ = φ̇_j² s_j − φ̇_i² s_i.
/// The multipliers are the force that the pin puts on body i; body j gets −λ.
template <class R>
struct Revolute {
  static constexpr std::size_t rows = 2;  ///< scalar equations
  BodyPoint<R> first;                     ///< P_i
  BodyPoint<R> second;                    ///< P_j

  std::size_t first_body() const { return first.body; }    ///< i
  std::size_t second_body() const { return second.body; }  ///< j

  /// On another scalar.
  template <class S>
  Revolute<S> cast() const {
    return {first.template cast<S>(), second.template cast<S>()};
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
    const Vector2<T> s_i = inertial_vector(body_i, first.point);
    const Vector2<T> s_j = inertial_vector(body_j, second.point);
    const T spin_i = body_i.spin * body_i.spin;
    const T spin_j = body_j.spin * body_j.spin;
    // Positions first, arms second: neighbours subtract without loss.
    const T x = (body_j.position.x() - body_i.position.x()) + (s_j.x() - s_i.x());
    const T y = (body_j.position.y() - body_i.position.y()) + (s_j.y() - s_i.y());
    const T zero(0);
    const T one(1);
    const T minus(-1);
    row[0] = {x, zero, T(spin_j * s_j.x() - spin_i * s_i.x()), {minus, zero, s_i.y()}, {one, zero, T(-s_j.y())}};
    row[1] = {y, zero, T(spin_j * s_j.y() - spin_i * s_i.y()), {zero, minus, T(-s_i.x())}, {zero, one, s_j.x()}};
  }
};

}  // namespace lubjoint

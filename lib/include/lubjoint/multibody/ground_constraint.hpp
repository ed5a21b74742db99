#pragma once

#include "lubjoint/multibody/constraint_row.hpp"

namespace lubjoint {

/// A body that is held where it is: Φ = (x − x₀, y − y₀, φ − φ₀), γ = 0.
template <class R>
struct GroundConstraint {
  static constexpr std::size_t rows = 3;  ///< scalar equations
  std::size_t body;                       ///< the one that is held
  Vector2<R> position;                    ///< x₀, y₀ of its mass centre [m]
  R angle;                                ///< φ₀ [rad]

  std::size_t first_body() const { return ground_body; }  ///< i
  std::size_t second_body() const { return body; }        ///< j

  /// On another scalar.
  template <class S>
  GroundConstraint<S> cast() const {
    return {body, position.template cast<S>(), S(angle)};
  }
  /// Calls visit(point) for each point that it fixes to a body.
  template <class Visit>
  void visit_points(Visit&&) {}

  /// Fills the rows of the constraint from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const PlanarFrame<T>&, const PlanarFrame<T>& held, const Time&, ConstraintRow<T>* row) const {
    const T zero(0);
    const T one(1);
    row[0] = {T(held.position.x() - position.x()), zero, zero, {zero, zero, zero}, {one, zero, zero}};
    row[1] = {T(held.position.y() - position.y()), zero, zero, {zero, zero, zero}, {zero, one, zero}};
    row[2] = {T(held.angle - angle), zero, zero, {zero, zero, zero}, {zero, zero, one}};
  }
};

}  // namespace lubjoint

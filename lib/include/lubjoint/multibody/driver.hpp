#pragma once

#include "lubjoint/multibody/constraint_row.hpp"

namespace lubjoint {

/// A motor that turns body j against body i: Φ = φ_j − φ_i − f(t), f = φ₀ + ωt + ½αt² (rheonomic); γ = f̈.
/// The driving moment on body j, counter-clockwise positive, is −λ.
template <class R>
struct Driver {
  static constexpr std::size_t rows = 1;  ///< scalar equations
  std::size_t first;                      ///< body i; may be the ground
  std::size_t second;                     ///< body j, which is turned
  R angle;                                ///< φ₀ [rad]
  R speed;                                ///< ω [rad/s]
  R acceleration;                         ///< α [rad/s²]

  std::size_t first_body() const { return first; }    ///< i
  std::size_t second_body() const { return second; }  ///< j

  /// On another scalar.
  template <class S>
  Driver<S> cast() const {
    return {first, second, S(angle), S(speed), S(acceleration)};
  }
  /// Calls visit(point) for each point that it fixes to a body.
  template <class Visit>
  void visit_points(Visit&&) {}

  /// Fills the rows of the constraint from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const PlanarFrame<T>& body_i, const PlanarFrame<T>& body_j, const Time& t,
                ConstraintRow<T>* row) const {
    const Time wanted = angle + t * (speed + t * acceleration / 2);
    const T zero(0);
    row[0] = {T((body_j.angle - body_i.angle) - wanted),
              T(-(speed + t * acceleration)),
              T(acceleration),
              {zero, zero, T(-1)},
              {zero, zero, T(1)}};
  }
};

}  // namespace lubjoint

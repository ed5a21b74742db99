/// Motors in space: prescribed turns about an axis, and prescribed ways along one.
#pragma once

#include "lubjoint/multibody/driven_motion.hpp"
#include "lubjoint/multibody/spatial/joints.hpp"
#include "lubjoint/multibody/spatial/turn.hpp"

namespace lubjoint {

namespace detail {

/// The row of a prescribed turn: that of the turn (turn.hpp), less f.
///   Φ = θ − f(t), of the revolution that is nearest to f: θ is counted through revolutions, not reduced, as long as
///   the motor is off by less than half a turn;   Φ̇ = θ̇ − ḟ
template <class R, class T, class Time>
void fill_prescribed_turn(const BetweenAxes<R>& joint, const PrescribedMotion<R>& motion, const SpatialFrame<T>& body_i,
                          const SpatialFrame<T>& body_j, const Time& t, SpatialRow<T>& row) {
  fill_turn_between(joint.first, joint.second, body_i, body_j, row);
  const DrivenMotion<Time> f = motion.at(t);
  row.value = nearest_turn(T(row.value - f.value), R(0));
  row.time_rate = T(-f.rate);
  row.gamma = T(row.gamma + f.acceleration);
}

}  // namespace detail

/// A motor that turns body j against body i about the axis n_i of a revolute or cylindrical joint: θ = f(t). The
/// driving moment on body j about n is −λ.
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
    detail::fill_prescribed_turn(*this, motion, body_i, body_j, t, row[0]);
  }
};

/// The whole orientation of body j is prescribed: it turns about an axis n that keeps its direction, θ = f(t), and
/// moves freely. Of a body whose spin is held. Rows: that of the turn, then t₁i·n_j = t₂i·n_j = 0. The moment about n
/// is −λ of the first row; the others keep the axis from tilting.
template <class R>
struct HeldSpin : detail::BetweenAxes<R> {
  static constexpr std::size_t rows = 3;  ///< scalar equations
  PrescribedMotion<R> motion;             ///< f
  /// Is Φ of a row a length? None is.
  static constexpr bool is_length(std::size_t) { return false; }

  /// On another scalar.
  template <class S>
  HeldSpin<S> cast() const {
    return {{this->first.template cast<S>(), this->second.template cast<S>()}, motion.template cast<S>()};
  }
  /// Fills the rows from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const Time& t, SpatialRow<T>* row) const {
    detail::fill_prescribed_turn(*this, motion, body_i, body_j, t, row[0]);
    const TurningVector<T> axis_j = turning_vector(body_j, this->second.axis);
    fill_perpendicular(body_i, turning_vector(body_i, this->first.across), body_j, axis_j, row[1]);
    fill_perpendicular(body_i, turning_vector(body_i, this->first.third()), body_j, axis_j, row[2]);
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
    const DrivenMotion<Time> f = motion.at(t);
    row[0].value = T(row[0].value - f.value);
    row[0].time_rate = T(-f.rate);
    row[0].gamma = T(row[0].gamma + f.acceleration);
  }
};

}  // namespace lubjoint

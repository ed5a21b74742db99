/// Ideal joints between two bodies in space. Each says its rows, its bodies, and fills its rows from their frames.
#pragma once

#include "lubjoint/multibody/spatial/constraint_row.hpp"

namespace lubjoint {

namespace detail {

/// What all joints have that hold axes of two bodies.
template <class R>
struct BetweenAxes {
  BodyAxes<R> first;   ///< fixed to body i
  BodyAxes<R> second;  ///< fixed to body j

  std::size_t first_body() const { return first.body; }    ///< i
  std::size_t second_body() const { return second.body; }  ///< j
  /// Where the reaction on body j is reported, in its frame.
  const Vector3<R>& second_point() const { return second.point; }
  /// Calls visit(body, point) for each point that it fixes to a body or the ground.
  template <class Visit>
  void visit_points(const Visit& visit) const {
    visit(first.body, first.point);
    visit(second.body, second.point);
  }
};

/// What all joints have that hold points of two bodies.
template <class R>
struct BetweenPoints {
  SpatialBodyPoint<R> first;   ///< P_i
  SpatialBodyPoint<R> second;  ///< P_j

  std::size_t first_body() const { return first.body; }    ///< i
  std::size_t second_body() const { return second.body; }  ///< j
  /// Where the reaction on body j is reported, in its frame.
  const Vector3<R>& second_point() const { return second.point; }
  /// Calls visit(body, point) for each point that it fixes to a body or the ground.
  template <class Visit>
  void visit_points(const Visit& visit) const {
    visit(first.body, first.point);
    visit(second.body, second.point);
  }
};

/// t₁i·n_j, t₂i·n_j, t₁i·d, t₂i·d. @returns t₁i
template <class R, class T>
TurningVector<T> fill_cylindrical(const BetweenAxes<R>& joint, const SpatialFrame<T>& body_i,
                                  const SpatialFrame<T>& body_j, SpatialRow<T>* row) {
  const PointPair<T> pair = point_pair(body_i, joint.first.point, body_j, joint.second.point);
  const TurningVector<T> axis_j = turning_vector(body_j, joint.second.axis);
  const TurningVector<T> across_i = turning_vector(body_i, joint.first.across);
  const TurningVector<T> third_i = turning_vector(body_i, joint.first.third());
  fill_perpendicular(body_i, across_i, body_j, axis_j, row[0]);
  fill_perpendicular(body_i, third_i, body_j, axis_j, row[1]);
  fill_across(body_i, across_i, body_j, pair, row[2]);
  fill_across(body_i, third_i, body_j, pair, row[3]);
  return across_i;
}

}  // namespace detail

/// Body j held to body i as a whole: both frames of axes coincide.
///   P_j = P_i,  t₁i·t₂j = t₂i·n_j = n_i·t₁j = 0
template <class R>
struct FixedJoint : detail::BetweenAxes<R> {
  static constexpr std::size_t rows = 6;  ///< scalar equations
  /// Is Φ of a row a length, and not the cosine of two vectors?
  static constexpr bool is_length(std::size_t row) { return row < 3; }

  /// On another scalar.
  template <class S>
  FixedJoint<S> cast() const {
    return {{this->first.template cast<S>(), this->second.template cast<S>()}};
  }
  /// Fills the rows from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const Time&, SpatialRow<T>* row) const {
    fill_spherical(body_i, body_j, point_pair(body_i, this->first.point, body_j, this->second.point), row);
    const TurningVector<T> across_j = turning_vector(body_j, this->second.across);
    const TurningVector<T> third_j = turning_vector(body_j, this->second.third());
    const TurningVector<T> axis_j = turning_vector(body_j, this->second.axis);
    fill_perpendicular(body_i, turning_vector(body_i, this->first.across), body_j, third_j, row[3]);
    fill_perpendicular(body_i, turning_vector(body_i, this->first.third()), body_j, axis_j, row[4]);
    fill_perpendicular(body_i, turning_vector(body_i, this->first.axis), body_j, across_j, row[5]);
  }
};

/// A ball joint: P_j = P_i.
template <class R>
struct SphericalJoint : detail::BetweenPoints<R> {
  static constexpr std::size_t rows = 3;  ///< scalar equations
  /// Is Φ of a row a length, and not the cosine of two vectors?
  static constexpr bool is_length(std::size_t) { return true; }

  /// On another scalar.
  template <class S>
  SphericalJoint<S> cast() const {
    return {{this->first.template cast<S>(), this->second.template cast<S>()}};
  }
  /// Fills the rows from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const Time&, SpatialRow<T>* row) const {
    fill_spherical(body_i, body_j, point_pair(body_i, this->first.point, body_j, this->second.point), row);
  }
};

/// A cross joint (Hooke, Cardan): P_j = P_i, n_i·n_j = 0, each axis fixed to its own body.
template <class R>
struct UniversalJoint : detail::BetweenAxes<R> {
  static constexpr std::size_t rows = 4;  ///< scalar equations
  /// Is Φ of a row a length, and not the cosine of two vectors?
  static constexpr bool is_length(std::size_t row) { return row < 3; }

  /// On another scalar.
  template <class S>
  UniversalJoint<S> cast() const {
    return {{this->first.template cast<S>(), this->second.template cast<S>()}};
  }
  /// Fills the rows from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const Time&, SpatialRow<T>* row) const {
    fill_spherical(body_i, body_j, point_pair(body_i, this->first.point, body_j, this->second.point), row);
    fill_perpendicular(body_i, turning_vector(body_i, this->first.axis), body_j,
                       turning_vector(body_j, this->second.axis), row[3]);
  }
};

/// A pin: P_j = P_i, t₁i·n_j = t₂i·n_j = 0.
template <class R>
struct RevoluteJoint : detail::BetweenAxes<R> {
  static constexpr std::size_t rows = 5;  ///< scalar equations
  /// Is Φ of a row a length, and not the cosine of two vectors?
  static constexpr bool is_length(std::size_t row) { return row < 3; }

  /// On another scalar.
  template <class S>
  RevoluteJoint<S> cast() const {
    return {{this->first.template cast<S>(), this->second.template cast<S>()}};
  }
  /// Fills the rows from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const Time&, SpatialRow<T>* row) const {
    fill_spherical(body_i, body_j, point_pair(body_i, this->first.point, body_j, this->second.point), row);
    const TurningVector<T> axis_j = turning_vector(body_j, this->second.axis);
    fill_perpendicular(body_i, turning_vector(body_i, this->first.across), body_j, axis_j, row[3]);
    fill_perpendicular(body_i, turning_vector(body_i, this->first.third()), body_j, axis_j, row[4]);
  }
};

/// A pin that may slide along its axis: t₁i·n_j = t₂i·n_j = 0, t₁i·d = t₂i·d = 0.
template <class R>
struct CylindricalJoint : detail::BetweenAxes<R> {
  static constexpr std::size_t rows = 4;  ///< scalar equations
  /// Is Φ of a row a length, and not the cosine of two vectors?
  static constexpr bool is_length(std::size_t row) { return row >= 2; }

  /// On another scalar.
  template <class S>
  CylindricalJoint<S> cast() const {
    return {{this->first.template cast<S>(), this->second.template cast<S>()}};
  }
  /// Fills the rows from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const Time&, SpatialRow<T>* row) const {
    detail::fill_cylindrical(*this, body_i, body_j, row);
  }
};

/// A slider: a cylindrical joint that keeps its angle, t₁i·t₂j = 0.
template <class R>
struct PrismaticJoint : detail::BetweenAxes<R> {
  static constexpr std::size_t rows = 5;  ///< scalar equations
  /// Is Φ of a row a length, and not the cosine of two vectors?
  static constexpr bool is_length(std::size_t row) { return row == 2 || row == 3; }

  /// On another scalar.
  template <class S>
  PrismaticJoint<S> cast() const {
    return {{this->first.template cast<S>(), this->second.template cast<S>()}};
  }
  /// Fills the rows from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const Time&, SpatialRow<T>* row) const {
    const TurningVector<T> across_i = detail::fill_cylindrical(*this, body_i, body_j, row);
    fill_perpendicular(body_i, across_i, body_j, turning_vector(body_j, this->second.third()), row[4]);
  }
};

/// Two faces that stay on each other: n_j along n_i, t₁i·n_j = t₂i·n_j = 0, and n_i·d = 0. What a film leaves free but
/// for its plane, the thrust faces and the length of a bearing hold.
template <class R>
struct PlanarJoint : detail::BetweenAxes<R> {
  static constexpr std::size_t rows = 3;  ///< scalar equations
  /// Is Φ of a row a length, and not the cosine of two vectors?
  static constexpr bool is_length(std::size_t row) { return row == 2; }

  /// On another scalar.
  template <class S>
  PlanarJoint<S> cast() const {
    return {{this->first.template cast<S>(), this->second.template cast<S>()}};
  }
  /// Fills the rows from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const Time&, SpatialRow<T>* row) const {
    const TurningVector<T> axis_j = turning_vector(body_j, this->second.axis);
    fill_perpendicular(body_i, turning_vector(body_i, this->first.across), body_j, axis_j, row[0]);
    fill_perpendicular(body_i, turning_vector(body_i, this->first.third()), body_j, axis_j, row[1]);
    fill_across(body_i, turning_vector(body_i, this->first.axis), body_j,
                point_pair(body_i, this->first.point, body_j, this->second.point), row[2]);
  }
};

/// A rod without mass between two points: |P_j − P_i| = l.
template <class R>
struct DistanceJoint : detail::BetweenPoints<R> {
  static constexpr std::size_t rows = 1;  ///< scalar equations
  R length;                               ///< l > 0 [m]
  /// Is Φ of a row a length, and not the cosine of two vectors?
  static constexpr bool is_length(std::size_t) { return true; }

  /// On another scalar.
  template <class S>
  DistanceJoint<S> cast() const {
    return {{this->first.template cast<S>(), this->second.template cast<S>()}, S(length)};
  }
  /// Fills the rows from the motions of its two bodies at time t.
  template <class T, class Time>
  void evaluate(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const Time&, SpatialRow<T>* row) const {
    fill_distance(body_i, body_j, point_pair(body_i, this->first.point, body_j, this->second.point), length, row[0]);
  }
};

}  // namespace lubjoint

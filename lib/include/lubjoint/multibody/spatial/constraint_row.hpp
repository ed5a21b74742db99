/// What the equations of motion need of one scalar constraint in space, and the blocks that joints are made of.
#pragma once

#include "lubjoint/multibody/spatial/body.hpp"

namespace lubjoint {

/// One row of Φ(q, t) = 0 between a first body i and a second body j. A column that belongs to the ground is ignored.
template <class T>
struct SpatialRow {
  T value;                  ///< Φ
  T time_rate;              ///< Φ_t
  T gamma;                  ///< γ: Φ̈ = columns · (r̈, ω̇′) − γ
  std::array<T, 6> first;   ///< columns of ṙ and ω′ of body i: Φ̇ = columns · (ṙ, ω′) + Φ_t
  std::array<T, 6> second;  ///< those of body j
};

/// A body-fixed vector a = A a′ with its rates, those of an angular velocity that stays as it is in the body.
template <class T>
struct TurningVector {
  Vector3<T> now;     ///< a
  Vector3<T> rate;    ///< ω × a
  Vector3<T> second;  ///< ω × (ω × a)
};

/// Of a frame and a′.
template <class T>
TurningVector<T> turning_vector(const SpatialFrame<T>& body, const Vector3<RealOf<T>>& body_fixed) {
  const Vector3<T> a = inertial_vector(body, body_fixed);
  const Vector3<T> rate = cross(body.spin, a);
  return {a, rate, cross(body.spin, rate)};
}

/// Distance of two points, each fixed to a body.
template <class T>
struct PointPair {
  TurningVector<T> first_arm;   ///< s_i
  TurningVector<T> second_arm;  ///< s_j
  Vector3<T> distance;          ///< d = P_j − P_i [m]
  Vector3<T> rate;              ///< ḋ [m/s]
  Vector3<T> second;            ///< d̈ without r̈ and ω̇ [m/s²]
};

/// Of two frames and two points.
template <class T>
PointPair<T> point_pair(const SpatialFrame<T>& body_i, const Vector3<RealOf<T>>& point_i, const SpatialFrame<T>& body_j,
                        const Vector3<RealOf<T>>& point_j) {
  const TurningVector<T> s_i = turning_vector(body_i, point_i);
  const TurningVector<T> s_j = turning_vector(body_j, point_j);
  // Positions first, arms second: neighbours subtract without loss.
  return {s_i, s_j, sum(difference(body_j.position, body_i.position), difference(s_j.now, s_i.now)),
          sum(difference(body_j.velocity, body_i.velocity), difference(s_j.rate, s_i.rate)),
          difference(s_j.second, s_i.second)};
}

namespace detail {

/// Columns of a form ṙ·force + ω·moment, as the force and the moment of a unit multiplier.
template <class T>
std::array<T, 6> columns(const SpatialFrame<T>& body, const Vector3<T>& force, const Vector3<T>& moment) {
  const Vector3<T> in_body = transposed_product(body.rotation, moment);
  return {force(0), force(1), force(2), in_body(0), in_body(1), in_body(2)};
}

}  // namespace detail

// The blocks. Each fills rows from frames and from what it is made of; derivatives act on (ṙ, ω′). The γ of each is
// proved in oracle/proofs.

/// P_j = P_i, three rows.
///   Φ = d,   Φ̇ = ṙ_j + ω_j × s_j − ṙ_i − ω_i × s_i,   γ = ω_i × (ω_i × s_i) − ω_j × (ω_j × s_j)
template <class T>
void fill_spherical(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const PointPair<T>& pair,
                    SpatialRow<T>* row) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    Vector3<T> unit = zero_vector<T>();
    unit(k) = T(1);
    row[k] = {pair.distance(k), T(0), T(-pair.second(k)),
              detail::columns(body_i, negative(unit), cross(unit, pair.first_arm.now)),
              detail::columns(body_j, unit, cross(pair.second_arm.now, unit))};
  }
}

/// Perpendicular₁: a of body i and b of body j.
///   Φ = a·b,   Φ̇ = (ω_i − ω_j)·(a × b),
///   γ = −(ω_i × (ω_i × a))·b − 2(ω_i × a)·(ω_j × b) − a·(ω_j × (ω_j × b))
template <class T>
void fill_perpendicular(const SpatialFrame<T>& body_i, const TurningVector<T>& a, const SpatialFrame<T>& body_j,
                        const TurningVector<T>& b, SpatialRow<T>& row) {
  const Vector3<T> normal = cross(a.now, b.now);
  const Vector3<T> none = zero_vector<T>();
  row = {dot(a.now, b.now), T(0), T(-(dot(a.second, b.now) + 2 * dot(a.rate, b.rate) + dot(a.now, b.second))),
         detail::columns(body_i, none, normal), detail::columns(body_j, none, negative(normal))};
}

/// Perpendicular₂: a of body i and d = P_j − P_i.
///   Φ = a·d,   Φ̇ = a·ḋ + (ω_i × a)·d,
///   γ = −(ω_i × (ω_i × a))·d − 2(ω_i × a)·ḋ − a·(ω_j × (ω_j × s_j) − ω_i × (ω_i × s_i))
template <class T>
void fill_across(const SpatialFrame<T>& body_i, const TurningVector<T>& a, const SpatialFrame<T>& body_j,
                 const PointPair<T>& pair, SpatialRow<T>& row) {
  row = {dot(a.now, pair.distance), T(0),
         T(-(dot(a.second, pair.distance) + 2 * dot(a.rate, pair.rate) + dot(a.now, pair.second))),
         detail::columns(body_i, negative(a.now), cross(a.now, sum(pair.distance, pair.first_arm.now))),
         detail::columns(body_j, a.now, cross(pair.second_arm.now, a.now))};
}

/// |d| = l, as Φ = (d·d − l²)/(2l), whose rate is that of |d| where it holds.
///   Φ̇ = d·ḋ/l,   γ = −(ḋ·ḋ + d·(ω_j × (ω_j × s_j) − ω_i × (ω_i × s_i)))/l;  the multiplier is the force between the
/// points, positive where they pull each other
template <class T>
void fill_distance(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const PointPair<T>& pair,
                   const RealOf<T>& length, SpatialRow<T>& row) {
  const Vector3<T> along = scaled(T(1 / length), pair.distance);
  row = {T((dot(pair.distance, along) - length) / 2), T(0),
         T(-(dot(pair.rate, pair.rate) / length + dot(along, pair.second))),
         detail::columns(body_i, negative(along), cross(along, pair.first_arm.now)),
         detail::columns(body_j, along, cross(pair.second_arm.now, along))};
}

}  // namespace lubjoint

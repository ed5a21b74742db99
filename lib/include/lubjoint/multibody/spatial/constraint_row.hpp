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

  /// On another scalar, as constants.
  template <class S>
  SpatialRow<S> cast() const {
    SpatialRow<S> row{S(value), S(time_rate), S(gamma), {}, {}};
    std::copy(first.begin(), first.end(), row.first.begin());
    std::copy(second.begin(), second.end(), row.second.begin());
    return row;
  }
};

/// A body-fixed vector a = A a′ with its rates, those of an angular velocity that stays as it is in the body.
template <class T>
struct TurningVector {
  Vector3<RealOf<T>> fixed;  ///< a′
  Vector3<T> now;            ///< a
  Vector3<T> rate;           ///< ω × a
  Vector3<T> second;         ///< ω × (ω × a)
};

/// Of a frame and a′.
template <class T>
TurningVector<T> turning_vector(const SpatialFrame<T>& body, const Vector3<RealOf<T>>& body_fixed) {
  if (!body.moves) return {body_fixed, body_fixed.template cast<T>(), zero_vector<T>(), zero_vector<T>()};
  const Vector3<T> a = inertial_vector(body, body_fixed);
  const Vector3<T> rate = cross(body.spin, a);
  return {body_fixed, a, rate, cross(body.spin, rate)};
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

/// a′ × b of a vector without derivatives.
template <class T>
Vector3<T> fixed_cross(const Vector3<RealOf<T>>& a, const Vector3<T>& b) {
  return Vector3<T>(T(a(1) * b(2) - a(2) * b(1)), T(a(2) * b(0) - a(0) * b(2)), T(a(0) * b(1) - a(1) * b(0)));
}

/// Aᵀ v
template <class T>
Vector3<T> in_body(const SpatialFrame<T>& body, const Vector3<T>& v) {
  return body.moves ? transposed_product(body.rotation, v) : v;
}

/// Are a body's columns asked for? Those of the ground are for its reaction alone, which has no derivatives.
template <class T>
bool has_columns(const SpatialFrame<T>& body) {
  return !ScalarTraits<T>::carries_derivatives || body.moves;
}

/// Columns of a form ṙ·force + ω′·moment, as the force of a unit multiplier and its moment in the body.
template <class T>
std::array<T, 6> columns(const Vector3<T>& force, const Vector3<T>& moment) {
  return {force(0), force(1), force(2), moment(0), moment(1), moment(2)};
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
    row[k].value = pair.distance(k);
    row[k].time_rate = T(0);
    row[k].gamma = T(-pair.second(k));
    const auto fill = [k](std::array<T, 6>& columns, const SpatialFrame<T>& body, const TurningVector<T>& arm,
                          int sign) {
      if (!detail::has_columns(body)) return;
      for (std::size_t i = 0; i < 3; ++i) columns[i] = T(i == static_cast<std::size_t>(k) ? sign : 0);
      // Aᵀ (s × e_k) = s′ × Aᵀe_k
      const Vector3<T> unit = body.rotation.row(k).transpose();
      const Vector3<T> moment =
          sign > 0 ? detail::fixed_cross(arm.fixed, unit) : detail::fixed_cross<T>(-arm.fixed, unit);
      for (std::size_t i = 0; i < 3; ++i) columns[3 + i] = moment(static_cast<Eigen::Index>(i));
    };
    fill(row[k].first, body_i, pair.first_arm, -1);
    fill(row[k].second, body_j, pair.second_arm, 1);
  }
}

/// Perpendicular₁: a of body i and b of body j.
///   Φ = a·b,   Φ̇ = (ω_i − ω_j)·(a × b),
///   γ = −(ω_i × (ω_i × a))·b − 2(ω_i × a)·(ω_j × b) − a·(ω_j × (ω_j × b))
template <class T>
void fill_perpendicular(const SpatialFrame<T>& body_i, const TurningVector<T>& a, const SpatialFrame<T>& body_j,
                        const TurningVector<T>& b, SpatialRow<T>& row) {
  row.value = dot(a.now, b.now);
  row.time_rate = T(0);
  if (!body_i.moves) {
    row.gamma = T(-dot(a.now, b.second));
  } else if (!body_j.moves) {
    row.gamma = T(-dot(a.second, b.now));
  } else {
    row.gamma = T(-(dot(a.second, b.now) + 2 * dot(a.rate, b.rate) + dot(a.now, b.second)));
  }
  // Aᵀ (a × b) = a′ × Aᵀb
  const Vector3<T> none = zero_vector<T>();
  if (detail::has_columns(body_i))
    row.first = detail::columns(none, detail::fixed_cross(a.fixed, detail::in_body(body_i, b.now)));
  if (detail::has_columns(body_j))
    row.second = detail::columns(none, detail::fixed_cross(b.fixed, detail::in_body(body_j, a.now)));
}

/// Perpendicular₂: a of body i and d = P_j − P_i.
///   Φ = a·d,   Φ̇ = a·ḋ + (ω_i × a)·d,
///   γ = −(ω_i × (ω_i × a))·d − 2(ω_i × a)·ḋ − a·(ω_j × (ω_j × s_j) − ω_i × (ω_i × s_i))
template <class T>
void fill_across(const SpatialFrame<T>& body_i, const TurningVector<T>& a, const SpatialFrame<T>& body_j,
                 const PointPair<T>& pair, SpatialRow<T>& row) {
  row.value = dot(a.now, pair.distance);
  row.time_rate = T(0);
  if (body_i.moves) {
    row.gamma = T(-(dot(a.second, pair.distance) + 2 * dot(a.rate, pair.rate) + dot(a.now, pair.second)));
  } else {
    row.gamma = T(-dot(a.now, pair.second));
  }
  if (detail::has_columns(body_i)) {
    const Vector3<T> arm = detail::in_body(body_i, sum(pair.distance, pair.first_arm.now));
    row.first = detail::columns(negative(a.now), detail::fixed_cross(a.fixed, arm));
  }
  if (detail::has_columns(body_j))
    row.second = detail::columns(a.now, detail::fixed_cross(pair.second_arm.fixed, detail::in_body(body_j, a.now)));
}

/// |d| = l, as Φ = (d·d − l²)/(2l), whose rate is that of |d| where it holds.
///   Φ̇ = d·ḋ/l,   γ = −(ḋ·ḋ + d·(ω_j × (ω_j × s_j) − ω_i × (ω_i × s_i)))/l;  the multiplier is the force between the
/// points, positive where they pull each other
template <class T>
void fill_distance(const SpatialFrame<T>& body_i, const SpatialFrame<T>& body_j, const PointPair<T>& pair,
                   const RealOf<T>& length, SpatialRow<T>& row) {
  const Vector3<T> along = scaled(T(1 / length), pair.distance);
  row.value = T((dot(pair.distance, along) - length) / 2);
  row.time_rate = T(0);
  row.gamma = T(-(dot(pair.rate, pair.rate) / length + dot(along, pair.second)));
  if (detail::has_columns(body_i)) {
    const Vector3<T> pull = negative(along);
    row.first = detail::columns(pull, detail::fixed_cross(pair.first_arm.fixed, detail::in_body(body_i, pull)));
  }
  if (detail::has_columns(body_j))
    row.second = detail::columns(along, detail::fixed_cross(pair.second_arm.fixed, detail::in_body(body_j, along)));
}

}  // namespace lubjoint

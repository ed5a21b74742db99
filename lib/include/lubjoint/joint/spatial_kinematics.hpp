/// Where a journal is in its bearing, from the motions of two bodies in space.
#pragma once

#include <cmath>
#include <stdexcept>

#include "lubjoint/film/film_state.hpp"
#include "lubjoint/joint/spatial_motion.hpp"

namespace lubjoint {

/// A journal that lies across its bearing: its axis does not pierce the film's middle plane.
class JournalAcross : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// |cos ψ| below which a journal counts as lying across its bearing.
inline constexpr double least_tilt_cosine = 1e-3;

/// Axes of a bearing, or of a journal, fixed to a body: a right-handed frame at a point.
template <class R>
struct AxisFrame {
  Vector3<R> point;   ///< centre, from the body's mass centre, in its frame [m]
  Vector3<R> axis;    ///< n′, a unit vector
  Vector3<R> across;  ///< t₁′, a unit vector normal to n′

  /// t₂′ = n′ × t₁′
  Vector3<R> third() const { return cross(axis, across); }

  /// On another scalar.
  template <class S>
  AxisFrame<S> cast() const {
    return {point.template cast<S>(), axis.template cast<S>(), across.template cast<S>()};
  }
};

/// A joint in space seen in the bearing's own frame.
template <class T>
struct SpatialJointKinematics {
  Vector3<T> axis;          ///< n, inertial
  Vector3<T> across;        ///< t₁
  Vector3<T> third;         ///< t₂ = n × t₁
  Vector3<T> journal_axis;  ///< n_J, inertial
  Vector3<T> bearing_arm;   ///< X − r_i, inertial [m]
  Vector3<T> journal_arm;   ///< X − r_j, inertial [m]
  T axes_cosine;            ///< n·n_J
  T sliding;                ///< σ [m]
  T sliding_rate;           ///< σ̇ [m/s]
  /// e and v_B by t₁ and t₂; in this frame the bearing does not turn, and the journal's spin is ω.
  JournalMotion<T> motion;

  /// A vector of the film's middle plane, inertial.
  Vector3<T> in_space(const Vector2<T>& in_plane) const {
    return Vector3<T>(T(in_plane.x() * across(0) + in_plane.y() * third(0)),
                      T(in_plane.x() * across(1) + in_plane.y() * third(1)),
                      T(in_plane.x() * across(2) + in_plane.y() * third(2)));
  }
  /// ψ, the smaller angle between n and ±n_J [rad]; exact also where it is small.
  RealOf<T> tilt() const {
    using std::abs;
    using std::atan2;
    using std::sqrt;
    using R = RealOf<T>;
    R squared(0);
    const Vector3<T> sine = cross(axis, journal_axis);
    for (Eigen::Index k = 0; k < 3; ++k) squared += value_of(sine(k)) * value_of(sine(k));
    return R(atan2(R(sqrt(squared)), R(abs(value_of(axes_cosine)))));
  }
};

/// Kinematics of a lubricated joint in space. The film's middle plane goes through P_i, normal to n; the journal's axis
/// pierces it at
///   X = P_j − σ n_J,  σ = n·d/(n·n_J),  d = P_j − P_i;   e = X − P_i.
/// With rates seen from the bearing, d° = Ṗ_j − Ṗ_i − ω_i × d and n_J° = (ω_j − ω_i) × n_J:
///   σ̇ = (n·d° − σ n·n_J°)/(n·n_J),   v_B = d° − σ n_J° − σ̇ n_J,   ω = n·(ω_j − ω_i).
/// Then u = (v_B − ½ ω n×e)/c is that of film_state.hpp, frame indifferent; e, v_B and u have no component along n.
/// The material points of journal and bearing at X move against each other by v_B + σ̇ n_J.
/// @throws JournalAcross  |n·n_J| below least_tilt_cosine
template <class T>
SpatialJointKinematics<T> spatial_joint_kinematics(const SpatialFrame<T>& bearing_body,
                                                   const AxisFrame<RealOf<T>>& bearing,
                                                   const SpatialFrame<T>& journal_body,
                                                   const AxisFrame<RealOf<T>>& journal) {
  using std::abs;
  const SpatialPoint<T> p_i = point_motion(bearing_body, bearing.point);
  const SpatialPoint<T> p_j = point_motion(journal_body, journal.point);
  SpatialJointKinematics<T> k;
  k.axis = inertial_vector(bearing_body, bearing.axis);
  k.across = inertial_vector(bearing_body, bearing.across);
  k.third = cross(k.axis, k.across);
  k.journal_axis = inertial_vector(journal_body, journal.axis);
  k.axes_cosine = dot(k.axis, k.journal_axis);
  if (!(abs(value_of(k.axes_cosine)) > RealOf<T>(least_tilt_cosine))) {
    throw JournalAcross("a journal lies across its bearing: its axis does not pierce the film's middle plane");
  }
  // Positions first, arms second: neighbours subtract without loss.
  const Vector3<T> d = sum(difference(journal_body.position, bearing_body.position), difference(p_j.arm, p_i.arm));
  const Vector3<T> relative_spin = difference(journal_body.spin, bearing_body.spin);
  const Vector3<T> d_rate =
      difference(sum(difference(journal_body.velocity, bearing_body.velocity), difference(p_j.turning, p_i.turning)),
                 cross(bearing_body.spin, d));
  const Vector3<T> axis_rate = cross(relative_spin, k.journal_axis);
  k.sliding = dot(k.axis, d) / k.axes_cosine;
  k.sliding_rate = (dot(k.axis, d_rate) - k.sliding * dot(k.axis, axis_rate)) / k.axes_cosine;
  const Vector3<T> slid = scaled(k.sliding, k.journal_axis);
  const Vector3<T> e = difference(d, slid);
  const Vector3<T> v = difference(d_rate, sum(scaled(k.sliding, axis_rate), scaled(k.sliding_rate, k.journal_axis)));
  k.bearing_arm = sum(p_i.arm, e);
  k.journal_arm = difference(p_j.arm, slid);
  k.motion = {Vector2<T>(dot(k.across, e), dot(k.third, e)), Vector2<T>(dot(k.across, v), dot(k.third, v)), T(0),
              dot(k.axis, relative_spin)};
  return k;
}

}  // namespace lubjoint

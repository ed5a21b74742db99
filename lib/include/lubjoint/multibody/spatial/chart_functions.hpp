/// Functions of places in space that stay small or regular over a long way: what charts of a mechanism are made of.
#pragma once

#include <array>

#include "lubjoint/multibody/spatial/constraint_row.hpp"

namespace lubjoint {

/// e of a journal in its bearing by t₁ and t₂, axes fixed to the bearing's body: two rows.
///   z_k = t_k·e.  With ρ_i = X − r_i and ρ_j = X − r_j, σ̇ and v_B of spatial_kinematics.hpp and
///   w_k = t_k − β_k n,  β_k = t_k·n_J/(n·n_J):  it is normal to n_J, so that what slides along the journal is not in
///   ż_k = w_k·u,  u = ṙ_j + ω_j × ρ_j − ṙ_i − ω_i × ρ_i;  columns: a force w_k at X on body j, and −w_k on body i;
///   γ_k = −ẇ_k·u − w_k·(ω_j × (ω_j × ρ_j − σ̇ n_J) − ω_i × (ω_i × ρ_i + v_B)),
///   ẇ_k = ω_i × w_k − β̇_k n,  β̇_k = w_k·((ω_j − ω_i) × n_J)/(n·n_J).
/// @param k  of the joint, from the same frames
template <class T>
void fill_eccentricity(const SpatialFrame<T>& bearing_body, const SpatialFrame<T>& journal_body,
                       const SpatialJointKinematics<T>& k, std::array<SpatialRow<T>, 2>& rows) {
  const Vector3<T>& arm_i = k.bearing_arm;
  const Vector3<T>& arm_j = k.journal_arm;
  const Vector3<T> v = k.in_space(k.motion.velocity);
  const Vector3<T> slid = scaled(k.sliding_rate, k.journal_axis);
  const Vector3<T> u = sum(v, slid);
  const Vector3<T> relative = difference(journal_body.spin, bearing_body.spin);
  const Vector3<T> axis_rate = cross(relative, k.journal_axis);
  const Vector3<T> second = difference(cross(journal_body.spin, difference(cross(journal_body.spin, arm_j), slid)),
                                       cross(bearing_body.spin, sum(cross(bearing_body.spin, arm_i), v)));
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector3<T>& t = i == 0 ? k.across : k.third;
    const Vector3<T> w = difference(t, scaled(T(dot(t, k.journal_axis) / k.axes_cosine), k.axis));
    const T lean_rate = T(dot(w, axis_rate) / k.axes_cosine);
    const Vector3<T> w_rate = difference(cross(bearing_body.spin, w), scaled(lean_rate, k.axis));
    rows[i].value = i == 0 ? k.motion.eccentricity.x() : k.motion.eccentricity.y();
    rows[i].time_rate = T(0);
    rows[i].gamma = T(-(dot(w_rate, u) + dot(w, second)));
    if (detail::has_columns(bearing_body))
      rows[i].first = detail::columns(negative(w), detail::in_body(bearing_body, cross(w, arm_i)));
    if (detail::has_columns(journal_body))
      rows[i].second = detail::columns(w, detail::in_body(journal_body, cross(arm_j, w)));
  }
}

namespace detail {

/// q = p₀⁻¹ p, the turn since p₀ in the body's frame.
template <class T>
EulerParameters<T> turn_since(const EulerParameters<RealOf<T>>& from, const EulerParameters<T>& p) {
  return EulerParameters<T>(T(from(0) * p(0) + from(1) * p(1) + from(2) * p(2) + from(3) * p(3)),
                            T(from(0) * p(1) - from(1) * p(0) - from(2) * p(3) + from(3) * p(2)),
                            T(from(0) * p(2) - from(2) * p(0) - from(3) * p(1) + from(1) * p(3)),
                            T(from(0) * p(3) - from(3) * p(0) - from(1) * p(2) + from(2) * p(1)));
}

}  // namespace detail

/// The turn of a body about an axis a fixed to it, since an orientation p₀. With q = (q₀, 𝐪) = p₀⁻¹p, q_a = a·𝐪 and
/// ρ² = q₀² + q_a²:
///   z = 2 atan2(q_a, q₀),   ż = c·ω′,   c = (q₀² a + q₀ a × 𝐪 + q_a 𝐪)/ρ²,   γ = −ċ·ω′.
/// c = a while the body turns about a alone, however far; the function ends where a has come to point against where it
/// was at p₀. z is of any revolution.
/// @param axis  a, a unit vector in the body's frame;  @param from  p₀
template <class T>
void fill_turn(const SpatialFrame<T>& body, const Vector3<RealOf<T>>& axis, const EulerParameters<RealOf<T>>& from,
               SpatialRow<T>& row) {
  const EulerParameters<T> q = detail::turn_since(from, body.parameters);
  const EulerParameters<T> q_rate = euler_rate(q, body.body_spin);
  const auto vector = [](const EulerParameters<T>& of) { return Vector3<T>(of(1), of(2), of(3)); };
  const auto along = [&](const EulerParameters<T>& of) {
    return T(axis(0) * of(1) + axis(1) * of(2) + axis(2) * of(3));
  };
  const Vector3<T> a = axis.template cast<T>();
  const T q_a = along(q);
  const T q_a_rate = along(q_rate);
  const T square = q(0) * q(0) + q_a * q_a;
  const Vector3<T> beside = detail::fixed_cross(axis, vector(q));
  const Vector3<T> c =
      scaled(T(1 / square), sum(scaled(T(q(0) * q(0)), a), sum(scaled(T(q(0)), beside), scaled(q_a, vector(q)))));
  const Vector3<T> of_numerator =
      sum(sum(scaled(T(2 * q(0) * q_rate(0)), a), scaled(T(q_rate(0)), beside)),
          sum(sum(scaled(T(q(0)), detail::fixed_cross(axis, vector(q_rate))), scaled(q_a_rate, vector(q))),
              scaled(q_a, vector(q_rate))));
  const T square_rate = 2 * (q(0) * q_rate(0) + q_a * q_a_rate);
  row.value = T(2 * polar_angle(q_a, T(q(0))));
  row.time_rate = T(0);
  row.gamma = T((square_rate * dot(c, body.body_spin) - dot(of_numerator, body.body_spin)) / square);
  row.first = detail::columns(zero_vector<T>(), c);
}

}  // namespace lubjoint

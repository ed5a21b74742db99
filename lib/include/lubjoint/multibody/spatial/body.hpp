/// Rigid bodies in space, and what a constraint or a joint may be fixed to.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lubjoint/joint/spatial_kinematics.hpp"
#include "lubjoint/multibody/planar_body.hpp"

namespace lubjoint {

/// Coordinates of a body: r of its mass centre and its Euler parameters p.
inline constexpr std::size_t spatial_coordinates = 7;
/// Its velocities: ṙ and ω′.
inline constexpr std::size_t spatial_velocities = 6;
/// Both: the states of a body.
inline constexpr std::size_t spatial_states = spatial_coordinates + spatial_velocities;

namespace detail {

/// Principal moments of a symmetric 3×3 matrix in rising order, by Jacobi's turns: right to rounding of the largest.
template <class R>
Vector3<R> principal_moments(Matrix3<R> j) {
  using std::abs;
  using std::sqrt;
  for (int sweep = 0; sweep < 60; ++sweep) {
    const R off = abs(j(0, 1)) + abs(j(0, 2)) + abs(j(1, 2));
    if (!(off > 0)) break;
    for (const auto& [p, q] : {std::pair<Eigen::Index, Eigen::Index>(0, 1), {0, 2}, {1, 2}}) {
      if (j(p, q) == 0) continue;
      const R theta = (j(q, q) - j(p, p)) / (2 * j(p, q));
      const R t = (theta < 0 ? R(-1) : R(1)) / R(abs(theta) + sqrt(R(theta * theta + 1)));
      const R c = 1 / sqrt(R(t * t + 1));
      const R s = t * c;
      Matrix3<R> turn = Matrix3<R>::Identity();
      turn(p, p) = turn(q, q) = c;
      turn(p, q) = s;
      turn(q, p) = -s;
      j = (turn.transpose() * j * turn).eval();
      j(p, q) = j(q, p) = R(0);
    }
  }
  Vector3<R> moments = j.diagonal();
  std::sort(moments.data(), moments.data() + 3);
  return moments;
}

}  // namespace detail

/// Inertia of a rigid body in space and the constant loads on it.
template <class R>
struct SpatialBody {
  R mass;              ///< m [kg]
  Matrix3<R> inertia;  ///< J′ about the mass centre, in the body's frame [kg m²]
  Vector3<R> load;     ///< constant force through the mass centre, inertial, without the weight [N]
  Vector3<R> moment;   ///< constant moment, inertial [N m]

  /// @throws std::invalid_argument  a mass that is not positive and finite; a J′ that is not symmetric, not positive
  ///   definite, or whose largest principal moment exceeds the sum of the others: no distribution of mass has it
  SpatialBody(const R& body_mass, const Matrix3<R>& body_inertia, const Vector3<R>& constant_load = zero_vector<R>(),
              const Vector3<R>& constant_moment = zero_vector<R>())
      : mass(body_mass), inertia(body_inertia), load(constant_load), moment(constant_moment) {
    detail::require_positive("mass", mass, "kg");
    require_inertia();
  }

  /// J′⁻¹, symmetric.
  Matrix3<R> inverse_inertia() const {
    const Matrix3<R>& j = inertia;
    Matrix3<R> inverse;
    inverse(0, 0) = j(1, 1) * j(2, 2) - j(1, 2) * j(1, 2);
    inverse(1, 1) = j(0, 0) * j(2, 2) - j(0, 2) * j(0, 2);
    inverse(2, 2) = j(0, 0) * j(1, 1) - j(0, 1) * j(0, 1);
    inverse(0, 1) = inverse(1, 0) = j(0, 2) * j(1, 2) - j(0, 1) * j(2, 2);
    inverse(0, 2) = inverse(2, 0) = j(0, 1) * j(1, 2) - j(0, 2) * j(1, 1);
    inverse(1, 2) = inverse(2, 1) = j(0, 1) * j(0, 2) - j(0, 0) * j(1, 2);
    const R determinant = j(0, 0) * inverse(0, 0) + j(0, 1) * inverse(0, 1) + j(0, 2) * inverse(0, 2);
    return inverse / determinant;
  }

 private:
  void require_inertia() const {
    using std::isfinite;
    const auto refuse = [](const auto& given, const char* allowed) {
      std::ostringstream message;
      message.precision(17);
      message << "inertia ";
      given(message);
      message << "; allowed is " << allowed;
      throw std::invalid_argument(message.str());
    };
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        if (!isfinite(inertia(i, k)))
          refuse([](auto& m) { m << "has a component that is not finite"; }, "finite numbers [kg m^2]");
        if (inertia(i, k) != inertia(k, i)) {
          refuse([&](auto& m) { m << "is not symmetric: " << inertia(i, k) << " and " << inertia(k, i) << " kg m^2"; },
                 "a symmetric matrix");
        }
      }
    }
    const Vector3<R> moments = detail::principal_moments<R>(inertia);
    const auto shown = [&](auto& m) {
      m << "has the principal moments " << moments(0) << ", " << moments(1) << ", " << moments(2) << " kg m^2";
    };
    const R rounding = 16 * std::numeric_limits<R>::epsilon() * moments(2);
    if (!(moments(0) > rounding)) refuse(shown, "a positive definite matrix");
    if (moments(2) > moments(0) + moments(1) + rounding) {
      refuse(shown, "none that exceeds the sum of the other two: no distribution of mass has it");
    }
  }
};

/// A point fixed to a body, from its mass centre; or to the ground, inertial.
template <class R>
struct SpatialBodyPoint {
  std::size_t body = ground_body;      ///< its number, or ground_body
  Vector3<R> point{R(0), R(0), R(0)};  ///< [m]

  bool on_ground() const { return body == ground_body; }  ///< is it inertial?

  /// On another scalar.
  template <class S>
  SpatialBodyPoint<S> cast() const {
    return {body, point.template cast<S>()};
  }
};

/// Axes fixed to a body, or to the ground.
template <class R>
struct BodyAxes : AxisFrame<R> {
  std::size_t body = ground_body;  ///< its number, or ground_body

  /// On another scalar.
  template <class S>
  BodyAxes<S> cast() const {
    return {AxisFrame<R>::template cast<S>(), body};
  }
};

/// Motion of a body in a state of a system, or of the ground.
/// @param y  (r, p) of all bodies, then (ṙ, ω′) of all; what follows is not looked at
/// @param bodies  how many there are
template <class T>
SpatialMotion<T> spatial_motion_in(const T* y, std::size_t bodies, std::size_t body) {
  if (body == ground_body) return spatial_ground_motion<T>();
  const T* q = y + spatial_coordinates * body;
  const T* v = y + spatial_coordinates * bodies + spatial_velocities * body;
  return {Vector3<T>(q[0], q[1], q[2]), EulerParameters<T>(q[3], q[4], q[5], q[6]), Vector3<T>(v[0], v[1], v[2]),
          Vector3<T>(v[3], v[4], v[5])};
}

}  // namespace lubjoint

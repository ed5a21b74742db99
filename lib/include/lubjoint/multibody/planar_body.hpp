/// Rigid bodies in the plane, and what a constraint or a joint may be fixed to.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "lubjoint/film/bearing.hpp"
#include "lubjoint/joint/planar_motion.hpp"

namespace lubjoint {

/// Coordinates of a body: x, y of its mass centre and its angle φ.
inline constexpr std::size_t planar_coordinates = 3;

/// The ground, where the number of a body is asked for. It is no body of the system.
inline constexpr std::size_t ground_body = std::numeric_limits<std::size_t>::max();

/// Inertia of a rigid body and the constant loads on it.
template <class R>
struct PlanarBody {
  R mass;           ///< m [kg]
  R inertia;        ///< about the mass centre [kg m²]
  Vector2<R> load;  ///< constant force through the mass centre, without the weight [N]
  R moment;         ///< constant moment [N m]

  /// @throws std::invalid_argument  mass or inertia not positive and finite
  PlanarBody(const R& body_mass, const R& body_inertia, const Vector2<R>& constant_load,
             const R& constant_moment = R(0))
      : mass(body_mass), inertia(body_inertia), load(constant_load), moment(constant_moment) {
    detail::require_positive("mass", mass, "kg");
    detail::require_positive("inertia", inertia, "kg m^2");
  }

  /// Diagonal of the inverse mass matrix.
  std::array<R, planar_coordinates> inverse_mass() const { return {1 / mass, 1 / mass, 1 / inertia}; }
};

/// A point fixed to a body, from its mass centre; or to the ground, inertial.
template <class R>
struct BodyPoint {
  std::size_t body = ground_body;  ///< its number, or ground_body
  Vector2<R> point{R(0), R(0)};    ///< [m]

  bool on_ground() const { return body == ground_body; }  ///< is it inertial?

  /// On another scalar.
  template <class S>
  BodyPoint<S> cast() const {
    return {body, point.template cast<S>()};
  }
};

/// Motion of a body in a state (q, q̇) of a system, or of the ground.
/// @param y  q of all bodies, then q̇ of all
template <class R>
PlanarMotion<R> motion_in(const std::vector<R>& y, std::size_t body) {
  if (body == ground_body) return ground_motion<R>();
  const R* q = y.data() + planar_coordinates * body;
  const R* v = q + y.size() / 2;
  return {Vector2<R>(q[0], q[1]), q[2], Vector2<R>(v[0], v[1]), v[2]};
}

}  // namespace lubjoint

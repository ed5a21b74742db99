/// Rigid bodies in the plane, and what a constraint or a joint may be fixed to.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

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
  std::size_t body;  ///< its number, or ground_body
  Vector2<R> point;  ///< [m]
};

}  // namespace lubjoint

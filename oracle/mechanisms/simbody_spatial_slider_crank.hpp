/// The film that Simbody is given of the spatial slider-crank: it shares the force law with the library, and nothing
/// else.
#pragma once

#include "lubjoint/film/pinkus_sternlicht.hpp"
#include "lubjoint/number/vector3.hpp"
#include "oracle/mechanisms/simbody_spatial_engine.hpp"

namespace lubjoint::mechanisms {

/// The law of Pinkus and Sternlicht in the bearing's middle plane, by ê = e/c and u = (v_B − ½ ω n × e)/c; it acts at
/// X.
inline SimbodyFilmLaw simbody_film(const Bearing<double>& bearing, const Lubricant<double>& oil) {
  return [bearing, oil](const SimbodyFilm& film) -> SimbodyFilmForce {
    const auto vector = [](const SimbodyVector& v) { return Vector3<double>(v[0], v[1], v[2]); };
    const Vector3<double> n = vector(film.axis);
    const Vector3<double> e = vector(film.eccentricity);
    const Vector3<double> u = vector(film.velocity) - film.spin / 2 * cross(n, e);
    // Any two axes of the plane will do.
    const Vector3<double> first = any_perpendicular(n);
    const Vector3<double> second = cross(n, first);
    const auto in_plane = [&](const Vector3<double>& v) {
      return Vector2<double>(Vector2<double>(v.dot(first), v.dot(second)) / bearing.clearance());
    };
    const Vector2<double> in_it =
        film_force<PinkusSternlicht>(bearing, oil, FilmState<double>(in_plane(e), in_plane(u)));
    const Vector3<double> force = in_it.x() * first + in_it.y() * second;
    return {{force.x(), force.y(), force.z()}, film.eccentricity};
  };
}

}  // namespace lubjoint::mechanisms

/// Pressures of the short and the long film in closed form, in balls.
#pragma once

#include "oracle/certified/film_laws.hpp"

namespace lubjoint::certified {

/// p c²/(3μ) of the short film before any cavitation: (L²/4 − z²)(a sinθ − 2b cosθ)/H³, eq. 3 [m²/s].
Ball short_pressure(const FilmBalls& film, double length, double theta, double z);

/// p/(6μ(R/c)²) of the long film with p(0) = 0 before any cavitation, eq. 5 without its division by ε [1/s]:
///   a sinθ (2 + ε cosθ)/(D H²) + b (1 − cosθ)(2 + ε + ε cosθ)/(H²(1+ε)²)
Ball long_pressure_eq5(const FilmBalls& film, double theta);

/// p/(6μ(R/c)²) of the long film with p = 0 at both ends [1/s]: a M01 + 2b M10 + C M00, the moments M from the film's
/// start to θ by Sommerfeld's angle, C from p = 0 at the film's end.
/// @param extent  half or dynamic;  @param theta  inside of the film
Ball long_pressure(Extent extent, const FilmBalls& film, double theta);

}  // namespace lubjoint::certified

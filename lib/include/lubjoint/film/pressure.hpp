/// Pressure fields of the short and the long bearing.
#pragma once

#include <cmath>

#include "lubjoint/film/bearing.hpp"
#include "lubjoint/film/film_state.hpp"

namespace lubjoint {

/// H = h/c = 1 + ε cosθ, without cancellation near the minimum film: (1 − ε) + 2ε cos²(θ/2), and 1 − ε = q/(1 + ε).
template <class T>
T relative_film_thickness(const PolarFilmState<T>& state, const T& theta) {
  using std::cos;
  const T half = cos(T(theta / 2));
  const T thinnest = state.q / (1 + state.eccentricity_ratio);
  return T(thinnest + 2 * state.eccentricity_ratio * half * half);
}

/// Pressure of the infinitely short bearing [Pa], |z| ≤ L/2, before any cavitation.
///   p = (3μ/(c²H³)) (L²/4 − z²)(a sinθ − 2b cosθ)
/// Source: Flores et al. (2009), eq. 3.
/// @param theta  from the maximum film, counter-clockwise [rad];  @param z  axial, from the middle [m]
template <class T>
T short_bearing_pressure(const Bearing<RealOf<T>>& bearing, const Lubricant<RealOf<T>>& oil,
                         const PolarFilmState<T>& state, const T& theta, const T& z) {
  using std::cos;
  using std::sin;
  const T h = relative_film_thickness(state, theta);
  const RealOf<T> half_length = bearing.length() / 2;
  const T axial = (half_length - z) * (half_length + z);
  const T source = state.slip_rate * sin(theta) - 2 * state.squeeze_rate * cos(theta);
  const RealOf<T> scale = 3 * oil.viscosity() / (bearing.clearance() * bearing.clearance());
  return T(scale * axial * source / (h * h * h));
}

/// Pressure of the infinitely long bearing [Pa] with p(0) = 0, before any cavitation.
///   p = 6μ(R/c)² [a sinθ (2 + ε cosθ)/(D H²) + b (1 − cosθ)(2 + ε + ε cosθ)/(H²(1+ε)²)]
/// Source: Flores et al. (2009), eq. 5, with its division by ε carried out.
template <class T>
T long_bearing_pressure(const Bearing<RealOf<T>>& bearing, const Lubricant<RealOf<T>>& oil,
                        const PolarFilmState<T>& state, const T& theta) {
  using std::cos;
  using std::sin;
  const T& epsilon = state.eccentricity_ratio;
  const T h = relative_film_thickness(state, theta);
  const T d = 2 + epsilon * epsilon;
  const T sin_half = sin(T(theta / 2));
  const T one_minus_cos = 2 * sin_half * sin_half;
  const T ec = epsilon * cos(theta);
  const T wedge = state.slip_rate * sin(theta) * (2 + ec) / d;
  const T widest = (1 + epsilon) * (1 + epsilon);
  const T squeeze = state.squeeze_rate * one_minus_cos * (2 + epsilon + ec) / widest;
  const RealOf<T> slenderness = bearing.radius() / bearing.clearance();
  const RealOf<T> scale = 6 * oil.viscosity() * slenderness * slenderness;
  return T(scale * (wedge + squeeze) / (h * h));
}

}  // namespace lubjoint

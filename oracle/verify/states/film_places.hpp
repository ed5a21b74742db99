/// Places over a film for sums in extended precision, near enough to each other where the film is thin.
#pragma once

#include <array>
#include <vector>

namespace lubjoint::verify {

/// One place θ of a film, with its weight in an integral over θ. Angles from the minimum film, φ = θ − π, so that
/// H = 1 − ε cosφ = (1 − ε) + 2ε sin²(φ/2) has no cancellation.
struct FilmPlace {
  long double weight;
  long double sine;       ///< sinθ
  long double cosine;     ///< cosθ
  long double wall;       ///< 1 + cosθ, small where the film is thin
  long double thickness;  ///< H = 1 + ε cosθ
};

/// Panels that double in length away from the minimum film, beginning at half of √(1 − ε), each with a Gauss–Legendre
/// rule of 20 points: the poles of the integrands, at √(2(1 − ε)/ε) beside the minimum film, are a panel's length away.
/// Accuracy: of an integral over a power of H, 1e-18 of the integral of its magnitude.
/// @param begin, end  θ of the film's ends, −π ≤ begin ≤ π, begin ≤ end ≤ 2π
std::vector<FilmPlace> film_places(long double ratio, long double gap, long double begin, long double end);

/// The integral of f(place) over a film.
template <class Integrand>
long double sum(const std::vector<FilmPlace>& film, const Integrand& f) {
  long double total = 0;
  for (const FilmPlace& at : film) total += at.weight * f(at);
  return total;
}

/// x³, the thickness's power in every one of these integrals.
inline long double cube(long double x) { return x * x * x; }

/// The thickness at θ.
long double film_thickness(long double ratio, long double gap, long double theta);

}  // namespace lubjoint::verify

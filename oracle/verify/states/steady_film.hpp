/// A journal that rests on its film under a load: where, and how the film's force changes about that place.
#pragma once

#include <array>

namespace lubjoint::verify {

/// F_r and F_t over S|ω| where a = ε, b = 0 (ω = 1 [1/s], the bearing at rest), and their slopes in ε, a and b.
struct SteadySlopes {
  long double radial = 0, tangential = 0;
  long double radial_by_ratio = 0, tangential_by_ratio = 0;  ///< a held
  long double radial_by_slip = 0, tangential_by_slip = 0;
  long double radial_by_squeeze = 0, tangential_by_squeeze = 0;

  long double size() const;           ///< √(F_r² + F_t²)
  long double size_by_ratio() const;  ///< its derivative along a = ε
};

/// ε with 1 − ε, which it can't say where the film is thin.
struct RestPlace {
  long double ratio = 0;
  long double gap = 1;
};

/// Row by row: of K or C, first index the force's direction.
using Entries = std::array<long double, 4>;

/// K c/(S|ω|) and C c/S in (r, t), of a spin with this sign: −F_r′, F_t/ε, −F_t′, −F_r/ε with ′ = d/dε along a = ε,
/// and −∂_bF_r, 2∂_aF_r, −∂_bF_t, 2∂_aF_t; for ω < 0 the picture is mirrored.
struct PolarCoefficients {
  Entries stiffness, damping;
};
PolarCoefficients polar_coefficients(const SteadySlopes& slopes, long double ratio, int spin_sign);

/// The same matrix in axes x, y with the load along −y: e = ε(± sin φ, −cos φ), φ the attitude angle.
/// @param sine, cosine  of the angle from −y to e, counter-clockwise
Entries in_inertial_axes(const Entries& polar, long double sine, long double cosine);

/// Where F_r² + F_t² is the square of what is wanted, a load over S|ω|; found by Newton's method in log(ε/(1 − ε)).
/// @param slopes  (ratio, gap) → SteadySlopes;  @param wanted  above 0;  @param start  log(ε/(1 − ε)) to begin at
/// @returns ratio NaN where none is found
template <class Slopes>
RestPlace place_under_load(const Slopes& slopes, long double wanted, long double start = 0);

}  // namespace lubjoint::verify

#include "oracle/verify/states/steady_film_place.hpp"

/// The two integrals that make the force of a film, each with what its rounding is relative to.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/reynolds/film_name.hpp"
#include "oracle/reynolds/film_rule.hpp"
#include "oracle/reynolds/narrow_gap.hpp"

namespace lubjoint::oracle {

/// Two components of one integral over the film.
struct FilmSums {
  std::array<double, 2> value{};
  std::array<double, 2> magnitude{};  ///< the same integral over the sums of magnitudes of its terms

  double norm() const { return std::hypot(value[0], value[1]); }
  double largest_magnitude() const { return std::max(magnitude[0], magnitude[1]); }
};

/// The same two components with their errors.
struct FilmPair {
  Estimate first;
  Estimate second;
};

/// The pressure where it is known in closed form, over its scale: 3μ(L²/4 − z²)/c² (short) or 6μ(R/c)² (long). With its
/// integrals of p cosθ and p sinθ over θ, F_r/S and F_t/S are factor() × integral. A full film is folded at the minimum
/// film: by symmetry only the part of p that is even there (the squeeze) has a radial force, and only the odd part (the
/// wedge) a tangential one.
class KnownPressure {
 public:
  KnownPressure(const NarrowGap& gap, const OneDimensionalFilmEntry& film)
      : gap_(gap), is_short_(film.limit() == BearingLimit::short_bearing), folded_(film.extent() == FilmExtent::full) {}

  /// The pressure at φ: parts with a and with b [1/s].
  struct Parts {
    double wedge;
    double squeeze;
  };
  Parts pressure(const GapPlace& place) const;

  /// Integrands of both components at φ.
  FilmSums terms(double phi) const;

  /// On a folded film the integrals are over one side and count twice.
  double factor() const { return (is_short_ ? 0.5 : 6.0) * (folded_ ? 2 : 1); }
  bool folded() const { return folded_; }

 private:
  NarrowGap gap_;
  bool is_short_;
  bool folded_;
};

/// Integrals of p cosθ and p sinθ by a rule.
FilmPair integrate_known_pressure(const KnownPressure& pressure, const NarrowGap& gap, const FilmWindow& window,
                                  const FilmRule& rule, double relative_tolerance);

/// ∫ p cosθ dθ and ∫ p sinθ dθ of the long film with p = 0 at both ends, p over 6μ(R/c)²: F_r/S is 6 × first and F_t/S
/// 6 × second. Two passes: means of X and Y with weight 1/H³, then −∫ (G − Ḡ)(X − X̄)/H³ and the same with Y
/// (pressure_slope.hpp), turned from the axes at φ₀ to the radial and tangential directions.
FilmPair integrate_pressure_slope(const NarrowGap& gap, const FilmWindow& window, bool edges_are_zeros,
                                  const FilmRule& rule, double relative_tolerance);

}  // namespace lubjoint::oracle

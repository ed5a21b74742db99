/// The force laws once more, in balls, polar and as published: nothing here comes from the library's laws.
#pragma once

#include <array>
#include <string_view>

#include "lubjoint/film/law_facts.hpp"
#include "oracle/certified/ball.hpp"

namespace lubjoint::certified {

enum class Law {
  short_full,
  short_half,
  short_dynamic,
  long_full,
  long_half,
  long_half_eq5,
  long_dynamic,
  pinkus_sternlicht,
  squeeze_long_full,
  squeeze_short_full,
  squeeze_long,
  squeeze_short
};

using Extent = FilmExtent;

struct LawEntry {
  Law law;
  std::string_view name;
  bool is_short;
  Extent extent;
  bool has_pressure;  ///< its force is the integral of a pressure field
  bool squeeze_only;  ///< it reads a as 0
};

/// With what the law of that name says of itself.
LawEntry law_entry(Law law, std::string_view name);

inline const std::array<LawEntry, 12> laws = {law_entry(Law::short_full, "short_full"),
                                              law_entry(Law::short_half, "short_half"),
                                              law_entry(Law::short_dynamic, "short_dynamic"),
                                              law_entry(Law::long_full, "long_full"),
                                              law_entry(Law::long_half, "long_half"),
                                              law_entry(Law::long_half_eq5, "long_half_eq5"),
                                              law_entry(Law::long_dynamic, "long_dynamic"),
                                              law_entry(Law::pinkus_sternlicht, "pinkus_sternlicht"),
                                              law_entry(Law::squeeze_long_full, "squeeze_long_full"),
                                              law_entry(Law::squeeze_short_full, "squeeze_short_full"),
                                              law_entry(Law::squeeze_long, "squeeze_long"),
                                              law_entry(Law::squeeze_short, "squeeze_short")};

/// The first of them: those whose film carries a journal at rest.
inline constexpr std::size_t laws_at_rest = 8;

/// ε, a = ε(ω − 2γ̇) and b = ε̇, enclosed. Zeros of a and b are exact zeros.
struct FilmBalls {
  Ball epsilon;
  Ball a;
  Ball b;

  Ball q() const { return (Ball(1) - epsilon) * (Ball(1) + epsilon); }
  bool at_rest() const { return a.is_exact_zero() && b.is_exact_zero(); }
  /// sgn(a), with sgn(0) = +1.
  int side() const { return a.sign() < 0 ? -1 : 1; }
};

struct PolarBalls {
  Ball radial;
  Ball tangential;
};

/// S = μRL³/c² (short) or μLR³/c² (long) [N s].
Ball force_scale(const LawEntry& law, double viscosity, double length, double radius, const Ball& clearance);

/// θs and θe, from the maximum film, counter-clockwise: full 0…2π; half 0…π, or π…2π for a < 0; dynamic
/// θs = atan2(2b, a), θe = θs + π, at rest 0 and π.
struct ExtentBalls {
  Ball start;
  Ball end;
};
ExtentBalls film_extent(Extent extent, const FilmBalls& film);

/// F_r/S and F_t/S of a law [1/s]: Flores et al. (2009), eqs. 6 to 18, and for the dynamic films Sommerfeld's angle
/// (sommerfeld_moments.hpp); films of the squeeze alone by their arccosine. Validity: 0 ≤ ε < 1, any a and b; at rest
/// exactly zero. Components that vanish by symmetry are exact zeros.
PolarBalls force_ratio(Law law, const FilmBalls& film);

/// The film as a law sees it: without its wedge where the law leaves it out.
FilmBalls film_seen(const LawEntry& law, const FilmBalls& film);

}  // namespace lubjoint::certified

/// Film laws as the free journal of this folder takes them: polar, with the branch of a law that jumps or kinks given.
#pragma once

#include <array>
#include <cmath>

#include "lubjoint/film/law.hpp"
#include "lubjoint/film/every_law.hpp"

namespace lubjoint::mechanisms {

/// Which branch of its law a film is on: one that is continued smoothly beyond the branch's end.
struct FilmBranch {
  int side = 1;     ///< half films: +1 film on 0…π (a ≥ 0), −1 on π…2π (a < 0)
  int squeeze = 1;  ///< laws that kink at b = 0: sign of b
};

/// F_r/S and F_t/S [1/s].
template <class R>
using PolarRatio = std::array<R, 2>;

/// A law of the library. The laws are certified by the golden film forces; everything around them is this folder's own.
template <FilmLaw Law>
struct LibraryFilm {
  static constexpr bool is_short = Law::limit == BearingLimit::short_bearing;
  static constexpr bool jumps = Law::extent == FilmExtent::half;  ///< at a = 0
  /// At b = 0: a squeeze film that opens resists in another way than one that closes.
  static constexpr bool kinks = SqueezeOnlyLaw<Law> && Law::extent == FilmExtent::dynamic;

  template <class R>
  static PolarRatio<R> ratio(const R& epsilon, const R& q, const R& a, const R& b, const FilmBranch& branch) {
    if (a == 0 && b == 0) return {R(0), R(0)};
    if constexpr (kinks) {  // linear in b on either branch
      const PolarFilmState<R> unit(epsilon, R(0), R(branch.squeeze), q, Unchecked());
      return {R(branch.squeeze * b * Law::force_ratio(unit, HalfFilmSide::converging).radial), R(0)};
    }
    const PolarFilmState<R> state(epsilon, a, b, q, Unchecked());
    if constexpr (PolarLaw<Law>) {
      const auto f = Law::force_ratio(state, branch.side < 0 ? HalfFilmSide::mirrored : HalfFilmSide::converging);
      return {f.radial, f.tangential};
    } else {
      const auto f = force_ratio<Law>(state.in_own_frame());
      return {f.x(), f.y()};
    }
  }
};

/// Pinkus and Sternlicht's law written out once more, from the paper's eqs. 14 to 18 with
///   k = √q |u|/(ε|b|),   |u|² = b² + a²/4,
/// multiplied through by ε|b|. On a given branch of sgn b it is smooth across b = 0, where the law itself has a jump in
/// its second derivatives.
struct PinkusSternlichtFilm {
  static constexpr bool is_short = false;
  static constexpr bool jumps = false;
  static constexpr bool kinks = true;  ///< at b = 0

  template <class R>
  static PolarRatio<R> ratio(const R& epsilon, const R& q, const R& a, const R& b, const FilmBranch& branch) {
    using std::sqrt;
    if (a == 0 && b == 0) return {R(0), R(0)};
    const R root = sqrt(q);
    const R rate = root * sqrt(R(b * b + a * a / 4));  // k ε|b|
    int sign = branch.squeeze;
    // Far on the other side the branch's denominator has a zero: there the law is what it is.
    if (sign * b < 0 && rate < -6 * sign * epsilon * b) sign = -sign;
    const R closing = 3 * sign * epsilon * b;  // 3 ε|b|
    const R phi = (sign < 0 ? rate : R(rate + closing)) / (rate + closing / 2);
    const R d = 3 - q;  // 2 + ε²
    const R circle = 6 * lubjoint::pi<R>() * phi;
    return {R(-(24 * epsilon * rate / d + circle * b) / (q * root)), R(circle * a / (d * root))};
  }
};

/// The film type of a law: the one written out here, or the library's.
template <FilmLaw Law>
struct JournalFilmOf {
  using Type = LibraryFilm<Law>;
};
template <>
struct JournalFilmOf<PinkusSternlicht> {
  using Type = PinkusSternlichtFilm;
};

}  // namespace lubjoint::mechanisms

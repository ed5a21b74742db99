/// What a film resists a pure squeeze with: F_r = −S k(ε) b, nothing across.
///
/// They are the dynamic films of dynamic_moments.hpp at a = 0, where x = ê·û = ε (closing) or −ε (opening) and N = 1:
///   long  k = 12 (δ + x√q)/q^{3/2},  short  k = [(q + 3x²)δ + 3x√q]/q^{5/2},  δ = atan2(√q, −x).
/// For an opening film both brackets cancel as ε → 1; with δ = ε√q (1 + 2q/3 + q²ρ(q)) the powers of q drop out:
///   long  k = 12ε(2/3 + qρ) → 8,  short  k = ε[(3 − 2q)ρ − 4/3] → 4/15.
#pragma once

#include "lubjoint/film/dynamic_moments.hpp"
#include "lubjoint/film/law.hpp"

namespace lubjoint::detail {

/// True where the closed form of an opening film would be less than 1/22 of its terms (short film, q = ½).
template <class T>
bool squeeze_opens_narrowly(const PolarFilmState<T>& state) {
  return (value_of(state.squeeze_rate) < 0) & (value_of(state.q) < RealOf<T>(0.5));
}

/// x = ε for b ≥ 0, −ε for b < 0.
template <class T>
T along_squeeze(const PolarFilmState<T>& state) {
  return value_of(state.squeeze_rate) < 0 ? T(-state.eccentricity_ratio) : state.eccentricity_ratio;
}

/// F/S of a law that has a form for films that open narrowly, and one for others.
template <class Law, class T>
PolarForce<T> squeeze_force(const PolarFilmState<T>& state) {
  const T resistance = squeeze_opens_narrowly(state) ? Law::narrow_resistance(state) : Law::wide_resistance(state);
  return {T(-resistance * state.squeeze_rate), T(0)};
}

/// The same with both formed and one selected: no branch, and the same bits.
template <class Law>
PolarForce<double> selected_squeeze_force(const PolarFilmState<double>& state) {
  const double narrow = Law::narrow_resistance(state), wide = Law::wide_resistance(state);
  const double resistance = squeeze_opens_narrowly(state) ? narrow : wide;
  return {-resistance * state.squeeze_rate, 0.0};
}

}  // namespace lubjoint::detail

/// Moments of the dynamic film, in the frame of its own motion.
///
/// Derivation. Let û = u/|u|, e₁ = ê·û, e₂ = ê·û⊥, and let d(φ) = û cosφ + û⊥ sinφ point at the place φ of the wall.
/// Then H = 1 − ê·d and the right-hand side of Reynolds' equation is proportional to cosφ: the film carries pressure
/// on |φ| < π/2, in front of the journal, whatever the direction of e. Sommerfeld's substitution, measured from the
/// middle of the film, is with N² = q + e₁² = 1 − e₂²
///     G = q/H = 1 + (e₁ cosχ + √q e₂ sinχ)/N,   dφ/H³ = q^{−5/2} G² dχ,   |χ| ≤ δ = atan2(√q, −e₁),
///     G(d₁ − e₁) = (√q/N)(√q cosχ − e₁e₂ sinχ),   G d₁ = e₁ + N cosχ,   G(d₂ − e₂) = √q N sinχ.
/// Every moment is then a combination of δ, sinδ = √q/N and cosδ = −e₁/N, without 1/ε and smooth at ê = 0:
///     V = ∫ sin²χ dχ                          = δ + e₁√q/N²
///     A = ∫ (1 + e₁ cosχ/N)² dχ               = [(2q + 3e₁²)δ + e₁√q (4q + 3e₁²)/N²]/N²
///     E = (1/N) ∫ (e₁ + N cosχ)(N + e₁ cosχ)  = 3e₁δ + √q (2q + 3e₁²)/N²
///     W = ∫ (e₁ + N cosχ)² dχ                 = (q + 3e₁²)δ + 3e₁√q
/// For e₁ ≥ 0 (a film that closes) all terms are positive. For e₁ < 0 they cancel as δ → 0: with m = −e₁,
/// y = sin²δ = q/N² and δ = sinδ cosδ (1 + 2y/3 + y²ρ), ρ(y) = (8/15) ₂F₁(1, 3; 7/2; y) (arc_series.hpp), the leading
/// terms drop out and
///     V = σ y (2/3 + yρ),  A = σ y² ((3 − y)ρ − 2/3),  E = σ y² (2N²/m − 3mρ),  W = (m√q) y² ((3 − 2y)ρ − 4/3),
/// σ = sinδ cosδ = m√q/N²: the powers of q that made them small stand in front.
#pragma once

#include "lubjoint/film/arc_series.hpp"
#include "lubjoint/film/film_state.hpp"

namespace lubjoint::detail {

/// A force over −|u|, along û and û⊥.
template <class T>
struct FrameForce {
  T along, across;
};

template <class T>
struct DynamicFrame {
  Vector2<T> along;   ///< û
  Vector2<T> across;  ///< û⊥
  T speed;            ///< |u| [1/s]
  T e1;               ///< ê·û
  T e2;               ///< ê·û⊥
  T n2;               ///< N² = q + e₁²
  T y;                ///< sin²δ

  explicit DynamicFrame(const FilmState<T>& film)
      : along(direction_in_range(film.velocity)),
        across(perpendicular(along)),
        speed(norm_in_range(film.velocity)),
        e1(dot(film.eccentricity, along)),
        e2(dot(film.eccentricity, across)),
        n2(film.q + e1 * e1),
        y(film.q / n2) {}

  /// True where the closed forms would lose more than about two digits (factor 11 (1 − y)²/y² at most 40).
  bool opens_narrowly() const { return (value_of(e1) < 0) & (value_of(y) < RealOf<T>(0.35)); }

  /// The force with components along û and û⊥ given over −|u|.
  Vector2<T> resistance(const FrameForce<T>& f) const {
    return Vector2<T>(T(-speed * (f.along * along.x() + f.across * across.x())),
                      T(-speed * (f.along * along.y() + f.across * across.y())));
  }
};

/// F/S of a law that has two forms: for films that open narrowly, and for others.
template <class Law, class T>
Vector2<T> resistance_of(const FilmState<T>& film) {
  const DynamicFrame<T> frame(film);
  return frame.resistance(frame.opens_narrowly() ? Law::narrow(frame) : Law::wide(frame, film.q));
}

/// The same with both formed and one selected: no branch, and the same bits.
template <class Law>
Vector2<double> selected_resistance_of(const FilmState<double>& film) {
  const DynamicFrame<double> frame(film);
  const FrameForce<double> narrow = Law::narrow(frame), wide = Law::wide(frame, film.q);
  const bool is_narrow = frame.opens_narrowly();
  return frame.resistance({is_narrow ? narrow.along : wide.along, is_narrow ? narrow.across : wide.across});
}

/// δ, half the length of the film in Sommerfeld's angle.
template <class T>
T half_length(const DynamicFrame<T>& frame, const T& root_q) {
  return angle_above(root_q, T(-frame.e1));
}

}  // namespace lubjoint::detail

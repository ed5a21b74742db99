/// Which laws come from a potential.
///
/// Φ(u) = −F·u with F = −½∇Φ, ê fixed. Where it is convex, ∂F/∂u is symmetric and negative semidefinite, the film is
/// monotone, (F(u₁) − F(u₂))·(u₁ − u₂) ≤ 0, and a force has one velocity where the convexity is strict: everywhere but
/// for the laws of the squeeze alone. All of it is proved in oracle/proofs.
#pragma once

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/film/squeeze_only.hpp"

namespace lubjoint {

/// convex: everywhere.
/// on_each_side: on each side of a = 0, where it has a kink; where b < 0 two velocities can have one force.
/// none: ∂F/∂u is not symmetric.
enum class Potential { convex, on_each_side, none };

/// The potential of a law: full films and short_dynamic (second moments of the film, positive definite) are convex.
template <FilmLaw Law>
inline constexpr Potential film_potential =
    Law::extent == FilmExtent::full || SqueezeOnlyLaw<Law> ? Potential::convex : Potential::none;
/// See above.
template <>
inline constexpr Potential film_potential<ShortDynamic> = Potential::convex;
/// Its pressure vanishes at both ends, as that of a quadratic functional does.
template <>
inline constexpr Potential film_potential<ShortHalf> = Potential::on_each_side;
/// The same.
template <>
inline constexpr Potential film_potential<LongHalf> = Potential::on_each_side;

}  // namespace lubjoint

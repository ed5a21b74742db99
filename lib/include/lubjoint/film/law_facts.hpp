/// What is known of a force law besides its formula. Stated once, in the law's own header, and read by everyone else,
/// also by oracles, which may see no formula.
#pragma once

#include <span>
#include <string_view>

#include "lubjoint/film/bearing.hpp"
#include "lubjoint/film/extent.hpp"

namespace lubjoint {

/// Is the force a gradient, F = −½ ∂Φ/∂u, of a function of u that is homogeneous of degree two?
/// convex: passive, monotone; where it is strictly so (everywhere but for laws of the squeeze alone) a force has one
/// velocity. on_each_side: on each side of a = 0, where it has a kink; where b < 0 two velocities can have one force.
/// none: ∂F/∂u is not symmetric. All of it is proved in oracle/proofs.
enum class Potential { convex, on_each_side, none };

/// The facts of one law.
struct LawFacts {
  std::string_view name;   ///< in scenes and options
  std::string_view words;  ///< "short bearing, half film"
  BearingLimit limit;      ///< which force scale
  FilmExtent extent;       ///< where its film carries pressure
  bool has_pressure;       ///< is the force the integral of a pressure field?
  bool kinks;              ///< is it at most once differentiable where b changes sign?
  bool jumps;              ///< does the force jump where a changes sign?
  bool squeeze_only;       ///< does it leave the wedge out, so that its film carries nothing that stays in its place?
  Potential potential;     ///< what it derives from

  /// Is its scale the short bearing's?
  constexpr bool is_short() const { return limit == BearingLimit::short_bearing; }
};

/// Of all laws, in the order in which they are listed everywhere. Link lubjoint::law_facts.
std::span<const LawFacts> film_law_facts();

/// Of the law of that name. Link lubjoint::law_facts.
/// @throws std::invalid_argument that lists the laws there are
const LawFacts& law_facts(std::string_view name);

}  // namespace lubjoint

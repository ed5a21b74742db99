/// What a program of finite length is asked, beyond its film's force alone.
#pragma once

#include <vector>

#include "oracle/verify/gallery/gallery_finite.hpp"
#include "oracle/verify/states/condition.hpp"

namespace lubjoint::verify {

/// Are forces of a film of finite length asked for, and nothing else? verify_finite_film judges those.
constexpr bool is_finite_force(Quantities q) { return q == Quantities::cartesian || q == Quantities::polar; }

/// The states that a program of finite length is asked about, with what knows their answers: bearings of L/D ¼, ½, 1
/// and 2. Coefficients and equilibrium: loads at about ε = 0.1 to 0.9 and both spins. Losses, wrench, extent and
/// pressure: the motions of finite_states, with arms or a place. Transition: the same motions inside the clearance, in
/// the blend and beyond it.
/// @param shear  of losses
/// @throws std::invalid_argument for what is not judged of these films: forces alone (verify_finite_film has them),
/// forms without dimensions, contact, where finite_reynolds ends, and coefficients and losses of an onset at the
/// maximum film; if no state is left
std::vector<State> solved_film_states(const FiniteClaim& claim, Quantities quantities, const Conjunction& domain,
                                      ShearExtent shear, unsigned threads);

}  // namespace lubjoint::verify

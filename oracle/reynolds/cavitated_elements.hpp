/// Finite-length film that ruptures where its pressure would become negative: a second solver, beside cavitated_film.
#pragma once

#include "oracle/reynolds/scaled_film.hpp"

namespace lubjoint::oracle {

/// Force of the cavitated film, free onset, by finite elements.
///
/// cavitated_film has finite volumes in θ, relaxed on grids of growing fineness. Here the film is the maximum of
///   ∬ sP − ½ ∬ H³(P_x² + P_ζ²)   over P ≥ 0
/// by bilinear elements in ζ and in Sommerfeld's angle ψ, cosψ = (ε + cosθ)/H, in which the pressure spike is as wide
/// as the film; which nodes carry pressure is found by the primal-dual active set (Hintermüller, Ito and Kunisch 2003),
/// each of its steps a sparse Cholesky factorisation. The two share the film's equation and nothing else.
///
/// The error is of second order in the step: the force is extrapolated from three grids; the error estimate is the
/// change from the extrapolation of the two coarser ones, of which the free boundary's rounding to the nodes is a part.
/// Accuracy: 1e-4 of |F| for ε ≤ 0.9 and L/D ¼ to 4, with the default grids.
/// @param around  elements around the coarsest grid, at least 8; along half of the length it has a quarter of that
ScaledForce cavitated_force_by_elements(const ScaledFilm& film, int around = 64);

/// Its side flow: at the edge's nodes, where P = 0 is given, the equation's residual is what leaves by them,
///   ∫ −H³ ∂ζP φ dx = ∬ (sφ − H³(P_x φ_x + P_ζ φ_ζ))   for the node's φ, the φ of all nodes being one along the edge,
/// which is of the second order of the force where a slope of P would be of the first. P ≥ 0 lets no oil in: a node
/// whose residual is negative is of a ruptured film. Extrapolated likewise; the free boundary's rounding counts for
/// more where it meets the edge, so that the error estimate is at least what the last two grids differ by.
/// @param around  as above
ScaledFlow cavitated_flow_by_elements(const ScaledFilm& film, int around = 64);

/// Its ∬ dθ dζ/(2ΛH) over the part that carries pressure: as dθ/H = dψ/√q, that part's share of ψ and ζ times 2π/√q. A
/// node along its bounds counts by the share of its source that the pressure beside it feeds. Extrapolated likewise,
/// with an error estimate as of the flow.
/// @param around  as above
ScaledCouette cavitated_couette_by_elements(const ScaledFilm& film, int around = 64);

}  // namespace lubjoint::oracle

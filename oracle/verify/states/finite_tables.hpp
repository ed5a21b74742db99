/// Tables of a film of the bearing's real length, and the solver's word on them.
#pragma once

#include <memory>
#include <vector>

#include "oracle/verify/gallery/gallery_finite.hpp"
#include "oracle/verify/states/condition.hpp"
#include "oracle/verify/states/solved_films.hpp"

namespace lubjoint::verify {

/// Films at rest: at each L/D that is asked for, once a process, by the solvers at the zeros of a Chebyshev polynomial
/// in log(ε/(1 − ε)); slopes in ε are the polynomials'. Full, half and dynamic films by modes around the bearing; of
/// finite_reynolds, by finite volumes, ∂F_t/∂b = −2 ∂F_r/∂a, as its force is a gradient. L/D counts to 3e-6 of itself.
/// Moving films: each state once.
/// Accuracy, ε from 0.1 to 0.9, L/D ¼ to 4 (tests, against the golden data within their bounds): forces of full, half
/// and dynamic films to 2e-9, K and C to 5e-7 of the largest entry; of finite_reynolds to 6e-4 and 4e-3.
/// @param threads  no result depends on them
std::shared_ptr<const SolvedFilms> solved_films(oracle::FilmOnset onset, unsigned threads);

/// The states of a table that a program of finite length is asked about, with what knows their answers: bearings of L/D
/// ¼, ½, 1 and 2; for coefficients and equilibrium loads at about ε = 0.1 to 0.9 and both spins, for losses the motions
/// of finite_states.
/// @param shear  of losses
/// @throws std::invalid_argument for quantities that are no table; for an onset at the maximum film where the table has
/// more than places; if no state is left
std::vector<State> finite_table_states(const FiniteClaim& claim, Quantities quantities, const Conjunction& domain,
                                       ShearExtent shear, unsigned threads);

}  // namespace lubjoint::verify

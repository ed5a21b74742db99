/// Films of the bearing's real length as the solvers have them.
#pragma once

#include <memory>

#include "oracle/reynolds/finite_length.hpp"
#include "oracle/verify/states/solved_films.hpp"

namespace lubjoint::verify {

/// Films at rest: at each L/D that is asked for, once a process, by the solvers at the zeros of a Chebyshev polynomial
/// in log(ε/(1 − ε)); slopes in ε are the polynomials'. Full, half and dynamic films by modes around the bearing; of
/// finite_reynolds, by finite volumes, ∂F_t/∂b = −2 ∂F_r/∂a, as its force is a gradient. L/D counts to 3e-6 of itself.
/// Moving films: each state once, at the rate one, ε, L/D and the rates' direction to 36 binary digits.
/// Accuracy, ε from 0.1 to 0.9, L/D ¼ to 4 (tests, against the golden data within their bounds): forces of full, half
/// and dynamic films to 2e-9, K and C to 5e-7 of the largest entry; of finite_reynolds to 6e-4 and 4e-3.
/// @param threads  no result depends on them
std::shared_ptr<const SolvedFilms> solved_films(oracle::FilmOnset onset, unsigned threads);

}  // namespace lubjoint::verify

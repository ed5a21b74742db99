/// Golden data of films of finite length. No ball arithmetic reaches them: their uncertainties are the bounds of
/// solvers, and what two of them differ by.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "oracle/certified/finite_force.hpp"
#include "oracle/certified/golden.hpp"

namespace lubjoint::certified {

/// L/D ¼, ½, 1, the paper's 2.0408 and 4; ε 0.1, 0.5 and 0.9; rotation, squeeze that closes and opens, and both
/// together, also the other way round.
std::vector<FiniteGoldenState> finite_golden_states();

/// By two solvers that share no step: of full, half and dynamic films both in series, of finite_reynolds finite volumes
/// and finite elements. The uncertainty is what they differ by, and their own bounds; of finite_reynolds the bound of
/// the finite volumes, whose force it is.
FiniteGoldenForce finite_golden_force(const FiniteGoldenState& state);

/// Writes finite_film_force.csv, finite_film_coefficients.csv, finite_film_side_flow.csv and their manifest into a
/// folder.
void write_finite_golden(const std::filesystem::path& folder, const GoldenRun& run = {});

/// Compares manifest and columns, and makes one row in run.every again: differences are those beyond both
/// uncertainties together, as other processors round otherwise.
std::vector<reports::GoldenDifference> check_finite_golden(const std::filesystem::path& folder,
                                                           const GoldenRun& run = {});

}  // namespace lubjoint::certified

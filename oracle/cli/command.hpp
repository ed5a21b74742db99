/// What every file of this folder offers: one command, added to the program's parser.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "lubjoint/version.hpp"
#include "oracle/files/data_folder.hpp"
#include "oracle/files/require.hpp"

namespace lubjoint::cli {

/// Set by the command that the user named; returns the exit status.
using Action = std::function<int()>;

void add_simulate(CLI::App& app, Action& action);
void add_force(CLI::App& app, Action& action);
void add_compile_film(CLI::App& app, Action& action);
void add_equilibrium(CLI::App& app, Action& action);
void add_losses(CLI::App& app, Action& action);
void add_mobility(CLI::App& app, Action& action);
void add_coefficients(CLI::App& app, Action& action);
void add_stability(CLI::App& app, Action& action);
void add_assemble(CLI::App& app, Action& action);
void add_periodic(CLI::App& app, Action& action);
void add_benchmark(CLI::App& app, Action& action);
void add_reproduce(CLI::App& app, Action& action);
void add_accuracy(CLI::App& app, Action& action);
void add_oracle(CLI::App& app, Action& action);
void add_model_error(CLI::App& app, Action& action);
void add_bench(CLI::App& app, Action& action);
void add_cost(CLI::App& app, Action& action);
void add_sweep(CLI::App& app, Action& action);
void add_stress(CLI::App& app, Action& action);
void add_golden(CLI::App& app, Action& action);  // where the enclosures are built
void add_verify(CLI::App& app, Action& action);
void add_prove(CLI::App& app, Action& action);  // where the proofs are built

/// Folder of the scenes that ship with the program.
inline std::string scenes_folder() { return reports::data_folder() / "scenes"; }
/// Folder of the golden data that ship with it.
inline std::string golden_folder() { return reports::data_folder() / "golden"; }

using reports::require_option;

}  // namespace lubjoint::cli

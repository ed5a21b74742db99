/// What a program is made of: commands, and how they are run. No parser is seen from here, so that a program's own
/// source costs nothing to compile.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace lubjoint::cli {

/// Set by the command that the user named; returns the exit status.
using Action = std::function<int()>;

// The commands, each added to a program's parser.

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

/// A program: parses, acts. @returns the exit status: 0 done; 1 the answer is no (a run stopped, a check failed); 2 bad
/// usage or input
int run_program(int argc, char** argv, void (*add)(CLI::App&, Action&));

}  // namespace lubjoint::cli

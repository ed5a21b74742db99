#include "oracle/cli/run_program.hpp"

int main(int argc, char** argv) {
  return lubjoint::cli::run_program(argc, argv, [](CLI::App& app, lubjoint::cli::Action& action) {
    lubjoint::cli::add_simulate(app, action);
    lubjoint::cli::add_assemble(app, action);
    lubjoint::cli::add_periodic(app, action);
    lubjoint::cli::add_force(app, action);
    lubjoint::cli::add_losses(app, action);
    lubjoint::cli::add_mobility(app, action);
    lubjoint::cli::add_equilibrium(app, action);
    lubjoint::cli::add_coefficients(app, action);
    lubjoint::cli::add_stability(app, action);
    lubjoint::cli::add_compile_film(app, action);
    lubjoint::cli::add_benchmark(app, action);
    lubjoint::cli::add_sweep(app, action);
  });
}

// lubjoint COMMAND: the program. Exit status 0: done; 1: the answer is no (a run stopped, a check failed); 2: bad usage
// or input.
#include <iostream>

#include "oracle/cli/command.hpp"
#include "oracle/reports/files.hpp"

int main(int argc, char** argv) {
  lubjoint::reports::remove_temporary_files_on_interrupt();
  CLI::App app("Reference for lubricated revolute joints in rigid multibody systems", "lubjoint");
  app.require_subcommand(1);
  app.set_version_flag("--version", LUBJOINT_VERSION);
  lubjoint::cli::Action action;
  lubjoint::cli::add_reproduce(app, action);
  lubjoint::cli::add_simulate(app, action);
  lubjoint::cli::add_force(app, action);
  lubjoint::cli::add_equilibrium(app, action);
  lubjoint::cli::add_oracle(app, action);
  lubjoint::cli::add_model_error(app, action);
  lubjoint::cli::add_accuracy(app, action);
  lubjoint::cli::add_bench(app, action);
  lubjoint::cli::add_verify(app, action);
#if LUBJOINT_HAS_PROOFS
  lubjoint::cli::add_prove(app, action);
#endif
  try {
    app.parse(argc, argv);
    return action();
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    std::cerr << "lubjoint: " << error.what()
              << "\nlubjoint --help, or lubjoint COMMAND --help, says what is allowed\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "lubjoint: " << error.what() << '\n';
    return 2;
  }
}

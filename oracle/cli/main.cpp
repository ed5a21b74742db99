// lubjoint COMMAND: the program. Exit status 0: done; 1: the answer is no (a run stopped, a check failed); 2: bad usage
// or input.
#include <iostream>

#include "lubjoint/scene/nearest_name.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/reports/files.hpp"

namespace {

/// What is wrong with the arguments; CLI11 names neither the command that it does not know nor what a number may be.
std::string in_own_words(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  if (dynamic_cast<const CLI::ConversionError*>(&error)) return error.what() + std::string("; allowed is a number");
  if (!dynamic_cast<const CLI::RequiredError*>(&error) || !app.get_subcommands().empty()) return error.what();
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
  const std::string given = argc > 1 ? argv[1] : "";
  const std::string what = argc > 1 ? "there is no command \"" + given + "\"" : "a command is missing";
  return what + "; allowed is " + lubjoint::one_of(commands, given);
}

}  // namespace

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
  lubjoint::cli::add_cost(app, action);
  lubjoint::cli::add_sweep(app, action);
  lubjoint::cli::add_stress(app, action);
#if LUBJOINT_HAS_CERTIFIED
  lubjoint::cli::add_golden(app, action);
#endif
  lubjoint::cli::add_verify(app, action);
#if LUBJOINT_HAS_PROOFS
  lubjoint::cli::add_prove(app, action);
#endif
  try {
    app.parse(argc, argv);
    const int status = action();
    if (!std::cout.flush()) throw std::runtime_error("standard output can't be written; allowed is one that takes all");
    return status;
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    std::cerr << "lubjoint: " << in_own_words(app, error, argc, argv)
              << "\nlubjoint --help, or lubjoint COMMAND --help, says what is allowed\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "lubjoint: " << error.what() << '\n';
    return 2;
  }
}

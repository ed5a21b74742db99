#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "oracle/cli/command_line.hpp"
#include "oracle/cli/other_programs.hpp"

namespace lubjoint::cli {

namespace {

char** given_arguments = nullptr;

/// Becomes the other program, with the same arguments. Returns if it can't.
int become(const OtherProgram& other) {
  const auto file = std::filesystem::read_symlink("/proc/self/exe").parent_path() / other.program;
  ::execv(file.c_str(), given_arguments);
  if (errno != ENOENT) throw std::system_error(errno, std::generic_category(), file.string());
  throw std::runtime_error(std::string(other.command) + " is a command of " + file.string() +
                           ", which was not built; in a checkout ./lubjoint " + std::string(other.command) +
                           " builds it");
}

void add_other(CLI::App& app, Action& action, std::string_view command) {
  for (const OtherProgram& each : other_programs) {
    if (each.command != command) continue;
    CLI::App* added = app.add_subcommand(std::string(command), std::string(each.words));
    added->set_help_flag();
    added->prefix_command();
    added->callback([&each, &action] { action = [&each] { return become(each); }; });
  }
}

}  // namespace

void add_commands(CLI::App& app, Action& action) {
  add_reproduce(app, action);
  add_simulate(app, action);
  add_assemble(app, action);
  add_periodic(app, action);
  add_force(app, action);
  add_losses(app, action);
  add_mobility(app, action);
  add_equilibrium(app, action);
  add_coefficients(app, action);
  add_stability(app, action);
  add_compile_film(app, action);
  add_oracle(app, action);
  add_model_error(app, action);
  add_benchmark(app, action);
  add_accuracy(app, action);
  add_other(app, action, "bench");
  add_other(app, action, "cost");
  add_sweep(app, action);
  add_other(app, action, "stress");
  add_other(app, action, "golden");
  add_other(app, action, "verify");
  add_other(app, action, "prove");
}

}  // namespace lubjoint::cli

int main(int argc, char** argv) {
  lubjoint::cli::given_arguments = argv;
  return lubjoint::cli::run_program(argc, argv, lubjoint::cli::add_commands);
}

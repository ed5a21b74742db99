#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "oracle/cli/command_line.hpp"
#include "oracle/cli/programs.hpp"

namespace lubjoint::cli {

namespace {

char** given_arguments = nullptr;

/// Becomes the program that has the command, with the same arguments. Returns if it can't.
int become(const ProgramCommand& wanted) {
  const auto file = std::filesystem::read_symlink("/proc/self/exe").parent_path() / wanted.program;
  ::execv(file.c_str(), given_arguments);
  if (errno != ENOENT) throw std::system_error(errno, std::generic_category(), file.string());
  throw std::runtime_error(std::string(wanted.command) + " is a command of " + file.string() +
                           ", which was not built; in a checkout ./lubjoint " + std::string(wanted.command) +
                           " builds it");
}

/// Every command, as one that another program has.
void add_commands(CLI::App& app, Action& action) {
  for (const ProgramCommand& each : program_commands) {
    CLI::App* added = app.add_subcommand(std::string(each.command), std::string(each.words));
    added->set_help_flag();
    added->prefix_command();
    added->callback([&each, &action] { action = [&each] { return become(each); }; });
  }
}

}  // namespace

}  // namespace lubjoint::cli

int main(int argc, char** argv) {
  lubjoint::cli::given_arguments = argv;
  return lubjoint::cli::run_program(argc, argv, lubjoint::cli::add_commands);
}

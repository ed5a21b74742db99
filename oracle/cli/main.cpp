// lubjoint COMMAND: the program. Exit status 0: done; 1: the answer is no (a run stopped, a check failed); 2: bad usage
// or input.
#include <iostream>

#include "oracle/cli/command_line.hpp"
#include "oracle/files/files.hpp"

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);  // nothing here reads or writes with C's streams but progress, on standard error
  lubjoint::reports::remove_temporary_files_on_interrupt();
  CLI::App app("Reference for lubricated revolute joints in rigid multibody systems", "lubjoint");
  lubjoint::cli::Action action;
  lubjoint::cli::add_commands(app, action);
  try {
    app.parse(argc, argv);
    const int status = action();
    if (!std::cout.flush()) throw std::runtime_error("standard output can't be written; allowed is one that takes all");
    return status;
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    std::cerr << "lubjoint: " << lubjoint::cli::refusal(app, error, argc, argv)
              << "\nlubjoint --help, or lubjoint COMMAND --help, says what is allowed\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "lubjoint: " << error.what() << '\n';
    return 2;
  }
}

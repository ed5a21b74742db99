#include "oracle/cli/run_program.hpp"

int main(int argc, char** argv) {
  return lubjoint::cli::run_program(
      argc, argv, [](CLI::App& app, lubjoint::cli::Action& action) { lubjoint::cli::add_prove(app, action); });
}

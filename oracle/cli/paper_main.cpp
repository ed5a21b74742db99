#include "oracle/cli/run_program.hpp"

int main(int argc, char** argv) {
  return lubjoint::cli::run_program(argc, argv, [](CLI::App& app, lubjoint::cli::Action& action) {
    lubjoint::cli::add_reproduce(app, action);
    lubjoint::cli::add_oracle(app, action);
    lubjoint::cli::add_model_error(app, action);
    lubjoint::cli::add_accuracy(app, action);
  });
}

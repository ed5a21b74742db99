#include "oracle/cli/command_line.hpp"

#include "lubjoint/text/nearest_name.hpp"
#include "lubjoint/text/printable.hpp"

namespace lubjoint::cli {

namespace {

/// CLI11 names neither the command that it does not know nor what a number may be.
std::string in_own_words(const CLI::App& app, const CLI::ParseError& error, int argc, const char* const* argv) {
  if (dynamic_cast<const CLI::ConversionError*>(&error)) return error.what() + std::string("; allowed is a number");
  // Nor, where an argument is empty, that there is one.
  if (dynamic_cast<const CLI::ExtrasError*>(&error))
    return error.what() + std::string("; allowed is what --help lists");
  const CLI::App* command = &app;
  int word = 1;  // where its own command would stand: none has options before it
  for (; !command->get_subcommands().empty(); ++word) command = command->get_subcommands().front();
  const auto allowed = command->get_subcommands({});
  if (!dynamic_cast<const CLI::RequiredError*>(&error) || allowed.empty()) return error.what();
  std::vector<std::string> names;
  names.reserve(allowed.size());
  for (const CLI::App* each : allowed) names.push_back(each->get_name());
  const std::string after = word > 1 ? " after \"" + command->get_name() + "\"" : "";
  const std::string given = argc > word ? argv[word] : "";
  const std::string what = argc > word ? "there is no command \"" + given + "\"" : "a command is missing";
  return what + after + "; allowed is " + one_of(names, given);
}

}  // namespace

void add_commands(CLI::App& app, Action& action) {
  app.require_subcommand(1);
  app.set_version_flag("--version", LUBJOINT_VERSION);
  add_reproduce(app, action);
  add_simulate(app, action);
  add_force(app, action);
  add_losses(app, action);
  add_mobility(app, action);
  add_equilibrium(app, action);
  add_coefficients(app, action);
  add_stability(app, action);
  add_oracle(app, action);
  add_model_error(app, action);
  add_accuracy(app, action);
  add_bench(app, action);
  add_cost(app, action);
  add_sweep(app, action);
  add_stress(app, action);
#if LUBJOINT_HAS_CERTIFIED
  add_golden(app, action);
#endif
  add_verify(app, action);
#if LUBJOINT_HAS_PROOFS
  add_prove(app, action);
#endif
}

std::string refusal(const CLI::App& app, const CLI::ParseError& error, int argc, const char* const* argv) {
  return printable(in_own_words(app, error, argc, argv));
}

}  // namespace lubjoint::cli

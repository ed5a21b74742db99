#include "oracle/cli/command_line.hpp"

#include <iostream>

#include "lubjoint/text/nearest_name.hpp"
#include "lubjoint/text/printable.hpp"
#include "oracle/files/files.hpp"

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

void prepare(CLI::App& app) {
  app.require_subcommand(1);
  app.set_version_flag("--version", LUBJOINT_VERSION);
}

std::string refusal(const CLI::App& app, const CLI::ParseError& error, int argc, const char* const* argv) {
  return printable(in_own_words(app, error, argc, argv));
}

int run_program(int argc, char** argv, void (*add)(CLI::App&, Action&)) {
  std::ios::sync_with_stdio(false);  // nothing here reads or writes with C's streams but progress, on standard error
  reports::remove_temporary_files_on_interrupt();
  CLI::App app("Reference for lubricated revolute joints in rigid multibody systems", "lubjoint");
  Action action;
  prepare(app);
  add(app, action);
  try {
    app.parse(argc, argv);
    const int status = action();
    if (!std::cout.flush()) throw std::runtime_error("standard output can't be written; allowed is one that takes all");
    return status;
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    std::cerr << "lubjoint: " << refusal(app, error, argc, argv)
              << "\nlubjoint --help, or lubjoint COMMAND --help, says what is allowed\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "lubjoint: " << error.what() << '\n';
    return 2;
  }
}

}  // namespace lubjoint::cli

#include "oracle/cli/command_line.hpp"

#include "fuzz/targets.hpp"
#include "lubjoint/text/printable.hpp"

namespace lubjoint::fuzz {

namespace {

/// The program's name and one argument a line; a zero byte ends an argument, as it does for any program.
std::vector<std::string> arguments_in(std::string_view bytes) {
  std::vector<std::string> words = {"lubjoint"};
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    words.emplace_back(std::string(bytes.substr(0, end)).c_str());
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  return words;
}

/// The commands of all programs in one.
void add_all(CLI::App& app, cli::Action& action) {
  cli::prepare(app);
  cli::add_reproduce(app, action);
  cli::add_simulate(app, action);
  cli::add_assemble(app, action);
  cli::add_periodic(app, action);
  cli::add_force(app, action);
  cli::add_losses(app, action);
  cli::add_mobility(app, action);
  cli::add_equilibrium(app, action);
  cli::add_coefficients(app, action);
  cli::add_stability(app, action);
  cli::add_compile_film(app, action);
  cli::add_oracle(app, action);
  cli::add_model_error(app, action);
  cli::add_benchmark(app, action);
  cli::add_accuracy(app, action);
  cli::add_bench(app, action);
  cli::add_cost(app, action);
  cli::add_sweep(app, action);
  cli::add_stress(app, action);
  cli::add_verify(app, action);
#if LUBJOINT_HAS_CERTIFIED
  cli::add_golden(app, action);
#endif
#if LUBJOINT_HAS_PROOFS
  cli::add_prove(app, action);
#endif
}

}  // namespace

void command_line(std::string_view bytes) {
  const std::vector<std::string> words = arguments_in(bytes);
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  argv.push_back(nullptr);
  const int argc = static_cast<int>(words.size());
  // Made once, which takes five times as long as parsing: CLI11 clears what an earlier parse has left.
  static cli::Action action;
  static CLI::App app("any", "lubjoint");
  [[maybe_unused]] static const bool made = (add_all(app, action), true);
  action = nullptr;
  try {
    app.parse(argc, argv.data());
    require(static_cast<bool>(action), "arguments that are accepted name an action");
    require(app.get_subcommands().size() == 1, "one command is named");
  } catch (const CLI::Success&) {  // --help, --version
  } catch (const CLI::ParseError& error) {
    const std::string message = cli::refusal(app, error, argc, argv.data());
    require_one_line(message);
    const auto says = [&](const std::string& part) { return message.find(part) != std::string::npos; };
    const bool names_argument =
        std::any_of(words.begin() + 1, words.end(), [&](const auto& w) { return !w.empty() && says(printable(w)); });
    require(names_argument || says("--") || says("allowed") || says("required"),
            "a message names an argument, an option, or what is allowed: " + message);
  }
}

}  // namespace lubjoint::fuzz

#include "oracle/laws/accuracy.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <iostream>
#include <stdexcept>

#include "lubjoint/film/every_law.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::cli {

namespace {
/// CLI11 would wrap a negative number and cut off one that is too large.
std::string whole_number(const std::string& given) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), value);
  if (error == std::errc() && end == given.data() + given.size()) return {};
  return "is \"" + given + "\"; allowed is a whole number from 0 to 18446744073709551615";
}
}  // namespace

void add_accuracy(CLI::App& app, Action& action) {
  struct AccuracyOptions {
    std::optional<std::string> out;
    std::size_t directions = 400;
    std::uint64_t seed = 1;
  };
  auto options = std::make_shared<AccuracyOptions>();
  CLI::App* command = app.add_subcommand("accuracy", words_of("accuracy"));
  command->add_option("--out", options->out, "CSV file to write, all rows");
  command->add_option("--directions", options->directions, "Random directions of motion at each ratio")
      ->check(whole_number, "UINT")
      ->check(CLI::Range(std::size_t{0}, std::size_t{1'000'000}));
  CLI::Option* seed =
      command->add_option("--seed", options->seed, "Seed of the directions, 0 or more")->check(whole_number, "UINT");
  command->callback([options, seed, &action] {
    action = [options, seed] {
      if (seed->count() > 0 && options->directions == 0) {
        throw std::invalid_argument("--seed has no effect with --directions 0; allowed with directions to be drawn");
      }
      if (options->out) reports::prepare_file(*options->out);
      const auto rows = reports::measure_accuracy(options->directions, options->seed);
      if (options->out) reports::write_file(*options->out, reports::accuracy_csv(rows));
      std::cout
          << "Largest error of a component, 1 - e from 1 down to 1e-12. ulp: of the sum of the terms' magnitudes\n"
             "(dynamic films: of |F|).\n";
      std::cout << fmt::format("{:<20}{:>10}{:>16}{:>16}{:>16}\n", "law", "ulp", "of |F| to 1e-6", "to 1e-9",
                               "to 1e-12");
      for (const std::string_view name : names_of_laws<StateFilmLaws>) {
        const std::string law(name);
        std::cout << fmt::format("{:<20}{:>10.2f}{:>16.2e}{:>16.2e}{:>16.2e}\n", law, reports::worst_ulp(rows, law, 0),
                                 reports::worst_of_force(rows, law, 0.99e-6),
                                 reports::worst_of_force(rows, law, 0.99e-9), reports::worst_of_force(rows, law, 0));
      }
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

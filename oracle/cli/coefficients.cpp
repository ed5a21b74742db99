#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "lubjoint/film/film_state.hpp"
#include "oracle/cli/bearing_options.hpp"
#include "oracle/cli/law_option.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "oracle/results/coefficient_table.hpp"
#include "oracle/sweep/sweep_grid.hpp"

namespace lubjoint::cli {

namespace {

using Rows = std::vector<reports::CoefficientRow>;

struct CoefficientsOptions : BearingOptions {
  std::string law;
  std::optional<std::string> states;
  std::optional<std::string> speeds;
  std::optional<double> load;
  std::optional<double> omega;
  bool dimensionless = false;
};

Rows of_states(const CoefficientsOptions& options, const reports::FilmInBearing& film) {
  if (options.load) throw std::invalid_argument("--load has no effect beside --states; allowed is one of them");
  if (!options.omega) throw std::invalid_argument("--omega is missing; required with --states is a spin [rad/s]");
  require_option("--omega", *options.omega, *options.omega != 0, "a finite spin other than 0 [rad/s]");
  const reports::CsvTable states(reports::read_input(*options.states), reports::input_name(*options.states));
  const std::size_t column = states.column("eccentricity_ratio");
  Rows rows;
  for (std::size_t row = 0; row < states.rows(); ++row) {
    try {
      rows.push_back(reports::coefficients_at(film, states.number(row, column), *options.omega));
    } catch (const FilmDomainError& error) {
      states.refuse(row, error.what());
    }
  }
  return rows;
}

Rows of_speeds(const CoefficientsOptions& options, const reports::FilmInBearing& film) {
  if (options.omega) throw std::invalid_argument("--omega has no effect beside --speeds; allowed is one of them");
  if (!options.load) throw std::invalid_argument("--load is missing; required with --speeds is a load [N]");
  require_option("--load", *options.load, *options.load > 0, "a finite number above 0 [N]");
  Rows rows;
  for (const double omega : reports::parse_range("--speeds", *options.speeds)) {
    require_option("a speed of --speeds", omega, omega != 0, "a spin other than 0 [rad/s]");
    const auto row = reports::coefficients_under(film, *options.load, omega);
    if (!row) {
      throw std::invalid_argument(fmt::format(
          "--load is {} N at {} rad/s; allowed is one that the film carries at an eccentricity ratio from 1e-300 to "
          "1 - 1e-15",
          *options.load, omega));
    }
    rows.push_back(*row);
  }
  return rows;
}

/// Closed forms and exact derivatives are two roads to one matrix. @returns 1 if they lead apart
int compare(const Rows& rows) {
  double worst = 0;
  for (const reports::CoefficientRow& row : rows) worst = std::max(worst, row.difference);
  if (worst < 1e-12) return 0;  // extended precision on both roads
  std::cerr << fmt::format("lubjoint: closed forms and exact derivatives of the law differ by {:.1e}\n", worst);
  return 1;
}

}  // namespace

void add_coefficients(CLI::App& app, Action& action) {
  auto options = std::make_shared<CoefficientsOptions>();
  CLI::App* command = app.add_subcommand("coefficients", words_of("coefficients"));
  command->add_option("--law", options->law, "Film law")->required();
  command->add_option("--states", options->states, "CSV with eccentricity_ratio; - is stdin. Needs --omega");
  command->add_option("--speeds", options->speeds, "Spins LO:HI:N or log:LO:HI:N [rad/s]. Needs --load");
  command->add_option("--load", options->load, "Load on the journal [N]");
  command->add_option("--omega", options->omega, "Spin of the journal, of either sign [rad/s]");
  options->add(*command);
  command->add_flag("--dimensionless", options->dimensionless, "cK/W, c omega C/W and m c omega^2/W");
  command->callback([options, &action] {
    action = [options] {
      require_law_with_rest(options->law);
      if (options->states.has_value() == options->speeds.has_value()) {
        throw std::invalid_argument("coefficients needs --states or --speeds; allowed is one of them");
      }
      const Bearing<double> bearing = options->bearing();
      require_law_of_bearing(options->law, bearing);
      const reports::FilmInBearing film = film_in_bearing(options->law, bearing, options->oil());
      const Rows rows = options->states ? of_states(*options, film) : of_speeds(*options, film);
      const std::string warning = reports::stability_warning(options->law, film.table.get());
      if (!warning.empty()) std::cerr << "warning: " << warning << '\n';
      double farthest = 0;
      for (const reports::CoefficientRow& row : rows) farthest = std::max(farthest, row.eccentricity_ratio);
      const std::string beyond = reports::beyond_table_note(film, farthest);
      if (!beyond.empty()) std::cerr << "warning: " << beyond << '\n';
      std::cout << reports::coefficients_csv(film, rows, options->dimensionless);
      return compare(rows);
    };
  });
}

}  // namespace lubjoint::cli

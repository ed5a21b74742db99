#include <fmt/format.h>

#include <iostream>

#include "lubjoint/film/law_list.hpp"
#include "oracle/cli/bearing_options.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/reports/csv_table.hpp"
#include "oracle/reports/files.hpp"

namespace lubjoint::cli {

namespace {

template <FilmLaw Law>
std::string forces(const reports::CsvTable& states, const Bearing<double>& bearing, const Lubricant<double>& oil) {
  const std::size_t ratio = states.column("eccentricity_ratio");
  const std::size_t slip = states.column("slip_rate");
  const std::size_t squeeze = states.column("squeeze_rate");
  constexpr bool dynamic = Law::extent == FilmExtent::dynamic;
  std::string csv = states.header() + ",radial,tangential" + (dynamic ? ",theta_s,theta_e\n" : "\n");
  for (std::size_t row = 0; row < states.rows(); ++row) {
    try {
      const PolarFilmState<double> state(states.number(row, ratio), states.number(row, slip),
                                         states.number(row, squeeze));
      const PolarForce<double> force = film_force<Law>(bearing, oil, state);
      if (!std::isfinite(force.radial) || !std::isfinite(force.tangential)) {
        states.refuse(row, "the force is beyond the range of double precision; allowed are smaller rates");
      }
      csv += fmt::format("{},{},{}", states.line(row), force.radial, force.tangential);
      if constexpr (dynamic) {
        const FilmBounds<double> bounds = film_bounds(Law::extent, state);
        csv += fmt::format(",{},{}", bounds.start, bounds.end);
      }
      csv += '\n';
    } catch (const FilmDomainError& error) {
      states.refuse(row, error.what());
    }
  }
  return csv;
}

}  // namespace

void add_force(CLI::App& app, Action& action) {
  struct Options : BearingOptions {
    std::string law;
    std::string states;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("force", "Film force of a law at given states, CSV in and out");
  command->add_option("--law", options->law, "Film law")->required();
  command->add_option("--states", options->states, "CSV with eccentricity_ratio,slip_rate,squeeze_rate; - is stdin")
      ->required();
  options->add(*command);
  command->callback([options, &action] {
    action = [options] {
      require_name("--law", options->law, film_law_names);
      const Bearing<double> bearing = options->bearing();
      const Lubricant<double> oil = options->oil();
      const reports::CsvTable states(reports::read_input(options->states),
                                     options->states == "-" ? "standard input" : options->states);
      std::cout << with_film_law(options->law, [&]<class Law>() { return forces<Law>(states, bearing, oil); });
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

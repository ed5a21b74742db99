#include <algorithm>
#include <cmath>
#include <iostream>

#include "oracle/cli/bearing_options.hpp"
#include "oracle/cli/law_option.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/cli/state_rows.hpp"
#include "oracle/results/coefficient_table.hpp"
#include "oracle/results/mobility_table.hpp"

namespace lubjoint::cli {

void add_mobility(CLI::App& app, Action& action) {
  struct MobilityOptions : BearingOptions {
    std::string law;
    std::string states;
  };
  auto options = std::make_shared<MobilityOptions>();
  CLI::App* command = app.add_subcommand("mobility", words_of("mobility"));
  command->add_option("--law", options->law, "Film law")->required();
  command
      ->add_option("--states", options->states,
                   "CSV with ex_over_c,ey_over_c and fx,fy, the force on the\njournal [N]; - is stdin")
      ->required();
  options->add(*command);
  command->callback([options, &action] {
    action = [options] {
      const Bearing<double> bearing = options->bearing();
      require_law_of_bearing(options->law, bearing);
      reports::require_mobility(options->law);
      const Lubricant<double> oil = options->oil();
      reports::FilmInBearing film{options->law, bearing, oil};
      double farthest = 0;
      answer_stream("mobility", options->states, [&](reports::CsvStream& states, const auto& write) {
        film = film_in_bearing(options->law, bearing, oil);  // once there are states: it may take a minute
        constexpr std::array given = {"ex_over_c", "ey_over_c", "fx", "fy"};
        answer_numbers(states, given, reports::mobility_column_names(options->law), write,
                       [&](const std::array<double, 4>& x) {
                         farthest = std::max(farthest, std::hypot(x[0], x[1]));
                         return reports::mobility_columns(film, {x[0], x[1]}, {x[2], x[3]});
                       });
      });
      const std::string beyond = reports::beyond_table_note(film, farthest);
      if (!beyond.empty()) std::cerr << "warning: " << beyond << '\n';
      const std::string note = reports::mobility_note(options->law);
      if (!note.empty()) std::cerr << "note: " << note << '\n';
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

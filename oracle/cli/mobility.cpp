#include <iostream>

#include "lubjoint/film/every_law.hpp"
#include "oracle/cli/bearing_options.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/files/files.hpp"
#include "oracle/results/mobility_table.hpp"

namespace lubjoint::cli {

void add_mobility(CLI::App& app, Action& action) {
  struct Options : BearingOptions {
    std::string law;
    std::string states;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "mobility", "Pure-squeeze velocities at which a film carries given forces, CSV in and out: the inverse of force");
  command->add_option("--law", options->law, "Film law")->required();
  command
      ->add_option("--states", options->states,
                   "CSV with ex_over_c,ey_over_c and fx,fy, the force on the\njournal [N]; - is stdin")
      ->required();
  options->add(*command);
  command->callback([options, &action] {
    action = [options] {
      require_name("--law", options->law, every_film_law_name);
      const Bearing<double> bearing = options->bearing();
      const Lubricant<double> oil = options->oil();
      const reports::CsvTable states(reports::read_input(options->states), reports::input_name(options->states));
      const std::string csv = reports::mobility_csv(states, options->law, bearing, oil);
      const std::string note = reports::mobility_note(options->law);
      if (!note.empty()) std::cerr << "note: " << note << '\n';
      std::cout << csv;
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/cli/bearing_options.hpp"
#include "oracle/cli/law_option.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/cli/state_rows.hpp"
#include "oracle/results/coefficient_table.hpp"
#include "oracle/results/losses_table.hpp"

namespace lubjoint::cli {

namespace {

/// What a user should know of the side flow and of the shear of a compiled law, a line each.
std::string solved_words(const std::string& law, ShearExtent shear) {
  return with_film_law<NamedFilmLaws>(law, [shear]<class Law>() {
    std::string words = fmt::format(
        "side flow: not of the table, but solved for at each state, within {:g} of what the motion displaces, "
        "2cRL|u|\n",
        reports::solved_flow_tolerance(FreeBoundaryLaw<Law>));
    if (reports::has_solved_couette<Law>(shear)) {
      words += fmt::format(
          "shear: of where the film carries pressure, solved for at each state, within {:g} of the torque of the "
          "shear\n",
          reports::solved_couette_tolerance);
    }
    return words;
  });
}

}  // namespace

void add_losses(CLI::App& app, Action& action) {
  struct LossesOptions : BearingOptions {
    std::string law;
    std::string states;
    std::string shear = "film";
  };
  auto options = std::make_shared<LossesOptions>();
  CLI::App* command = app.add_subcommand("losses", words_of("losses"));
  command->add_option("--law", options->law, "Film law")->required();
  command
      ->add_option("--states", options->states,
                   "CSV with ex,ey,vx,vy,omega_bearing,omega_journal (SI, inertial);\n- is stdin")
      ->required();
  options->add(*command);
  command->add_option("--shear", options->shear,
                      "What is sheared: film (where the law's film is; default), flooded\n(the whole gap) or striated "
                      "(half films: streaks behind the minimum film)");
  command->callback([options, &action] {
    action = [options] {
      require_name("--law", options->law, named_film_laws);
      require_name("--shear", options->shear, shear_extent_names);
      const ShearExtent shear = shear_extent(options->shear);
      with_film_law<NamedFilmLaws>(options->law, [&]<class Law>() { reports::require_solvable_shear<Law>(shear); });
      const Bearing<double> bearing = options->bearing();
      require_law_of_bearing(options->law, bearing);
      const Lubricant<double> oil = options->oil();
      reports::FilmInBearing film{options->law, bearing, oil};
      double farthest = 0;
      answer_stream("losses", options->states, [&](reports::CsvStream& states, const auto& write) {
        film = film_in_bearing(options->law, bearing, oil);  // once there are states: it may take a minute
        if (film.table != nullptr) std::cerr << solved_words(options->law, shear);
        constexpr std::array given = {"ex", "ey", "vx", "vy", "omega_bearing", "omega_journal"};
        answer_numbers(states, given, reports::loss_column_names, write, [&](const std::array<double, 6>& x) {
          farthest = std::max(farthest, std::hypot(x[0], x[1]) / bearing.clearance());
          return reports::loss_columns(film, shear, {{x[0], x[1]}, {x[2], x[3]}, x[4], x[5]});
        });
      });
      const std::string beyond = reports::beyond_table_note(film, farthest);
      if (!beyond.empty()) std::cerr << "warning: " << beyond << '\n';
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

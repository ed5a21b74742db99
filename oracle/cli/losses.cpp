#include <array>
#include <stdexcept>

#include "lubjoint/film/every_law.hpp"
#include "oracle/cli/bearing_options.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/cli/state_rows.hpp"
#include "oracle/results/losses_table.hpp"

namespace lubjoint::cli {

namespace {

/// Adds the losses to every row of a stream with ex, ey, vx, vy, omega_bearing and omega_journal.
/// @throws reports::CsvError that names file and line
template <class Write, class Answer>
void answer_motions(reports::CsvStream& states, const Write& write, const Answer& answer) {
  std::array<std::size_t, 6> columns{};
  constexpr std::array names = {"ex", "ey", "vx", "vy", "omega_bearing", "omega_journal"};
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i] = states.header().column(names[i]);
  const AnsweredRows rows(states, reports::loss_column_names);
  write(rows.header());
  while (states.next()) {
    std::array<double, 6> given{};
    for (std::size_t i = 0; i < columns.size(); ++i) given[i] = states.number(columns[i]);
    try {
      write(rows.row() + answer({{given[0], given[1]}, {given[2], given[3]}, given[4], given[5]}) + "\n");
    } catch (const FilmDomainError& error) {
      states.refuse(error.what());
    } catch (const std::range_error& error) {
      states.refuse(error.what());
    }
  }
}

}  // namespace

void add_losses(CLI::App& app, Action& action) {
  struct Options : BearingOptions {
    std::string law;
    std::string states;
    std::string shear = "film";
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("losses", "Friction torques, power and side flow of a film at given motions, CSV in and out");
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
      require_name("--law", options->law, every_film_law_name);
      require_name("--shear", options->shear, shear_extent_names);
      const ShearExtent shear = shear_extent(options->shear);
      with_every_film_law(options->law, [&]<class Law>() { return sheared_gap<Law>(shear); });  // refuses
      const Bearing<double> bearing = options->bearing();
      const Lubricant<double> oil = options->oil();
      answer_stream("losses", options->states, [&](reports::CsvStream& states, const auto& write) {
        answer_motions(states, write, [&](const JournalMotion<double>& motion) {
          return reports::loss_columns(options->law, bearing, oil, shear, motion);
        });
      });
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

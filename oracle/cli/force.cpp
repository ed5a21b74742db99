#include <iostream>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/film/squeeze_only.hpp"
#include "oracle/cli/bearing_options.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/cli/state_rows.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::cli {

namespace {

/// The law in extended precision, rounded once: what is printed is right to the last digit of a double.
template <FilmLaw Law>
std::string forces(const reports::CsvTable& states, const Bearing<double>& bearing, const Lubricant<double>& oil) {
  using Wide = long double;
  const Bearing<Wide> wide_bearing(bearing.length(), bearing.radius(), bearing.clearance());
  const Lubricant<Wide> wide_oil(oil.viscosity());
  std::vector<std::string> names = {"radial", "tangential"};
  if constexpr (Law::extent == FilmExtent::dynamic) names.insert(names.end(), {"theta_s", "theta_e"});
  return answered_rows(states, names, [&](const PolarFilmState<double>& state) {
    const PolarFilmState<Wide> wide(state.eccentricity_ratio, state.slip_rate, state.squeeze_rate);
    const PolarForce<Wide> force = film_force<Law>(wide_bearing, wide_oil, wide);
    std::vector<double> answer = {static_cast<double>(force.radial), static_cast<double>(force.tangential)};
    if constexpr (Law::extent == FilmExtent::dynamic) {
      const FilmBounds<double> bounds = film_bounds(Law::extent, state_of_film<Law>(state));
      answer.insert(answer.end(), {bounds.start, bounds.end});
    }
    return answer;
  });
}

}  // namespace

void add_force(CLI::App& app, Action& action) {
  struct Options : BearingOptions, StatesOption {
    std::string law;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("force", "Film force of a law at given states, CSV in and out");
  command->add_option("--law", options->law, "Film law")->required();
  options->add_states(*command);
  options->add(*command);
  command->callback([options, &action] {
    action = [options] {
      require_name("--law", options->law, every_film_law_name);
      const Bearing<double> bearing = options->bearing();
      const Lubricant<double> oil = options->oil();
      const reports::CsvTable states = options->read_states();
      std::cout << with_every_film_law(options->law, [&]<class Law>() { return forces<Law>(states, bearing, oil); });
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

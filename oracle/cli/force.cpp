#include "lubjoint/film/every_law.hpp"
#include "lubjoint/film/squeeze_only.hpp"
#include "oracle/cli/bearing_options.hpp"
#include "oracle/cli/law_option.hpp"
#include "oracle/cli/state_rows.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::cli {

namespace {

/// The law in extended precision, rounded once: what is printed is right to the last digit of a double.
template <AnyFilmLaw Law, class Write>
void forces(reports::CsvStream& states, const Bearing<double>& bearing, const Lubricant<double>& oil,
            const Write& write) {
  using Wide = long double;
  const Bearing<Wide> wide_bearing(bearing.length(), bearing.radius(), bearing.clearance());
  const Lubricant<Wide> wide_oil(oil.viscosity());
  std::vector<std::string> names = {"radial", "tangential"};
  if constexpr (Law::extent == FilmExtent::dynamic) names.insert(names.end(), {"theta_s", "theta_e"});
  const auto answer = [&](const PolarFilmState<double>& state) {
    const PolarFilmState<Wide> wide(state.eccentricity_ratio, state.slip_rate, state.squeeze_rate);
    const PolarForce<Wide> force = film_force<Law>(wide_bearing, wide_oil, wide);
    std::vector<double> values = {static_cast<double>(force.radial), static_cast<double>(force.tangential)};
    if constexpr (Law::extent == FilmExtent::dynamic) {
      const FilmBounds<double> bounds = film_bounds(Law::extent, state_of_film<Law>(state));
      values.insert(values.end(), {bounds.start, bounds.end});
    }
    return values;
  };
  answer_rows(states, names, answer, write);
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
      const Bearing<double> bearing = options->bearing();
      require_law_of_bearing(options->law, bearing);
      const Lubricant<double> oil = options->oil();
      answer_stream("force", options->states, [&](reports::CsvStream& states, const auto& write) {
        with_film_law<EveryFilmLaw>(options->law, [&]<class Law>() { forces<Law>(states, bearing, oil, write); });
      });
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

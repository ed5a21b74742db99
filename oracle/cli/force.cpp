#include "lubjoint/film/every_law.hpp"
#include "lubjoint/film/squeeze_only.hpp"
#include "oracle/cli/bearing_options.hpp"
#include "oracle/cli/compiled_film.hpp"
#include "oracle/cli/law_option.hpp"
#include "oracle/cli/name_option.hpp"
#include "oracle/cli/programs.hpp"
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

/// A law that is a table: in double precision, as its error is far above a double's.
template <CompiledLaw Law, class Write>
std::size_t compiled_forces(const Law& law, const CompiledFilm& film, reports::CsvStream& states,
                            const Bearing<double>& bearing, const Lubricant<double>& oil, const Write& write) {
  constexpr bool dynamic = std::is_same_v<Law, FiniteDynamic>;  // the bounds of finite_reynolds are not known to it
  std::vector<std::string> names = {"radial", "tangential"};
  if constexpr (dynamic) names.insert(names.end(), {"theta_s", "theta_e"});
  std::size_t beyond = 0;
  const auto answer = [&](const PolarFilmState<double>& state) {
    beyond += state.eccentricity_ratio > film.ratio_limit ? 1 : 0;
    const PolarForce<double> force = film_force(law, bearing, oil, state);
    std::vector<double> values = {force.radial, force.tangential};
    if constexpr (dynamic) {
      const FilmBounds<double> bounds = film_bounds(Law::extent, state);
      values.insert(values.end(), {bounds.start, bounds.end});
    }
    return values;
  };
  answer_rows(states, names, answer, write);
  return beyond;
}

void answer_with_compiled_law(const std::string& name, const std::string& states_file, const Bearing<double>& bearing,
                              const Lubricant<double>& oil) {
  const double shape = length_to_diameter(bearing);
  require_option("--length over twice --radius", shape,
                 shape >= least_compiled_shape && shape <= largest_compiled_shape,
                 fmt::format("a number from {} to {} with {}", least_compiled_shape, largest_compiled_shape, name));
  CompiledFilm film;
  std::size_t beyond = 0;
  answer_stream("force", states_file, [&](reports::CsvStream& states, const auto& write) {
    film = film_for_user(name, shape);  // once there are states: it may take a minute
    with_compiled_law(film, [&](const auto& law) { beyond = compiled_forces(law, film, states, bearing, oil, write); });
  });
  std::cerr << stated_error(film) << '\n';
  if (beyond > 0) {
    std::cerr << fmt::format(
        "warning: {} of the states have an eccentricity ratio above {}, where that bound was not measured\n", beyond,
        film.ratio_limit);
  }
}

}  // namespace

void add_force(CLI::App& app, Action& action) {
  struct ForceOptions : BearingOptions, StatesOption {
    std::string law;
  };
  auto options = std::make_shared<ForceOptions>();
  CLI::App* command = app.add_subcommand("force", words_of("force"));
  command->add_option("--law", options->law, "Film law")->required();
  options->add_states(*command);
  options->add(*command);
  command->callback([options, &action] {
    action = [options] {
      require_name("--law", options->law, named_film_laws);
      const Bearing<double> bearing = options->bearing();
      const Lubricant<double> oil = options->oil();
      if (is_compiled_law(options->law)) {
        answer_with_compiled_law(options->law, options->states, bearing, oil);
        return 0;
      }
      require_law_of_bearing(options->law, bearing);
      answer_stream("force", options->states, [&](reports::CsvStream& states, const auto& write) {
        with_film_law<EveryFilmLaw>(options->law, [&]<class Law>() { forces<Law>(states, bearing, oil, write); });
      });
      return 0;
    };
  });
}

}  // namespace lubjoint::cli

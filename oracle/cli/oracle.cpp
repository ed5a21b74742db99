#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "lubjoint/film/extent.hpp"
#include "oracle/cli/bearing_options.hpp"
#include "oracle/cli/programs.hpp"
#include "oracle/cli/state_rows.hpp"
#include "oracle/files/files.hpp"
#include "oracle/laws/pinkus_sternlicht_report.hpp"
#include "oracle/results/pressure_report.hpp"
#include "oracle/reynolds/film_integral.hpp"
#include "oracle/reynolds/film_onset.hpp"
#include "oracle/reynolds/finite_length.hpp"
#include "oracle/reynolds/solved_film.hpp"

namespace lubjoint::cli {

namespace {

bool is_finite_film(const std::string& name) { return !oracle::is_one_dimensional(name); }

/// @throws std::invalid_argument that lists all films, of either kind
void require_film(const std::string& name) { oracle::require_solved_film(name, "--film"); }

oracle::FilmOnset onset_of(const std::string& film, const std::optional<std::string>& given) {
  return oracle::film_onset_of(film, given, "--onset");
}

/// @throws std::invalid_argument  no rule, or one for a film that is not integrated by it
oracle::FilmQuadratureRule rule_of(const std::string& film, const std::optional<std::string>& given) {
  if (given && is_finite_film(film)) {
    throw std::invalid_argument("--rule has no effect on " + film + "; allowed with the one-dimensional films alone");
  }
  const std::string name = given.value_or("gauss_legendre");
  const auto& names = oracle::film_quadrature_rule_names;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<oracle::FilmQuadratureRule>(found - names.begin());
  std::string all;
  for (const std::string_view each : names) all += (all.empty() ? "" : ", ") + std::string(each);
  throw std::invalid_argument("--rule is \"" + name + "\"; allowed are " + all);
}

/// A film in a bearing.
struct FilmOptions : BearingOptions {
  std::string film;
  std::optional<std::string> onset;

  void add(CLI::App& command) {
    command.add_option("--film", film, "short_full … long_dynamic, or finite_full … finite_reynolds")->required();
    command.add_option("--onset", onset, "Onset of finite_reynolds: free (default) or maximum_film");
    BearingOptions::add(command);
  }
};

struct ForceOptions : FilmOptions, StatesOption {
  std::optional<std::string> rule;
  std::optional<double> rtol;
};

std::vector<std::string> force_columns(bool dynamic) {
  if (!dynamic) return {"radial", "tangential", "radial_error", "tangential_error"};
  return {"radial", "tangential", "theta_s", "theta_e", "radial_error", "tangential_error"};
}

template <class Write>
void one_dimensional_forces(const ForceOptions& options, reports::CsvStream& states, const Write& write) {
  const auto film = oracle::one_dimensional_film(options.film);
  const oracle::FilmQuadratureOptions how{rule_of(options.film, options.rule), options.rtol.value_or(1e-13)};
  const bool dynamic = oracle::entry_of(film).extent() == FilmExtent::dynamic;
  const Bearing<double> bearing = options.bearing();
  const Lubricant<double> oil = options.oil();
  const auto answer = [&](const PolarFilmState<double>& state) {
    const auto force = film_force_by_quadrature(film, bearing, oil, state, how);
    std::vector<double> values = {force.radial.value, force.tangential.value};
    if (dynamic) values.insert(values.end(), {force.theta_s, force.theta_e});
    values.insert(values.end(), {force.radial.error, force.tangential.error});
    return values;
  };
  answer_rows(states, force_columns(dynamic), answer, write);
}

/// Up to here the grids of finite_reynolds resolve the film (finite_length.hpp).
constexpr double meant_up_to = 0.99;

/// Rows of finite-length films that are less certain than asked for.
struct Doubts {
  std::size_t coarse = 0;  ///< whose error estimate is not within the tolerance
  std::size_t thin = 0;    ///< of finite_reynolds at ratios for which it is not meant

  std::string warning(double tolerance) const {
    std::string text;
    if (coarse > 0) {
      text +=
          fmt::format("warning: {} of the forces could not be had to {:g} of |F|; their error columns say to what\n",
                      coarse, tolerance);
    }
    if (thin > 0) {
      text += fmt::format(
          "warning: {} of the states have an eccentricity ratio above {}, where the grids of finite_reynolds no longer "
          "resolve the film: its forces there may be off by several per cent, and more than the error columns say\n",
          thin, meant_up_to);
    }
    return text;
  }
};

template <class Write>
void finite_forces(const ForceOptions& options, reports::CsvStream& states, const Write& write) {
  const auto film = oracle::finite_film_of(options.film);
  const oracle::FiniteLengthOptions how{options.rtol.value_or(1e-3), onset_of(options.film, options.onset)};
  const bool dynamic = film == oracle::FiniteFilm::finite_dynamic;
  const Bearing<double> bearing = options.bearing();
  const Lubricant<double> oil = options.oil();
  Doubts doubts;
  const auto answer = [&](const PolarFilmState<double>& state) {
    const auto force = finite_length_force(film, bearing, oil, state, how);
    doubts.coarse += force.tolerance_met ? 0 : 1;
    doubts.thin += film == oracle::FiniteFilm::finite_reynolds && state.eccentricity_ratio > meant_up_to ? 1 : 0;
    std::vector<double> values = {force.radial, force.tangential};
    if (dynamic) {
      const FilmBounds<double> bounds = film_bounds(FilmExtent::dynamic, state);
      values.insert(values.end(), {bounds.start, bounds.end});
    }
    values.insert(values.end(), {force.radial_error, force.tangential_error});
    return values;
  };
  answer_rows(states, force_columns(dynamic), answer, write);
  std::cerr << doubts.warning(how.relative_tolerance);
}

void add_oracle_force(CLI::App& parent, Action& action) {
  auto options = std::make_shared<ForceOptions>();
  CLI::App* command = parent.add_subcommand("force", "Film force by integrating the pressure, CSV in and out");
  options->add_states(*command);
  command->add_option("--rule", options->rule, "Quadrature rule of the one-dimensional films (gauss_legendre)");
  command->add_option("--rtol", options->rtol, "Tolerance relative to |F| (1e-13; finite films 1e-3)");
  options->add(*command);
  command->callback([options, &action] {
    action = [options] {
      require_film(options->film);
      rule_of(options->film, options->rule);
      onset_of(options->film, options->onset);
      if (options->rtol) {
        const bool finite = is_finite_film(options->film);
        require_option("--rtol", *options->rtol,
                       finite ? *options->rtol >= 1e-12 && *options->rtol <= 0.1
                              : *options->rtol >= 1e-15 && *options->rtol <= 0.1,
                       finite ? "a number from 1e-12 to 0.1" : "a number from 1e-15 to 0.1");
      }
      options->bearing();
      options->oil();
      answer_stream("oracle force", options->states, [&](reports::CsvStream& states, const auto& write) {
        is_finite_film(options->film) ? finite_forces(*options, states, write)
                                      : one_dimensional_forces(*options, states, write);
      });
      return 0;
    };
  });
}

void add_oracle_pressure(CLI::App& parent, Action& action) {
  struct OracleOptions : FilmOptions {
    double ratio = 0;
    double slip = 0;
    double squeeze = 0;
    int angles = 181;
    int stations = 21;
    std::optional<std::string> out;
  };
  auto options = std::make_shared<OracleOptions>();
  CLI::App* command = parent.add_subcommand("pressure", "Pressure field of one state as CSV theta,z,pressure");
  command->add_option("--eccentricity-ratio", options->ratio, "In [0, 1)")->required();
  command->add_option("--slip-rate", options->slip, "a [1/s]")->required();
  command->add_option("--squeeze-rate", options->squeeze, "b [1/s]")->required();
  command->add_option("--angles", options->angles, "Number of angles, 0 to 2 pi")->capture_default_str();
  command->add_option("--stations", options->stations, "Number of stations along z")->capture_default_str();
  command->add_option("--out", options->out, "Folder for pressure.csv and a plot, in place of standard output");
  options->add(*command);
  command->callback([options, &action] {
    action = [options] {
      require_film(options->film);
      const auto onset = onset_of(options->film, options->onset);
      require_option("--angles", options->angles, options->angles >= 3 && options->angles <= 10000, "3 to 10000");
      require_option("--stations", options->stations, options->stations >= 3 && options->stations <= 1000, "3 to 1000");
      const PolarFilmState<double> state(options->ratio, options->slip, options->squeeze);
      const Bearing<double> bearing = options->bearing();
      const Lubricant<double> oil = options->oil();
      const oracle::PressureField field =
          is_finite_film(options->film)
              ? finite_length_pressure(oracle::finite_film_of(options->film), bearing, oil, state, options->angles,
                                       options->stations, onset)
              : reports::one_dimensional_pressure(oracle::one_dimensional_film(options->film), bearing, oil, state,
                                                  options->angles, options->stations);
      const std::string csv = reports::pressure_csv(field);
      if (!options->out) {
        std::cout << csv;
        return 0;
      }
      reports::prepare_folder(*options->out);
      reports::write_file(std::filesystem::path(*options->out) / "pressure.csv", csv);
      reports::draw_pressure(field, options->film, state, *options->out);
      std::cerr << "pressure.csv, pressure.svg and pressure.png written to " << *options->out << '\n';
      return 0;
    };
  });
}

void add_oracle_difference(CLI::App& parent, Action& action) {
  auto out = std::make_shared<std::optional<std::string>>();
  CLI::App* command =
      parent.add_subcommand("difference", "Pinkus-Sternlicht against the long dynamic film, by squeeze");
  command->add_option("--out", *out, "Folder for pinkus-sternlicht-difference.csv and a plot");
  command->callback([out, &action] {
    action = [out] {
      if (*out) reports::prepare_folder(**out);
      const auto differences = reports::pinkus_sternlicht_difference(reports::DifferenceGrid::uniform(0.97, 97, 360));
      std::cout << reports::difference_text(differences);
      if (*out) {
        const auto rows = reports::by_ratio(differences);
        const std::string name = "pinkus-sternlicht-difference";
        reports::write_file(std::filesystem::path(**out) / (name + ".csv"), reports::difference_csv(rows));
        reports::draw_difference(rows, **out, name);
        std::cerr << name << ".csv, .svg and .png written to " << **out << '\n';
      }
      return 0;
    };
  });
}

}  // namespace

void add_oracle(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("oracle", words_of("oracle"));
  command->require_subcommand(1);
  add_oracle_force(*command, action);
  add_oracle_pressure(*command, action);
  add_oracle_difference(*command, action);
}

}  // namespace lubjoint::cli

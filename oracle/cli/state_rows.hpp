/// CSV of film states in, the same rows with columns added out.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "lubjoint/film/film_state.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"

namespace lubjoint::cli {

/// The option that names the CSV of states.
struct StatesOption {
  std::string states;

  void add_states(CLI::App& command) {
    command.add_option("--states", states, "CSV with eccentricity_ratio,slip_rate,squeeze_rate; - is stdin")
        ->required();
  }
  /// @throws std::invalid_argument if it can't be read, reports::CsvError if it is none
  reports::CsvTable read_states() const { return {reports::read_input(states), reports::input_name(states)}; }
};

/// Adds columns to every row of a table with eccentricity_ratio, slip_rate and squeeze_rate.
/// @param answer  gives the added numbers of a PolarFilmState<double>, as many as there are names
/// @throws reports::CsvError that names file and line if a state is impossible or an answer is not finite
template <class Answer>
std::string answered_rows(const reports::CsvTable& states, const std::vector<std::string>& names,
                          const Answer& answer) {
  const std::size_t ratio = states.column("eccentricity_ratio");
  const std::size_t slip = states.column("slip_rate");
  const std::size_t squeeze = states.column("squeeze_rate");
  std::string csv = states.header();
  for (const std::string& name : names) csv += "," + name;
  csv += '\n';
  for (std::size_t row = 0; row < states.rows(); ++row) {
    csv += states.line(row);
    try {
      const PolarFilmState<double> state(states.number(row, ratio), states.number(row, slip),
                                         states.number(row, squeeze));
      for (const double value : answer(state)) {
        if (!std::isfinite(value)) {
          states.refuse(row, "the force is beyond the range of double precision; allowed are smaller rates");
        }
        csv += fmt::format(",{}", value);
      }
    } catch (const FilmDomainError& error) {
      states.refuse(row, error.what());
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace lubjoint::cli

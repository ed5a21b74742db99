/// CSV of states in, the same rows with columns added out.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "lubjoint/film/film_state.hpp"
#include "oracle/cli/command.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/progress.hpp"
#include "oracle/files/quoted_csv.hpp"
#include "oracle/files/streams.hpp"

namespace lubjoint::cli {

/// The option that names the CSV of states.
struct StatesOption {
  std::string states;

  void add_states(CLI::App& command) {
    command.add_option("--states", states, "CSV with eccentricity_ratio,slip_rate,squeeze_rate; - is stdin")
        ->required();
  }
};

/// Rows of a stream with columns added. One that has the name of an added column is replaced: an answer can be given
/// back as states.
class AnsweredRows {
 public:
  AnsweredRows(const reports::CsvStream& given, const std::vector<std::string>& names) : given_(given) {
    const std::vector<std::string>& columns = given.header().columns();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (std::find(names.begin(), names.end(), columns[i]) == names.end()) kept_.push_back(i);
    }
    const bool all = kept_.size() == columns.size();
    header_ = all ? given.header().line() : "";
    for (const std::size_t i : kept_) {
      if (!all) add_to(header_, reports::quoted_field(columns[i]));
    }
    for (const std::string& name : names) add_to(header_, name);
    header_ += '\n';
  }

  const std::string& header() const { return header_; }
  /// The row as it was given, without the columns that are replaced.
  std::string row() const {
    if (kept_.size() == given_.header().columns().size()) return given_.line();
    std::string row;
    for (const std::size_t i : kept_) add_to(row, given_.raw_field(i));
    return row;
  }

 private:
  static void add_to(std::string& row, std::string_view field) {
    if (!row.empty()) row += ',';
    row += field;
  }

  const reports::CsvStream& given_;
  std::vector<std::size_t> kept_;
  std::string header_;
};

/// Adds columns to every row of a stream with eccentricity_ratio, slip_rate and squeeze_rate.
/// @param answer  gives the added numbers of a PolarFilmState<double>, as many as there are names
/// @param write   takes the header and every row, with its line end
/// @throws reports::CsvError that names file and line if a state is impossible or an answer is not finite
template <class Answer, class Write>
void answer_rows(reports::CsvStream& states, const std::vector<std::string>& names, const Answer& answer,
                 const Write& write) {
  const std::size_t ratio = states.header().column("eccentricity_ratio");
  const std::size_t slip = states.header().column("slip_rate");
  const std::size_t squeeze = states.header().column("squeeze_rate");
  const AnsweredRows rows(states, names);
  write(rows.header());
  while (states.next()) {
    std::string csv = rows.row();
    try {
      const PolarFilmState<double> state(states.number(ratio), states.number(slip), states.number(squeeze));
      for (const double value : answer(state)) {
        if (!std::isfinite(value)) {
          states.refuse("the force is beyond the range of double precision; allowed are smaller rates");
        }
        csv += fmt::format(",{}", value);
      }
    } catch (const FilmDomainError& error) {
      states.refuse(error.what());
    }
    csv += '\n';
    write(csv);
  }
}

/// The same of any columns of numbers, with fields of any kind.
/// @param given  names of the columns that are read;  @param answer  gives the added fields of their numbers, each
///   behind its comma; std::range_error and FilmDomainError are refusals of the row
template <std::size_t N, class Write, class Answer>
void answer_numbers(reports::CsvStream& states, const std::array<const char*, N>& given,
                    const std::vector<std::string>& names, const Write& write, const Answer& answer) {
  std::array<std::size_t, N> columns{};
  for (std::size_t i = 0; i < N; ++i) columns[i] = states.header().column(given[i]);
  const AnsweredRows rows(states, names);
  write(rows.header());
  while (states.next()) {
    std::array<double, N> numbers{};
    for (std::size_t i = 0; i < N; ++i) numbers[i] = states.number(columns[i]);
    try {
      write(rows.row() + answer(numbers) + "\n");
    } catch (const FilmDomainError& error) {
      states.refuse(error.what());
    } catch (const std::range_error& error) {
      states.refuse(error.what());
    }
  }
}

/// Answers a file of states, or standard input, on standard output: a row at a time, with progress on a terminal.
/// @param answer  writes header and rows: answer(CsvStream&, write)
template <class Answer>
void answer_stream(const std::string& command, const std::string& name, const Answer& answer) {
  reports::InputStream input(name);
  reports::CsvStream states(input.stream(), reports::input_name(name));
  reports::HeldOutput output(std::cout);
  reports::ProgressBar progress(command, input.size());
  std::size_t rows = 0;
  answer(states, [&](std::string_view row) {
    output.write(row);
    progress.reach(rows++, states.bytes());
  });
  if (input.stream().bad()) {
    throw std::invalid_argument("\"" + name +
                                "\" can't be read to its end; allowed is a file, or - for standard input");
  }
  output.finish();
}

}  // namespace lubjoint::cli

/// What the files of films of finite length share: how numbers are printed, how rows are made, and made again.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>
#include <vector>

#include "oracle/certified/golden.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/parallel.hpp"

namespace lubjoint::certified {

/// Shortest text that reads back as the same double.
inline std::string exact(double value) { return reports::number(value); }

inline std::string rounded(double value, int digits) { return fmt::format("{:.{}g}", value, digits); }

/// To a hundredth of an uncertainty; no minus before a zero.
inline std::string rounded_to(double value, double uncertainty) {
  const int decimals = std::max(0, 2 - static_cast<int>(std::floor(std::log10(uncertainty))));
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.find_first_of("123456789") == std::string::npos ? "0" : text;
}

/// The first fields of a row, with the comma behind them.
inline std::string first_fields(const std::string& row, int count) {
  std::size_t end = 0;
  for (int comma = 0; comma < count; ++comma) end = row.find(',', end) + 1;
  return row.substr(0, end);
}

/// Calls work(i) for all i on run.threads threads, and tells of each that is done.
template <class Work>
void in_parallel(const GoldenRun& run, std::size_t count, const Work& work) {
  std::mutex mutex;
  std::size_t done = 0;
  reports::run_parallel(count, run.threads ? run.threads : reports::available_cores(), [&](std::size_t i) {
    work(i);
    const std::lock_guard lock(mutex);
    run.progress(++done, count);
  });
}

/// A file with a row for each of some states, which its first columns name.
struct FiniteFile {
  const char* name;
  const char* header;
  int inputs;  ///< columns of the state
};

/// The file's text.
/// @param row  row(state), a line
template <class State, class Row>
std::string finite_csv(const FiniteFile& file, const std::vector<State>& states, const GoldenRun& run, const Row& row) {
  std::vector<std::string> rows(states.size());
  in_parallel(run, rows.size(), [&](std::size_t i) { rows[i] = row(states[i]); });
  std::string text = std::string(file.header) + "\n";
  for (const std::string& each : rows) text += each + "\n";
  return text;
}

/// What of the file's text is not as it is made again, one row in run.every; in the order of its lines.
/// @param make  make(state), the numbers;  @param row  row(state, numbers), a line
/// @param hold  hold(table, i, numbers, tell) compares line i, and calls tell(column, what) for what differs
template <class State, class Make, class Row, class Hold>
std::vector<reports::GoldenDifference> finite_differences(const FiniteFile& file, const std::vector<State>& states,
                                                          const std::string& text, const GoldenRun& run,
                                                          const Make& make, const Row& row, const Hold& hold) {
  const reports::CsvTable table(text, file.name);
  if (table.header() != file.header || table.rows() != states.size())
    return {{file.name, 1, "", "other columns or another number of rows than are made"}};
  std::vector<reports::GoldenDifference> differences;
  const std::size_t every = std::max<std::size_t>(run.every, 1);
  std::mutex mutex;
  in_parallel(run, (states.size() + every - 1) / every, [&](std::size_t job) {
    const std::size_t i = job * every;
    const auto made = make(states[i]);
    const auto tell = [&](const std::string& column, const std::string& what) {
      const std::lock_guard lock(mutex);
      differences.push_back({file.name, i + 2, column, what});
    };
    const std::string state = first_fields(row(states[i], made), file.inputs);
    if (first_fields(table.line(i), file.inputs) != state) return tell("", "another state than " + state);
    hold(table, i, made, tell);
  });
  std::ranges::sort(differences, {}, &reports::GoldenDifference::line);
  return differences;
}

}  // namespace lubjoint::certified

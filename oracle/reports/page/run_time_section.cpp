#include <fmt/format.h>

#include <array>
#include <map>

#include "oracle/reports/page/sections.hpp"

namespace lubjoint::reports::page {

namespace {

constexpr std::array<double, 3> bounds = {1e-3, 1e-6, 1e-9};

std::string milliseconds(double seconds) { return fmt::format("{:.3g} ms", 1e3 * seconds); }

/// The integrator that is first within an error, for each scene and formulation, in the order of the data.
std::string fastest_table(const std::vector<RunTimeRow>& rows) {
  Table table("Which integrator to use: the fastest that is within an error, with its time",
              {{"scene", {}, false},
               {"coordinates", {}, false},
               {"error up to 10⁻³ c", {}, false},
               {"10⁻⁶ c", {}, false},
               {"10⁻⁹ c", {}, false}});
  using Key = std::pair<std::string, std::string>;
  std::vector<Key> order;
  std::map<Key, std::array<const RunTimeRow*, bounds.size()>> best;
  for (const RunTimeRow& row : rows) {
    const Key key{row.scene, row.formulation};
    if (!best.contains(key)) {
      order.push_back(key);
      best[key].fill(nullptr);
    }
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      const RunTimeRow*& first = best[key][i];
      if (row.error && *row.error <= bounds[i] && (!first || *row.seconds < *first->seconds)) first = &row;
    }
  }
  for (const Key& key : order) {
    std::vector<Cell> cells{key.first, key.second};
    for (const RunTimeRow* row : best[key]) {
      cells.emplace_back(row ? row->integrator + ", " + milliseconds(*row->seconds) : "none");
    }
    table.row(std::move(cells));
  }
  return table.html();
}

/// Runs that gave up, and runs that are far off without saying so.
std::string failed_table(const std::vector<RunTimeRow>& rows) {
  Table table("Runs that stopped, and runs that are wrong by more than 10⁻² c", {{"scene", {}, false},
                                                                                 {"coordinates", {}, false},
                                                                                 {"integrator", {}, false},
                                                                                 {"tolerance"},
                                                                                 {"error", "c"},
                                                                                 {"what happened", {}, false}});
  std::size_t count = 0;
  for (const RunTimeRow& row : rows) {
    const bool stopped = row.status == RowStatus::stopped;
    if (!stopped && row.error && *row.error <= 1e-2) continue;
    table.row({row.scene, row.formulation, row.integrator, scientific(row.tolerance, 0),
               row.error ? scientific(*row.error) : "–",
               stopped ? "stopped: " + (row.message.empty() ? "no reason given" : row.message)
                       : std::string("finished, without noticing")});
    ++count;
  }
  if (count == 0) return "<p>Every run finished, within 10⁻² c of the reference.</p>\n";
  return fmt::format(
      "<details>\n<summary>{} runs stopped or are off by more than 10<sup>−2</sup> c</summary>\n{}</details>\n", count,
      table.html());
}

}  // namespace

Section run_time_section(const Content& content) {
  std::string inner =
      "<p>Not measured in this run. <code>./lubjoint bench scenes --out FOLDER</code> writes "
      "<code>bench-scenes.csv</code>, "
      "and "
      "<code>./lubjoint reproduce --data FOLDER</code> puts it here.</p>\n";
  if (content.run_times) {
    inner =
        filled("run-time-plot.html", {{"fastest", fastest_table(content.run_times->rows)},
                                      {"failed", failed_table(content.run_times->rows)},
                                      {"csv", csv_block("csv-run-time", "bench-scenes.csv", content.run_times->csv)}});
  }
  return {"run-time", "Error against run time", filled("run-time.html", {{"content", inner}})};
}

}  // namespace lubjoint::reports::page

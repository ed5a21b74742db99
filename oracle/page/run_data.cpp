#include "oracle/page/run_data.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "oracle/files/csv_table.hpp"

namespace lubjoint::reports::page {

namespace {

constexpr std::pair<std::string_view, RowStatus> of_a_case[] = {{"finished", RowStatus::finished},
                                                                {"coarse", RowStatus::coarse},
                                                                {"unreferenced", RowStatus::unreferenced},
                                                                {"stopped", RowStatus::stopped},
                                                                {"wrong", RowStatus::wrong}};

template <class Words>
RowStatus status_of(const CsvTable& table, std::size_t row, const Words& words) {
  const std::string_view given = table.field(row, table.column("status"));
  std::string allowed;
  for (const auto& [word, status] : words) {
    if (given == word) return status;
    allowed += (allowed.empty() ? "" : ", ") + std::string(word);
  }
  table.refuse(row, "status is \"" + std::string(given) + "\"; allowed are " + allowed);
}

std::string name_in(const CsvTable& table, std::size_t row, const char* column) {
  const std::string_view text = table.field(row, table.column(column));
  if (text.empty()) table.refuse(row, std::string(column) + " is empty; allowed is a name");
  return std::string(text);
}

/// A number from 0 on.
double size_in(const CsvTable& table, std::size_t row, const char* column) {
  const double size = table.number(row, table.column(column));
  if (size < 0) table.refuse(row, std::string(column) + " is negative; allowed are numbers from 0 on");
  return size;
}

/// The same, or nothing where the field is empty.
std::optional<double> known_size_in(const CsvTable& table, std::size_t row, const char* column) {
  if (table.field(row, table.column(column)).empty()) return std::nullopt;
  return size_in(table, row, column);
}

/// The text without what only editors see, so that scripts can split it at line feeds.
std::string plain(std::string_view csv) {
  if (csv.starts_with("\xEF\xBB\xBF")) csv.remove_prefix(3);
  std::string text;
  for (const char c : csv) {
    if (c != '\r') text += c;
  }
  return text;
}

}  // namespace

RunTimes read_run_times(std::string_view csv, const std::string& name) {
  return {plain(csv), read_bench_rows(CsvTable(csv, name)), {}};
}

Stability read_stability(std::string_view csv, const std::string& name) {
  const CsvTable table(csv, name);
  for (const char* shown : {"seconds", "steps"}) table.column(shown);
  const std::vector<std::string>& columns = table.columns();
  const bool compares_all = std::find(columns.begin(), columns.end(), "program") != columns.end();
  Stability result{plain(csv), {}};
  std::set<std::tuple<std::string, std::string, std::string>> seen;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    StabilityRow row;
    row.problem = name_in(table, i, "case");
    row.law = name_in(table, i, "law");
    row.integrator = name_in(table, i, "integrator");
    row.status = status_of(table, i, of_a_case);
    row.error = known_size_in(table, i, "error");
    if (!compares_all) {  // a table from before rates and forces were compared: what finished was not judged as now
      if (row.status == RowStatus::finished) row.status = RowStatus::unreferenced;
    } else {
      row.rate_error = known_size_in(table, i, "rate_error");
      row.force_error = known_size_in(table, i, "force_error");
      row.program = table.field(i, table.column("program"));
    }
    if (row.status == RowStatus::finished && !(row.error && row.rate_error && row.force_error)) {
      table.refuse(i,
                   "a finished run has no error, rate_error or force_error; allowed without them is \"unreferenced\"");
    }
    row.message = table.field(i, table.column("message"));
    if (!seen.emplace(row.problem, row.law, row.integrator).second) {
      table.refuse(i, "case, law and integrator are those of an earlier line; allowed is one line each");
    }
    result.rows.push_back(std::move(row));
  }
  return result;
}

}  // namespace lubjoint::reports::page

#include "oracle/reports/page/run_data.hpp"

#include <set>
#include <tuple>

#include "oracle/reports/csv_table.hpp"

namespace lubjoint::reports::page {

namespace {

RowStatus status_of(const CsvTable& table, std::size_t row) {
  const std::string_view word = table.field(row, table.column("status"));
  if (word == "finished") return RowStatus::finished;
  if (word != "stopped") {
    table.refuse(row, "status is \"" + std::string(word) + "\"; allowed are finished and stopped");
  }
  if (table.field(row, table.column("message")).empty())
    table.refuse(row, "message is empty; required is why the run stopped");
  return RowStatus::stopped;
}

std::string name_in(const CsvTable& table, std::size_t row, const char* column) {
  const std::string_view text = table.field(row, table.column(column));
  if (text.empty()) table.refuse(row, std::string(column) + " is empty; allowed is a name");
  return std::string(text);
}

/// The error of a run that finished; a run that stopped has none, whatever stands there.
std::optional<double> error_of(const CsvTable& table, std::size_t row, RowStatus status) {
  if (status == RowStatus::stopped) return std::nullopt;
  const double error = table.number(row, table.column("error"));
  if (error < 0) table.refuse(row, "error is negative; allowed are numbers from 0 on");
  return error;
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
  const CsvTable table(csv, name);
  for (const char* counted : {"steps", "rejected", "rhs_evaluations", "jacobian_evaluations", "factorisations"}) {
    table.column(counted);
  }
  RunTimes result{plain(csv), {}};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    RunTimeRow row;
    row.scene = name_in(table, i, "scene");
    row.formulation = name_in(table, i, "formulation");
    row.integrator = name_in(table, i, "integrator");
    row.tolerance = table.number(i, table.column("tolerance"));
    row.status = status_of(table, i);
    row.error = error_of(table, i, row.status);
    row.message = table.field(i, table.column("message"));
    row.seconds = table.number(i, table.column("seconds"));
    if (row.seconds < 0) table.refuse(i, "seconds are negative; allowed are numbers from 0 on");
    result.rows.push_back(std::move(row));
  }
  return result;
}

Stability read_stability(std::string_view csv, const std::string& name) {
  const CsvTable table(csv, name);
  for (const char* shown : {"seconds", "steps"}) table.column(shown);
  Stability result{plain(csv), {}};
  std::set<std::tuple<std::string, std::string, std::string>> seen;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    StabilityRow row;
    row.problem = name_in(table, i, "case");
    row.law = name_in(table, i, "law");
    row.integrator = name_in(table, i, "integrator");
    row.status = status_of(table, i);
    row.error = error_of(table, i, row.status);
    row.message = table.field(i, table.column("message"));
    if (!seen.emplace(row.problem, row.law, row.integrator).second) {
      table.refuse(i, "case, law and integrator are those of an earlier line; allowed is one line each");
    }
    result.rows.push_back(std::move(row));
  }
  return result;
}

}  // namespace lubjoint::reports::page

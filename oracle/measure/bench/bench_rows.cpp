#include "oracle/measure/bench/bench_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "oracle/files/files.hpp"

namespace lubjoint::reports {

namespace {

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

/// A count; 0 where the field is empty.
std::size_t count_in(const CsvTable& table, std::size_t row, const char* column) {
  if (table.field(row, table.column(column)).empty()) return 0;
  return static_cast<std::size_t>(size_in(table, row, column));
}

bool is_finished(const CsvTable& table, std::size_t row) {
  const std::string_view status = table.field(row, table.column("status"));
  if (status == "finished") return true;
  if (status == "stopped") return false;
  table.refuse(row, "status is \"" + std::string(status) + "\"; allowed are finished, stopped");
}

}  // namespace

const char* const bench_header =
    "scene,formulation,integrator,tolerance,error,seconds,spread,steps,rejected,rhs_evaluations,jacobian_evaluations,"
    "factorisations,status,message\n";

std::string bench_line(const BenchRow& row) {
  const MethodRun& run = row.run;
  std::string message = run.message;
  std::replace(message.begin(), message.end(), ',', ';');
  const auto known = [&](double value) { return run.finished ? number(value) : std::string(); };
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.scene, row.formulation, row.integrator,
                     number(row.tolerance), known(run.error), known(run.seconds),
                     run.finished ? fmt::format("{:.3g}", run.spread) : "", run.steps, run.rejected,
                     run.rhs_evaluations, run.jacobian_evaluations, run.factorisations,
                     run.finished ? "finished" : "stopped", message);
}

std::vector<BenchRow> read_bench_rows(const CsvTable& table) {
  const bool with_spread = std::ranges::find(table.columns(), "spread") != table.columns().end();
  for (const char* counted : {"steps", "rejected", "rhs_evaluations", "jacobian_evaluations", "factorisations"}) {
    table.column(counted);  // refused here even if there are no rows
  }
  std::vector<BenchRow> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    BenchRow row{name_in(table, i, "scene"),
                 name_in(table, i, "formulation"),
                 name_in(table, i, "integrator"),
                 table.number(i, table.column("tolerance")),
                 {}};
    MethodRun& run = row.run;
    run.finished = is_finished(table, i);
    run.message = table.field(i, table.column("message"));
    if (run.finished) {
      run.error = size_in(table, i, "error");
      run.seconds = size_in(table, i, "seconds");
      if (with_spread) run.spread = size_in(table, i, "spread");
    }
    run.steps = count_in(table, i, "steps");
    run.rejected = count_in(table, i, "rejected");
    run.rhs_evaluations = count_in(table, i, "rhs_evaluations");
    run.jacobian_evaluations = count_in(table, i, "jacobian_evaluations");
    run.factorisations = count_in(table, i, "factorisations");
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace lubjoint::reports

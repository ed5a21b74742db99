/// The lines of the race, as they are kept: bench-scenes.csv.
#pragma once

#include <string>
#include <vector>

#include "oracle/files/csv_table.hpp"
#include "oracle/measure/bench/bench_case.hpp"

namespace lubjoint::reports {

/// One line of the campaign.
struct BenchRow {
  std::string scene;
  std::string formulation;  ///< as BenchCase has it
  std::string integrator;
  double tolerance = 0;
  MethodRun run;
};

/// The header row, with its line end.
extern const char* const bench_header;

std::string bench_line(const BenchRow& row);

/// Columns scene, formulation, integrator, tolerance, error, seconds, steps, rejected, rhs_evaluations,
/// jacobian_evaluations, factorisations, status (finished, stopped), message and, where it was kept, spread; others are
/// left aside. Counts may be empty, and of a run that stopped error and seconds.
/// @throws CsvError that names file, line and column
std::vector<BenchRow> read_bench_rows(const CsvTable& table);

}  // namespace lubjoint::reports

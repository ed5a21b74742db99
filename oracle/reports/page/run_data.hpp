/// Tables that other commands measure and the page shows: read, checked, and kept as they were given.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/reports/bench/bench_rows.hpp"

namespace lubjoint::reports::page {

enum class RowStatus {
  finished,
  coarse,   ///< of extreme cases: finished further off than its tolerance lets one expect, and warned of that itself
  stopped,  ///< with a reason
  wrong     ///< of extreme cases: far from the reference, a number that is none, a stop without a reason
};

/// What `bench scenes` measured.
struct RunTimes {
  std::string csv;
  std::vector<BenchRow> rows;
  std::string measured_by;  ///< program and machine; empty where it is not known
};

/// The columns of read_bench_rows.
/// @param name  of the file, for messages
/// @throws CsvError that names file, line and column
RunTimes read_run_times(std::string_view csv, const std::string& name);

/// One extreme case with one law and one integrator.
struct StabilityRow {
  std::string problem;  ///< column "case"
  std::string law;
  std::string integrator;
  RowStatus status = RowStatus::finished;
  std::optional<double> error;  ///< none without a reference
  std::string message;
};

struct Stability {
  std::string csv;
  std::vector<StabilityRow> rows;
};

/// Columns case, law, integrator, status (finished, coarse, stopped, wrong), error (may be empty), seconds, steps,
/// message.
/// @throws CsvError
Stability read_stability(std::string_view csv, const std::string& name);

}  // namespace lubjoint::reports::page

/// Tables that other commands measure and the page shows: read, checked, and kept as they were given.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/measure/bench/bench_rows.hpp"

namespace lubjoint::reports::page {

enum class RowStatus {
  finished,
  coarse,  ///< of extreme cases: finished further off than its tolerance lets one expect, and warned of that itself
  unreferenced,  ///< of extreme cases: finished, and nothing is known of its error
  stopped,       ///< with a reason
  wrong          ///< of extreme cases: far from the reference, a number that is not finite, a stop without a reason
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
  std::optional<double> error;        ///< of places [clearances]; none where nothing was compared
  std::optional<double> rate_error;   ///< of velocities, over the motion's own
  std::optional<double> force_error;  ///< over the motion's largest
  std::string program;                ///< version and sources that ran it; empty if the file does not say
  std::string message;
};

struct Stability {
  std::string csv;
  std::vector<StabilityRow> rows;
};

/// Columns case, law, integrator, status (finished, coarse, unreferenced, stopped, wrong), error, rate_error,
/// force_error (may be empty; a finished run has all three), seconds, steps, program, message. In a table without
/// rate_error, force_error and program, of before these were compared, what finished counts as unreferenced.
/// @throws CsvError
Stability read_stability(std::string_view csv, const std::string& name);

}  // namespace lubjoint::reports::page

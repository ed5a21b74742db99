/// Tables that other commands measure and the page shows: read, checked, and kept as they were given.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lubjoint::reports::page {

enum class RowStatus {
  finished,
  coarse,   ///< of extreme cases: finished further off than its tolerance lets one expect, and warned of that itself
  stopped,  ///< with a reason
  wrong     ///< of extreme cases: far from the reference, a number that is none, a stop without a reason
};

/// One run of a scene.
struct RunTimeRow {
  std::string scene;
  std::string formulation;  ///< journal, absolute or minimal coordinates
  std::string integrator;
  double tolerance = 0;
  std::optional<double> error;    ///< largest |e − e_ref| over the clearance; none if the run stopped
  std::optional<double> seconds;  ///< none if the run stopped
  RowStatus status = RowStatus::finished;
  std::string message;
};

struct RunTimes {
  std::string csv;
  std::vector<RunTimeRow> rows;
};

/// Columns scene, formulation, integrator, tolerance, error, seconds, steps, rejected, rhs_evaluations,
/// jacobian_evaluations, factorisations, status (finished, stopped), message; others are kept and not shown. Counts may
/// be empty, and of a run that stopped error and seconds.
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

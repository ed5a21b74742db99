/// Tables that other commands measure and the page shows: read, checked, and kept as they were given.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lubjoint::reports::page {

enum class RowStatus {
  finished,
  coarse,  ///< of extreme cases: finished further off than its tolerance lets one expect, and warned of that itself
  unreferenced,  ///< of extreme cases: finished, and nothing is known of its error
  stopped,       ///< with a reason
  wrong          ///< of extreme cases: far from the reference, a number that is none, a stop without a reason
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

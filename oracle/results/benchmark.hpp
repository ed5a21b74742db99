/// Problems that others have published, with their numbers: data/literature/benchmarks.csv and scenes/benchmarks.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace lubjoint::reports {

/// A number that was published, and what a run gives for it.
struct BenchmarkRow {
  std::string quantity;            ///< a column of the trajectory, or energy_residual
  double t = 0;                    ///< when [s]
  double published = 0;            ///< SI units
  double allowed = 0;              ///< difference up to which a run agrees
  std::optional<double> computed;  ///< none if the run did not get there

  /// computed − published, if there is one.
  std::optional<double> difference() const;
  /// Is it within what is allowed? Not if there is none.
  bool agrees() const;
};

/// A problem that was run.
struct BenchmarkRun {
  std::string name;        ///< of its scene
  std::string integrator;  ///< that ran it
  std::string message;     ///< why the run stopped; empty if it finished
  std::vector<BenchmarkRow> rows;
  double seconds = 0;        ///< that the run took
  std::size_t steps = 0;     ///< accepted
  double energy_drift = 0;   ///< largest |E − E₀ − work| over the largest energy or work
  double closure_drift = 0;  ///< largest |Φ| [m or rad]

  /// Do all rows agree?
  bool agrees() const;
};

/// The names of the published problems, in the file's order. @throws CsvError
std::vector<std::string> benchmark_names(const std::filesystem::path& literature);

/// Runs a published problem.
/// @param literature  benchmarks.csv;  @param scenes  folder of its scenes
/// @param tolerance  relative and absolute, in place of the scene's;  @param integrator  likewise; empty: the scene's
/// @param max_steps  likewise
/// @throws CsvError, SceneError; std::invalid_argument for a quantity that the trajectory does not have
BenchmarkRun run_benchmark(const std::string& name, const std::filesystem::path& literature,
                           const std::filesystem::path& scenes, const std::optional<double>& tolerance,
                           const std::string& integrator = "",
                           const std::optional<std::size_t>& max_steps = std::nullopt);

/// A point of a work-precision line: what an error costs.
struct WorkPrecision {
  std::string name;        ///< of the problem
  std::string integrator;  ///< that ran it
  double tolerance = 0;    ///< relative and absolute
  /// Largest |difference| from a published number [m or rad]; none if the run stopped, did not reach one of them, or
  /// there is none: a residual of energy is no place or angle.
  std::optional<double> error;
  double seconds = 0;     ///< that the run took
  std::size_t steps = 0;  ///< accepted
};

/// A problem by every integrator at tolerances from 1e-4 to 1e-12, in at most 100,000 steps each. Errors end at the
/// published digits' own.
/// @throws as run_benchmark does
std::vector<WorkPrecision> work_precision(const std::string& name, const std::filesystem::path& literature,
                                          const std::filesystem::path& scenes);

/// A row for each point.
std::string work_precision_text(const std::vector<WorkPrecision>& points);
/// An array of name, integrator, tolerance, error, seconds, steps.
nlohmann::ordered_json work_precision_json(const std::vector<WorkPrecision>& points);

/// An array of name, quantity, t, published, computed, difference, allowed, agrees, seconds, integrator, energy_drift.
nlohmann::ordered_json benchmark_json(const std::vector<BenchmarkRun>& runs);
/// A table of the numbers, and one of the runs.
std::string benchmark_text(const std::vector<BenchmarkRun>& runs);

}  // namespace lubjoint::reports

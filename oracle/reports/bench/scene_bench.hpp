/// Error against run time: scenes × formulations × integrators × tolerances.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oracle/reports/bench/bench_case.hpp"

namespace lubjoint::reports {

/// One line of the campaign.
struct BenchRow {
  std::string scene;
  std::string formulation;
  std::string integrator;
  double tolerance = 0;
  MethodRun run;
};

/// A scene's references: how far two methods of extended precision lie apart bounds what an error can mean.
struct BenchReference {
  std::string scene;
  double agreement;
};

struct SceneBench {
  std::vector<BenchRow> rows;
  std::vector<BenchReference> references;
  bool with_sundials = false;
};

struct SceneBenchSettings {
  std::vector<double> tolerances;
  std::vector<std::string> integrators;  ///< these alone; empty: all there are
  BenchLimits limits;
  /// Rows so far are kept here after every one of them, and taken up again if the settings are the same.
  /// Whoever has written the results removes it (discard_kept_rows).
  std::optional<std::filesystem::path> resume_file;
};

/// @param quick  few tolerances and repeats: a minute for the scenes that ship
SceneBenchSettings scene_bench_settings(bool quick);

/// @throws SceneError, std::invalid_argument, OutputError
SceneBench bench_scenes(const std::vector<Scene>& scenes, const SceneBenchSettings& settings);

/// Least time in which an integrator reaches an error, between its tolerances on a log-log line; none if it never does.
std::optional<double> seconds_at_error(const SceneBench& bench, const std::string& scene,
                                       const std::string& formulation, const std::string& integrator, double error);

/// Least error that any tolerance reached.
std::optional<double> error_floor(const SceneBench& bench, const std::string& scene, const std::string& formulation,
                                  const std::string& integrator);

std::string scene_bench_csv(const SceneBench& bench);

/// By scene and formulation: times at 1e-3, 1e-6 and 1e-9, the fastest, how it compares with CVODE's BDF, floors.
std::string scene_bench_table(const SceneBench& bench);

/// Work-precision plots, bench-SCENE-FORMULATION.svg and .png. @throws OutputError
void draw_scene_bench(const SceneBench& bench, const std::filesystem::path& folder);

}  // namespace lubjoint::reports

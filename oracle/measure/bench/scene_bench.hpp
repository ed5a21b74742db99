/// Error against run time: scenes × formulations × integrators × tolerances.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lubjoint/scene/spatial_scene.hpp"
#include "oracle/measure/bench/bench_rows.hpp"

namespace lubjoint::reports {

/// A scene's reference: how far its two methods lie apart bounds what an error can mean.
struct BenchReference {
  std::string scene;
  bool golden;  ///< the golden trajectory, or two integrators in extended precision
  double agreement;
};

struct SceneBench {
  std::vector<BenchRow> rows;
  std::vector<BenchReference> references;
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

/// Whatever runs out of time at two tolerances in a row is not run at the tighter ones, and says so.
/// @param in_space  spatial slider-cranks; they come last
/// @throws SceneError, std::invalid_argument, OutputError
SceneBench bench_scenes(const std::vector<Scene>& scenes, const SceneBenchSettings& settings,
                        const std::vector<SpatialScene>& in_space = {});

std::string scene_bench_csv(const std::vector<BenchRow>& rows);

/// Work-precision plots, bench-SCENE-FORMULATION.svg and .png, one for each race. @throws OutputError
void draw_scene_bench(const std::vector<BenchRow>& rows, const std::filesystem::path& folder);

}  // namespace lubjoint::reports

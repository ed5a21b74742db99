/// Runs of scene files as `lubjoint simulate` makes them: what may be changed, what is refused, what is told of a run.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "oracle/laws/scene_settings.hpp"
#include "oracle/results/late_extremes.hpp"

namespace lubjoint::reports {

/// A scene of either kind.
using SceneToRun = std::variant<Scene, SpatialScene>;

/// The scene of a file, changed.
/// @throws SceneError for a file that can't be used, and for a start that can't be run; std::invalid_argument for
/// settings
SceneToRun scene_to_run(const SceneFile& file, const SceneSettings& settings, SceneFilms& films);

/// Runs a scene in the plane, and calls visitor(run) with a JournalTrajectory or a MultibodyTrajectory.
template <class Visitor>
auto with_run(const Scene& scene, const Visitor& visitor) {
  return is_free_journal(scene) ? visitor(simulate_journal(scene)) : visitor(simulate_multibody(scene));
}
/// The same of a scene in space, with a SpatialTrajectory.
template <class Visitor>
auto with_run(const SpatialScene& scene, const Visitor& visitor) {
  return visitor(simulate_spatial(scene));
}

using Say = std::function<void(const std::string&)>;

/// Says, a sentence each, what in a scene its author has probably not meant.
void warn_before(const Scene& scene, const Say& say);
void warn_before(const SpatialScene& scene, const Say& say);

/// Says, a sentence each, where the film model itself is in doubt at the places that a run has visited, the tolerance
/// too coarse for the film, or the film too thin for a bearing.
void warn_after(const Scene& scene, const JournalTrajectory& run, const Say& say);
void warn_after(const Scene& scene, const MultibodyTrajectory& run, const Say& say);
void warn_after(const SpatialScene& scene, const SpatialTrajectory& run, const Say& say);

/// The extremes after a time, where they were asked for and the run got to its end; else it is said.
std::optional<LateExtremes> late_extremes_of(const Scene& scene, const RunOutcome& outcome,
                                             const std::optional<double>& after, const Say& say);

/// A run as other languages take it: the table of `simulate --out`, the summary of `simulate --json`.
struct RunOfScene {
  TrajectoryTable table;
  nlohmann::ordered_json summary;
  bool finished = false;              ///< else it stopped, and the summary's message says why
  std::vector<std::string> warnings;  ///< as `simulate` has them on standard error
};

/// Runs a scene.
/// @param late  extremes from a time on, too
/// @throws SceneError, std::invalid_argument
RunOfScene run_of_scene(const SceneToRun& scene, const LateChoice& late);

}  // namespace lubjoint::reports

#include "oracle/laws/scene_run.hpp"

#include <stdexcept>

#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "oracle/laws/model_error.hpp"
#include "oracle/results/film_resolution.hpp"
#include "oracle/results/journal_report.hpp"
#include "oracle/results/multibody_report.hpp"
#include "oracle/results/scene_warnings.hpp"
#include "oracle/results/spatial_report.hpp"
#include "oracle/results/squeeze_reynolds.hpp"

namespace lubjoint::reports {

namespace {

void say_each(const std::vector<std::string>& warnings, const Say& say) {
  for (const std::string& warning : warnings) {
    if (!warning.empty()) say(warning);
  }
}

/// Joints and run of a scene in space, as the plane's rules for them want them.
Scene joints_alone(const SpatialScene& scene) {
  Scene joints;
  joints.name = scene.name;
  for (const SpatialSceneJoint& joint : scene.joints) joints.joints.push_back(joint.plane);
  joints.integrator = scene.integrator;
  joints.run = scene.run;
  return joints;
}

template <class SceneType, class Run>
RunOfScene outcome_of(const SceneType& scene, const Run& run, const std::optional<double>& after,
                      std::vector<std::string>& warnings) {
  const Say say = [&warnings](const std::string& warning) { warnings.push_back(warning); };
  RunOfScene result{
      trajectory_table(scene, run), summary_json(scene, run), run.outcome.status == RunStatus::finished, {}};
  if constexpr (std::is_same_v<SceneType, Scene>) {
    if (const auto late = late_extremes_of(scene, run.outcome, after, say))
      add_late_extremes(result.summary, scene, *late);
  }
  warn_after(scene, run, say);
  return result;
}

}  // namespace

void SceneSettings::change(SpatialScene& scene, SceneFilms& films) const {
  Scene joints = joints_alone(scene);  // what settings say of joints and runs, they say by the plane's rules
  change(joints, films);
  for (std::size_t j = 0; j < scene.joints.size(); ++j) scene.joints[j].plane = joints.joints[j];
  scene.integrator = joints.integrator;
  scene.run = joints.run;
}

SceneToRun scene_to_run(const SceneFile& file, const SceneSettings& settings, SceneFilms& films) {
  settings.require();
  if (scene_dimension(file) == 3) {
    SpatialScene scene = spatial_scene(file);
    settings.change(scene, films);
    prepare_spatial(scene);  // refuses
    return scene;
  }
  Scene scene = file.scene();
  settings.change(scene, films);
  if (is_free_journal(scene)) journal_scene(scene);  // refuses
  return scene;
}

void warn_before(const Scene& scene, const Say& say) {
  say_each(unit_warnings(scene), say);
  say_each(law_warnings(scene), say);
}

void warn_before(const SpatialScene& scene, const Say& say) {
  say_each(unit_warnings(scene), say);
  say_each(law_warnings(joints_alone(scene)), say);
}

void warn_after(const Scene& scene, const JournalTrajectory& run, const Say& say) {
  const SceneJoint& joint = scene.joints[0];
  const double thinnest = thinnest_film(scene, run);
  say_each({thin_film_warning(joint, run.min_film_thickness, run.t_max_eccentricity_ratio),
            squeeze_reynolds_warning(joint, squeeze_reynolds(scene, run)), resolution_warning(scene, joint, thinnest),
            unseen_warning(scene, joint, run.outcome.integrator, thinnest),
            beyond_table_warning(joint, joint.clearance * run.max_eccentricity_ratio),
            model_warning(joint, visited_model_error(scene, run))},
           say);
}

void warn_after(const Scene& scene, const MultibodyTrajectory& run, const Say& say) {
  say_each(correction_warnings(scene, run), say);
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    const Peak& farthest = run.joints[j].eccentricity;
    const double thinnest = thinnest_film(scene, j, run);
    say_each(
        {thin_film_warning(joint, joint.clearance - farthest.value, farthest.t),
         squeeze_reynolds_warning(joint, squeeze_reynolds(scene, j, run)), resolution_warning(scene, joint, thinnest),
         unseen_warning(scene, joint, run.outcome.integrator, thinnest), beyond_table_warning(joint, farthest.value),
         model_warning(joint, visited_model_error(scene, j, run))},
        say);
  }
}

void warn_after(const SpatialScene& scene, const SpatialTrajectory& run, const Say& say) {
  say_each(run_warnings(scene, run), say);
  const Scene joints = joints_alone(scene);
  for (std::size_t j = 0; j < joints.joints.size(); ++j) {
    const SceneJoint& joint = joints.joints[j];
    const double farthest = run.joints[j].eccentricity.value;
    const double thinnest = thinnest_film(joint, farthest);
    const std::vector<SeenMotion> seen = seen_motions(scene, j, run);
    std::vector<JournalMotion<double>> motions;
    for (const SeenMotion& each : seen) motions.push_back(each.motion);
    say_each(
        {squeeze_reynolds_warning(joint, squeeze_reynolds(joint, seen)), resolution_warning(joints, joint, thinnest),
         unseen_warning(joints, joint, run.outcome.integrator, thinnest), beyond_table_warning(joint, farthest),
         model_warning(joint, visited_model_error(joint, motions))},
        say);
  }
}

std::optional<LateExtremes> late_extremes_of(const Scene& scene, const RunOutcome& outcome,
                                             const std::optional<double>& after, const Say& say) {
  if (!after) return std::nullopt;
  if (outcome.status == RunStatus::finished) return late_extremes(scene, *after);
  say("warning: the run stopped before its end, and has no extremes after a time");
  return std::nullopt;
}

RunOfScene run_of_scene(const SceneToRun& scene, const LateChoice& late) {
  late.require();
  return std::visit(
      [&]<class SceneType>(const SceneType& each) {
        std::optional<double> after;
        if constexpr (std::is_same_v<SceneType, Scene>) {
          after = late.start(each);
        } else {
          late.require_none_in_space();
        }
        std::vector<std::string> warnings;
        warn_before(each, [&warnings](const std::string& warning) { warnings.push_back(warning); });
        RunOfScene result = with_run(each, [&](const auto& run) { return outcome_of(each, run, after, warnings); });
        result.warnings = std::move(warnings);
        return result;
      },
      scene);
}

}  // namespace lubjoint::reports

#include <iostream>
#include <nlohmann/json.hpp>

#include "lubjoint/scene/journal_scene.hpp"
#include "oracle/cli/programs.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "oracle/cli/scene_options.hpp"
#include "oracle/files/files.hpp"
#include "oracle/laws/model_error.hpp"
#include "oracle/laws/scene_films.hpp"
#include "oracle/results/film_resolution.hpp"
#include "oracle/results/journal_report.hpp"
#include "oracle/results/late_extremes.hpp"
#include "oracle/results/multibody_report.hpp"
#include "oracle/results/run_plots.hpp"
#include "oracle/results/scene_warnings.hpp"
#include "oracle/results/spatial_report.hpp"
#include "oracle/results/squeeze_reynolds.hpp"
#include "oracle/results/trajectory_csv.hpp"

namespace lubjoint::cli {

namespace {

/// Where a run is to go, and how.
struct Output {
  std::optional<std::string> folder;  ///< of the trajectory and the plots
  bool plot = false;
  bool json = false;
};

/// Trajectory to a file if asked for, summary to standard output.
template <class SceneType, class Trajectory>
void report(const SceneType& scene, const Trajectory& run, const std::optional<reports::LateExtremes>& late,
            const Output& output) {
  if (output.folder) {
    const auto file = std::filesystem::path(*output.folder) / (scene.name + ".csv");
    reports::write_file(file, reports::trajectory_csv(trajectory_table(scene, run)));
    std::cerr << "trajectory written to " << file.string() << '\n';
  }
  if (output.json) {
    nlohmann::ordered_json summary = reports::summary_json(scene, run);
    if constexpr (std::is_same_v<SceneType, Scene>) {
      if (late) reports::add_late_extremes(summary, scene, *late);
    }
    std::cout << summary.dump(2) << '\n';
  } else {
    std::cout << reports::summary_text(scene, run);
    if constexpr (std::is_same_v<SceneType, Scene>) {
      if (late) std::cout << reports::late_extremes_text(scene, *late);
    }
  }
}

/// Last of all: gnuplot may be missing or fail, and the run is not to be lost.
template <class Trajectory>
void plot(const Scene& scene, const Trajectory& run, const Output& output) {
  if (!output.plot) return;
  std::string files;
  for (const std::string& name : reports::write_run_plots(scene, run, *output.folder)) files += " " + name;
  std::cerr << "plots:" << files << '\n';
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    if (!warning.empty()) std::cerr << warning << '\n';
  }
}

/// The extremes that were asked for, of a run that got to its end.
std::optional<reports::LateExtremes> late_of(const Scene& scene, const RunOutcome& outcome,
                                             const std::optional<double>& after) {
  if (!after) return std::nullopt;
  if (outcome.status == RunStatus::finished) return reports::late_extremes(scene, *after);
  warn({"warning: the run stopped before its end, and has no extremes after a time"});
  return std::nullopt;
}

int simulate(const Scene& scene, const std::optional<double>& after, const Output& output) {
  warn(reports::unit_warnings(scene));
  warn(reports::law_warnings(scene));
  // Where the film model itself is in doubt, the tolerance too coarse for the film, or the film too thin for a bearing.
  if (is_free_journal(scene)) {
    const JournalTrajectory run = simulate_journal(scene);
    const SceneJoint& joint = scene.joints[0];
    report(scene, run, late_of(scene, run.outcome, after), output);
    const double thinnest = reports::thinnest_film(scene, run);
    warn({reports::thin_film_warning(joint, run.min_film_thickness, run.t_max_eccentricity_ratio),
          reports::squeeze_reynolds_warning(joint, reports::squeeze_reynolds(scene, run)),
          reports::resolution_warning(scene, joint, thinnest),
          reports::unseen_warning(scene, joint, run.outcome.integrator, thinnest),
          reports::beyond_table_warning(joint, joint.clearance * run.max_eccentricity_ratio),
          reports::model_warning(joint, reports::visited_model_error(scene, run))});
    plot(scene, run, output);
    return run.outcome.status == RunStatus::finished ? 0 : 1;
  }
  const MultibodyTrajectory run = simulate_multibody(scene);
  report(scene, run, late_of(scene, run.outcome, after), output);
  warn(reports::correction_warnings(scene, run));
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    const Peak& farthest = run.joints[j].eccentricity;
    const double thinnest = reports::thinnest_film(scene, j, run);
    warn({reports::thin_film_warning(joint, joint.clearance - farthest.value, farthest.t),
          reports::squeeze_reynolds_warning(joint, reports::squeeze_reynolds(scene, j, run)),
          reports::resolution_warning(scene, joint, thinnest),
          reports::unseen_warning(scene, joint, run.outcome.integrator, thinnest),
          reports::beyond_table_warning(joint, farthest.value),
          reports::model_warning(joint, reports::visited_model_error(scene, j, run))});
  }
  plot(scene, run, output);
  return run.outcome.status == RunStatus::finished ? 0 : 1;
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

/// The scene in space, read and changed. @throws SceneError, std::invalid_argument
SpatialScene load_in_space(const SceneFile& file, const SceneOptions& options, const LateOptions& late,
                           const Output& output) {
  if (late.after || late.last_revolution) {
    throw std::invalid_argument(std::string(late.after ? "--after" : "--last-revolution") +
                                " is for scenes in the plane, and this one is in space; allowed without it");
  }
  if (output.plot) {
    throw std::invalid_argument("--plot is for scenes in the plane, and this one is in space; allowed without it");
  }
  options.require();
  SpatialScene scene = spatial_scene(file);
  Scene joints = joints_alone(scene);  // what options say of joints and runs, they say by the plane's rules
  options.change(joints);
  for (std::size_t j = 0; j < scene.joints.size(); ++j) scene.joints[j].plane = joints.joints[j];
  scene.integrator = joints.integrator;
  scene.run = joints.run;
  return scene;
}

int simulate_in_space(const SpatialScene& scene, const Output& output) {
  const Scene joints = joints_alone(scene);
  warn(reports::unit_warnings(scene));
  warn(reports::law_warnings(joints));
  const SpatialTrajectory run = simulate_spatial(scene);
  report(scene, run, {}, output);
  warn(reports::run_warnings(scene, run));
  for (std::size_t j = 0; j < joints.joints.size(); ++j) {
    const SceneJoint& joint = joints.joints[j];
    const double farthest = run.joints[j].eccentricity.value;
    const double thinnest = reports::thinnest_film(joint, farthest);
    const std::vector<reports::SeenMotion> seen = reports::seen_motions(scene, j, run);
    std::vector<JournalMotion<double>> motions;
    for (const reports::SeenMotion& each : seen) motions.push_back(each.motion);
    warn({reports::squeeze_reynolds_warning(joint, reports::squeeze_reynolds(joint, seen)),
          reports::resolution_warning(joints, joint, thinnest),
          reports::unseen_warning(joints, joint, run.outcome.integrator, thinnest),
          reports::beyond_table_warning(joint, farthest),
          reports::model_warning(joint, reports::visited_model_error(joint, motions))});
  }
  return run.outcome.status == RunStatus::finished ? 0 : 1;
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  struct SimulateOptions : SceneOptions, LateOptions, Output {};
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = app.add_subcommand("simulate", words_of("simulate"));
  options->add_file(*command);
  options->add_law(*command);
  options->add_run(*command);
  options->add_late(*command);
  CLI::Option* out = command->add_option("--out", options->folder, "Folder for the trajectory, SCENE.csv");
  command->add_flag("--plot", options->plot, "Orbit, forces and film thickness as SVG and PNG beside the trajectory")
      ->needs(out);
  command->add_flag("--json", options->json, "Summary as one JSON object");
  command->callback([options, &action] {
    action = [options] {
      options->LateOptions::require();
      const SceneFile file(options->file);
      if (scene_dimension(file) == 3) {
        const SpatialScene scene = load_in_space(file, *options, *options, *options);
        prepare_spatial(scene);  // refuses what it can before a folder is made
        if (options->folder) reports::prepare_folder(*options->folder);
        return simulate_in_space(scene, *options);
      }
      const Scene scene = options->load();
      const std::optional<double> after = options->start(scene);
      if (is_free_journal(scene)) journal_scene(scene);  // refuses what it can before a folder is made
      if (options->plot && scene.joints.empty()) {
        throw std::invalid_argument("--plot draws joints, and the scene has none; allowed is a scene with [[joints]]");
      }
      if (options->folder) reports::prepare_folder(*options->folder);
      return simulate(scene, after, *options);
    };
  });
}

}  // namespace lubjoint::cli

#include "multibody_simulation.hpp"

#include <algorithm>
#include <chrono>

#include "lubjoint/motion/constrained_radau.hpp"
#include "lubjoint/motion/multibody_run.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_coordinates.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "pilot_run.hpp"

namespace lubjoint {

namespace {

/// Number of bodies from which on a step with sparse matrices is faster, measured on chains.
constexpr std::size_t first_sparse = 12;

ConstraintUpkeep upkeep_of(const Scene& scene) {
  return scene.stabilisation.projection ? ConstraintUpkeep::by_projection : ConstraintUpkeep::by_accelerations;
}

MultibodyOptions options_of(const Scene& scene) {
  return {scene.sensors, scene.stabilisation.passes_singular ? AtSingularPosition::pass : AtSingularPosition::stop};
}

/// Every state by its own absolute tolerance: a coordinate of 0.1 m says nothing of the clearance that is at stake.
/// The last states, a ledger's work, change no step.
std::unique_ptr<Integrator<double, run_time_size>> method_of(const std::string& name, const RunSettings& run,
                                                             const std::vector<double>& tolerances,
                                                             const MultibodyOde<double>& ode) {
  const std::size_t integrals = ode.dimension() - ode.mechanical_states();
  const StepTolerance<double, run_time_size> tolerance{0, tolerances, run.relative_tolerance, integrals};
  const auto& joints = ode.system().joints();
  const bool may_slide = std::any_of(joints.begin(), joints.end(), [](const auto& j) { return j.has_half_film(); });
  if (name == "radau_iia5" && !may_slide && ode.system().bodies().size() >= first_sparse)
    return std::make_unique<ConstrainedRadau<double>>(ode, tolerance);
  return make_integrator<run_time_size>(name, tolerance);
}

detail::StiffnessMeasure measure_stiffness(const Scene& scene, const detail::PreparedScene& prepared) {
  Scene pilot_scene = scene;
  pilot_scene.run = detail::pilot_settings(scene.run);
  pilot_scene.run.knots = scene_knots(scene);
  pilot_scene.energy_ledger = false;
  const std::vector<double> tolerances = scene_tolerances<double>(pilot_scene);
  MultibodyOde<double> ode(prepared.system, false);
  MultibodyRun<double> pilot(ode, pilot_scene.run, method_of("radau_iia5", pilot_scene.run, tolerances, ode),
                             upkeep_of(scene), {{}, options_of(scene).at_singular});
  return detail::measure_by_pilot(pilot, ode, prepared.start, pilot_scene.run, tolerances, scene.joints.empty());
}

}  // namespace

MultibodyTrajectory simulate_multibody(const Scene& scene) {
  const detail::PreparedScene prepared = detail::prepare(scene);
  const CoordinatesChoice coordinates = choose_coordinates(scene, prepared.system);
  MultibodyTrajectory result;
  const auto begin = std::chrono::steady_clock::now();
  detail::IntegratorChoice choice{scene.integrator, ""};
  if (scene.integrator == automatic_integrator) {
    detail::StiffnessMeasure measure = measure_stiffness(scene, prepared);
    measure.independent = coordinates.independent;
    choice = detail::choose_integrator(measure, scene.run.relative_tolerance);
  }
  MultibodyOde<double> ode(prepared.system, scene.energy_ledger);
  RunSettings settings = scene.run;
  settings.knots = scene_knots(scene);
  const std::vector<double> tolerances = scene_tolerances<double>(scene);
  MultibodyRun<double> run(ode, settings,
                           coordinates.independent ? independent_method(choice.name, scene, ode, scene.run, tolerances)
                                                   : method_of(choice.name, scene.run, tolerances, ode),
                           coordinates.independent ? ConstraintUpkeep::by_accelerations : upkeep_of(scene),
                           options_of(scene));
  result.outcome = run.run(prepared.start);
  const auto end = std::chrono::steady_clock::now();
  result.wall_seconds = std::chrono::duration<double>(end - begin).count();
  result.outcome.integrator = choice.name;
  result.outcome.integrator_reason = choice.reason;
  result.outcome.coordinates = coordinates.independent ? "independent" : "absolute";
  result.outcome.coordinates_reason = coordinates.reason;
  const MultibodyRecorder<double>& recorder = run.recorder();
  result.correction = prepared.correction;
  result.samples = recorder.samples();
  result.joints = recorder.joint_extremes();
  result.drivers = recorder.driver_extremes();
  for (const auto& constraint : prepared.system.constraints()) {
    if (constraint.is_driver()) result.driver_names.push_back(constraint.name);
  }
  result.reactions = recorder.reaction_extremes();
  result.sensors = recorder.sensor_extremes();
  for (const SingularPosition& each : run.passed()) result.passed.push_back({each.t, run.constraint(each)});
  result.events = run.events();
  result.slides = run.slides();
  result.drift = recorder.drift();
  if (scene.energy_ledger) result.energy_residual = recorder.energy_residual();
  result.energy_scale = recorder.energy_scale();
  return result;
}

}  // namespace lubjoint

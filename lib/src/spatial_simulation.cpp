#include <chrono>

#include "lubjoint/motion/spatial_run.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/spatial_coordinates.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "pilot_run.hpp"

namespace lubjoint {

namespace {

ConstraintUpkeep upkeep_of(const SpatialScene& scene) {
  return scene.stabilisation.projection ? ConstraintUpkeep::by_projection : ConstraintUpkeep::by_accelerations;
}

/// @param integrals  the last states, a ledger's work: they change no step
std::unique_ptr<Integrator<double, run_time_size>> method_of(const std::string& name, const RunSettings& run,
                                                             const std::vector<double>& tolerances,
                                                             std::size_t integrals) {
  return make_integrator<run_time_size>(name, {0, tolerances, run.relative_tolerance, integrals});
}

SpatialResolution resolution_of(const SpatialScene& scene) {
  const SceneUnits units = scene_units(scene);
  const double tolerance = scene.run.absolute_tolerance;
  return {units.mechanism, tolerance * units.length, tolerance * units.angle};
}

detail::StiffnessMeasure measure_stiffness(const SpatialScene& scene, const PreparedSpatialScene& prepared) {
  SpatialScene pilot_scene = scene;
  pilot_scene.run = detail::pilot_settings(scene.run);
  pilot_scene.run.knots = scene_knots(scene);
  pilot_scene.energy_ledger = false;
  const std::vector<double> tolerances = scene_tolerances(pilot_scene);
  SpatialOde<double> ode(prepared.system, false);
  const std::vector<SpatialSensor> unmeasured;
  SpatialRun<double> pilot(ode, pilot_scene.run, method_of("radau_iia5", pilot_scene.run, tolerances, 0),
                           upkeep_of(scene), resolution_of(pilot_scene), unmeasured);
  return detail::measure_by_pilot(pilot, ode, prepared.start, pilot_scene.run, tolerances, scene.joints.empty());
}

}  // namespace

SpatialTrajectory simulate_spatial(const SpatialScene& scene) {
  const PreparedSpatialScene prepared = prepare_spatial(scene);
  const CoordinatesChoice coordinates = choose_coordinates(scene, prepared.system);
  SpatialTrajectory result;
  const auto begin = std::chrono::steady_clock::now();
  detail::IntegratorChoice choice{scene.integrator, ""};
  if (scene.integrator == automatic_integrator) {
    detail::StiffnessMeasure measure = measure_stiffness(scene, prepared);
    measure.independent = coordinates.independent;
    choice = detail::choose_integrator(measure, scene.run.relative_tolerance);
  }
  SpatialOde<double> ode(prepared.system, scene.energy_ledger);
  const std::size_t integrals = ode.dimension() - ode.mechanical_states();
  const std::vector<double> tolerances = scene_tolerances(scene);
  RunSettings settings = scene.run;
  settings.knots = scene_knots(scene);
  SpatialRun<double> run(ode, settings,
                         coordinates.independent ? independent_method(choice.name, scene, ode, scene.run, tolerances)
                                                 : method_of(choice.name, scene.run, tolerances, integrals),
                         coordinates.independent ? ConstraintUpkeep::by_accelerations : upkeep_of(scene),
                         resolution_of(scene), scene.sensors);
  result.outcome = run.run(prepared.start);
  const auto end = std::chrono::steady_clock::now();
  result.wall_seconds = std::chrono::duration<double>(end - begin).count();
  result.outcome.integrator = choice.name;
  result.outcome.integrator_reason = choice.reason;
  result.outcome.coordinates = coordinates.independent ? "independent" : "absolute";
  result.outcome.coordinates_reason = coordinates.reason;
  result.correction = prepared.found.correction;
  result.rows = prepared.system.constraint_rows();
  result.rank = prepared.found.rank;
  const auto& constraints = prepared.system.constraints();
  for (const std::size_t row : prepared.found.left_out) {
    result.left_out.push_back(constraints[prepared.system.constraint_of(row)].name);
  }
  for (const auto& constraint : constraints) {
    if (!constraint.is_driver()) continue;
    result.driver_names.push_back(constraint.name);
    result.driver_turns.push_back(!std::holds_alternative<TranslationalDriver<double>>(constraint.constraint));
  }
  const SpatialRecorder<double>& recorder = run.recorder();
  result.samples = recorder.samples();
  result.joints = recorder.joint_extremes();
  result.drivers = recorder.driver_extremes();
  result.reactions = recorder.reaction_extremes();
  result.sensors = recorder.sensor_extremes();
  result.events = run.events();
  result.slides = run.slides();
  result.drift = run.drift();
  if (scene.energy_ledger) result.energy_residual = recorder.energy_residual();
  result.energy_scale = recorder.energy_scale();
  return result;
}

}  // namespace lubjoint

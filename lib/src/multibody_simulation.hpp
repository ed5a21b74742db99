/// One integrator's part of simulate_multibody; each is compiled by itself.
#pragma once

#include <chrono>

#include "lubjoint/dynamics/multibody_run.hpp"
#include "lubjoint/dynamics/multibody_steppers.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/simulate.hpp"

namespace lubjoint {

namespace detail {

/// A system that is ready to run, and its start on the constraints.
struct PreparedScene {
  PlanarSystem<double> system;
  std::vector<double> start;
  StartCorrection<double> correction;
};

/// @throws SceneError
PreparedScene prepare(const Scene& scene);

MultibodyTrajectory simulate_multibody_radau(const Scene& scene);
MultibodyTrajectory simulate_multibody_dopri5(const Scene& scene);
MultibodyTrajectory simulate_multibody_fehlberg78(const Scene& scene);

template <class Stepper>
MultibodyTrajectory simulate_multibody_with(const Scene& scene) {
  const PreparedScene prepared = prepare(scene);
  MultibodyOde<double> ode(prepared.system, scene.energy_ledger);
  MultibodyRun<double, Stepper> run(
      ode, scene.run, scene_tolerances<double>(scene),
      scene.stabilisation.projection ? ConstraintUpkeep::by_projection : ConstraintUpkeep::by_accelerations);
  MultibodyTrajectory result;
  const auto begin = std::chrono::steady_clock::now();
  result.outcome = run.run(prepared.start);
  const auto end = std::chrono::steady_clock::now();
  result.wall_seconds = std::chrono::duration<double>(end - begin).count();
  const MultibodyRecorder<double>& recorder = run.recorder();
  result.correction = prepared.correction;
  result.samples = recorder.samples();
  result.joints = recorder.joint_extremes();
  result.drivers = recorder.driver_extremes();
  for (const auto& constraint : prepared.system.constraints()) {
    if (constraint.is_driver()) result.driver_names.push_back(constraint.name);
  }
  result.events = run.events();
  result.drift = recorder.drift();
  if (scene.energy_ledger) result.energy_residual = recorder.energy_residual();
  result.energy_scale = recorder.energy_scale();
  return result;
}

}  // namespace detail
}  // namespace lubjoint

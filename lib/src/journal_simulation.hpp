/// One law's part of simulate_journal; each is compiled by itself, since each is a program of its own.
#pragma once

#include <chrono>

#include "choose_integrator.hpp"
#include "lubjoint/motion/journal_run.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::detail {

template <FilmLaw Law>
StiffnessMeasure measure_stiffness(const FreeJournal<Law>& journal, const Scene& scene,
                                   const JournalState<double>& start) {
  const RunSettings settings = pilot_settings(scene.run);
  JournalRun<Law> pilot(journal, scene.joints.front().name, "radau_iia5", settings);
  const RunOutcome outcome = pilot.run(start);
  StiffnessMeasure measure{outcome.status == RunStatus::finished, static_cast<double>(outcome.steps), 0, false};
  Eigen::Matrix4d jacobian;
  for (const JournalSample& sample : pilot.recorder().samples()) {
    exact_jacobian([&](const auto& y, auto& dydt) { journal.rate(y, dydt); }, sample.state, jacobian);
    measure.stability_steps += settings.output_interval * fastest_decay(jacobian, {});
  }
  return measure;
}

/// What the generated file of a law instantiates.
template <FilmLaw Law>
JournalTrajectory simulate_journal_with(const Scene& scene) {
  const JournalScene parts = journal_scene(scene);
  const FreeJournal<Law> journal(LubricatedJoint<Law, double>(parts.bearing, parts.oil), parts.drive);
  JournalTrajectory result;
  const auto begin = std::chrono::steady_clock::now();
  IntegratorChoice choice{scene.integrator, ""};
  if (scene.integrator == automatic_integrator) {
    choice = choose_integrator(measure_stiffness(journal, scene, parts.start), scene.run.relative_tolerance);
  }
  JournalRun<Law> run(journal, scene.joints.front().name, choice.name, scene.run);
  result.outcome = run.run(parts.start);
  result.outcome.integrator = choice.name;
  result.outcome.integrator_reason = choice.reason;
  const auto end = std::chrono::steady_clock::now();
  result.wall_seconds = std::chrono::duration<double>(end - begin).count();
  const JournalRecorder& recorder = run.recorder();
  result.samples = recorder.samples();
  result.sliding = recorder.sliding();
  result.max_eccentricity_ratio = recorder.max_eccentricity_ratio();
  result.t_max_eccentricity_ratio = recorder.t_max_eccentricity_ratio();
  result.max_force = recorder.max_force();
  result.t_max_force = recorder.t_max_force();
  result.min_film_thickness = parts.bearing.clearance() * (1 - result.max_eccentricity_ratio);
  return result;
}

}  // namespace lubjoint::detail

/// One law's part of simulate_journal; each is compiled by itself, since each is a program of its own.
#pragma once

#include <chrono>

#include "choose_integrator.hpp"
#include "lubjoint/motion/journal_run.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::detail {

template <class Law>
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

/// A run that has begun at `begin` and is over: its trajectory and its extremes.
inline JournalTrajectory trajectory_of(const ModeRuns& run, const RunOutcome& outcome, const IntegratorChoice& choice,
                                       const Bearing<double>& bearing, std::chrono::steady_clock::time_point begin) {
  JournalTrajectory result;
  result.outcome = outcome;
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
  result.min_film_thickness = bearing.clearance() * (1 - result.max_eccentricity_ratio);
  return result;
}

/// What the generated file of a law instantiates.
/// @tparam Law  of law_list.hpp, FiniteHalf, or ChosenLaw for all others
template <class Law>
JournalTrajectory simulate_journal_with(const Scene& scene) {
  const JournalScene parts = journal_scene(scene);
  const FreeJournal<Law> journal(film_of<Law, double>(parts.law, parts.bearing, parts.oil, parts.table.get()),
                                 parts.drive);
  const auto begin = std::chrono::steady_clock::now();
  IntegratorChoice choice{scene.integrator, ""};
  if (scene.integrator == automatic_integrator) {
    choice = choose_integrator(measure_stiffness(journal, scene, parts.start), scene.run.relative_tolerance);
  }
  JournalRun<Law> run(journal, scene.joints.front().name, choice.name, scene.run);
  const RunOutcome outcome = run.run(parts.start);
  return trajectory_of(run, outcome, choice, parts.bearing, begin);
}

}  // namespace lubjoint::detail

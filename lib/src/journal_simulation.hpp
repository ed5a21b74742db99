/// One law's part of simulate_journal; each is compiled by itself, since each is a program of its own.
#pragma once

#include <chrono>
#include <stdexcept>

#include "lubjoint/dynamics/journal_run.hpp"
#include "lubjoint/scene/journal_scene.hpp"
#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::detail {

template <FilmLaw Law>
JournalTrajectory simulate_journal_with(const Scene& scene);

template <FilmLaw Law, template <std::size_t> class Stepper>
JournalTrajectory run_journal(const Scene& scene) {
  const JournalScene parts = journal_scene(scene);
  const FreeJournal<Law> journal(LubricatedJoint<Law, double>(parts.bearing, parts.oil), parts.drive);
  JournalRun<Law, Stepper> run(journal, scene.joints.front().name, scene.run);
  JournalTrajectory result;
  const auto begin = std::chrono::steady_clock::now();
  result.outcome = run.run(parts.start);
  const auto end = std::chrono::steady_clock::now();
  result.wall_seconds = std::chrono::duration<double>(end - begin).count();
  const JournalRecorder& recorder = run.recorder();
  result.samples = recorder.samples();
  result.sliding = recorder.sliding();
  result.max_eccentricity_ratio = recorder.max_eccentricity_ratio();
  result.max_force = recorder.max_force();
  result.min_film_thickness = parts.bearing.clearance() * (1 - result.max_eccentricity_ratio);
  return result;
}

/// What the generated file of a law instantiates.
template <FilmLaw Law>
JournalTrajectory simulate_journal_with_any(const Scene& scene) {
  if (scene.integrator == "radau_iia5") return run_journal<Law, ImplicitStepper>(scene);
  if (scene.integrator == "dopri5") return run_journal<Law, Dopri5>(scene);
  if (scene.integrator == "fehlberg78") return run_journal<Law, Fehlberg78>(scene);
  throw std::invalid_argument("there is no integrator \"" + scene.integrator + "\"");
}

}  // namespace lubjoint::detail

#include "massless_simulation.hpp"

#include "journal_simulation.hpp"

namespace lubjoint::detail {

namespace {

StiffnessMeasure measure_stiffness(const MasslessJournal<ChosenLaw>& journal, const Scene& scene,
                                   const MasslessState<double>& start) {
  const RunSettings settings = pilot_settings(scene.run);
  MasslessRun<ChosenLaw> pilot(journal, scene.joints.front().name, "radau_iia5", settings);
  const RunOutcome outcome = pilot.run(start);
  StiffnessMeasure measure{outcome.status == RunStatus::finished, static_cast<double>(outcome.steps), 0, false};
  for (const JournalSample& sample : pilot.recorder().samples()) {
    const Eigen::Matrix2d jacobian = journal.jacobian({sample.state[0], sample.state[1]});
    measure.stability_steps += settings.output_interval * fastest_decay(jacobian, {});
  }
  return measure;
}

}  // namespace

JournalTrajectory simulate_massless_journal(const Scene& scene) {
  const JournalScene parts = journal_scene(scene);
  const MasslessJournal<ChosenLaw> journal(ChosenFilm<double>(parts.law, parts.bearing, parts.oil, parts.table.get()),
                                           parts.drive);
  const MasslessState<double> start{parts.start[0], parts.start[1]};
  const auto begin = std::chrono::steady_clock::now();
  IntegratorChoice choice{scene.integrator, ""};
  if (scene.integrator == automatic_integrator) {
    choice = choose_integrator(measure_stiffness(journal, scene, start), scene.run.relative_tolerance);
  }
  MasslessRun<ChosenLaw> run(journal, scene.joints.front().name, choice.name, scene.run);
  const RunOutcome outcome = run.run(start);
  return trajectory_of(run, outcome, choice, parts.bearing, begin);
}

}  // namespace lubjoint::detail

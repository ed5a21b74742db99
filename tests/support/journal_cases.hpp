/// Example 1 of Flores et al. (2009), Table 1, run without a scene file.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/motion/journal_run.hpp"

namespace lubjoint::test {

inline constexpr double journal_load = 30 + 0.13 * 9.81;  // 31.2753 N, carried by the film at the end

/// Table 1; c 0.2 mm, R 9.8 mm, L 40 mm, 0.4 Pa s, 0.13 kg, 500 rpm, 30 N and the weight downward.
template <FilmLaw Law>
FreeJournal<Law> journal_of_table_1(double load = journal_load) {
  const LubricatedJoint<Law, double> joint(Bearing<double>(0.04, 0.0098, 0.0002), Lubricant<double>(0.4));
  return FreeJournal<Law>(joint, {0.13, Vector2<double>(0, -load), 0, 52.35987755982989});
}

struct FinishedRun {
  RunOutcome outcome;
  JournalRecorder recorder;

  const JournalSample& last() const { return recorder.samples().back(); }
};

/// From rest with centres coincident. Every sample of every run is checked: numbers, inside the clearance, in order.
template <FilmLaw Law>
FinishedRun run_journal(const FreeJournal<Law>& journal, const RunSettings& settings,
                        const std::string& method = "radau_iia5") {
  JournalRun<Law> run(journal, "bearing", method, settings);
  const RunOutcome outcome = run.run({0, 0, 0, 0});
  double before = -1;
  bool sound = true;
  for (const JournalSample& sample : run.recorder().samples()) {
    const auto& y = sample.state;
    sound = sound && std::isfinite(y[0] + y[1] + y[2] + y[3]) && sample.force.allFinite();
    sound = sound && one_minus_squared_norm(y[0], y[1]) > 0 && sample.t > before;
    before = sample.t;
  }
  INFO(Law::name);
  CHECK(sound);
  return {outcome, run.recorder()};
}

}  // namespace lubjoint::test

/// Example 1 of the paper: a journal under a constant load, with every law, checked in ways that do not share code.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/paper/journal_motion.hpp"
#include "oracle/plot/figure.hpp"
#include "oracle/results/check.hpp"

namespace lubjoint::reports {

/// One law's orbit, its equilibrium, and what they say of each other and of the paper.
struct Example1Law {
  std::string law;
  Scene scene;
  JournalTrajectory run;
  JournalEquilibrium rest;
  double end_distance = 0;               ///< |ê − ê_eq| at the end of the run
  double long_run_distance = 0;          ///< and after three times the duration
  Behaviour found = Behaviour::neither;  ///< what the orbit does within three times the duration
  std::string paper;                     ///< what the paper's figures 9 to 11 say of this law; "-": nothing
  std::optional<MotionRate> near_rest;   ///< of the motion from 1e-3 c off the equilibrium
  std::optional<MotionRate>
      from_the_start;  ///< of the scene's own run, as far as it comes round: amplitude shows in it
  Verdict verdict;
};

struct Example1 {
  double load = 0;  ///< |W| [N]
  std::vector<Example1Law> laws;
  std::vector<const Verdict*> verdicts() const;  ///< in the order of the laws
  bool passed() const;                           ///< does every law agree?
};

/// Runs the journal scene with all laws, on all cores. @param scene  free journal; its own law and tolerances are
/// replaced
Example1 run_example_1(const Scene& scene);

/// A run from near the equilibrium: displaced by 1e-3 c along the leading eigenvector, with its velocity. It lasts
/// until what decays is down to 1e-8 c; else forty turns, or until the displacement has grown tenfold.
Scene displaced_from(const Scene& scene, const JournalEquilibrium& rest);

/// The table that people read, and the same as CSV.
std::string example_1_table(const Example1& example);
std::string example_1_csv(const Example1& example);
std::string example_1_checks_csv(const Example1& example);

/// The paper's figure 9: a panel a law, in the order of the laws.
Figure journal_orbit_figure(const Example1& example);

enum class ForceComponent { horizontal, vertical };

/// Figures 10 and 11; the vertical force over the load.
Figure journal_force_figure(const Example1& example, ForceComponent component);

/// Trajectories as CSV, the summary, and the figures 9 to 11, into a folder.
/// @returns the files written
std::vector<std::string> write_example_1(const Example1& example, const std::filesystem::path& folder);

}  // namespace lubjoint::reports

/// Example 1 of the paper: a journal under a constant load, with every law, checked in ways that do not share code.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/reports/figure.hpp"

namespace lubjoint::reports {

/// One law's orbit, its equilibrium, and what they say of each other and of the paper.
struct Example1Law {
  std::string law;
  Scene scene;
  JournalTrajectory run;
  JournalEquilibrium rest;
  double start_distance = 0;         ///< |ê − ê_eq| at the start
  double end_distance = 0;           ///< and at the end
  bool rests = false;                ///< the orbit has shrunk to less than a tenth
  double integrator_difference = 0;  ///< largest |Δê| between Radau IIA(5) and Fehlberg 7(8), tolerance 1e-10
  double long_run_distance = 0;      ///< |ê − ê_eq| after three times the duration
  double predicted_distance = 0;     ///< what the leading eigenvalue makes of end_distance until then
  std::string paper;                 ///< what the paper's figures 9 to 11 say of this law
  std::vector<std::string> failures;
};

struct Example1 {
  double load = 0;  ///< |W| [N]
  std::vector<Example1Law> laws;
  bool passed() const;
};

/// Runs the journal scene with all laws. @param scene  free journal; its own law and tolerances are replaced
Example1 run_example_1(const Scene& scene);

/// The table that people read, and the same as CSV.
std::string example_1_table(const Example1& example);
std::string example_1_csv(const Example1& example);

/// The paper's figure 9: a panel a law, in the order of the laws.
Figure journal_orbit_figure(const Example1& example);

enum class ForceComponent { horizontal, vertical };

/// Figures 10 and 11; the vertical force over the load.
Figure journal_force_figure(const Example1& example, ForceComponent component);

/// Trajectories as CSV, the summary, and the figures 9 to 11, into a folder.
/// @returns the files written
std::vector<std::string> write_example_1(const Example1& example, const std::filesystem::path& folder);

}  // namespace lubjoint::reports

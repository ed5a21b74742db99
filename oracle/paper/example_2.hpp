/// Example 2 of the paper: the slider-crank with a lubricated gudgeon pin, checked against minimal coordinates.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lubjoint/scene/simulate.hpp"
#include "oracle/plot/figure.hpp"
#include "oracle/results/check.hpp"
#include "oracle/trajectories/slider_crank_reference.hpp"

namespace lubjoint::reports {

/// One set of clearance and viscosity.
struct Example2Case {
  Scene scene;
  MultibodyTrajectory run;
  double repeat_difference = 0;  ///< largest |Δê| of the second revolution to the first
  double swapped_ratio = 0;      ///< largest |Δε| when bearing and journal change bodies
  double swapped_force = 0;      ///< peak force then [N]
  PeriodicOrbit orbit;           ///< in minimal coordinates
  Verdict verdict;
};

struct Example2 {
  MultibodyTrajectory ideal;
  double ideal_force = 0;   ///< peak force on the ideal gudgeon pin, closed form [N]
  double ideal_moment = 0;  ///< peak driving moment, closed form [N m]
  Verdict ideal_verdict;    ///< of the ideal mechanisms
  std::vector<Example2Case> cases;

  std::vector<const Verdict*> verdicts() const;  ///< in the order of the cases
  bool passed() const;
};

/// All parameter sets, on all cores. @param scenes  folder with the slider-crank scenes
Example2 run_example_2(const std::filesystem::path& scenes);

std::string example_2_table(const Example2& example);
std::string example_2_csv(const Example2& example);
std::string example_2_checks_csv(const Example2& example);

enum class SliderCrankQuantity { force, moment, orbit, film };

/// The paper's figures 13 to 21 by quantity: a panel a parameter set, in the order of the cases.
/// @param aspect  width over height of an orbit's panel
/// @param real  runs of the same cases with another film, drawn green beside them: one each, or none
Figure slider_crank_figure(const Example2& example, SliderCrankQuantity quantity, double aspect = 1,
                           const std::vector<const MultibodyTrajectory*>& real = {});

/// Trajectories, the summary and the figures 13 to 21, into a folder. @returns the files written
std::vector<std::string> write_example_2(const Example2& example, const std::filesystem::path& folder);

}  // namespace lubjoint::reports

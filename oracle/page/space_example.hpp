/// The spatial slider-crank with a lubricated gudgeon pin that ships, run and checked.
#pragma once

#include <string>
#include <vector>

#include "lubjoint/scene/spatial_simulate.hpp"
#include "oracle/results/check.hpp"
#include "oracle/trajectories/spatial_slider_crank_scene.hpp"

namespace lubjoint::reports::page {

/// The gudgeon pin at an instant, in minimal coordinates.
struct SpacePin {
  Vector3<double> eccentricity;  ///< e/c, inertial
  Vector3<double> force;         ///< of the film on the journal, inertial [N]
};

/// What the run of the scene leaves, and what was checked of it.
struct SpaceExample {
  SpatialScene scene;
  SpatialTrajectory run;
  Verdict verdict;
};

using reports::crank_speed_of;
using reports::spatial_slider_crank_of;

/// The mechanism in minimal coordinates at times after the start, with Pinkus and Sternlicht's film, by Lobatto IIIC of
/// order 14. @throws std::invalid_argument as spatial_slider_crank_of
std::vector<SpacePin> space_reference(const SpatialScene& scene, const std::vector<double>& times);

/// Checks of a run against minimal coordinates at all output times after the start; of its constraints, Euler
/// parameters and energy. They take what was found and what it is held against, so that a test can falsify either.
std::vector<Check> space_checks(const SpatialScene& scene, const SpatialTrajectory& run,
                                const std::vector<SpacePin>& reference);

/// Runs the scene, with an energy ledger, and checks it. @throws SceneError, std::invalid_argument as space_reference
SpaceExample run_space_example(const SpatialScene& scene);

/// The table that people read.
std::string space_example_table(const SpaceExample& example);

}  // namespace lubjoint::reports::page

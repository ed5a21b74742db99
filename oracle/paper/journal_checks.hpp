/// The checks of example 1. They take what was found and what it is held against, so that a test can falsify either.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/paper/journal_motion.hpp"
#include "oracle/results/check.hpp"

namespace lubjoint::reports {

/// A run against one by another integrator: e/c, velocity, force and film thickness at all output times, the peaks with
/// their times, the intervals of sliding.
/// @param other_name  of the other integrator, for people
std::vector<Check> compare_runs(const Scene& scene, const JournalTrajectory& run, const JournalTrajectory& other,
                                const std::string& other_name);

/// The force of every sample against the quadrature of the film's pressure at its state; of Pinkus–Sternlicht, which is
/// the integral of no pressure, against the published formula in extended precision. Times of sliding are left out:
/// there the force is what keeps the motion on the jump.
Check sampled_force_check(const Scene& scene, const JournalTrajectory& run);

/// The film by the same other means at the equilibrium, against the load.
Check equilibrium_check(const Scene& scene, const JournalEquilibrium& rest);

/// Rate and frequency of the motion near the equilibrium against an eigenvalue.
/// @param motion  none if the path did not come round
std::vector<Check> rate_checks(const std::optional<MotionRate>& motion, std::complex<double> eigenvalue);

/// What the path does against what the eigenvalue foretells.
/// @param duration  of the path [s]
Check behaviour_check(Behaviour found, std::complex<double> eigenvalue, double duration);

/// What the path does against the paper's words.
/// @param paper  "circles", "rests", or "-" where the paper has no such law
Check paper_check(Behaviour found, const std::string& paper);

}  // namespace lubjoint::reports

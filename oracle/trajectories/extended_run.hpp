/// Scenes in extended precision (64-bit significands): references for errors in double precision.
#pragma once

#include <string>
#include <vector>

#include "lubjoint/motion/multibody_results.hpp"
#include "lubjoint/scene/scene.hpp"
#include "oracle/trajectories/reference.hpp"

namespace lubjoint::reports {

/// Two integrators of different families.
enum class ExtendedMethod { radau, fehlberg };

/// ê of a free journal with a law without jumps.
/// @throws std::invalid_argument  a law with a jump; std::runtime_error if the run stops
Reference extended_journal_run(const Scene& scene, const std::vector<double>& times, ExtendedMethod method);

/// A run of any scene in absolute coordinates.
struct ExtendedRun {
  std::vector<long double> start;        ///< (q, q̇) on the constraints
  std::vector<MultibodySample> samples;  ///< rounded to double when all is done; the first at t = 0
};

/// Tolerance of a step that leaves errors of some 1e-12 of a clearance, a good reference for double precision.
double extended_tolerance(ExtendedMethod method);

/// Every output is the end of a step: no sample is interpolated. Without energy ledger.
/// @param tolerance  of a step, as the scene's own
/// @throws std::runtime_error if the run stops
ExtendedRun extended_multibody_run(const Scene& scene, double output_interval, ExtendedMethod method, double tolerance);

/// ê of the first joint at every sample after the start; without joints, what looked_at_without_joints says.
Reference looked_at(const Scene& scene, const std::vector<MultibodySample>& samples);

/// The last body's position over the scene's unit of length: what stands for an eccentricity where no joint is.
Vector2<double> looked_at_without_joints(const Scene& scene, const std::vector<double>& y);

}  // namespace lubjoint::reports

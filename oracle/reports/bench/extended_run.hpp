/// Scenes in extended precision (64-bit significands): references for errors in double precision.
#pragma once

#include <string>
#include <vector>

#include "oracle/reports/bench/bench_case.hpp"

namespace lubjoint::reports {

/// Two integrators of different families.
enum class ExtendedMethod { radau, fehlberg };

/// ê of a free journal with a law without jumps.
/// @throws std::invalid_argument  a law with a jump; std::runtime_error if the run stops
Reference extended_journal_run(const Scene& scene, const std::vector<double>& times, ExtendedMethod method);

/// ê of the first joint of any scene; of one without joints, what looked_at_without_joints says.
/// @throws std::runtime_error if the run stops
Reference extended_multibody_run(const Scene& scene, const std::vector<double>& times, ExtendedMethod method);

/// The last body's position over the scene's unit of length: what stands for an eccentricity where no joint is.
Vector2<double> looked_at_without_joints(const Scene& scene, const std::vector<double>& y);

}  // namespace lubjoint::reports

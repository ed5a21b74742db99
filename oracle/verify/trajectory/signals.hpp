/// What trajectories of a scene are compared in.
#pragma once

#include <string>
#include <vector>

#include "lubjoint/scene/scene.hpp"
#include "oracle/verify/trajectory/trajectory.hpp"

namespace lubjoint::verify {

enum class SignalKind { eccentricity, ratio, thickness, force, place, velocity, angle, spin, moment, energy };

/// A vector in the plane, or one number, over time.
struct Signal {
  SignalKind kind;
  std::string owner;                 ///< joint, body or driver; the ledger's term
  std::string quantity;              ///< "eccentricity"
  std::vector<std::string> columns;  ///< one a component
  double scale;                      ///< error that counts as 1: a clearance, the largest force of the run, … [SI]
  double unit;                       ///< in which errors are told [SI]
  std::string unit_name;

  std::string name() const { return owner + ": " + quantity; }
};

/// All that a trajectory CSV of this scene may say.
/// Scales: clearances for places; the angle that moves the longest arm's end by a clearance; the run's largest value
/// for speeds, forces, moments and energies.
/// @param reference  has all columns
std::vector<Signal> signals_of(const Scene& scene, const Trajectory& reference);

/// The signals of which `given` has all or some components.
std::vector<Signal> signals_in(const std::vector<Signal>& signals, const Trajectory& given);

/// The eccentricity where only its ratio and the attitude are given. @returns columns that were used so
std::vector<std::string> add_eccentricities(const Scene& scene, Trajectory& given);

/// A signal's samples. Angles are continued over full turns.
Samples samples_of(const Signal& signal, const Trajectory& trajectory);

}  // namespace lubjoint::verify

/// What a run of an extreme case is worth beside its reference.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/measure/stress/stress_references.hpp"

namespace lubjoint::reports {

enum class StressStatus {
  finished,      ///< at the end of the duration, as near to its reference as its tolerance lets one expect
  coarse,        ///< at the end, further off, having itself warned that its tolerance does not resolve its film; no
                 ///< further than that warning lets one expect
  unreferenced,  ///< at the end; there is no reference, or none to the end: nothing is known of its error
  stopped,       ///< with a reason, the results so far kept
  wrong          ///< further off than any of this, a number that is not finite, a stop without a reason, an exception
};

const char* stress_status_name(StressStatus status);

/// A sample of a run.
struct StressSample {
  double t = 0;           ///< [s]
  Vector2<double> place;  ///< ê
  Vector2<double> rate;   ///< its inertial rate [1/s]
  Vector2<double> force;  ///< on the journal [N]
};

/// What the errors of a run come from.
struct StressAccuracy {
  double tolerance = 0;      ///< of a step's error in ê [clearances]
  double rounding = 0;       ///< of a step [clearances]
  double thinnest_film = 1;  ///< in the run [clearances]
  std::size_t steps = 0;     ///< accepted
  double roundings = 0;  ///< a tenth of the evaluations, each of which rounds anew: of radau_iia5 one a step
  double rate_share = 1;     ///< over V, what the tolerance of rates refers to; at least 1
  bool no_digit = false;     ///< does its warning say that no digit of velocities and forces is known?
  double unseen = 0;         ///< error of places that its estimate does not see, as its warning says [clearances]
};

/// Errors are largest over the output times up to where the run came; none where nothing was compared.
struct StressDeviation {
  std::size_t compared = 0;     ///< output times
  std::optional<double> place;  ///< |ê − ê_ref| [clearances]
  std::optional<double> rate;   ///< of ê's rate, over V
  std::optional<double> force;  ///< over the reference's unit of force
  /// The largest of all three over what the tolerance lets one expect at that time; above 1, it is further off.
  double over_expected = 0;
  /// The same over what a run may be off that has warned of its tolerance.
  double over_warned = 0;
  std::string worst;   ///< which of the three is furthest beyond what is expected, and when
  bool whole = false;  ///< is the reference one to the end, and was all of it compared?
};

/// The error that a tolerance τ lets one expect in a state at an output time: that of so many steps, no more than a
/// thousand (a stable motion forgets what is older, and more are not the tolerance's), and the rounding of all steps,
/// both grown as disturbances of this motion grow.
///   E = (min(steps, 1000) · τ + steps · rounding) · growth
/// and of that no more than a thousand tolerances, at least 1e-3 clearances, at most a tenth: however a motion
/// amplifies, further off than that it says too little to go unmarked.
double expected_error(const StressAccuracy& run, double growth);

/// Compares at the reference's times. A place may be off by E, a rate by E in what its tolerance refers to, the force
/// by that times what a disturbance of the state does to it there (in a stiff film far more than E); all by ten times
/// what the reference's own two methods differ by. A run that has warned: force and creep along a wall follow the
/// thickness h of the film to a power of at most 5/2, so what a place along it is off is a share 5E/2h of the way gone
/// so far, at most all of it, and of a rate along it as large a share; the force is open once that share is 1. Where
/// the warning says that no digit of rates and forces is known both are open, and so is the place up to a clearance; it
/// is never more off than that: no more would be off by saying e = 0 throughout. Where it says that steps met a half
/// film's jump, all steps count, not a thousand of them, and a force may be that of one side.
StressDeviation deviation_of(const std::vector<StressSample>& samples, const StressReference& reference,
                             const StressAccuracy& run);

/// The status of a run whose numbers are all finite.
/// @param warned  has it said that its tolerance is too coarse for its film?
StressStatus stress_status(bool finished, const StressDeviation& deviation, bool warned);

}  // namespace lubjoint::reports

/// What a journal's path does about a point, read from the path alone: no law, no equation of motion.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lubjoint/motion/journal_recorder.hpp"

namespace lubjoint::reports {

/// Rate and frequency of a motion about a point.
struct MotionRate {
  double rate = 0;        ///< d ln|Δê|/dt between returns to the same direction, mean over directions [1/s]
  double frequency = 0;   ///< 2π over the time of a turn, mean over directions [rad/s]
  double least_rate = 0;  ///< of any direction [1/s]
  double most_rate = 0;   ///< of any direction [1/s]
  std::size_t turns = 0;  ///< whole turns, from the first direction's start on
};

/// A linear motion Re(z v e^{λt}) comes back to the direction Δê(t) after exactly one period, by e^{Re λ T} longer. So
/// rate and frequency need no fit: twelve samples of the first turn each wait for their last return.
/// Between samples: cubics through ê and its rate.
/// @param below  the first sample with |Δê| ≤ below is the start
/// @param floor  returns nearer than this to the point are left to the integrator's error
/// @returns nothing if the path does not come round above the floor
std::optional<MotionRate> rate_of_motion(const std::vector<JournalSample>& samples, const Vector2<double>& centre,
                                         double below, double floor);

enum class Behaviour { rests, circles, neither };
const char* behaviour_word(Behaviour behaviour);

/// A path rests if in the last third of its time it stays within this part of its first distance.
inline constexpr double rest_share = 1e-3;
/// A path circles if it comes round at least so often, never turns back, and in no turn leaves the ring between its
/// first turn's nearest and farthest distance by more than this part of them.
inline constexpr std::size_t circling_turns = 3;
inline constexpr double circling_share = 0.01;

/// What a path does about a point.
Behaviour behaviour_of(const std::vector<JournalSample>& samples, const Vector2<double>& centre);

}  // namespace lubjoint::reports

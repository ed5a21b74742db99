/// What became of a journal's motion, as far as the samples of its run show it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::reports {

/// What a motion does towards its end.
enum class MotionKind {
  rests,         ///< stays near its last place for the last tenth of the run, or longer
  periodic,      ///< its last revolution repeats the one before
  not_periodic,  ///< there are two revolutions, and the last differs from the one before
  grows,         ///< its distance from the mean place is larger in the last third than in the second
  dies_away,     ///< it is smaller
  keeps_on,      ///< neither
  unknown        ///< too few samples to say
};

/// The word, and the number that it rests on.
struct MotionOutcome {
  MotionKind kind = MotionKind::unknown;
  double t = 0;        ///< rests: from when on [s]
  double measure = 0;  ///< rests, periodic, not_periodic: a distance [clearances]; grows, dies_away, keeps_on: a ratio
};

/// So near counts as the same place [clearances].
inline constexpr double same_place = 1e-3;
/// Amplitudes that differ by less than this share count as the same.
inline constexpr double same_amplitude = 0.02;

/// @param t  times, rising [s];  @param places  e/c at these times;  @param period  of what drives it [s], if anything
MotionOutcome motion_outcome(const std::vector<double>& t, const std::vector<Vector2<double>>& places,
                             const std::optional<double>& period);

MotionOutcome motion_outcome(const Scene& scene, const JournalTrajectory& run);
MotionOutcome motion_outcome(const Scene& scene, std::size_t joint, const MultibodyTrajectory& run);

/// A line of a summary.
std::string motion_text(const MotionOutcome& outcome);
/// kind, t and measure; null where there is none.
nlohmann::ordered_json motion_json(const MotionOutcome& outcome);

}  // namespace lubjoint::reports

/// Extremes of the part of a run behind a time: those of a start are often larger than any that follow.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lubjoint/scene/simulate.hpp"

namespace lubjoint::reports {

/// The largest values from a time on. Times are those of the whole run.
struct LateExtremes {
  double after;                             ///< [s]
  std::vector<JointExtremes> joints;        ///< in the scene's order
  std::vector<DriverExtremes> drivers;      ///< in the scene's order
  std::vector<ReactionExtremes> reactions;  ///< of the constraints that are no drivers, in the scene's order
};

/// Runs the scene to a time, and from its state there to the end: the extremes of the second part, with the accuracy of
/// a run's own.
/// @param after  from 0 to below the duration [s]
/// @throws std::invalid_argument  another time, a run that stops before its end, or a journal that touches its wall at
/// that time: the impact that it is in has begun before
LateExtremes late_extremes(const Scene& scene, double after);

/// What the two ways to ask for later extremes are called, for messages.
struct LateNames {
  std::string after = "--after";
  std::string last_revolution = "--last-revolution";
};

/// When the last revolution of a scene begins: of its driver, or of a free journal's spin [s].
/// @throws std::invalid_argument  nothing turns, drivers that turn differently, or less than a revolution
double start_of_last_revolution(const Scene& scene, const LateNames& names = {});

/// From when on extremes are wanted beside those of the whole run, if at all.
struct LateChoice {
  std::optional<double> after;   ///< [s]
  bool last_revolution = false;  ///< from the start of the last revolution on
  LateNames names;

  /// @throws std::invalid_argument  both are wanted
  void require() const;
  /// @throws std::invalid_argument  one of them is: of a scene in space there are none
  void require_none_in_space() const;
  /// The time in a scene [s]. @throws std::invalid_argument  it has none
  std::optional<double> start(const Scene& scene) const;
};

/// Adds the key `after` to each joint, driver and reaction of a summary.
void add_late_extremes(nlohmann::ordered_json& summary, const Scene& scene, const LateExtremes& late);

/// The lines of a summary.
std::string late_extremes_text(const Scene& scene, const LateExtremes& late);

}  // namespace lubjoint::reports

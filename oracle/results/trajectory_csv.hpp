/// A run's samples as CSV.
#pragma once

#include <string>

#include "lubjoint/scene/trajectory_table.hpp"

namespace lubjoint::reports {

/// A header and one line a row, numbers with the digits that give them back; what is not defined is an empty field.
std::string trajectory_csv(const TrajectoryTable& table);

/// The samples of a run of either kind.
template <class Run>
std::string trajectory_csv(const Scene& scene, const Run& run) {
  return trajectory_csv(trajectory_table(scene, run));
}

}  // namespace lubjoint::reports

/// A run's samples as columns with names: what CSV files print, and what judges compare.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lubjoint/scene/simulate.hpp"

namespace lubjoint {

/// One row a sample, in time's order; every row as long as the columns. What is not defined is none.
struct TrajectoryTable {
  std::vector<std::string> columns;                      ///< "t" first; then BODY.x, JOINT.ex, ...
  std::vector<std::vector<std::optional<double>>> rows;  ///< SI units
};

/// A free journal's: t; x, y, phi, vx, vy, omega of its body; ex, ey, eccentricity_ratio, attitude, fx, fy,
/// film_thickness of its joint, and its losses where it has a shear.
TrajectoryTable trajectory_table(const Scene& scene, const JournalTrajectory& run);

/// A mechanism's: the same for all bodies and joints, NAME.moment of the drivers, the ledger's energies and works, and
/// the sensors' quantities.
TrajectoryTable trajectory_table(const Scene& scene, const MultibodyTrajectory& run);

/// The four losses of a joint by name; what is not defined is none.
std::vector<std::pair<std::string, std::optional<double>>> named_losses(const LossSample& losses);

}  // namespace lubjoint

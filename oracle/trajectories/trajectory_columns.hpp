/// Columns of a scene's reference trajectory, and the vectors that they are components of.
#pragma once

#include <string>
#include <vector>

#include "lubjoint/scene/scene.hpp"

namespace lubjoint::reports {

/// Without the time, which comes first, and the disagreement, which comes last.
struct TrajectoryColumns {
  std::vector<std::string> names;
  std::vector<std::size_t> vectors;  ///< numbers of components

  void add(const std::vector<std::string>& components) {
    names.insert(names.end(), components.begin(), components.end());
    vectors.push_back(components.size());
  }
};

/// Of a free journal with one of the laws.
inline TrajectoryColumns journal_columns() {
  TrajectoryColumns columns;
  columns.add({"ex_over_c", "ey_over_c"});
  columns.add({"wx", "wy"});
  columns.add({"fx", "fy"});
  return columns;
}

/// Of any other scene.
inline TrajectoryColumns multibody_columns(const Scene& scene) {
  TrajectoryColumns columns;
  for (const SceneJoint& joint : scene.joints) {
    columns.add({joint.name + ".ex_over_c", joint.name + ".ey_over_c"});
    columns.add({joint.name + ".fx", joint.name + ".fy"});
  }
  if (scene.joints.empty()) {
    std::vector<std::string> angles;
    for (const SceneBody& body : scene.bodies) {
      columns.add({body.name + ".x", body.name + ".y"});
      angles.push_back(body.name + ".phi");
    }
    columns.add(angles);
  }
  for (const SceneConstraint& each : scene.constraints) {
    if (std::holds_alternative<Driver<double>>(each.constraint)) columns.add({each.name + ".moment"});
  }
  return columns;
}

}  // namespace lubjoint::reports

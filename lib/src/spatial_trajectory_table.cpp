#include <algorithm>

#include "lubjoint/scene/spatial_simulate.hpp"

namespace lubjoint {

namespace {

void add_columns(TrajectoryTable& table, const std::string& name, std::initializer_list<const char*> quantities) {
  for (const char* quantity : quantities) table.columns.push_back(name + "." + quantity);
}

}  // namespace

TrajectoryTable trajectory_table(const SpatialScene& scene, const SpatialTrajectory& run) {
  TrajectoryTable table{{"t"}, {}};
  for (const SpatialSceneBody& body : scene.bodies) {
    add_columns(table, body.name, {"x", "y", "z", "e0", "e1", "e2", "e3", "vx", "vy", "vz", "wx", "wy", "wz"});
  }
  for (const SpatialSceneJoint& joint : scene.joints) {
    add_columns(table, joint.plane.name,
                {"ex", "ey", "ez", "eccentricity_ratio", "tilt", "sliding", "fx", "fy", "fz", "film_thickness"});
    if (!joint.plane.shear) continue;
    for (const auto& [name, value] : named_losses({})) table.columns.push_back(joint.plane.name + "." + name);
  }
  for (std::size_t d = 0; d < run.driver_names.size(); ++d) {
    table.columns.push_back(run.driver_names[d] + (run.driver_turns[d] ? ".moment" : ".force"));
  }
  if (scene.energy_ledger) {
    table.columns.insert(table.columns.end(), {"energy.kinetic", "energy.potential"});
    for (std::size_t i = 0; i < ledger_works(scene); ++i) {
      table.columns.push_back(std::string("work.") + ledger_names[i]);
    }
  }
  for (const SpatialSensor& sensor : scene.sensors) {
    for (const char* quantity : sensor_quantities(sensor)) table.columns.push_back(sensor.name + "." + quantity);
  }
  const std::size_t bodies = scene.bodies.size();
  table.rows.reserve(run.samples.size());
  for (const SpatialSample& s : run.samples) {
    std::vector<std::optional<double>> row{s.t};
    row.reserve(table.columns.size());
    for (std::size_t b = 0; b < bodies; ++b) {
      const double* q = &s.state[spatial_coordinates * b];
      const double* v = &s.state[spatial_coordinates * bodies + spatial_velocities * b];
      row.insert(row.end(), q, q + spatial_coordinates);
      row.insert(row.end(), v, v + spatial_velocities);
    }
    for (std::size_t k = 0; k < s.joints.size(); ++k) {
      const SpatialJointSample& j = s.joints[k];
      row.insert(row.end(),
                 {j.eccentricity.x(), j.eccentricity.y(), j.eccentricity.z(), j.eccentricity_ratio, j.tilt, j.sliding,
                  j.force.x(), j.force.y(), j.force.z(), std::max(j.film_thickness, 0.0)});  // in contact there is none
      if (!scene.joints[k].plane.shear) continue;
      for (const auto& [name, value] : named_losses(j.losses)) row.push_back(value);
    }
    row.insert(row.end(), s.driving_efforts.begin(), s.driving_efforts.end());
    row.insert(row.end(), s.ledger.begin(), s.ledger.end());
    row.insert(row.end(), s.sensors.begin(), s.sensors.end());
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace lubjoint

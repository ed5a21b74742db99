#include "lubjoint/scene/trajectory_table.hpp"

#include <algorithm>
#include <cmath>

#include "lubjoint/film/film_state.hpp"
#include "lubjoint/scene/journal_losses.hpp"

namespace lubjoint {

namespace {

double clearance_left(const JournalState<double>& y) {
  const double epsilon = std::hypot(y[0], y[1]);
  return one_minus_squared_norm(y[0], y[1]) / (1 + epsilon);  // 1 − ε without cancellation
}

using Row = std::vector<std::optional<double>>;

void add_columns(TrajectoryTable& table, const std::string& name, std::initializer_list<const char*> quantities) {
  for (const char* quantity : quantities) table.columns.push_back(name + "." + quantity);
}

void add_body_columns(TrajectoryTable& table, const SceneBody& body) {
  add_columns(table, body.name, {"x", "y", "phi", "vx", "vy", "omega"});
}

void add_joint_columns(TrajectoryTable& table, const SceneJoint& joint) {
  add_columns(table, joint.name, {"ex", "ey", "eccentricity_ratio", "attitude", "fx", "fy", "film_thickness"});
  if (!joint.shear) return;
  for (const auto& [name, value] : named_losses({})) table.columns.push_back(joint.name + "." + name);
}

void add_losses(Row& row, const LossSample& losses) {
  for (const auto& [name, value] : named_losses(losses)) row.push_back(value);
}

}  // namespace

std::vector<std::pair<std::string, std::optional<double>>> named_losses(const LossSample& losses) {
  return {{"torque_journal", losses.torque_journal},
          {"torque_bearing", losses.torque_bearing},
          {"power", losses.power},
          {"side_flow", losses.side_flow}};
}

TrajectoryTable trajectory_table(const Scene& scene, const JournalTrajectory& run) {
  const SceneBody& body = scene.bodies.front();
  const SceneJoint& joint = scene.joints.front();
  const double c = joint.clearance;
  TrajectoryTable table{{"t"}, {}};
  add_body_columns(table, body);
  add_joint_columns(table, joint);
  table.rows.reserve(run.samples.size());
  for (const JournalSample& s : run.samples) {
    const double ex = c * s.state[0];
    const double ey = c * s.state[1];
    Row row{s.t,
            joint.bearing.point.x() + ex,
            joint.bearing.point.y() + ey,
            body.angle + body.spin * s.t,
            c * s.state[2],
            c * s.state[3],
            body.spin,
            ex,
            ey,
            s.eccentricity_ratio(),
            std::atan2(s.state[1], s.state[0]),
            s.force.x(),
            s.force.y(),
            c * clearance_left(s.state)};
    if (joint.shear) add_losses(row, journal_losses(scene, s));
    table.rows.push_back(std::move(row));
  }
  return table;
}

TrajectoryTable trajectory_table(const Scene& scene, const MultibodyTrajectory& run) {
  TrajectoryTable table{{"t"}, {}};
  for (const SceneBody& body : scene.bodies) add_body_columns(table, body);
  for (const SceneJoint& joint : scene.joints) add_joint_columns(table, joint);
  for (const SceneDriver& driver : scene_drivers(scene)) table.columns.push_back(driver.name + "." + driver.effort);
  if (scene.energy_ledger) {
    table.columns.insert(table.columns.end(), {"energy.kinetic", "energy.potential"});
    for (std::size_t i = 0; i < ledger_works(scene); ++i) {
      table.columns.push_back(std::string("work.") + ledger_names[i]);
    }
  }
  for (const Sensor& sensor : scene.sensors) {
    for (const char* quantity : sensor_quantities(sensor)) table.columns.push_back(sensor.name + "." + quantity);
  }
  const std::size_t n = 3 * scene.bodies.size();
  table.rows.reserve(run.samples.size());
  for (const MultibodySample& s : run.samples) {
    Row row{s.t};
    row.reserve(table.columns.size());
    for (std::size_t i = 0; i < n; i += 3) {
      for (const std::size_t first : {i, n + i}) row.insert(row.end(), &s.state[first], &s.state[first] + 3);
    }
    for (std::size_t k = 0; k < s.joints.size(); ++k) {
      const JointSample& j = s.joints[k];
      row.insert(row.end(), {j.eccentricity.x(), j.eccentricity.y(), j.eccentricity_ratio,
                             std::atan2(j.eccentricity.y(), j.eccentricity.x()), j.force.x(), j.force.y(),
                             std::max(j.film_thickness, 0.0)});  // in contact there is none
      if (scene.joints[k].shear) add_losses(row, j.losses);
    }
    row.insert(row.end(), s.driving_moments.begin(), s.driving_moments.end());
    row.insert(row.end(), s.ledger.begin(), s.ledger.end());
    row.insert(row.end(), s.sensors.begin(), s.sensors.end());
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace lubjoint

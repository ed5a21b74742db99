#include "lubjoint/scene/spatial_scene_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "lubjoint/text/nearest_name.hpp"
#include "scene_changes.hpp"
#include "scene_forces.hpp"
#include "scene_parts.hpp"
#include "scene_tables.hpp"
#include "spatial_constraints.hpp"

namespace lubjoint {

namespace {

Matrix3<double> read_inertia(TableReader& table) {
  const std::vector<double> j = table.numbers("inertia", {3, 6}, "kg m^2");
  Matrix3<double> inertia = Matrix3<double>::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) inertia(k, k) = j[static_cast<std::size_t>(k)];
  if (j.size() == 6) {
    inertia(0, 1) = inertia(1, 0) = j[3];
    inertia(0, 2) = inertia(2, 0) = j[4];
    inertia(1, 2) = inertia(2, 1) = j[5];
  }
  return inertia;
}

SpatialSceneBody read_spatial_body(TableReader table, const std::vector<SpatialSceneBody>& others) {
  SpatialSceneBody body;
  body.name = table.name("name");
  body.line = table.line();
  if (body.name == "ground" || is_taken(others, body.name)) {
    table.refuse("name", in_quotes(body.name), "a name that no other body has; \"ground\" is what never moves");
  }
  body.mass = table.number("mass", Allowed::positive, "kg");
  body.inertia = read_inertia(table);
  try {
    static_cast<void>(SpatialBody<double>(body.mass, body.inertia));
  } catch (const std::invalid_argument& error) {
    const std::string words = error.what();  // "inertia has …; allowed is …"
    const std::size_t allowed = words.find("; allowed is ");
    table.refuse("inertia", "one that " + words.substr(std::string("inertia ").size(), allowed - 8),
                 words.substr(allowed + 13));
  }
  body.position = table.vector3_or("position", body.position, "m");
  if (table.has("orientation")) body.orientation = read_orientation(table.table("orientation"));
  body.velocity = table.vector3_or("velocity", body.velocity, "m/s");
  if (table.has("points")) {
    TableReader points = table.table("points");
    for (const std::string& name : points.keys()) body.points.push_back({name, points.vector3(name, "m")});
  }
  if (table.is_table("spin")) {
    TableReader spin = table.table("spin");
    if (!spin.has("held")) {
      table.refuse("spin", "a table without held", "[x, y, z] [rad/s], or {held = [x, y, z]} where it is prescribed");
    }
    body.spin = spin.vector3("held", "rad/s");
    body.spin_is_held = true;
    spin.finish();
  } else {
    body.spin = table.vector3_or("spin", body.spin, "rad/s");
  }
  table.finish();
  return body;
}

/// U u of a body whose spin is held.
Vector3<double> read_spatial_unbalance(TableReader table, const SpatialSceneBody& body) {
  const double mass_radius = table.number("mass_radius", Allowed::positive, "kg m");
  const Vector3<double> given = table.vector3("direction", "-");
  if (is_zero(given)) table.refuse("direction", "[0, 0, 0]", "a direction, of any length");
  const Vector3<double> u = direction(given);
  if (is_zero(body.spin)) {
    table.refuse("mass_radius", "given for body " + in_quotes(body.name) + ", which is held without spin",
                 "none: an unbalance that does not turn does nothing");
  }
  const double along = dot(u, direction(body.spin));
  if (std::abs(along) > 1e-6) {  // as far as rounded numbers of a file may be off
    table.refuse("direction",
                 "one that leans by " + with_unit(std::asin(std::min(1.0, std::abs(along))), "rad") +
                     " from the plane across the held spin",
                 "one across that spin, in the body's axes: what lies along it does nothing");
  }
  table.finish();
  return mass_radius * u;
}

SpatialSceneLoad read_spatial_load(TableReader table, SpatialScene& scene) {
  SpatialSceneLoad load;
  const SpatialBodyPoint<double> at = read_body_point(table, scene, false);
  load.body = at.body;
  load.point = at.point;
  if (table.has("unbalance")) {
    const SpatialSceneBody& body = scene.bodies[load.body];
    if (!body.spin_is_held) {
      table.refuse("unbalance", "on body " + in_quotes(body.name) + ", whose spin is not held",
                   "a body with spin = {held = [x, y, z]}; where the spin is free, let the mass centre lie off the "
                   "points of its joints and constraints");
    }
    if (table.has("point")) table.refuse("point", "given for an unbalance", "none: it is of the body as a whole");
    load.unbalance = read_spatial_unbalance(table.table("unbalance"), body);
    table.finish();
    return load;
  }
  bool has_force = !table.has("moment") || table.has("force");
  if (table.has("table")) {
    const LoadCurves<6> read = read_load_curves<6>(table, scene.run.duration, {"fx", "fy", "fz", "mx", "my", "mz"},
                                                   {"against", "start_angle"});
    load.table = SpatialSceneTable{read.curves, read.of_angle};
    if (read.of_angle)
      load.table->angle = read_angle(table, "against", scene, table.number_or("start_angle", 0, Allowed::any, "rad"));
    has_force = read.is_there[0] || read.is_there[1] || read.is_there[2];
  } else {
    if (has_force) load.force = table.vector3("force", "N");
    load.moment = table.vector3_or("moment", load.moment, "N m");
  }
  if (!has_force && table.has("point")) table.refuse("point", "given for a moment alone", "none, or a force beside it");
  const std::string frame = table.text_or("frame", "inertial");
  if (frame != "inertial" && frame != "body") table.refuse("frame", in_quotes(frame), "\"inertial\" or \"body\"");
  load.turns_with_body = frame == "body";
  if (!load.table && table.has("harmonic")) {
    load.harmonic = read_harmonic(table, scene.run.duration, !is_zero(load.force) || !is_zero(load.moment));
  }
  table.finish();
  return load;
}

SpatialSceneJoint read_spatial_joint(TableReader table, const SpatialScene& scene) {
  SpatialSceneJoint joint{read_joint_film(table), {}, {}};
  const bool taken = std::any_of(scene.joints.begin(), scene.joints.end(),
                                 [&](const auto& other) { return other.plane.name == joint.plane.name; });
  if (taken) table.refuse("name", in_quotes(joint.plane.name), "a name that no other joint has");
  joint.bearing = read_axes(table.table("bearing"), scene);
  TableReader journal = table.table("journal");
  joint.journal = read_axes_like(journal, scene, joint.bearing);
  if (joint.bearing.body == joint.journal.body) {
    table.refuse("journal", "on the same body as the bearing", "another body");
  }
  table.finish();
  return joint;
}

/// A rotational spring acts about the pivot that it names.
SpatialRotationalSpring<double> read_about(TableReader& table, SpatialScene& scene) {
  SpatialRotationalSpring<double> spring{read_angle(table, "revolute", scene, 0), 0, 0, 0, 0, 0};
  spring.first = scene.angles[spring.angle].first.body;
  spring.second = scene.angles[spring.angle].second.body;
  read_rotational_terms(table, spring);
  return spring;
}

SpatialTranslationalSpring<double> read_between_points(TableReader& table, const SpatialScene& scene) {
  SpatialTranslationalSpring<double> spring{
      read_spatial_point(table.table("first"), scene), read_spatial_point(table.table("second"), scene), 0, 0, 0, 0};
  require_two_ends(table, spring, [&](const SpatialBodyPoint<double>& at) {
    return point_motion(frame_at_start(scene, at.body), at.point).position;
  });
  read_translational_terms(table, spring);
  return spring;
}

NamedSpatialSpring<double> read_spatial_spring(TableReader table, SpatialScene& scene) {
  NamedSpatialSpring<double> spring;
  spring.name = table.name("name");
  if (is_taken(scene.springs, spring.name)) {
    table.refuse("name", in_quotes(spring.name), "a name that no other spring has");
  }
  if (table.has("revolute")) {
    spring.spring = read_about(table, scene);
  } else {
    spring.spring = read_between_points(table, scene);
  }
  table.finish();
  return spring;
}

constexpr std::array<std::string_view, 5> sensor_types = {"reaction", "point", "distance", "angle", "spring"};

/// Of a scene whose bodies, joints, constraints and springs are known.
SpatialSensor read_spatial_sensor(TableReader table, SpatialScene& scene) {
  SpatialSensor sensor;
  sensor.name = table.name("name");
  const bool of_joint = std::any_of(scene.joints.begin(), scene.joints.end(),
                                    [&](const auto& joint) { return joint.plane.name == sensor.name; });
  const bool held = std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const auto& body) {
    return body.spin_is_held && held_spin_name(body) == sensor.name;
  });
  if (of_joint || held || is_taken(scene.bodies, sensor.name) || is_taken(scene.constraints, sensor.name) ||
      is_taken(scene.sensors, sensor.name)) {
    table.refuse("name", in_quotes(sensor.name), "a name that no body, joint, constraint or other sensor has");
  }
  const std::string type = table.text("type");
  if (type == "reaction") {
    sensor.of =
        ReactionSensor{find_named(table, "constraint", table.text("constraint"), scene.constraints, "constraint")};
  } else if (type == "point") {
    sensor.of = SpatialPointSensor{read_body_point(table, scene, false)};
  } else if (type == "distance") {
    const SpatialDistanceSensor distance{read_spatial_point(table.table("first"), scene),
                                         read_spatial_point(table.table("second"), scene)};
    if (distance.first.body == distance.second.body) {
      table.refuse("second", "on the same body as first", "another body: that distance never changes");
    }
    sensor.of = distance;
  } else if (type == "angle") {
    const double zero = table.number_or("start_angle", 0, Allowed::any, "rad");
    sensor.of = SpatialAngleSensor{read_angle(table, "revolute", scene, zero)};
  } else if (type == "spring") {
    sensor.of = SpringSensor{find_named(table, "spring", table.text("spring"), scene.springs, "spring")};
  } else {
    table.refuse("type", in_quotes(type), one_of(sensor_types, type));
  }
  table.finish();
  return sensor;
}

SpatialScene read_spatial_scene(TableReader root, const std::string& file) {
  SpatialScene scene;
  scene.file = file;
  if (root.number("dimension", Allowed::positive, "-") != 3) {
    root.refuse("dimension", with_unit(root.number("dimension", Allowed::positive, "-"), ""), "3 in a scene in space");
  }
  scene.name = root.name("name");
  scene.gravity = root.vector3_or("gravity", scene.gravity, "m/s^2");
  scene.run.duration = read_duration(root);
  for (const TableReader& table : root.tables("bodies")) {
    scene.bodies.push_back(read_spatial_body(table, scene.bodies));
  }
  if (scene.bodies.empty()) root.refuse("bodies", "missing or empty", "at least one [[bodies]] table");
  for (const TableReader& table : root.tables("joints")) scene.joints.push_back(read_spatial_joint(table, scene));
  for (const TableReader& table : root.tables("constraints")) {
    scene.constraints.push_back(read_spatial_constraint(table, scene));
  }
  for (const TableReader& table : root.tables("loads")) scene.loads.push_back(read_spatial_load(table, scene));
  for (const TableReader& table : root.tables("springs")) scene.springs.push_back(read_spatial_spring(table, scene));
  for (const TableReader& table : root.tables("sensors")) scene.sensors.push_back(read_spatial_sensor(table, scene));
  if (!root.has("joints") && !root.has("constraints")) {  // a file cut off there would run as free flight
    root.refuse("joints", "missing, and so is constraints",
                "at least one [[joints]] or [[constraints]] table, or joints = [] for bodies that fly freely");
  }
  const std::string redundant = root.text_or("redundant", "refuse");
  if (redundant != "refuse" && redundant != "allow") {
    root.refuse("redundant", in_quotes(redundant), "\"refuse\" or \"allow\"");
  }
  if (redundant == "allow") scene.redundant = RedundantConstraints::allow;
  if (root.has("stabilisation")) {
    scene.stabilisation = read_stabilisation(root.table("stabilisation"));
    if (scene.stabilisation.passes_singular) {
      root.refuse("stabilisation", "one that passes singular positions", "singular_positions = \"stop\" in space");
    }
  }
  const bool holds_spin =
      std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const auto& body) { return body.spin_is_held; });
  scene.coordinates = read_coordinates(root, !scene.constraints.empty() || holds_spin, scene.stabilisation);
  scene.run.output_interval = scene.run.duration / 1000;
  if (root.has("integrator")) read_integrator(root.table("integrator"), scene.integrator, scene.run);
  if (root.has("output")) scene.energy_ledger = read_output(root.table("output"), scene.run);
  root.finish();
  return scene;
}

}  // namespace

int scene_dimension(const SceneFile& file) {
  const toml::table table = parse_scene_text(file.text(), file.name());
  return table["dimension"].value_or(2.0) == 3 ? 3 : 2;
}

SpatialScene spatial_scene(const SceneFile& file, const std::vector<SceneChange>& changes) {
  toml::table table = parse_scene_text(file.text(), file.name());
  for (const SceneChange& change : changes) change_value(table, change, file.name());
  return read_spatial_scene(TableReader(table, file.name(), ""), file.name());
}

std::size_t ledger_works(const SpatialScene& scene) {
  const auto& all = scene.springs;
  const bool damped = std::any_of(all.begin(), all.end(), [](const auto& s) { return s.is_damped(); });
  return damped ? ledger_names.size() : ledger_terms;
}

SpatialFrame<double> frame_at_start(const SpatialScene& scene, std::size_t body) {
  if (body == ground_body) return SpatialFrame<double>(spatial_ground_motion<double>());
  const SpatialSceneBody& b = scene.bodies[body];
  return SpatialFrame<double>(SpatialMotion<double>{b.position, b.orientation, b.velocity, b.spin});
}

}  // namespace lubjoint

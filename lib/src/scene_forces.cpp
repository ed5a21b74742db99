#include "scene_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "lubjoint/text/nearest_name.hpp"
#include "scene_parts.hpp"
#include "scene_tables.hpp"

namespace lubjoint {

namespace {

SceneUnbalance read_unbalance(TableReader table) {
  SceneUnbalance unbalance;
  unbalance.mass_radius = table.number("mass_radius", Allowed::positive, "kg m");
  unbalance.phase = table.number_or("phase", 0, Allowed::any, "rad");
  table.finish();
  return unbalance;
}

/// A rotational spring acts about the pin that it names.
RotationalSpring<double> read_rotational(TableReader& table, const Scene& scene) {
  std::vector<SceneConstraint> pins;
  std::copy_if(scene.constraints.begin(), scene.constraints.end(), std::back_inserter(pins),
               [](const auto& each) { return std::holds_alternative<Revolute<double>>(each.constraint); });
  const SceneConstraint& pin =
      pins[find_named(table, "revolute", table.text("revolute"), pins, "constraint of type \"revolute\"")];
  RotationalSpring<double> spring{pin.first_body(), pin.second_body(), 0, 0, 0};
  spring.stiffness = table.number("stiffness", Allowed::not_negative, "N m/rad");
  spring.damping = table.number_or("damping", 0, Allowed::not_negative, "N m s/rad");
  if (spring.stiffness > 0) {
    spring.free_angle = table.number("free_angle", Allowed::any, "rad");
  } else if (table.has("free_angle")) {
    table.refuse("free_angle", "given where stiffness is 0", "none: a damper alone has no free angle");
  }
  return spring;
}

TranslationalSpring<double> read_translational_spring(TableReader& table, const Scene& scene) {
  TranslationalSpring<double> spring{
      read_anchor(table.table("first"), scene), read_anchor(table.table("second"), scene), 0, 0, 0, 0};
  if (spring.first.body == spring.second.body) table.refuse("second", "on the same body as first", "another body");
  spring.stiffness = table.number("stiffness", Allowed::not_negative, "N/m");
  spring.damping = table.number_or("damping", 0, Allowed::not_negative, "N s/m");
  spring.preload = table.number_or("preload", 0, Allowed::any, "N");
  if (spring.stiffness > 0) {
    spring.free_length = table.number("free_length", Allowed::not_negative, "m");
  } else if (table.has("free_length")) {
    table.refuse("free_length", "given where stiffness is 0", "none: a force that does not depend on the length");
  }
  // A start may be moved onto its constraints: what is left to rounding there is looked at again before the run.
  if (position_of(spring.first, scene) == position_of(spring.second, scene)) {
    table.refuse("second", "where first is: the spring has length 0, and so no direction",
                 "a point at a distance above 0 at t = 0");
  }
  return spring;
}

/// A sensor's columns begin with its name.
void require_free_name(const TableReader& table, const std::string& name, const Scene& scene) {
  const bool held = std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const SceneBody& body) {
    return body.spin_is_held && held_spin_name(body) == name;
  });
  if (held || is_taken(scene.bodies, name) || is_taken(scene.joints, name) || is_taken(scene.constraints, name) ||
      is_taken(scene.sensors, name)) {
    table.refuse("name", in_quotes(name), "a name that no body, joint, constraint or other sensor has");
  }
}

constexpr std::array<std::string_view, 5> sensor_types = {"reaction", "point", "distance", "angle", "spring"};

}  // namespace

Vector2<double> position_of(const SceneAnchor& anchor, const Scene& scene) {
  if (anchor.on_ground()) return anchor.point;
  const SceneBody& body = scene.bodies[anchor.body];
  const double cosine = std::cos(body.angle);
  const double sine = std::sin(body.angle);
  const Vector2<double>& s = anchor.point;
  return body.position + Vector2<double>(cosine * s.x() - sine * s.y(), sine * s.x() + cosine * s.y());
}

SceneHarmonic read_harmonic(TableReader& table, bool acts) {
  TableReader swing = table.table("harmonic");
  SceneHarmonic harmonic;
  if (swing.has("frequency") == swing.has("speed")) {
    swing.refuse("speed", swing.has("speed") ? "given beside frequency" : "missing, and so is frequency",
                 "one of them: speed [rad/s] or frequency [Hz]");
  }
  harmonic.rate = swing.has("speed") ? swing.number("speed", Allowed::positive, "rad/s")
                                     : 2 * std::numbers::pi * swing.number("frequency", Allowed::positive, "Hz");
  harmonic.phase = swing.number_or("phase", 0, Allowed::any, "rad");
  swing.finish();
  if (!acts) table.refuse("harmonic", "given for a force and a moment of 0", "none, or an amplitude other than 0");
  return harmonic;
}

SceneLoad read_load(TableReader table, const Scene& scene) {
  SceneLoad load;
  load.body = read_body_name(table, "body", scene, false);
  if (table.has("unbalance")) {
    load.unbalance = read_unbalance(table.table("unbalance"));
    if (!scene.bodies[load.body].spin_is_held) {
      table.refuse("unbalance", "on body " + in_quotes(scene.bodies[load.body].name) + ", whose spin is not held",
                   "a body with spin = {held = NUMBER}; where the spin is free, let the mass centre lie off the points "
                   "of its joints and constraints");
    }
    table.finish();
    return load;
  }
  bool has_force = !table.has("moment") || table.has("force");
  if (table.has("table")) {
    LoadTable read = read_load_table(table, scene);
    load.table = std::move(read.table);
    has_force = read.has_force;
  } else {
    if (has_force) load.force = table.vector("force", "N");
    load.moment = table.number_or("moment", 0, Allowed::any, "N m");
  }
  load.point = read_point(table, "point", scene, load.body);
  const std::string frame = table.text_or("frame", "inertial");
  if (frame != "inertial" && frame != "body") table.refuse("frame", in_quotes(frame), "\"inertial\" or \"body\"");
  load.turns_with_body = frame == "body";
  for (const char* key : {"point", "frame"}) {
    if (!has_force && table.has(key)) table.refuse(key, "given for a moment alone", "none, or a force beside it");
  }
  if (!load.table && table.has("harmonic"))
    load.harmonic = read_harmonic(table, !is_zero(load.force) || load.moment != 0);
  table.finish();
  return load;
}

SceneSpring read_spring(TableReader table, const Scene& scene) {
  SceneSpring spring;
  spring.name = table.name("name");
  if (is_taken(scene.springs, spring.name)) {
    table.refuse("name", in_quotes(spring.name), "a name that no other spring has");
  }
  bool acts = false;
  if (table.has("revolute")) {
    const RotationalSpring<double> rotational = read_rotational(table, scene);
    acts = rotational.stiffness > 0 || rotational.damping > 0;
    spring.spring = rotational;
  } else {
    const TranslationalSpring<double> translational = read_translational_spring(table, scene);
    acts = translational.stiffness > 0 || translational.damping > 0 || translational.preload != 0;
    spring.spring = translational;
  }
  if (!acts) table.refuse("stiffness", "0 in a spring without damping or preload", "a spring that does something");
  table.finish();
  return spring;
}

Sensor read_sensor(TableReader table, const Scene& scene) {
  Sensor sensor;
  sensor.name = table.name("name");
  require_free_name(table, sensor.name, scene);
  const std::string type = table.text("type");
  if (type == "reaction") {
    sensor.of =
        ReactionSensor{find_named(table, "constraint", table.text("constraint"), scene.constraints, "constraint")};
  } else if (type == "point") {
    const std::size_t body = read_body_name(table, "body", scene, false);
    sensor.of = PointSensor{{body, read_point(table, "point", scene, body)}};
  } else if (type == "distance") {
    const DistanceSensor distance{read_anchor(table.table("first"), scene), read_anchor(table.table("second"), scene)};
    if (distance.first.body == distance.second.body) {
      table.refuse("second", "on the same body as first", "another body: that distance never changes");
    }
    sensor.of = distance;
  } else if (type == "angle") {
    AngleSensor angle{ground_body, read_body_name(table, "body", scene, false)};
    if (table.has("against")) angle.first = read_body_name(table, "against", scene, true);
    if (angle.first == angle.second) {
      table.refuse("against", in_quotes(scene.bodies[angle.second].name), "another body, or \"ground\"");
    }
    sensor.of = angle;
  } else if (type == "spring") {
    sensor.of = SpringSensor{find_named(table, "spring", table.text("spring"), scene.springs, "spring")};
  } else {
    table.refuse("type", in_quotes(type), one_of(sensor_types, type));
  }
  table.finish();
  return sensor;
}

}  // namespace lubjoint

#include "scene_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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
  read_rotational_terms(table, spring);
  return spring;
}

TranslationalSpring<double> read_translational_spring(TableReader& table, const Scene& scene) {
  TranslationalSpring<double> spring{
      read_anchor(table.table("first"), scene), read_anchor(table.table("second"), scene), 0, 0, 0, 0};
  require_two_ends(table, spring, [&](const SceneAnchor& end) { return position_of(end, scene); });
  read_translational_terms(table, spring);
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

SceneHarmonic read_oscillation(TableReader& table, double duration) {
  SceneHarmonic harmonic;
  if (table.has("frequency") == table.has("speed")) {
    table.refuse("speed", table.has("speed") ? "given beside frequency" : "missing, and so is frequency",
                 "one of them: speed [rad/s] or frequency [Hz]");
  }
  const char* key = table.has("speed") ? "speed" : "frequency";
  const double given = table.number(key, Allowed::positive, table.has("speed") ? "rad/s" : "Hz");
  harmonic.rate = table.has("speed") ? given : 2 * std::numbers::pi * given;
  const double periods = harmonic.rate / (2 * std::numbers::pi) * duration;
  if (periods > most_periods) {
    table.refuse(key,
                 with_unit(given, table.has("speed") ? "rad/s" : "Hz") + ", by which the run has " +
                     with_unit(periods, "periods"),
                 "at most " + std::to_string(static_cast<int>(most_periods)) + " periods in a run");
  }
  harmonic.phase = table.number_or("phase", 0, Allowed::any, "rad");
  return harmonic;
}

SceneHarmonic read_harmonic(TableReader& table, double duration, bool acts) {
  TableReader swing = table.table("harmonic");
  const SceneHarmonic harmonic = read_oscillation(swing, duration);
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
    const LoadCurves<3> read = read_load_curves<3>(table, scene.run.duration, {"fx", "fy", "moment"}, {"against"});
    load.table = SceneTable{read.curves, read.of_angle};
    if (read.of_angle) load.table->against = read_body_name(table, "against", scene, false);
    has_force = read.is_there[0] || read.is_there[1];
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
    load.harmonic = read_harmonic(table, scene.run.duration, !is_zero(load.force) || load.moment != 0);
  table.finish();
  return load;
}

SceneSpring read_spring(TableReader table, const Scene& scene) {
  SceneSpring spring;
  spring.name = table.name("name");
  if (is_taken(scene.springs, spring.name)) {
    table.refuse("name", in_quotes(spring.name), "a name that no other spring has");
  }
  if (table.has("revolute")) {
    spring.spring = read_rotational(table, scene);
  } else {
    spring.spring = read_translational_spring(table, scene);
  }
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

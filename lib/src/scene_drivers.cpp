#include "scene_drivers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "lubjoint/text/nearest_name.hpp"
#include "scene_forces.hpp"
#include "scene_parts.hpp"
#include "scene_tables.hpp"

namespace lubjoint {

namespace {

using Shape = MotionShape<double>;

constexpr MotionWords turning{"angle", "rad", "rad/s", "rad/s^2"};
constexpr MotionWords sliding{"position", "m", "m/s", "m/s^2"};

Shape read_swing(TableReader table, double duration, const MotionWords& words) {
  const double amplitude = table.number("amplitude", Allowed::any, words.unit);
  if (amplitude == 0) table.refuse("amplitude", "0", "a number other than 0: a swing that does something");
  const SceneHarmonic harmonic = read_oscillation(table, duration);
  table.finish();
  return {amplitude, harmonic.rate, harmonic.phase};
}

SlideDriver<double> read_slide_driver(TableReader& table, const Scene& scene) {
  std::vector<SceneConstraint> guides;
  std::copy_if(scene.constraints.begin(), scene.constraints.end(), std::back_inserter(guides),
               [](const auto& each) { return std::holds_alternative<Translational<double>>(each.constraint); });
  const std::size_t named = find_named(table, "along", table.text("along"), guides,
                                       "constraint of type \"translational\" that stands before it");
  const auto& guide = std::get<Translational<double>>(guides[named].constraint);
  SlideDriver<double> driver{guide.first, guide.axis, guide.second, 0, 0, 0};
  const double angle = guide.first.on_ground() ? 0 : scene.bodies[guide.first.body].angle;
  const Vector2<double> along(std::cos(angle) * guide.axis.x() - std::sin(angle) * guide.axis.y(),
                              std::sin(angle) * guide.axis.x() + std::cos(angle) * guide.axis.y());
  const double here = along.dot(position_of(guide.second, scene) - position_of(guide.first, scene));
  const PrescribedMotion<double> motion = read_motion(table, scene.run.duration, sliding, here);
  driver.position = motion.start;
  driver.speed = motion.speed;
  driver.acceleration = motion.acceleration;
  driver.shape = motion.shape;
  return driver;
}

}  // namespace

PrescribedMotion<double> read_motion(TableReader& table, double duration, const MotionWords& words, double here) {
  if (table.has("table")) {
    Shape shape{0, 0, 0};
    shape.table = read_motion_table(table, duration, words.quantity);
    return {0, 0, 0, std::make_shared<const Shape>(shape)};
  }
  PrescribedMotion<double> motion{0, 0, 0, nullptr};
  double swing = 0;
  if (table.has("harmonic")) {
    const Shape shape = read_swing(table.table("harmonic"), duration, words);
    swing = shape.amplitude * std::cos(shape.phase);
    motion.shape = std::make_shared<const Shape>(shape);
  }
  motion.start = table.number_or(words.quantity, here - swing, Allowed::any, words.unit);
  if (!std::isfinite(motion.start)) {
    table.refuse(words.quantity, "missing, and the bodies' places differ by more than double precision can hold",
                 std::string("a finite number [") + words.unit + "]");
  }
  motion.speed = motion.shape ? table.number_or("speed", 0, Allowed::any, words.speed_unit)
                              : table.number("speed", Allowed::any, words.speed_unit);
  motion.acceleration = table.number_or("acceleration", 0, Allowed::any, words.acceleration_unit);
  return motion;
}

AnyConstraint<double> read_driver(TableReader& table, const Scene& scene) {
  if (table.has("along")) return read_slide_driver(table, scene);
  const std::size_t body = read_body_name(table, "body", scene, false);
  const std::size_t against = table.has("against") ? read_body_name(table, "against", scene, true) : ground_body;
  if (against == body) table.refuse("against", in_quotes(scene.bodies[body].name), "another body, or \"ground\"");
  const double here = scene.bodies[body].angle - (against == ground_body ? 0.0 : scene.bodies[against].angle);
  const PrescribedMotion<double> motion = read_motion(table, scene.run.duration, turning, here);
  return Driver<double>{against, body, motion.start, motion.speed, motion.acceleration, motion.shape};
}

}  // namespace lubjoint

/// What sensors show.
#pragma once

#include <vector>

#include "lubjoint/multibody/planar_system.hpp"
#include "lubjoint/multibody/sensor.hpp"

namespace lubjoint {

namespace detail {

/// Appends a sensor's values to a list, from an evaluated workspace.
template <class R>
struct SensorReader {
  const PlanarSystem<R>& system;
  const SystemWorkspace<R>& w;
  std::vector<double>& values;

  void add(const R& value) const { values.push_back(static_cast<double>(value)); }

  PointMotion<R> point(const BodyPoint<double>& at) const {
    return point_motion(system.frame(at.body, w), Vector2<R>(R(at.point.x()), R(at.point.y())));
  }

  void operator()(const ReactionSensor& sensor) const {
    const JointReaction<R> reaction = system.reaction_at_joint(sensor.constraint, w);
    add(reaction.force.x());
    add(reaction.force.y());
    add(reaction.moment);
  }
  void operator()(const PointSensor& sensor) const {
    const PointMotion<R> p = point(sensor.at);
    add(p.position.x());
    add(p.position.y());
    add(p.velocity.x());
    add(p.velocity.y());
  }
  void operator()(const DistanceSensor& sensor) const {
    const PointMotion<R> i = point(sensor.first);
    const PointMotion<R> j = point(sensor.second);
    const Vector2<R> d = j.position - i.position;
    const Vector2<R> v = j.velocity - i.velocity;
    if (is_zero(d)) {  // the distance grows from there whatever the direction
      add(R(0));
      add(is_zero(v) ? R(0) : norm(v));
      return;
    }
    add(norm(d));
    add(dot(direction(d), v));
  }
  void operator()(const AngleSensor& sensor) const {
    const PlanarFrame<R>& i = system.frame(sensor.first, w);
    const PlanarFrame<R>& j = system.frame(sensor.second, w);
    add(R(j.angle - i.angle));
    add(R(j.spin - i.spin));
  }
  void operator()(const SpringSensor& sensor) const {
    const auto& spring = system.elements().springs[sensor.spring];
    const PlanarFrame<R>& i = system.frame(spring.first_body(), w);
    const PlanarFrame<R>& j = system.frame(spring.second_body(), w);
    if (const auto* translational = std::get_if<TranslationalSpring<R>>(&spring.spring)) {
      add(translational->state(i, j).tension);
    } else {
      add(std::get<RotationalSpring<R>>(spring.spring).torque(i, j));
    }
  }
};

}  // namespace detail

/// Values of all sensors, one after the other, from an evaluated workspace.
template <class R>
void read_sensors(const std::vector<Sensor>& sensors, const PlanarSystem<R>& system, const SystemWorkspace<R>& w,
                  std::vector<double>& values) {
  values.clear();
  for (const Sensor& sensor : sensors) std::visit(detail::SensorReader<R>{system, w, values}, sensor.of);
}

}  // namespace lubjoint

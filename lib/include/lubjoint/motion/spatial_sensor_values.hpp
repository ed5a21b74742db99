/// What sensors in space show.
#pragma once

#include <vector>

#include "lubjoint/multibody/spatial/sensor.hpp"
#include "lubjoint/multibody/spatial/system.hpp"

namespace lubjoint {

namespace detail {

/// Appends a sensor's values to a list, from an evaluated workspace.
template <class R>
struct SpatialSensorReader {
  const SpatialSystem<R>& system;
  const R& t;
  const SpatialWorkspace<R>& w;
  std::vector<double>& values;

  void add(const R& value) const { values.push_back(static_cast<double>(value)); }
  void add(const Vector3<R>& v) const {
    for (Eigen::Index k = 0; k < 3; ++k) add(v(k));
  }

  SpatialPoint<R> point(const SpatialBodyPoint<double>& at) const {
    return point_motion(system.frame(at.body, w), Vector3<R>(at.point.template cast<R>()));
  }

  /// Force and moment on the second body at the joint, both in inertial axes [N, N m].
  void operator()(const ReactionSensor& sensor) const {
    const SpatialReaction<R> reaction = system.reaction_at_joint(sensor.constraint, w);
    add(reaction.force);
    add(reaction.moment);
  }
  void operator()(const SpatialPointSensor& sensor) const {
    const SpatialPoint<R> p = point(sensor.at);
    add(p.position);
    add(p.velocity);
  }
  void operator()(const SpatialDistanceSensor& sensor) const {
    const SpatialPoint<R> i = point(sensor.first);
    const SpatialPoint<R> j = point(sensor.second);
    const Vector3<R> d = difference(j.position, i.position);
    const Vector3<R> v = difference(j.velocity, i.velocity);
    if (is_zero(d)) {  // the distance grows from there whatever the direction
      add(R(0));
      add(is_zero(v) ? R(0) : R(norm(v)));
      return;
    }
    add(R(norm(d)));
    add(R(dot(direction(d), v)));
  }
  void operator()(const SpatialAngleSensor& sensor) const {
    const AngleMotion<R> motion = system.elements_in(t, w).angle(sensor.angle);
    add(motion.angle);
    add(motion.rate);
  }
  void operator()(const SpringSensor& sensor) const {
    const auto in = system.elements_in(t, w);
    add(std::visit([&](const auto& s) { return s.template effort<R>(in); },
                   system.elements().springs[sensor.spring].spring));
  }
};

}  // namespace detail

/// Values of all sensors, one after the other, from a workspace evaluated at t.
template <class R>
void read_sensors(const std::vector<SpatialSensor>& sensors, const SpatialSystem<R>& system, const R& t,
                  const SpatialWorkspace<R>& w, std::vector<double>& values) {
  values.clear();
  for (const SpatialSensor& sensor : sensors)
    std::visit(detail::SpatialSensorReader<R>{system, t, w, values}, sensor.of);
}

}  // namespace lubjoint

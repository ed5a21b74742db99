#include "lubjoint/scene/spatial_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <type_traits>
#include <utility>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "table_times.hpp"

namespace lubjoint {

template class SpatialOde<double>;
template SpatialStart<double> assemble_spatial_start(SpatialSystem<double>& system, const double& t,
                                                     const double& length, std::vector<double>& y,
                                                     RedundantConstraints redundant);

namespace {

/// Length of a spring in a state [m].
double length_of(const SpatialTranslationalSpring<double>& spring, const std::vector<double>& y, std::size_t bodies) {
  const auto place = [&](const SpatialBodyPoint<double>& at) {
    return point_motion(SpatialFrame<double>(spatial_motion_in(y.data(), bodies, at.body)), at.point).position;
  };
  return difference(place(spring.second), place(spring.first)).norm();
}

/// Refuses a journal that starts outside its bearing or across it, and a film whose edge starts at its wall.
void require_inside(const SpatialScene& scene, const PreparedSpatialScene& prepared, std::size_t j) {
  const SpatialJointElement<double>& joint = prepared.system.joints()[j];
  const std::size_t bodies = scene.bodies.size();
  const auto frame = [&](std::size_t body) {
    return SpatialFrame<double>(spatial_motion_in(prepared.start.data(), bodies, body));
  };
  std::ostringstream message;
  message << scene.file << ": joints[" << j << "] \"" << joint.name() << "\": ";
  const double c = joint.plane.bearing.clearance();
  SpatialJointKinematics<double> k;
  try {
    k = joint.kinematics(frame(joint.bearing_at.body), frame(joint.journal_at.body));
  } catch (const JournalAcross&) {
    message << "its journal starts across its bearing; allowed are axes that are nearly parallel";
    throw SceneError(message.str());
  }
  if (joint.plane.contact) return;
  const Vector2<double> e = k.motion.eccentricity / c;
  if (!(one_minus_squared_norm(e.x(), e.y()) > 0)) {
    message << "its journal starts at eccentricity ratio " << e.norm()
            << "; allowed are eccentricity ratios in [0, 1), or a transition to contact";
    throw SceneError(message.str());
  }
  if (e.norm() * c + joint.edge_shift(k.tilt()) < c) return;
  message << "its journal starts with a tilt of " << k.tilt() << " rad at eccentricity ratio " << e.norm()
          << ", by which it meets the wall at the bearing's edge; allowed are tilts below "
          << 2 * (c - e.norm() * c) / joint.plane.bearing.length() << " rad there, or a transition to contact";
  throw SceneError(message.str());
}

/// Joints of parallel axes hold with these antiparallel as well, a slider also when turned by half a turn, and the rows
/// of a fixed body at eight orientations: the three half turns and the four cyclic turns by 120 degrees. Refuses a
/// start that has come to another closure than is asked for.
void require_closure(const SpatialScene& scene, const PreparedSpatialScene& prepared, std::size_t c) {
  const auto frame = [&](std::size_t body) {
    return SpatialFrame<double>(spatial_motion_in(prepared.start.data(), scene.bodies.size(), body));
  };
  const auto columns = [](const BodyAxes<double>& at) {
    Matrix3<double> a;
    a << at.across, at.third(), at.axis;
    return a;
  };
  const SpatialSceneConstraint& constraint = scene.constraints[c];
  const auto refuse = [&](const BodyAxes<double>& first, const BodyAxes<double>& second) {
    // A_i F_i = A_j F_j, of a body that is not the ground.
    const bool of_second = second.body != ground_body;
    const BodyAxes<double>& fixed = of_second ? first : second;
    const BodyAxes<double>& turned = of_second ? second : first;
    const Matrix3<double> wanted = frame(fixed.body).rotation * columns(fixed) * columns(turned).transpose();
    const EulerParameters<double> p = euler_parameters<double>(wanted);
    const SpatialMotion<double> found = spatial_motion_in(prepared.start.data(), scene.bodies.size(), turned.body);
    const double off = 2 * std::acos(std::min(1.0, std::abs(found.parameters.dot(p))));
    std::ostringstream message;
    message << scene.file << ": constraints: \"" << constraint.name << "\" closes with body \""
            << scene.bodies[turned.body].name << "\" turned by " << off
            << " rad from the orientation that it asks for, because the body starts nearer to that; allowed is a start "
               "nearer to what is asked for: give the body orientation = {euler_parameters = ["
            << p(0) << ", " << p(1) << ", " << p(2) << ", " << p(3) << "]}";
    throw SceneError(message.str());
  };
  std::visit(
      [&]<class Joint>(const Joint& joint) {
        constexpr bool is_fixed = std::is_same_v<Joint, FixedJoint<double>>;
        constexpr bool is_slider = std::is_same_v<Joint, PrismaticJoint<double>>;
        constexpr bool is_parallel = std::is_same_v<Joint, RevoluteJoint<double>> ||
                                     std::is_same_v<Joint, CylindricalJoint<double>> ||
                                     std::is_same_v<Joint, PlanarJoint<double>>;
        if constexpr (is_fixed || is_slider || is_parallel) {
          // Cosines of the axes: on the constraints each is −1, 0 or 1 where the joint says something of it.
          const Vector3<double> cosines = (frame(joint.first.body).rotation * columns(joint.first))
                                              .cwiseProduct(frame(joint.second.body).rotation * columns(joint.second))
                                              .colwise()
                                              .sum();
          const bool closed = is_fixed    ? cosines.sum() > 2
                              : is_slider ? cosines(2) > 0 && cosines(0) > 0
                                          : cosines(2) > 0;
          if (!closed) refuse(joint.first, joint.second);
        }
      },
      constraint.constraint);
}

}  // namespace

namespace {

/// The springs along lines, with their numbers: act(number, spring).
template <class Act>
void for_each_straight_spring(const SpatialScene& scene, const Act& act) {
  for (std::size_t k = 0; k < scene.springs.size(); ++k) {
    if (const auto* spring = std::get_if<SpatialTranslationalSpring<double>>(&scene.springs[k].spring)) act(k, *spring);
  }
}

/// |J′⁻¹ M′|, M inertial or of the body, which is at its start.
double angular_acceleration(const SpatialSceneBody& body, const Vector3<double>& moment, bool in_body) {
  const Vector3<double> turned = in_body ? moment : transposed_product(rotation_matrix(body.orientation), moment);
  return body.inertia.llt().solve(turned).norm();
}

/// Refuses tables that the run leaves, or repeats too often.
void require_tables(const SpatialScene& scene) {
  const double duration = scene.run.duration;
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    const std::optional<SpatialSceneTable>& table = scene.loads[l].table;
    if (!table || table->of_angle) continue;
    const std::string what = "loads[" + std::to_string(l) + "]";
    require_cover(scene.file, duration, what, *table->curves, 0);
    if (table->curves->is_periodic()) require_few_passages(scene.file, what, *table->curves, duration);
  }
  for (const SpatialSceneConstraint& each : scene.constraints) {
    std::visit(
        [&]<class Constraint>(const Constraint& constraint) {
          if constexpr (requires { constraint.motion; })
            require_cover(scene.file, duration, each.name, constraint.motion.shape);
        },
        each.constraint);
  }
}

}  // namespace

HeldSpin<double> held_spin(const SpatialScene& scene, std::size_t body) {
  const SpatialSceneBody& held = scene.bodies[body];
  const Vector3<double> axis = is_zero(held.spin) ? Vector3<double>(0, 0, 1) : direction(held.spin);
  const Vector3<double> across = any_perpendicular(axis);
  const Matrix3<double> a = rotation_matrix(held.orientation);
  return {{{{{0, 0, 0}, product(a, axis), product(a, across)}, ground_body}, {{{0, 0, 0}, axis, across}, body}},
          {0, held.spin.norm(), 0}};
}

std::vector<double> scene_knots(const SpatialScene& scene) {
  std::vector<double> times;
  for (const SpatialSceneLoad& load : scene.loads) {
    if (load.table && !load.table->of_angle) add_knots(*load.table->curves, 0, scene.run.duration, times);
  }
  for (const SpatialSceneConstraint& each : scene.constraints) {
    std::visit(
        [&]<class Constraint>(const Constraint& constraint) {
          if constexpr (requires { constraint.motion; }) add_knots(constraint.motion.shape, scene.run.duration, times);
        },
        each.constraint);
  }
  return in_order(std::move(times));
}

SceneUnits scene_units(const SpatialScene& scene) {
  SceneUnits units{0, 0, 0, 1 / scene.run.duration, 0};
  const auto reach = [&](std::size_t body, const Vector3<double>& point) {
    if (body != ground_body) units.mechanism = std::max(units.mechanism, point.norm());
  };
  for (const SpatialSceneConstraint& each : scene.constraints) each.visit_points(reach);
  for (const SpatialSceneJoint& joint : scene.joints) {
    reach(joint.bearing.body, joint.bearing.point);
    reach(joint.journal.body, joint.journal.point);
  }
  for_each_straight_spring(scene, [&](std::size_t, const auto& spring) {
    reach(spring.first.body, spring.first.point);
    reach(spring.second.body, spring.second.point);
  });
  for_each_straight_spring(scene, [&](std::size_t, const auto& spring) {  // of bodies that hang at their mass centres
    if (units.mechanism == 0) units.mechanism = length_of(spring, scene_start<double>(scene), scene.bodies.size());
  });
  if (units.mechanism == 0) units.mechanism = scene.joints.empty() ? 1 : scene.joints.front().plane.journal_radius;
  units.length = units.mechanism;
  for (const SpatialSceneJoint& joint : scene.joints) units.length = std::min(units.length, joint.plane.clearance);
  units.angle = units.length / units.mechanism;
  const auto at_least = [&](double rate) { units.rate = std::max(units.rate, std::abs(rate)); };
  at_least(std::sqrt(scene.gravity.norm() / units.mechanism));
  for (const SpatialSceneBody& body : scene.bodies) {
    at_least(body.spin.norm());
    at_least(body.velocity.norm() / units.mechanism);
    units.energy += (body.mass * body.velocity.squaredNorm() + body.spin.dot(body.inertia * body.spin)) / 2 +
                    body.mass * scene.gravity.norm() * units.mechanism;
  }
  for (const SpatialSceneLoad& load : scene.loads) {
    const SpatialSceneBody& body = scene.bodies[load.body];
    at_least(std::sqrt(angular_acceleration(body, load.moment, load.turns_with_body)));
    units.energy += load.moment.norm() + load.force.norm() * units.mechanism;
    if (load.harmonic) at_least(load.harmonic->rate);
    if (!load.table) continue;
    double force = 0;
    double moment = 0;
    for (const double knot : load.table->curves->knots()) {
      const std::array<double, 6> values = load.table->curves->at(knot);
      const Vector3<double> m(values[3], values[4], values[5]);
      force = std::max(force, Vector3<double>(values[0], values[1], values[2]).norm());
      moment = std::max(moment, m.norm());
      at_least(std::sqrt(angular_acceleration(body, m, load.turns_with_body)));
    }
    units.energy += moment + force * units.mechanism;
    if (!load.table->of_angle) at_least(2 * std::numbers::pi / load.table->curves->length());
  }
  for_each_straight_spring(scene, [&](std::size_t, const auto& spring) {
    units.energy += std::abs(spring.preload) * units.mechanism;
    for (const std::size_t body : {spring.first.body, spring.second.body}) {
      if (body != ground_body) at_least(std::sqrt(spring.stiffness / scene.bodies[body].mass));
    }
  });
  for (const NamedSpatialSpring<double>& each : scene.springs) {
    const auto* spring = std::get_if<SpatialRotationalSpring<double>>(&each.spring);
    if (spring == nullptr) continue;
    const CountedAngle<double>& angle = scene.angles[spring->angle];
    for (const BodyAxes<double>& side : {angle.first, angle.second}) {
      if (side.body == ground_body) continue;
      const Vector3<double> moment = spring->stiffness * side.axis;
      at_least(std::sqrt(angular_acceleration(scene.bodies[side.body], moment, true)));
    }
  }
  for (const SpatialSceneConstraint& each : scene.constraints) {
    std::visit(
        [&]<class Constraint>(const Constraint& constraint) {
          if constexpr (requires { constraint.motion; }) {
            const double unit = Constraint::is_length(0) ? units.mechanism : 1;
            for_each_rate(
                constraint.motion.speed, constraint.motion.shape, [&](double rate) { at_least(rate / unit); },
                at_least);
          }
        },
        each.constraint);
  }
  for (const SpatialSceneBody& body : scene.bodies) {
    units.energy = std::max(units.energy, body.mass * std::pow(units.length * units.rate, 2));
  }
  return units;
}

std::vector<double> scene_tolerances(const SpatialScene& scene) {
  const SceneUnits units = scene_units(scene);
  const double tolerance = scene.run.absolute_tolerance;
  const double length = tolerance * units.length;
  const double angle = tolerance * units.angle;
  std::vector<double> result;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    result.insert(result.end(), 3, length);
    result.insert(result.end(), 4, angle / 2);
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    result.insert(result.end(), 3, length * units.rate);
    result.insert(result.end(), 3, angle * units.rate);
  }
  if (scene.energy_ledger) result.insert(result.end(), ledger_works(scene), tolerance * units.energy);
  return result;
}

PreparedSpatialScene prepare_spatial(const SpatialScene& scene) {
  require_tables(scene);
  PreparedSpatialScene prepared{spatial_system<double>(scene), scene_start<double>(scene), {}};
  try {
    prepared.found =
        assemble_spatial_start(prepared.system, 0.0, scene_units(scene).mechanism, prepared.start, scene.redundant);
  } catch (const ConstraintError& error) {
    throw SceneError(scene.file + ": constraints: " + error.what());
  }
  if (scene.redundant == RedundantConstraints::allow && prepared.found.left_out.empty()) {
    throw SceneError(scene.file + ": redundant is \"allow\", and none of the " +
                     std::to_string(prepared.system.constraint_rows()) +
                     " rows of the constraints repeats others; allowed is \"refuse\", or no such key");
  }
  for (std::size_t c = 0; c < scene.constraints.size(); ++c) require_closure(scene, prepared, c);
  for_each_straight_spring(scene, [&](std::size_t k, const auto& spring) {
    if (length_of(spring, prepared.start, scene.bodies.size()) > 1e-12 * scene_units(scene).mechanism) return;
    throw SceneError(scene.file + ": springs[" + std::to_string(k) + "] \"" + scene.springs[k].name +
                     "\" has length 0 at the start that fulfils the constraints; allowed is a length above 0: a spring "
                     "of length 0 has no direction");
  });
  for (std::size_t j = 0; j < scene.joints.size(); ++j) require_inside(scene, prepared, j);
  return prepared;
}

}  // namespace lubjoint

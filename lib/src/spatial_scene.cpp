#include "lubjoint/scene/spatial_scene.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <type_traits>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"

namespace lubjoint {

template class SpatialOde<double>;
template SpatialStart<double> assemble_spatial_start(SpatialSystem<double>& system, const double& t,
                                                     const double& length, std::vector<double>& y,
                                                     RedundantConstraints redundant);

namespace {

/// Length of a spring in a state [m].
double length_of(const SpatialSpring<double>& spring, const std::vector<double>& y, std::size_t bodies) {
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
  for (const SpatialSpring<double>& spring : scene.springs) {
    reach(spring.first.body, spring.first.point);
    reach(spring.second.body, spring.second.point);
  }
  for (const SpatialSpring<double>& spring : scene.springs) {  // bodies that hang on springs at their mass centres
    if (units.mechanism == 0) units.mechanism = length_of(spring, scene_start<double>(scene), scene.bodies.size());
  }
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
  /// |J′⁻¹ M′|, the body at its start.
  const auto angular_acceleration = [&](const SpatialSceneLoad& load) {
    const SpatialSceneBody& body = scene.bodies[load.body];
    const Vector3<double> in_body =
        load.turns_with_body ? load.moment : transposed_product(rotation_matrix(body.orientation), load.moment);
    return body.inertia.llt().solve(in_body).norm();
  };
  for (const SpatialSceneLoad& load : scene.loads) {
    at_least(std::sqrt(angular_acceleration(load)));
    units.energy += load.moment.norm() + load.force.norm() * units.mechanism;
    if (load.harmonic) at_least(load.harmonic->rate);
  }
  for (const SpatialSpring<double>& spring : scene.springs) {
    units.energy += std::abs(spring.preload) * units.mechanism;
    for (const std::size_t body : {spring.first.body, spring.second.body}) {
      if (body != ground_body) at_least(std::sqrt(spring.stiffness / scene.bodies[body].mass));
    }
  }
  for (const SpatialSceneConstraint& each : scene.constraints) {
    if (const auto* motor = std::get_if<RotationalDriver<double>>(&each.constraint)) at_least(motor->motion.speed);
    if (const auto* ram = std::get_if<TranslationalDriver<double>>(&each.constraint))
      at_least(ram->motion.speed / units.mechanism);
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
  for (std::size_t k = 0; k < scene.springs.size(); ++k) {
    if (length_of(scene.springs[k], prepared.start, scene.bodies.size()) > 1e-12 * scene_units(scene).mechanism)
      continue;
    throw SceneError(scene.file + ": springs[" + std::to_string(k) + "] \"" + scene.springs[k].name +
                     "\" has length 0 at the start that fulfils the constraints; allowed is a length above 0: a spring "
                     "of length 0 has no direction");
  }
  for (std::size_t j = 0; j < scene.joints.size(); ++j) require_inside(scene, prepared, j);
  return prepared;
}

}  // namespace lubjoint

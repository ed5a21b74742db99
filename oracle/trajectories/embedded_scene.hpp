/// A scene of the plane as one in space: its plane is turned and shifted, and may move.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "lubjoint/scene/spatial_scene.hpp"

namespace lubjoint::reports {

/// Where the plane lies: a point (x, y) of it is at A (x, y, 0) + shift + velocity t.
struct Plane {
  EulerParameters<double> orientation{1, 0, 0, 0};
  Vector3<double> shift{0, 0, 0};
  Vector3<double> velocity{0, 0, 0};

  Vector3<double> vector(const Vector2<double>& v) const {
    return product(rotation_matrix(orientation), Vector3<double>(v.x(), v.y(), 0));
  }
  Vector3<double> place(const Vector2<double>& p) const { return sum(vector(p), shift); }
  Vector3<double> normal() const { return rotation_matrix(orientation).col(2); }
  /// Of a body that is turned by φ in the plane.
  EulerParameters<double> turned(double angle) const {
    const EulerParameters<double>& p = orientation;
    const EulerParameters<double> q = euler_parameters<double>({0, 0, 1}, angle);
    // The product of two turns, that in the plane first.
    return {p(0) * q(0) - p(3) * q(3), p(1) * q(0) + p(2) * q(3), p(2) * q(0) - p(1) * q(3), p(3) * q(0) + p(0) * q(3)};
  }
};

/// Scenes, states and accelerations of the plane as those in space.
class Embedding {
 public:
  explicit Embedding(Plane plane) : plane_(std::move(plane)) {}

  /// A table of time that is read later than the run begins is not for space.
  SpatialScene scene(const Scene& flat) const {
    SpatialScene space;
    space.file = flat.file;
    space.name = flat.name;
    space.gravity = plane_.vector(flat.gravity);
    for (const SceneBody& body : flat.bodies) {
      SpatialSceneBody in_space;
      in_space.name = body.name;
      in_space.mass = body.mass;
      in_space.inertia.diagonal() << 0.6 * body.inertia, 0.7 * body.inertia, body.inertia;
      in_space.position = plane_.place(body.position);
      in_space.orientation = plane_.turned(body.angle);
      in_space.velocity = sum(plane_.vector(body.velocity), plane_.velocity);
      in_space.spin = {0, 0, body.spin};
      space.bodies.push_back(in_space);
    }
    for (const SceneLoad& load : flat.loads) {
      SpatialSceneLoad in_space;
      in_space.body = load.body;
      in_space.force =
          load.turns_with_body ? Vector3<double>(load.force.x(), load.force.y(), 0) : plane_.vector(load.force);
      in_space.moment =
          load.turns_with_body ? Vector3<double>(0, 0, load.moment) : Vector3<double>(load.moment * plane_.normal());
      in_space.point = {load.point.x(), load.point.y(), 0};
      in_space.turns_with_body = load.turns_with_body;
      in_space.harmonic = load.harmonic;
      if (load.unbalance) {
        const double size = load.unbalance->mass_radius;
        in_space.unbalance =
            Vector3<double>(size * std::cos(load.unbalance->phase), size * std::sin(load.unbalance->phase), 0);
      }
      if (load.table) {
        in_space.table = SpatialSceneTable{curves(*load.table->curves, load.turns_with_body), load.table->of_angle};
        if (load.table->of_angle) in_space.table->angle = add_angle(flat, ground_body, load.table->against, space);
      }
      space.loads.push_back(in_space);
    }
    for (const SceneJoint& joint : flat.joints) {
      space.joints.push_back({joint, axes(joint.bearing), axes(joint.journal)});
    }
    for (const SceneConstraint& each : flat.constraints) space.constraints.push_back(constraint(each));
    for (std::size_t b = 0; b < flat.bodies.size(); ++b) {
      const SceneBody& body = flat.bodies[b];
      if (!body.spin_is_held) continue;
      space.constraints.push_back(
          constraint({held_spin_name(body), Driver<double>{ground_body, b, body.angle, body.spin, 0}}));
    }
    for (const SceneSpring& each : flat.springs) {
      if (const auto* about = std::get_if<RotationalSpring<double>>(&each.spring)) {
        const std::size_t angle = add_angle(flat, about->first, about->second, space);
        space.springs.push_back(
            {each.name, SpatialRotationalSpring<double>{angle, about->first, about->second, about->stiffness,
                                                        about->damping, about->free_angle}});
        continue;
      }
      const auto& spring = std::get<TranslationalSpring<double>>(each.spring);
      space.springs.push_back(
          {each.name, SpatialTranslationalSpring<double>{point(spring.first), point(spring.second), spring.stiffness,
                                                         spring.damping, spring.free_length, spring.preload}});
    }
    space.stabilisation = flat.stabilisation;
    space.energy_ledger = flat.energy_ledger;
    space.integrator = flat.integrator;
    space.run = flat.run;
    return space;
  }

  /// A state (q, q̇) of the plane as (r, p; ṙ, ω′), at t.
  std::vector<double> state(const std::vector<double>& flat, double t = 0) const {
    const std::size_t n = flat.size() / 6;
    std::vector<double> y;
    for (std::size_t b = 0; b < n; ++b) {
      put(y, Vector3<double>(plane_.place({flat[3 * b], flat[3 * b + 1]}) + t * plane_.velocity));
      put(y, plane_.turned(flat[3 * b + 2]));
    }
    for (std::size_t b = 0; b < n; ++b) {
      const double* v = &flat[3 * (n + b)];
      put(y, sum(plane_.vector({v[0], v[1]}), plane_.velocity));
      put(y, Vector3<double>(0, 0, v[2]));
    }
    return y;
  }
  /// Accelerations (ẍ, ÿ, φ̈) of every body as (r̈, ω̇′).
  std::vector<double> accelerations(const std::vector<double>& flat) const {
    std::vector<double> a;
    for (std::size_t i = 0; i < flat.size(); i += 3) {
      put(a, plane_.vector({flat[i], flat[i + 1]}));
      put(a, Vector3<double>(0, 0, flat[i + 2]));
    }
    return a;
  }
  Vector3<double> vector(const Vector2<double>& v) const { return plane_.vector(v); }

 private:
  template <class V>
  static void put(std::vector<double>& y, const V& values) {
    y.insert(y.end(), values.data(), values.data() + values.size());
  }

  BodyAxes<double> axes(const SceneAnchor& at, const Vector3<double>& axis = {0, 0, 1},
                        const Vector3<double>& across = {1, 0, 0}) const {
    if (!at.on_ground()) return {{{at.point.x(), at.point.y(), 0}, axis, across}, at.body};
    const Matrix3<double> a = rotation_matrix(plane_.orientation);
    return {{plane_.place(at.point), product(a, axis), product(a, across)}, ground_body};
  }
  /// φ_j − φ_i, as the plane counts it. @returns its number
  std::size_t add_angle(const Scene& flat, std::size_t first, std::size_t second, SpatialScene& space) const {
    const auto angle = [&](std::size_t body) { return body == ground_body ? 0 : flat.bodies[body].angle; };
    const double turn = 2 * pi<double>();
    const double zero = turn * std::round((angle(second) - angle(first)) / turn);
    space.angles.push_back({axes({first, {0, 0}}), axes({second, {0, 0}}), zero});
    return space.angles.size() - 1;
  }
  /// F_x, F_y and M of the plane, inertial or of a body, as six quantities of space.
  std::shared_ptr<const TableCurves<6>> curves(const TableCurves<3>& flat, bool of_body) const {
    using Cubic = TableCurves<6>::Cubic;
    const Vector3<double> x = of_body ? Vector3<double>(1, 0, 0) : plane_.vector({1, 0});
    const Vector3<double> y = of_body ? Vector3<double>(0, 1, 0) : plane_.vector({0, 1});
    const Vector3<double> n = of_body ? Vector3<double>(0, 0, 1) : plane_.normal();
    std::vector<std::array<Cubic, 6>> pieces;
    for (const auto& piece : flat.pieces()) {
      pieces.emplace_back();
      for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t k = 0; k < 3; ++k) {
          const auto i = static_cast<Eigen::Index>(k);
          pieces.back()[k][c] = piece[0][c] * x(i) + piece[1][c] * y(i);
          pieces.back()[3 + k][c] = piece[2][c] * n(i);
        }
      }
    }
    return std::make_shared<const TableCurves<6>>(flat.knots(), std::move(pieces), flat.is_periodic());
  }
  SpatialBodyPoint<double> point(const SceneAnchor& at) const { return {at.body, axes(at).point}; }

  SpatialSceneConstraint constraint(const SceneConstraint& flat) const {
    struct Converter {
      const Embedding& in;
      AnySpatialConstraint<double> operator()(const GroundConstraint<double>& ground) const {
        const Matrix3<double> a = rotation_matrix(in.plane_.turned(ground.angle));
        return FixedJoint<double>{
            {{{in.plane_.place(ground.position), a.col(2), a.col(0)}, ground_body}, in.axes({ground.body, {0, 0}})}};
      }
      AnySpatialConstraint<double> operator()(const Revolute<double>& pin) const {
        return RevoluteJoint<double>{{in.axes(pin.first), in.axes(pin.second)}};
      }
      AnySpatialConstraint<double> operator()(const Translational<double>& guide) const {
        const Vector3<double> along(guide.axis.x(), guide.axis.y(), 0);
        // Seen from body j the guide is turned back by the angle that the joint keeps.
        const double c = std::cos(guide.angle);
        const double s = std::sin(guide.angle);
        const Vector3<double> from_second(c * along.x() + s * along.y(), c * along.y() - s * along.x(), 0);
        return PrismaticJoint<double>{
            {in.axes(guide.first, along, {0, 0, 1}), in.axes(guide.second, from_second, {0, 0, 1})}};
      }
      AnySpatialConstraint<double> operator()(const Driver<double>& driver) const {
        return RotationalDriver<double>{{in.axes({driver.first, {0, 0}}), in.axes({driver.second, {0, 0}})},
                                        {driver.angle, driver.speed, driver.acceleration, driver.shape}};
      }
      AnySpatialConstraint<double> operator()(const SlideDriver<double>& driver) const {
        const Vector3<double> along(driver.axis.x(), driver.axis.y(), 0);
        return TranslationalDriver<double>{{in.axes(driver.first, along, {0, 0, 1}), in.axes(driver.second)},
                                           {driver.position, driver.speed, driver.acceleration, driver.shape}};
      }
    };
    return {flat.name, std::visit(Converter{*this}, flat.constraint)};
  }

  Plane plane_;
};

/// Constraints of a closed loop of the plane repeat each other in space.
inline void allow_what_is_redundant(SpatialScene& scene) {
  SpatialSystem<double> system = spatial_system<double>(scene);
  std::vector<double> y = scene_start<double>(scene);
  const auto found = assemble_spatial_start(system, 0.0, scene_units(scene).mechanism, y, RedundantConstraints::allow);
  scene.redundant = found.left_out.empty() ? RedundantConstraints::refuse : RedundantConstraints::allow;
}

/// A turn and a shift of no special kind.
inline Plane some_plane(unsigned number) {
  const double k = number;
  const Vector3<double> axis = direction(Vector3<double>(std::sin(1 + k), std::cos(2 + 3 * k), std::sin(5 * k) - 0.4));
  return {euler_parameters(axis, 0.7 + 1.3 * k), {0.1 * std::sin(k), -0.07, 0.1 * std::cos(k)}, {0, 0, 0}};
}

}  // namespace lubjoint::reports

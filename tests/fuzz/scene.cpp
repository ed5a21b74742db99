#include <cmath>

#include "fuzz/targets.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"

namespace lubjoint::fuzz {

namespace {

void require_finite(double value, const char* what) { require(std::isfinite(value), std::string(what) + " is finite"); }

void require_finite(const Vector2<double>& value, const char* what) {
  require_finite(value.x(), what);
  require_finite(value.y(), what);
}

void require_positive(double value, const char* what) {
  require_finite(value, what);
  require(value > 0, std::string(what) + " is above 0");
}

/// Columns and files are called by it.
void require_name(const std::string& name) {
  require(name.find_first_of(",\"'/\\\n\r") == std::string::npos, "a name can be part of a column: " + name);
  require_one_line(name);
}

void require_anchor(const SceneAnchor& anchor, const Scene& scene) {
  require(anchor.on_ground() || anchor.body < scene.bodies.size(), "an anchor's body is there");
  require_finite(anchor.point, "an anchor's point");
}

void require_joint(const SceneJoint& joint, const Scene& scene) {
  require_name(joint.name);
  require_anchor(joint.bearing, scene);
  require_anchor(joint.journal, scene);
  require(joint.bearing.body != joint.journal.body, "a joint joins two bodies");
  require_positive(joint.journal_radius, "journal_radius");
  require_positive(joint.clearance, "clearance");
  require(joint.clearance < joint.journal_radius, "a clearance is smaller than the radius");
  if (joint.film != no_film) {
    require_positive(joint.viscosity, "viscosity");
    require_positive(joint.length, "length");
    if (joint.density) require_positive(*joint.density, "density");
  } else {
    require(joint.contact.has_value(), "a dry joint has contact");
  }
  if (joint.transition) {
    require_positive(joint.transition->e0, "e0");
    require_positive(joint.transition->e1, "e1");
    require(joint.transition->e0 < joint.transition->e1, "e0 < e1");
  }
  if (joint.contact) {
    const SceneContact& c = *joint.contact;
    require_positive(c.bearing_modulus, "bearing_modulus");
    require_positive(c.journal_modulus, "journal_modulus");
    require_positive(c.min_impact_speed, "min_impact_speed");
    require_positive(c.slow_sliding, "slow_sliding");
    require(std::abs(c.bearing_poisson) <= 1 && std::abs(c.journal_poisson) <= 1, "Poisson's ratio is in (-1, 0.5]");
    require(c.restitution >= 0 && c.restitution <= 1, "restitution is in [0, 1]");
    require_finite(c.friction, "friction");
    if (c.form == ContactForm::cylinder) require_positive(joint.length, "length of a cylinder in contact");
  }
}

struct RequireConstraint {
  const Scene& scene;

  void operator()(const GroundConstraint<double>& ground) const {
    require(ground.body < scene.bodies.size(), "a grounded body is there");
    require_finite(ground.position, "a ground's position");
    require_finite(ground.angle, "a ground's angle");
  }
  void operator()(const Revolute<double>& pin) const {
    require_anchor(pin.first, scene);
    require_anchor(pin.second, scene);
  }
  void operator()(const Translational<double>& guide) const {
    require_anchor(guide.first, scene);
    require_anchor(guide.second, scene);
    require(std::abs(guide.axis.norm() - 1) < 1e-15 * 4, "an axis has length 1");  // rounding of a norm and a quotient
    require_finite(guide.angle, "a guide's angle");
  }
  void operator()(const Driver<double>& driver) const {
    require(driver.second < scene.bodies.size(), "a driven body is there");
    require(driver.first == ground_body || driver.first < scene.bodies.size(),
            "the body that a driver leans on is there");
    require_finite(driver.angle, "a driver's angle");
    require_finite(driver.speed, "a driver's speed");
    require_finite(driver.acceleration, "a driver's acceleration");
    require_shape(driver.shape);
  }
  void operator()(const SlideDriver<double>& driver) const {
    require_anchor(driver.first, scene);
    require_anchor(driver.second, scene);
    require_finite(driver.position, "a driver's position");
    require_finite(driver.speed, "a driver's speed");
    require_finite(driver.acceleration, "a driver's acceleration");
    require_shape(driver.shape);
  }

  static void require_shape(const std::shared_ptr<const MotionShape<double>>& shape) {
    if (!shape) return;
    require_finite(shape->amplitude, "a swing's amplitude");
    require_finite(shape->rate, "a swing's speed");
    require_finite(shape->phase, "a swing's phase");
    if (!shape->table) return;
    for (const double knot : shape->table->knots()) require_finite(shape->table->at(knot)[0], "a table's value");
  }
};

void require_sound(const Scene& scene) {
  require_name(scene.name);
  require_finite(scene.gravity, "gravity");
  require(!scene.bodies.empty(), "a scene has a body");
  for (const SceneBody& body : scene.bodies) {
    require_name(body.name);
    require_finite(body.mass, "mass");
    require(body.mass > 0 || is_massless_journal(scene), "a mass is above 0, or 0 for a journal alone on its film");
    require_positive(body.inertia, "inertia");
    require_finite(body.position, "position");
    require_finite(body.velocity, "velocity");
    require_finite(body.angle, "angle");
    require_finite(body.spin, "spin");
  }
  for (const SceneLoad& load : scene.loads) {
    require(load.body < scene.bodies.size(), "a loaded body is there");
    require_finite(load.force, "force");
    require_finite(load.moment, "moment");
  }
  for (const SceneJoint& joint : scene.joints) require_joint(joint, scene);
  for (const SceneConstraint& constraint : scene.constraints) {
    require_name(constraint.name);
    std::visit(RequireConstraint{scene}, constraint.constraint);
  }
  require_finite(scene.stabilisation.alpha, "alpha");
  require_finite(scene.stabilisation.beta, "beta");
  require_positive(scene.run.duration, "duration");
  require_positive(scene.run.output_interval, "output interval");
  require(scene.run.duration / scene.run.output_interval < 1.1e7, "a trajectory has some ten million rows at most");
  require_positive(scene.run.relative_tolerance, "relative tolerance");
  require_positive(scene.run.absolute_tolerance, "absolute tolerance");
  require(scene.run.max_steps >= 1, "a run may take a step");
}

void require_finite(const Vector3<double>& value, const char* what) {
  for (Eigen::Index k = 0; k < 3; ++k) require_finite(value(k), what);
}

/// What every number of a scene in space is once it is read.
void require_sound(const SpatialScene& scene) {
  require_name(scene.name);
  require_finite(scene.gravity, "gravity");
  require(!scene.bodies.empty(), "a scene has a body");
  for (const SpatialSceneBody& body : scene.bodies) {
    require_name(body.name);
    require_positive(body.mass, "mass");
    require_finite(body.position, "position");
    require_finite(body.velocity, "velocity");
    require_finite(body.spin, "spin");
    require(std::abs(body.orientation.norm() - 1) < 1e-15 * 4, "Euler parameters have norm 1");  // as an axis, above
  }
  const auto require_fixed = [&](std::size_t body, const Vector3<double>& point) {
    require(body == ground_body || body < scene.bodies.size(), "what is fixed to a body is on one that is there");
    require_finite(point, "a point");
  };
  for (const SpatialSceneConstraint& each : scene.constraints) {
    require_name(each.name);
    each.visit_points(require_fixed);
  }
  for (const SpatialSceneJoint& joint : scene.joints) {
    require_name(joint.plane.name);
    for (const BodyAxes<double>* at : {&joint.bearing, &joint.journal}) {
      require_fixed(at->body, at->point);
      require(std::abs(at->axis.norm() - 1) < 1e-15 * 4, "an axis has length 1");  // rounding of a norm and a quotient
    }
  }
  require_positive(scene.run.duration, "duration");
  require_positive(scene.run.output_interval, "output interval");
}

}  // namespace

void scene(std::string_view bytes) {
  try {
    const SceneFile file(std::string(bytes), "any.toml");
    if (scene_dimension(file) == 3) {
      require_sound(spatial_scene(file));
    } else {
      require_sound(file.scene());
    }
  } catch (const SceneError& error) {
    require_refusal(error.what(), "any.toml");
  }
}

}  // namespace lubjoint::fuzz

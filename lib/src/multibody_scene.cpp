#include "lubjoint/scene/multibody_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "lubjoint/scene/scene_file.hpp"
#include "multibody_simulation.hpp"
#include "overloaded.hpp"
#include "table_times.hpp"

namespace lubjoint {

template class MultibodyOde<double>;
template const FilmFunctions<double>& film_functions<double>(std::string_view law);
template PlanarSystem<double> planar_system(const Scene& scene);
template StartCorrection<double> assemble_start(const PlanarSystem<double>& system, const double& t,
                                                const double& length, std::vector<double>& y);

namespace {

/// Every point that a constraint, a joint or a spring fixes to a body.
template <class Visit>
void for_each_anchor(const Scene& scene, const Visit& visit) {
  for (const SceneConstraint& each : scene.constraints) each.visit_points(visit);
  for (const SceneJoint& joint : scene.joints) {
    visit(joint.bearing);
    visit(joint.journal);
  }
  for (const SceneSpring& each : scene.springs) {
    if (const auto* spring = std::get_if<TranslationalSpring<double>>(&each.spring)) {
      visit(spring->first);
      visit(spring->second);
    }
  }
}

/// Length of a spring in a state [m].
double length_of(const TranslationalSpring<double>& spring, const std::vector<double>& y) {
  const auto place = [&](const SceneAnchor& at) {
    const PlanarMotion<double> body = motion_in(y, at.body);
    return Vector2<double>(body.position + inertial_vector(body, at.point));
  };
  return (place(spring.second) - place(spring.first)).norm();
}

/// The largest force [N] and moment [N m] at the knots of a table.
std::pair<double, double> largest_of(const TableCurves<3>& curves) {
  double force = 0;
  double moment = 0;
  for (const double knot : curves.knots()) {
    const std::array<double, 3> values = curves.at(knot);
    force = std::max(force, std::hypot(values[0], values[1]));
    moment = std::max(moment, std::abs(values[2]));
  }
  return {force, moment};
}

JournalMotion<double> motion_at(const std::vector<double>& y, const JointElement<double>& joint) {
  return joint
      .kinematics(PlanarFrame<double>(motion_in(y, joint.bearing_at.body)),
                  PlanarFrame<double>(motion_in(y, joint.journal_at.body)))
      .motion;
}

}  // namespace

SceneUnits scene_units(const Scene& scene) {
  SceneUnits units{0, 0, 0, 1 / scene.run.duration, 0};
  for_each_anchor(scene, [&](const SceneAnchor& anchor) {
    if (!anchor.on_ground()) units.mechanism = std::max(units.mechanism, anchor.point.norm());
  });
  for (const SceneSpring& each : scene.springs) {  // bodies that hang on springs at their mass centres
    const auto* spring = std::get_if<TranslationalSpring<double>>(&each.spring);
    if (spring && units.mechanism == 0) units.mechanism = length_of(*spring, scene_start<double>(scene));
  }
  if (units.mechanism == 0) units.mechanism = scene.joints.empty() ? 1 : scene.joints.front().journal_radius;
  units.length = units.mechanism;
  for (const SceneJoint& joint : scene.joints) units.length = std::min(units.length, joint.clearance);
  units.angle = units.length / units.mechanism;
  const auto at_least = [&](double rate) { units.rate = std::max(units.rate, std::abs(rate)); };
  at_least(std::sqrt(scene.gravity.norm() / units.mechanism));
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SceneBody& body = scene.bodies[b];
    at_least(body.spin);
    at_least(body.velocity.norm() / units.mechanism);
    units.energy += (body.mass * body.velocity.squaredNorm() + body.inertia * body.spin * body.spin) / 2 +
                    body.mass * scene.gravity.norm() * units.mechanism;
  }
  for (const SceneLoad& load : scene.loads) {
    at_least(std::sqrt(std::abs(load.moment) / scene.bodies[load.body].inertia));
    units.energy += std::abs(load.moment) + load.force.norm() * units.mechanism;
    if (load.harmonic) at_least(load.harmonic->rate);
    if (load.table) {
      const auto [force, moment] = largest_of(*load.table->curves);
      at_least(std::sqrt(moment / scene.bodies[load.body].inertia));
      units.energy += moment + force * units.mechanism;
      if (!load.table->of_angle) at_least(2 * std::numbers::pi / load.table->curves->length());
    }
  }
  const auto of_spring = Overloaded{[&](const TranslationalSpring<double>& spring, std::size_t b) {
                                      at_least(std::sqrt(spring.stiffness / scene.bodies[b].mass));
                                      units.energy += std::abs(spring.preload) * units.mechanism;
                                    },
                                    [&](const RotationalSpring<double>& spring, std::size_t b) {
                                      at_least(std::sqrt(spring.stiffness / scene.bodies[b].inertia));
                                    }};
  for (const SceneSpring& each : scene.springs) {
    for (const std::size_t b : {each.first_body(), each.second_body()}) {
      if (b != ground_body) std::visit([&](const auto& spring) { of_spring(spring, b); }, each.spring);
    }
  }
  const auto at_least_of_driver = [&](const auto& driver, double unit) {  // of its motion: rad, or m
    for_each_rate(
        driver.speed, driver.shape, [&](double rate) { at_least(rate / unit); }, at_least);
  };
  for (const SceneConstraint& each : scene.constraints) {
    std::visit(Overloaded{[&](const Driver<double>& driver) { at_least_of_driver(driver, 1); },
                          [&](const SlideDriver<double>& driver) { at_least_of_driver(driver, units.mechanism); },
                          [](const GroundConstraint<double>&) {}, [](const Revolute<double>&) {},
                          [](const Translational<double>&) {}},
               each.constraint);
  }
  for (const SceneBody& body : scene.bodies) {
    units.energy = std::max(units.energy, body.mass * std::pow(units.length * units.rate, 2));
  }
  return units;
}

namespace {

/// Refuses tables that the run leaves, or repeats too often.
void require_tables(const Scene& scene) {
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    const std::optional<SceneTable>& table = scene.loads[l].table;
    if (!table) continue;
    const std::string what = "loads[" + std::to_string(l) + "]";
    if (!table->of_angle) {
      require_cover(scene.file, scene.run.duration, what, *table->curves, table->delay);
      if (table->curves->is_periodic()) require_few_passages(scene.file, what, *table->curves, scene.run.duration);
    } else if (const std::optional<EvenTurn> turn = even_turn(scene, table->against)) {
      require_few_passages(scene.file, what, *table->curves, std::abs(turn->speed) * scene.run.duration);
    }
  }
  for (const SceneConstraint& each : scene.constraints) {
    std::visit(
        [&]<class Constraint>(const Constraint& constraint) {
          if constexpr (requires { constraint.shape; }) {
            require_cover(scene.file, scene.run.duration, each.name, constraint.shape);
          }
        },
        each.constraint);
  }
}

}  // namespace

namespace detail {

PreparedScene prepare(const Scene& scene) {
  require_tables(scene);
  PreparedScene prepared{planar_system<double>(scene), scene_start<double>(scene), {}};
  try {
    prepared.correction = assemble_start(prepared.system, 0.0, scene_units(scene).mechanism, prepared.start);
  } catch (const ConstraintError& error) {
    throw SceneError(scene.file + ": constraints: " + error.what());
  }
  for (std::size_t k = 0; k < scene.springs.size(); ++k) {
    const auto* spring = std::get_if<TranslationalSpring<double>>(&scene.springs[k].spring);
    if (spring == nullptr || length_of(*spring, prepared.start) > 1e-12 * scene_units(scene).mechanism) continue;
    throw SceneError(scene.file + ": springs[" + std::to_string(k) + "] \"" + scene.springs[k].name +
                     "\" has length 0 at the start that fulfils the constraints; allowed is a length above 0: a spring "
                     "of length 0 has no direction");
  }
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const JointElement<double>& joint = prepared.system.joints()[j];
    const SceneJoint& given = scene.joints[j];
    const Vector2<double> e = motion_at(prepared.start, joint).eccentricity / given.clearance;
    if (joint.contact || one_minus_squared_norm(e.x(), e.y()) > 0) continue;
    std::ostringstream message;
    message << scene.file << ": joints[" << j << "] \"" << given.name << "\": its journal starts at eccentricity ratio "
            << e.norm() << "; allowed are eccentricity ratios in [0, 1), or a transition to contact";
    throw SceneError(message.str());
  }
  return prepared;
}

}  // namespace detail

}  // namespace lubjoint

#include "lubjoint/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lubjoint/motion/multibody_results.hpp"
#include "table_times.hpp"

namespace lubjoint {

bool is_free_journal(const Scene& scene) {
  if (scene.bodies.size() != 1 || scene.joints.size() != 1 || !scene.constraints.empty() || scene.energy_ledger) {
    return false;
  }
  const SceneJoint& joint = scene.joints.front();
  const bool turned = std::any_of(scene.loads.begin(), scene.loads.end(), [](const auto& l) { return l.moment != 0; });
  const bool slows_down = joint.shear && !scene.bodies.front().spin_is_held;
  const bool steady =
      std::all_of(scene.loads.begin(), scene.loads.end(), [](const auto& l) { return l.is_constant(); });
  if (!steady || !scene.springs.empty() || !scene.sensors.empty()) return false;
  return !joint.contact && !turned && !slows_down && joint.bearing.on_ground() && is_zero(joint.journal.point);
}

namespace {

/// Times at which a body that turns evenly, in either sense, passes the knots of a table over its angle.
void add_passages(const TableCurves<3>& curves, const EvenTurn& turn, double duration, std::vector<double>& times) {
  if (turn.speed == 0) return;
  const double way = turn.speed * duration;
  std::vector<double> angles;  // from the lower end of the way on
  add_knots(curves, turn.start + std::min(way, 0.0), std::abs(way), angles);
  for (const double angle : angles) times.push_back((angle + std::min(way, 0.0)) / turn.speed);
}

}  // namespace

std::vector<SceneDriver> scene_drivers(const Scene& scene) {
  std::vector<SceneDriver> drivers;
  if (is_free_journal(scene)) return drivers;
  for (const SceneConstraint& each : scene.constraints) {
    if (!each.is_driver()) continue;
    const bool slides = std::holds_alternative<SlideDriver<double>>(each.constraint);
    drivers.push_back({each.name, slides ? "force" : "moment", slides ? "N" : "N m"});
  }
  for (const SceneBody& body : scene.bodies) {
    if (body.spin_is_held) drivers.push_back({held_spin_name(body)});
  }
  return drivers;
}

std::optional<EvenTurn> even_turn(const Scene& scene, std::size_t body) {
  if (scene.bodies[body].spin_is_held) return EvenTurn{scene.bodies[body].angle, scene.bodies[body].spin};
  for (const SceneConstraint& each : scene.constraints) {
    const auto* driver = std::get_if<Driver<double>>(&each.constraint);
    if (driver == nullptr || driver->second != body || driver->first != ground_body) continue;
    if (driver->acceleration == 0 && !driver->shape) return EvenTurn{driver->angle, driver->speed};
  }
  return std::nullopt;
}

std::vector<double> scene_knots(const Scene& scene) {
  std::vector<double> times;
  for (const SceneLoad& load : scene.loads) {
    if (!load.table) continue;
    if (!load.table->of_angle) {
      add_knots(*load.table->curves, load.table->delay, scene.run.duration, times);
    } else if (const std::optional<EvenTurn> turn = even_turn(scene, load.table->against)) {
      add_passages(*load.table->curves, *turn, scene.run.duration, times);
    }
  }
  for (const SceneConstraint& each : scene.constraints) {
    std::visit(
        [&]<class Constraint>(const Constraint& constraint) {
          if constexpr (requires { constraint.shape; }) {
            add_knots(constraint.shape, scene.run.duration, times);
          }
        },
        each.constraint);
  }
  return in_order(std::move(times));
}

std::size_t ledger_works(const Scene& scene) {
  const auto& all = scene.springs;
  const bool damped = std::any_of(all.begin(), all.end(), [](const auto& s) { return s.is_damped(); });
  return damped ? ledger_names.size() : ledger_terms;
}

bool is_massless_journal(const Scene& scene) { return is_free_journal(scene) && scene.bodies.front().mass == 0; }

}  // namespace lubjoint

#include <rapidcheck/catch.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/scenes.hpp"

namespace multibody_property_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

/// A number in [low, high], one of a thousand.
double between(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0; }

Vector2<double> vector_between(double low, double high) { return {between(low, high), between(low, high)}; }

std::string any_law() { return std::string(film_law_names[*rc::gen::inRange<std::size_t>(0, film_law_names.size())]); }

/// Turned by an angle about the origin, then moved.
Vector2<double> moved(const Vector2<double>& v, double angle, const Vector2<double>& by) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x() - s * v.y() + by.x(), s * v.x() + c * v.y() + by.y()};
}

/// A whole scene seen by another observer: turned and moved.
Scene seen_from_elsewhere(Scene scene, double angle, const Vector2<double>& by) {
  const Vector2<double> none(0, 0);
  scene.gravity = moved(scene.gravity, angle, none);
  for (SceneBody& each : scene.bodies) {
    each.position = moved(each.position, angle, by);
    each.velocity = moved(each.velocity, angle, none);
    each.angle += angle;
  }
  for (SceneLoad& load : scene.loads) load.force = moved(load.force, angle, none);
  const auto move_ground = [&](SceneAnchor& anchor) {
    if (anchor.on_ground()) anchor.point = moved(anchor.point, angle, by);
  };
  for (SceneJoint& joint : scene.joints) {
    move_ground(joint.bearing);
    move_ground(joint.journal);
  }
  for (SceneConstraint& each : scene.constraints) {
    if (auto* pin = std::get_if<Revolute<double>>(&each.constraint)) {
      move_ground(pin->first);
      move_ground(pin->second);
    } else if (auto* guide = std::get_if<Translational<double>>(&each.constraint)) {
      if (guide->first.on_ground()) {
        guide->axis = moved(guide->axis, angle, none);
        guide->angle += angle;
      }
      move_ground(guide->first);
    } else if (auto* driver = std::get_if<Driver<double>>(&each.constraint)) {
      if (driver->first == ground_body) driver->angle += angle;
    }
  }
  return scene;
}

Scene slider_crank() {
  Scene scene = load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/slider-crank.toml");
  scene.run.duration = 0.006;
  set_tolerance(scene, 1e-8);
  return scene;
}

/// A crank that turns right round, a coupler and a rocker, from any position.
Scene four_bar() {
  const double crank = between(0.03, 0.06);
  const double coupler = between(0.15, 0.2);
  const double rocker = between(0.12, 0.18);
  const double ground = between(0.15, 0.19);  // Grashof: the crank turns right round
  const double angle = between(-3, 3);
  // Where coupler and rocker meet: two circles.
  const Vector2<double> a(crank * std::cos(angle), crank * std::sin(angle));
  const Vector2<double> b(ground, 0);
  const double d = (b - a).norm();
  RC_PRE(d < 0.98 * (coupler + rocker) && d > 1.02 * std::abs(coupler - rocker));
  const double along = (coupler * coupler - rocker * rocker + d * d) / (2 * d);
  const Vector2<double> towards = (b - a) / d;
  const Vector2<double> meet =
      a + along * towards + std::sqrt(coupler * coupler - along * along) * perpendicular(towards);
  const auto rod = [](const std::string& name, const Vector2<double>& from, const Vector2<double>& to) {
    return body(name, 0.2, 2e-4, (from + to) / 2, std::atan2(to.y() - from.y(), to.x() - from.x()));
  };
  Scene scene;
  scene.file = scene.name = "four-bar";
  scene.gravity = {0, -9.81};
  scene.bodies = {rod("crank", {0, 0}, a), rod("coupler", a, meet), rod("rocker", b, meet)};
  scene.constraints = {{"a", Revolute<double>{{ground_body, {0, 0}}, {0, {-crank / 2, 0}}}},
                       {"b", Revolute<double>{{0, {crank / 2, 0}}, {1, {-coupler / 2, 0}}}},
                       {"c", Revolute<double>{{1, {coupler / 2, 0}}, {2, {rocker / 2, 0}}}},
                       {"d", Revolute<double>{{2, {-rocker / 2, 0}}, {ground_body, b}}}};
  return scene;
}

/// Speed after a free impact over the speed before it, with u = δ̇/δ̇₀ and α = 3(1 − c_r²)/4: m v dv/dδ = −Kδ^{3/2}(1 +
/// αu) keeps ∫ u du/(1 + αu), so that u₁ solves (1 + u₁)/α = ln((1 + α)/(1 − αu₁))/α².
double exit_speed_ratio(double restitution) {
  const double alpha = 3 * (1 - restitution * restitution) / 4;
  const auto defect = [&](double u) { return alpha * (1 + u) - std::log1p(alpha) + std::log1p(-alpha * u); };
  // Zero at u = −1, too: the root is where the defect, which first rises, has come down again.
  double low = 1e-3;
  double high = std::min(1.0, (1 - 1e-15) / alpha);
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (defect(middle) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

TEST_CASE("multibody systems obey momentum, frame indifference and order") {
  rc::prop("a film or a contact between free bodies gives them no momentum, linear or angular", [] {
    Scene scene;
    scene.bodies = {body("housing", between(0.1, 2), between(1e-4, 1e-2), vector_between(-1, 1), between(-3, 3)),
                    body("shaft", between(0.1, 2), between(1e-4, 1e-2), {0, 0}, between(-3, 3))};
    SceneJoint joint = dry_joint({0, vector_between(-0.1, 0.1)}, {1, vector_between(-0.1, 0.1)}, between(0.1, 1));
    joint.film = any_law();
    joint.viscosity = between(0.01, 1);
    joint.contact->friction = between(0, 0.3);
    joint.transition = SceneTransition{2e-5, 4e-5};
    scene.joints = {joint};
    const auto system = planar_system<double>(scene);
    auto w = system.workspace<double>();
    std::vector<double> y = scene_start<double>(scene);
    for (std::size_t i = 6; i < 12; ++i) y[i] = between(-1, 1);
    y[8] = between(-300, 300);
    y[11] = between(-300, 300);
    // The shaft where the journal is at a chosen place, in the film, the blend or the wall.
    const double direction = between(0, 6.28);
    const double distance = 0.0002 * between(0.001, 1.3);
    const Vector2<double> none(0, 0);
    const Vector2<double> centre =
        moved(joint.bearing.point, y[2], {y[0], y[1]}) - moved(joint.journal.point, y[5], none);
    y[3] = centre.x() + distance * std::cos(direction);
    y[4] = centre.y() + distance * std::sin(direction);
    const TransitionTolerances<double> widths(2e-5, 4e-5);
    const std::vector<JointMemory<double>> memory = {{contact_phase(distance, 0.0002, widths), between(0.01, 1)}};
    system.evaluate(0.0, y.data(), memory, w);
    const double force = w.joints[0].total().norm();
    const auto& a = w.accelerations;
    double angular = 0;
    for (std::size_t b = 0; b < 2; ++b) {
      const SceneBody& each = scene.bodies[b];
      angular += each.inertia * a[3 * b + 2] + each.mass * (y[3 * b] * a[3 * b + 1] - y[3 * b + 1] * a[3 * b]);
    }
    const double x = scene.bodies[0].mass * a[0] + scene.bodies[1].mass * a[3];
    const double up = scene.bodies[0].mass * a[1] + scene.bodies[1].mass * a[4];
    RC_ASSERT(std::hypot(x, up) <= 1e-14 * force);  // roundings of two products
    RC_ASSERT(std::abs(angular) <= 2e-14 * force);  // the same, arms below 1.5 m
  });

  rc::prop("the force is continuous at both seams, for every law, velocity, e0 and e1", [] {
    SceneJoint given = dry_joint({ground_body, {0, 0}}, {0, {0, 0}}, between(0, 1));
    given.film = any_law();
    given.viscosity = between(1e-3, 1);
    const double e0 = between(1e-6, 5e-5);
    given.transition = SceneTransition{e0, e0 * between(1.05, 5)};
    Scene scene;
    scene.bodies = {body("journal", 1, 1, {0, 0})};
    scene.joints = {given};
    const auto system = planar_system<double>(scene);
    const JointElement<double>& joint = system.joints()[0];
    const double angle = between(0, 6.28);
    const Vector2<double> v = vector_between(-2, 2);
    const double spin = between(-500, 500);
    const double impact_speed = between(0.001, 2);
    const PlanarFrame<double> ground(ground_motion<double>());
    const auto force = [&](double distance, ContactPhase phase) {
      const Vector2<double> e(distance * std::cos(angle), distance * std::sin(angle));
      const PlanarFrame<double> journal(PlanarMotion<double>{e, 0, v, spin});
      return joint.force(ground, journal, {phase, impact_speed}).total();
    };
    const double c = given.clearance;
    const double scale = 1 + force(c, ContactPhase::film).norm() + force(c + e0, ContactPhase::dry).norm();
    const double inner = (force(c, ContactPhase::film) - force(c, ContactPhase::blend)).norm();
    const double outer = (force(c + e0, ContactPhase::blend) - force(c + e0, ContactPhase::dry)).norm();
    // The distance is rounded (1e-16 of c), and e0 may be c/200: 1e-13; the film is steep by up to (e1 - e0)/c.
    RC_ASSERT(inner <= 1e-10 * scale);
    RC_ASSERT(outer <= 1e-10 * scale);
  });

  rc::prop("a scene that is turned and moved gives the answer turned and moved", [] {
    static const MultibodyTrajectory here = simulate_multibody(slider_crank());
    const double angle = between(-3, 3);
    const Scene there = seen_from_elsewhere(slider_crank(), angle, vector_between(-0.2, 0.2));
    const MultibodyTrajectory run = simulate_multibody(there);
    RC_ASSERT(run.outcome.status == RunStatus::finished);
    const Vector2<double> expected = moved(here.samples.back().joints[0].eccentricity, angle, {0, 0});
    const double gap = (run.samples.back().joints[0].eccentricity - expected).norm() / 0.0002;
    RC_ASSERT(gap < 1e-6);  // two runs at 1e-8, other steps
    RC_ASSERT(std::abs(run.drivers[0].max_moment.value - here.drivers[0].max_moment.value) < 1e-4);
  });

  rc::prop("the order of bodies and constraints in the file does not matter", [] {
    static const MultibodyTrajectory here = simulate_multibody(slider_crank());
    Scene scene = slider_crank();
    const std::vector<std::size_t> place = *rc::gen::element(
        std::vector<std::size_t>{2, 0, 1}, std::vector<std::size_t>{1, 2, 0}, std::vector<std::size_t>{2, 1, 0});
    std::vector<SceneBody> bodies(3);
    for (std::size_t b = 0; b < 3; ++b) bodies[place[b]] = scene.bodies[b];
    scene.bodies = bodies;
    const auto rename = [&](SceneAnchor& anchor) {
      if (!anchor.on_ground()) anchor.body = place[anchor.body];
    };
    for (SceneJoint& joint : scene.joints) {
      rename(joint.bearing);
      rename(joint.journal);
    }
    for (SceneConstraint& each : scene.constraints) {
      if (auto* pin = std::get_if<Revolute<double>>(&each.constraint)) {
        rename(pin->first);
        rename(pin->second);
      } else if (auto* guide = std::get_if<Translational<double>>(&each.constraint)) {
        rename(guide->first);
        rename(guide->second);
      } else if (auto* driver = std::get_if<Driver<double>>(&each.constraint)) {
        driver->second = place[driver->second];
      }
    }
    if (*rc::gen::arbitrary<bool>()) std::reverse(scene.constraints.begin(), scene.constraints.end());
    const MultibodyTrajectory run = simulate_multibody(scene);
    const auto gap = run.samples.back().joints[0].eccentricity - here.samples.back().joints[0].eccentricity;
    RC_ASSERT(gap.norm() / 0.0002 < 1e-8);  // the same steps but for rounding
  });
}

TEST_CASE("random mechanisms keep their constraints and close their ledgers") {
  rc::prop("four-bars from any position, driven or falling, by either upkeep", [] {
    Scene scene = four_bar();
    const bool driven = *rc::gen::arbitrary<bool>();
    if (driven)
      scene.constraints.push_back(
          {"motor", Driver<double>{ground_body, 0, scene.bodies[0].angle, between(-20, 20), 0}});
    scene.stabilisation = *rc::gen::arbitrary<bool>() ? SceneStabilisation{true, 0, 0} : SceneStabilisation{};
    scene.run.duration = 0.3;
    scene.energy_ledger = true;
    set_tolerance(scene, 1e-9);
    const MultibodyTrajectory run = simulate_multibody(scene);
    RC_ASSERT(run.outcome.status == RunStatus::finished);
    RC_ASSERT(run.drift.position < 1e-7);
    RC_ASSERT(*run.energy_residual < 100 * 1e-9 * std::max(run.energy_scale, 0.1));
  });

  rc::prop("chains of pendulums", [] {
    Scene scene = pendulum_chain(*rc::gen::inRange<std::size_t>(1, 6), between(-1.5, 1.5));
    scene.run.duration = 0.5;
    set_tolerance(scene, 1e-9);
    const MultibodyTrajectory run = simulate_multibody(scene);
    RC_ASSERT(run.outcome.status == RunStatus::finished);
    RC_ASSERT(run.drift.position < 1e-7);
    RC_ASSERT(*run.energy_residual < 100 * 1e-9 * std::max(run.energy_scale, 0.01));
  });
}

TEST_CASE("free impacts leave with the exact exit speed, which is above what the coefficient says") {
  rc::prop("a journal thrown at the dry wall of its bearing", [] {
    const double restitution = between(0.05, 0.95);
    const double speed = between(0.05, 2);
    const double direction = between(0, 6.28);
    const Vector2<double> r(std::cos(direction), std::sin(direction));
    Scene scene;
    scene.file = scene.name = "impact";
    scene.bodies = {body("journal", between(0.05, 5), 1e-3, {0, 0})};
    scene.bodies[0].velocity = speed * r;
    scene.joints = {dry_joint({ground_body, {0, 0}}, {0, {0, 0}}, restitution)};
    scene.run.duration = 0.0003 / speed + 0.002;
    set_tolerance(scene, 1e-10);
    const MultibodyTrajectory run = simulate_multibody(scene);
    RC_ASSERT(run.outcome.status == RunStatus::finished);
    RC_ASSERT(run.events.size() >= 2u);
    RC_ASSERT(std::abs(run.events[0].normal_speed - speed) < 1e-9 * speed);  // free flight: rounding and 1e-10
    const double exit = -run.events[1].normal_speed / speed;
    RC_ASSERT(std::abs(exit - exit_speed_ratio(restitution)) < 1e-6);  // 1e-10 of a clearance over an impact of 1e-4 s
    RC_ASSERT(exit > restitution);
  });
}

TEST_CASE("reactions balance") {
  rc::prop("each constraint's on its two bodies, and all of the ground's with what the bodies gain", [] {
    const Scene scene = four_bar();
    const auto system = planar_system<double>(scene);
    auto w = system.workspace<double>();
    std::vector<double> y = scene_start<double>(scene);
    for (std::size_t i = 9; i < 18; ++i) y[i] = between(-5, 5);
    system.evaluate(0.0, y.data(), {}, w);
    double size = 1;
    for (const double lambda : w.multipliers) size += std::abs(lambda);
    std::array<double, 3> from_ground{0, 0, 0};
    for (std::size_t c = 0; c < 4; ++c) {
      // −Φqᵀλ on both bodies, moments about the origin.
      std::array<double, 3> sum{0, 0, 0};
      const auto add = [&](std::size_t b, const std::array<double, 3>& f, std::array<double, 3>& to) {
        to[0] += f[0];
        to[1] += f[1];
        to[2] += f[2] + y[3 * b] * f[1] - y[3 * b + 1] * f[0];
      };
      for (std::size_t row = system.first_row(c); row < system.first_row(c + 1); ++row) {
        for (const bool second : {false, true}) {
          const std::size_t b = second ? system.second_body_of_row(row) : system.first_body_of_row(row);
          if (b == ground_body) continue;
          const auto& columns = second ? w.rows[row].second : w.rows[row].first;
          const double factor = -w.multipliers[row];
          add(b, {factor * columns[0], factor * columns[1], factor * columns[2]}, sum);
        }
      }
      const bool on_ground = c == 0 || c == 3;
      for (std::size_t k = 0; k < 3; ++k) {
        if (on_ground) from_ground[k] += sum[k];
        if (!on_ground) RC_ASSERT(std::abs(sum[k]) < 1e-13 * size);  // roundings of a few products, arms below 0.4 m
      }
    }
    std::array<double, 3> gained{0, 0, 0};
    for (std::size_t b = 0; b < 3; ++b) {
      const SceneBody& each = scene.bodies[b];
      const double* a = &w.accelerations[3 * b];
      gained[0] += each.mass * a[0];
      gained[1] += each.mass * (a[1] + 9.81);
      gained[2] += each.inertia * a[2] + each.mass * (y[3 * b] * (a[1] + 9.81) - y[3 * b + 1] * a[0]);
    }
    for (std::size_t k = 0; k < 3; ++k)
      RC_ASSERT(std::abs(gained[k] - from_ground[k]) < 1e-12 * size);  // solve included
  });
}

}  // namespace multibody_property_test

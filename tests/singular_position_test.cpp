// Singular positions, where constraints stop being independent: every integrator names them, and runs that come near
// one but not to it go on.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "lubjoint/motion/stop_words.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/scenes.hpp"

namespace singular_position_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

constexpr double crank_length = 0.1;
constexpr double base_length = 0.2;
constexpr double speed = 10;

/// A four-bar whose rocker is `excess` longer than its crank, coupler as long as the base: with 0 a parallelogram,
/// whose change points are at crank angles 0 and π. It starts with the crank upright.
Scene four_bar(double excess, bool driven) {
  const double rocker_length = crank_length + excess;
  // The rocker's end is a coupler's length from the crank's, (0, 0.1).
  const double distance = std::hypot(base_length, crank_length);
  const double at_base = std::acos((rocker_length * rocker_length + distance * distance - base_length * base_length) /
                                   (2 * rocker_length * distance));
  const double rocker_angle = std::numbers::pi - std::atan2(crank_length, base_length) - at_base;
  const Vector2<double> rocker_end(base_length + rocker_length * std::cos(rocker_angle),
                                   rocker_length * std::sin(rocker_angle));
  const Vector2<double> crank_end(0, crank_length);
  const Vector2<double> base(base_length, 0);
  Scene scene;
  scene.file = scene.name = "four-bar";
  scene.bodies = {body("crank", 1, 1e-3, 0.5 * crank_end), body("coupler", 1, 4e-3, 0.5 * (crank_end + rocker_end)),
                  body("rocker", 1, 1e-3, 0.5 * (base + rocker_end))};
  scene.bodies[0].angle = std::numbers::pi / 2;
  scene.bodies[1].angle = std::atan2(rocker_end.y() - crank_end.y(), rocker_end.x() - crank_end.x());
  scene.bodies[2].angle = rocker_angle;
  for (const std::size_t b : {0, 2}) scene.bodies[b].spin = speed;
  for (std::size_t b = 0; b < 3; ++b) scene.bodies[b].velocity = {(b == 1 ? -1 : -0.5) * speed * crank_length, 0};
  const auto pin = [](const char* name, BodyPoint<double> first, BodyPoint<double> second) {
    return SceneConstraint{name, Revolute<double>{first, second}};
  };
  const double half = base_length / 2;
  scene.constraints = {
      pin("crank-bearing", {ground_body, {0, 0}}, {0, {-crank_length / 2, 0}}),
      pin("crank-pin", {0, {crank_length / 2, 0}}, {1, {-half, 0}}),
      pin("rocker-pin", {1, {half, 0}}, {2, {rocker_length / 2, 0}}),
      pin("rocker-bearing", {ground_body, base}, {2, {-rocker_length / 2, 0}}),
  };
  if (driven) {
    scene.constraints.push_back({"motor", Driver<double>{ground_body, 0, std::numbers::pi / 2, speed, 0}});
  }
  scene.run.duration = 0.3;  // from π/2 by 3 rad, across π
  scene.run.output_interval = 1e-3;
  set_tolerance(scene, 1e-8);
  return scene;
}

}  // namespace

TEST_CASE("singular positions: every integrator names a parallelogram's change point, when and which constraint") {
  const double change_point = std::numbers::pi / 2 / speed;
  for (const std::string_view integrator : integrator_names()) {
    for (const bool driven : {true, false}) {
      Scene scene = four_bar(0, driven);
      scene.integrator = integrator;
      const MultibodyTrajectory run = simulate_multibody(scene);
      INFO(integrator << (driven ? ", driven" : ", free") << ": " << run.outcome.message);
      REQUIRE(run.outcome.status == RunStatus::stopped);
      CHECK_THAT(run.outcome.message, Contains("singular position") && Contains("not independent: \""));
      CHECK(run.outcome.message.find("viscosity") == std::string::npos);
      CHECK(run.outcome.message.find("radau") == std::string::npos);
      // A step ends beyond it, or gets no further.
      const std::string passed = "passed, at ";
      const std::size_t at = run.outcome.message.find(passed);
      const double place =
          at == std::string::npos ? run.outcome.t_end : std::stod(run.outcome.message.substr(at + passed.size()));
      CHECK(std::abs(place - change_point) < 1e-4);  // the sine 1e-4 that counts as close, over 10 rad/s
      CHECK(run.outcome.t_end > change_point - 1e-4);
    }
  }
}

TEST_CASE("singular positions: one that the run's last step passes is named, too") {
  Scene scene = four_bar(0, true);
  scene.run.duration = std::numbers::pi / 2 / speed + 1e-5;
  const MultibodyTrajectory run = simulate_multibody(scene);
  INFO(run.outcome.message);
  CHECK(run.outcome.status == RunStatus::stopped);
  CHECK_THAT(run.outcome.message, Contains("singular position"));
  scene.run.duration = std::numbers::pi / 2 / speed - 5e-3;  // 0.05 rad before it
  CHECK(simulate_multibody(scene).outcome.status == RunStatus::finished);
}

TEST_CASE("singular positions: a mechanism that comes near one, and not to it, goes on") {
  // The rocker is a ten-thousandth longer: bars are as near as some hundredths of a radian to a line.
  for (const std::string_view integrator : integrator_names()) {
    Scene scene = four_bar(1e-5, true);
    scene.integrator = integrator;
    const MultibodyTrajectory run = simulate_multibody(scene);
    INFO(integrator << ": " << run.outcome.message);
    CHECK(run.outcome.status == RunStatus::finished);
  }
}

TEST_CASE("singular positions: a light rod with a heavy bob swings through the vertical") {
  // Masses of 1e10 to 1: seen by their inverse roots, the rows that hold the rod are 1e-5 from dependent there.
  Scene scene;
  scene.name = "pendulum";
  scene.gravity = {0, -9.81};
  const double angle = 0.2;
  const Vector2<double> along(std::sin(angle), -std::cos(angle));
  scene.bodies.push_back(body("rod", 1e-9, 1e-11, 0.5 * along, angle));
  scene.bodies.push_back(body("bob", 10, 0.1, along, angle));
  scene.constraints.push_back({"pivot", Revolute<double>{{ground_body, {0, 0}}, {0, {0, 0.5}}}});
  scene.constraints.push_back({"pin", Revolute<double>{{0, {0, -0.5}}, {1, {0, 0}}}});
  scene.run.duration = 1;  // half a period
  scene.run.output_interval = 0.1;
  set_tolerance(scene, 1e-6);
  for (const char* integrator : {"radau_iia5", "dopri5"}) {
    scene.integrator = integrator;
    const MultibodyTrajectory run = simulate_multibody(scene);
    INFO(integrator << ": " << run.outcome.message);
    CHECK(run.outcome.status == RunStatus::finished);
  }
}

TEST_CASE("singular positions: a tolerance too coarse to tell one stops no mechanism that has none") {
  Scene scene = load_scene(LUBJOINT_SOURCE_DIR "/data/scenes/slider-crank.toml");
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 0.1;
  scene.run.duration = 0.006;
  const RunOutcome outcome = simulate_multibody(scene).outcome;
  INFO(outcome.message);
  CHECK(outcome.status == RunStatus::finished);
}

TEST_CASE("stops: an implicit integrator is not told to be one, and a thin film is named where there is one") {
  CHECK(detail::remedy_words(true, 0.5).find("radau") == std::string::npos);
  CHECK(detail::remedy_words(true, 1).find("viscosity") == std::string::npos);
  CHECK_THAT(detail::remedy_words(true, 1e-9), Contains("viscosity"));
  CHECK_THAT(detail::remedy_words(false, 0.5), Contains("radau_iia5"));
}

}  // namespace singular_position_test

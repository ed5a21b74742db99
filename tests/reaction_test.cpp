// Reactions of ideal constraints, their peaks, and what sensors show.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "lubjoint/scene/trajectory_table.hpp"
#include "oracle/mechanisms/slider_crank.hpp"
#include "oracle/trajectories/slider_crank_reference.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"
#include "support/scenes.hpp"

namespace reaction_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;
using Json = nlohmann::ordered_json;

namespace {

const std::string ideal = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/slider-crank-ideal.toml";

/// What the constraints of the ideal slider-crank carry at a crank angle, by Newton and Euler.
struct Forces {
  double main_bearing, crank_pin, gudgeon_pin, guide;
};
Forces forces_at(const mechanisms::SliderCrank<double>& m, double angle, double speed) {
  const auto r = mechanisms::ideal_reactions<double>(m, {angle, speed, 0});
  const double half = m.crank_length / 2;
  const Vector2<double> crank = -half * speed * speed * Vector2<double>(std::cos(angle), std::sin(angle));
  const Vector2<double> main = m.crank_mass * crank + r.crank_pin;  // the crank pin pulls the crank back
  return {main.norm(), r.crank_pin.norm(), r.gudgeon_pin.norm(), std::abs(r.gudgeon_pin.y())};
}

}  // namespace

TEST_CASE("reactions: peaks of the ideal slider-crank's are the largest of its closed form") {
  Scene scene = load_scene(ideal);
  set_tolerance(scene, 1e-11);
  const MultibodyTrajectory run = simulate_multibody(scene);
  const auto mechanism = reports::slider_crank_of(scene);
  const double speed = reports::crank_speed_of(scene);
  Forces largest{0, 0, 0, 0};
  for (int i = 0; i <= 200000; ++i) {
    const Forces f = forces_at(mechanism, 2 * std::numbers::pi * i / 200000, speed);
    largest = {std::max(largest.main_bearing, f.main_bearing), std::max(largest.crank_pin, f.crank_pin),
               std::max(largest.gudgeon_pin, f.gudgeon_pin), std::max(largest.guide, f.guide)};
  }
  REQUIRE(run.reactions.size() == 4);
  const auto peak_of = [&](const std::string& name) {
    for (const ReactionExtremes& each : run.reactions) {
      if (scene.constraints[each.constraint].name == name) return each;
    }
    FAIL(name);
    return ReactionExtremes();
  };
  // A search on a grid of 3e-5 rad and a run at 1e-11: parts in 1e9, and ten for safety.
  CHECK(peak_of("main-bearing").force.value == Approx(largest.main_bearing).epsilon(1e-8));
  CHECK(peak_of("crank-pin").force.value == Approx(largest.crank_pin).epsilon(1e-8));
  CHECK(peak_of("gudgeon-pin").force.value == Approx(largest.gudgeon_pin).epsilon(1e-8));
  CHECK(peak_of("guide").force.value == Approx(largest.guide).epsilon(1e-8));
  for (const ReactionExtremes& each : run.reactions) {
    const double there = [&] {
      const Forces f = forces_at(mechanism, speed * each.force.t, speed);
      const std::string& name = scene.constraints[each.constraint].name;
      return name == "main-bearing" ? f.main_bearing
             : name == "crank-pin"  ? f.crank_pin
             : name == "guide"      ? f.guide
                                    : f.gudgeon_pin;
    }();
    CHECK(each.force.value == Approx(there).epsilon(1e-8));  // it is reached when it is said to be
  }
  CHECK_FALSE(peak_of("crank-pin").moment);
  REQUIRE(peak_of("guide").moment);
  CHECK(peak_of("guide").moment->value < 1e-6);  // the pin is at the slider's mass centre: rounding of 2700 N
}

TEST_CASE("reactions: a pendulum's pin carries weight and centripetal force, a clamp its load and moment") {
  const double m = 2;
  const double inertia = 0.3;
  const double a = 0.4;
  Scene scene;
  scene.file = scene.name = "pendulum";
  scene.gravity = {0, -9.81};
  scene.run.duration = 2;
  scene.run.output_interval = 0.02;
  set_tolerance(scene, 1e-11);
  scene.bodies = {body("rod", m, inertia, {a, 0}), body("held", 1, 1, {3, 0})};
  scene.constraints = {{"pin", Revolute<double>{{}, {0, {-a, 0}}}}, {"clamp", GroundConstraint<double>{1, {3, 0}, 0}}};
  SceneLoad load{1, {4, -7}, 0.25};
  load.point = {0.5, 0.2};
  scene.loads = {load};
  scene.sensors = {
      {"pin-force", ReactionSensor{0}}, {"clamp-force", ReactionSensor{1}}, {"tip", PointSensor{{0, {0.1, 0}}}}};
  const MultibodyTrajectory run = simulate_multibody(scene);
  const double whole = inertia + m * a * a;
  for (const MultibodySample& sample : run.samples) {
    const double angle = sample.state[2];
    const double squared = -2 * m * 9.81 * a * std::sin(angle) / whole;  // from energy, and it falls from 0
    const double acceleration = -m * 9.81 * a * std::cos(angle) / whole;
    const double fx = m * a * (-acceleration * std::sin(angle) - squared * std::cos(angle));
    const double fy = m * a * (acceleration * std::cos(angle) - squared * std::sin(angle)) + m * 9.81;
    CHECK(std::abs(sample.sensors[0] - fx) < 1e-7);  // 20 N at 1e-11 times some hundred steps
    CHECK(std::abs(sample.sensors[1] - fy) < 1e-7);
    CHECK(std::abs(sample.sensors[2]) < 1e-10);  // a pin holds no moment: rounding
    CHECK(sample.sensors[3] == Approx(-4));
    CHECK(sample.sensors[4] == Approx(7 + 9.81));
    CHECK(sample.sensors[5] == Approx(-(0.25 + 0.5 * -7 - 0.2 * 4)));
    CHECK(std::abs(sample.sensors[6] - 0.5 * std::cos(angle)) < 1e-9);
    CHECK(std::abs(sample.sensors[8] + 0.5 * std::sin(angle) * sample.state[8]) < 1e-9);
  }
  // The largest force hangs straight down: m g + m a φ̇².
  CHECK(run.reactions[0].force.value == Approx(m * 9.81 * (1 + 2 * m * a * a / whole)).epsilon(1e-9));
  REQUIRE(run.reactions[1].moment);
  CHECK(run.reactions[1].moment->value == Approx(4.05));
  // Sensors' extremes are those of the motion: the tip at the lowest place.
  REQUIRE(run.sensors.size() == 10);
  CHECK(run.sensors[7].min.value == Approx(-0.5).epsilon(1e-9));
  CHECK(run.sensors[6].max.value == Approx(0.5).epsilon(1e-9));
  const TrajectoryTable table = trajectory_table(scene, run);
  const std::vector<std::string> last(table.columns.end() - 10, table.columns.end());
  CHECK(last == std::vector<std::string>{"pin-force.fx", "pin-force.fy", "pin-force.moment", "clamp-force.fx",
                                         "clamp-force.fy", "clamp-force.moment", "tip.x", "tip.y", "tip.vx", "tip.vy"});
}

TEST_CASE("reactions: summary, JSON, later part and sweep have them without being asked") {
  const ProgramResult text = lubjoint_program({"simulate", ideal});
  CHECK_THAT(text.out, Contains("reaction     gudgeon-pin: force 2718.71 N at "));
  const ProgramResult result = lubjoint_program({"simulate", ideal, "--json", "--last-revolution"});
  REQUIRE(result.status == 0);
  const Json json = Json::parse(result.out);
  REQUIRE(json["reactions"].size() == 4);
  const Json& pin = json["reactions"][3];
  CHECK(pin["name"] == "gudgeon-pin");
  CHECK(pin["max_force"].get<double>() == Approx(2718.71).epsilon(2e-6));  // half the last digit
  CHECK(pin["max_moment"].is_null());
  CHECK(pin["after"]["max_force"].get<double>() == Approx(2718.71).epsilon(2e-6));
  CHECK(pin["after"]["t_max_force"].get<double>() >= pin["after"]["t"].get<double>());
  CHECK(json["reactions"][2]["max_moment"].is_number());
  CHECK_FALSE(json.contains("sensors"));
  CHECK_FALSE(json.contains("singular_positions"));
  const ProgramResult sweep =
      lubjoint_program({"sweep", ideal, "--vary", "bodies.slider.mass=0.14:0.28:2", "--rtol", "1e-6"});
  REQUIRE(sweep.status == 0);
  const std::vector<CsvRow> rows = parse_csv(sweep.out);
  REQUIRE(rows.size() == 2);
  CHECK(number(rows[0].at("gudgeon-pin.max_force")) == Approx(2718.71).epsilon(1e-5));
  // Twice the slider's mass: a force along the guide twice as large.
  CHECK(number(rows[1].at("gudgeon-pin.max_force")) > 1.9 * number(rows[0].at("gudgeon-pin.max_force")));
  CHECK(rows[0].at("crank-pin.max_moment").empty());
  CHECK(sweep.out.find("rhs_evaluations,main-bearing.max_force") != std::string::npos);  // behind what was there before
}

}  // namespace reaction_test

// Sensors in space: those of the plane, turned with it, and those of springs and places.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "oracle/results/spatial_report.hpp"
#include "support/embedded_scene.hpp"

namespace space_sensor_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

std::size_t column(const TrajectoryTable& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  REQUIRE(found != table.columns.end());
  return static_cast<std::size_t>(found - table.columns.begin());
}
Vector3<double> vector_of(const TrajectoryTable& table, std::size_t row, const std::string& name,
                          const std::array<const char*, 3>& parts) {
  Vector3<double> v;
  for (Eigen::Index k = 0; k < 3; ++k)
    v(k) = table.rows[row][column(table, name + "." + parts[static_cast<std::size_t>(k)])].value();
  return v;
}

}  // namespace

TEST_CASE("sensors in space: of a mechanism that is turned anywhere they show the plane's, turned") {
  Scene flat = load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/slider-crank.toml");
  flat.run.duration = 0.01;
  flat.run.output_interval = 0.002;
  flat.run.relative_tolerance = flat.run.absolute_tolerance = 1e-10;
  const std::size_t pin = 1;
  REQUIRE(flat.constraints[pin].name == "crank-pin");
  const std::size_t rod = 1, slider = 2;
  flat.sensors = {{"pin", ReactionSensor{pin}},
                  {"mark", PointSensor{{rod, {0.05, -0.01}}}},
                  {"reach", DistanceSensor{{rod, {0.01, 0.02}}, {slider, {0.003, 0.0}}}}};
  const reports::Plane plane = some_plane(5);
  SpatialScene scene = reports::Embedding(plane).scene(flat);
  allow_what_is_redundant(scene);
  REQUIRE(scene.constraints[pin].name == "crank-pin");
  scene.sensors = {{"pin", ReactionSensor{pin}},
                   {"mark", SpatialPointSensor{{rod, {0.05, -0.01, 0}}}},
                   {"reach", SpatialDistanceSensor{{rod, {0.01, 0.02, 0}}, {slider, {0.003, 0, 0}}}}};
  const TrajectoryTable two = trajectory_table(flat, simulate_multibody(flat));
  const SpatialTrajectory run = simulate_spatial(scene);
  const TrajectoryTable three = trajectory_table(scene, run);
  REQUIRE(two.rows.size() == three.rows.size());
  const auto in_plane = [&](const Vector3<double>& v) {
    return transposed_product(rotation_matrix(plane.orientation), v);
  };
  for (std::size_t row = 0; row < two.rows.size(); ++row) {
    CAPTURE(row);
    const auto flat_value = [&](const char* name) { return two.rows[row][column(two, name)].value(); };
    // Across the plane what the rows that were left out would bear is anyone's.
    const Vector3<double> force = in_plane(vector_of(three, row, "pin", {"fx", "fy", "fz"}));
    const double size = 1 + std::hypot(flat_value("pin.fx"), flat_value("pin.fy"));
    CHECK(std::abs(force.x() - flat_value("pin.fx")) < 1e-6 * size);  // a film multiplies 1e-10 of a clearance by 1e3
    CHECK(std::abs(force.y() - flat_value("pin.fy")) < 1e-6 * size);  // likewise
    const Vector3<double> moment = in_plane(vector_of(three, row, "pin", {"mx", "my", "mz"}));
    CHECK(std::abs(moment.z()) < 1e-9 * size);  // a pin bears none about its axis
    const Vector3<double> place = in_plane(difference(vector_of(three, row, "mark", {"x", "y", "z"}), plane.shift));
    CHECK(std::abs(place.x() - flat_value("mark.x")) < 1e-12);  // 1e-10 of a clearance of 0.2 mm, and rounding
    CHECK(std::abs(place.y() - flat_value("mark.y")) < 1e-12);  // likewise
    CHECK(std::abs(place.z()) < 1e-12);                         // likewise
    const Vector3<double> velocity = in_plane(vector_of(three, row, "mark", {"vx", "vy", "vz"}));
    CHECK(std::abs(velocity.x() - flat_value("mark.vx")) < 1e-8);  // places times 1e4/s, at which films answer and more
    CHECK(std::abs(velocity.y() - flat_value("mark.vy")) < 1e-8);  // likewise
    CHECK(std::abs(three.rows[row][column(three, "reach.distance")].value() - flat_value("reach.distance")) < 1e-12);
    CHECK(std::abs(three.rows[row][column(three, "reach.rate")].value() - flat_value("reach.rate")) <
          1e-8);  // likewise
  }
  // Peaks are at least those of the samples, and no higher than the motion between them allows.
  REQUIRE(run.sensors.size() == 6 + 6 + 2);
  std::size_t k = 0;
  for (const SpatialSensor& sensor : scene.sensors) {
    for (const char* quantity : sensor_quantities(sensor)) {
      CAPTURE(sensor.name, quantity);
      double high = -1e300, low = 1e300;
      for (const auto& row : three.rows) {
        const double value = row[column(three, sensor.name + "." + quantity)].value();
        high = std::max(high, value);
        low = std::min(low, value);
      }
      const double rounding = 1e-9 * (1 + std::abs(high) + std::abs(low));  // of forces at two ends of a step
      CHECK(run.sensors[k].max.value >= high - rounding);
      CHECK(run.sensors[k].min.value <= low + rounding);
      ++k;
    }
  }
  const auto json = reports::summary_json(scene, run);
  CHECK(json["sensors"][1]["name"] == "mark");
  CHECK(json["sensors"][1]["vz"]["max"] == run.sensors[6 + 5].max.value);
  CHECK(reports::summary_text(scene, run).find("sensor       reach\n  distance ") != std::string::npos);
}

TEST_CASE("sensors in space: a spring's tension is its law's, of the distance that another sensor shows") {
  const SpatialScene scene = parse_spatial_scene(R"(
dimension = 3
name = "hung"
duration = 0.5
joints = []
gravity = [0.0, 0.0, -9.81]
[[bodies]]
name = "bob"
mass = 0.3
inertia = [1e-4, 1e-4, 1e-4]
position = [0.1, 0.02, -0.3]
spin = [1.0, 2.0, -3.0]
[[springs]]
name = "cord"
first = {body = "ground", point = [0.0, 0.0, 0.1]}
second = {body = "bob", point = [0.01, 0.0, 0.02]}
stiffness = 50.0
free_length = 0.3
damping = 0.7
preload = 0.2
[[sensors]]
name = "tension"
type = "spring"
spring = "cord"
[[sensors]]
name = "length"
type = "distance"
first = {body = "ground", point = [0.0, 0.0, 0.1]}
second = {body = "bob", point = [0.01, 0.0, 0.02]}
[[sensors]]
name = "centre"
type = "point"
body = "bob"
[output]
interval = 0.05
)",
                                                 "hung.toml");
  const SpatialTrajectory run = simulate_spatial(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  const TrajectoryTable table = trajectory_table(scene, run);
  for (const auto& row : table.rows) {
    const auto value = [&](const char* name) { return row[column(table, name)].value(); };
    const double expected = 0.2 + 50.0 * (value("length.distance") - 0.3) + 0.7 * value("length.rate");
    CHECK(std::abs(value("tension.tension") - expected) < 1e-13 * 50);  // rounding of the stiffness' share
    CHECK(value("centre.x") == value("bob.x"));
    CHECK(value("centre.vz") == value("bob.vz"));
  }
}

}  // namespace space_sensor_test

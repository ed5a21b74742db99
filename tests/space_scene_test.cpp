// Scene files in space: what they may not say, what is asked of a start, and the columns of a run.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "support/spatial_refusals.hpp"
#include "support/temporary_folder.hpp"

namespace space_scene_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;

namespace {

const std::string folder = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/space/";

}  // namespace

TEST_CASE("scene in space: what can't be is refused by line, key, what was given and what is allowed") {
  const std::string engine = read_text(folder + "engine.toml");
  const Refused all[] = {
      {"dimension = 3", "dimension = 4", "dimension is 4", "3 in a scene in space"},
      {"gravity = [0.0, 0.0, -9.81]", "gravity = [0.0, -9.5]", "gravity is [ 0.0, -9.5 ]", "three finite numbers"},
      {"inertia = [2.0e-2, 1.5e-2, 1.5e-2]", "inertia = [2.0e-2, 1.5e-2]", "bodies[0].inertia is",
       "three or six finite numbers"},
      {"inertia = [2.0e-2, 1.5e-2, 1.5e-2]", "inertia = [4.0e-2, 1.5e-2, 1.5e-2]", "bodies[0].inertia is one that",
       "exceeds the sum of the other two"},
      {"inertia = [2.0e-2, 1.5e-2, 1.5e-2]", "inertia = [2e-2, 2e-2, 2e-2, 2e-2, 0.0, 0.0]",
       "bodies[0].inertia is one that", "positive definite"},
      {"mass = 4.0 ", "mass = 0.0 ", "bodies[0].mass is 0", "above 0"},
      {"orientation = {axis = [1.0, 0.0, 0.0]", "orientation = {axis = [0.0, 0.0, 0.0]",
       "orientation.axis is [0, 0, 0]", "a direction"},
      {"orientation = {axis = [1.0, 0.0, 0.0]", "orientation = {euler_parameters = [1.0, 0.1, 0.0, 0.0]",
       "euler_parameters is given beside axis or angle", "axis and angle, or euler_parameters"},
      {"type = \"universal\"", "type = \"universal\"\naxis = [1.0, 0.0, 0.0]", "unknown key constraints[1].axis",
       "allowed are"},
      {"type = \"universal\"", "type = \"universel\"", "constraints[1].type is \"universel\"",
       "did you mean universal?"},
      {"second = {body = \"piston\", axis = [0.0, 1.0, 0.0]}", "second = {body = \"piston\"}",
       "constraints[1].second.axis is missing", "three finite numbers"},
      {"second = {body = \"rod\", point = [0.0, 0.0, -0.05]}", "second = {body = \"crankshaft\"}",
       "constraints[0].second is on the same body as first", "another body"},
      {"body = \"crankshaft\", point = [-0.06", "body = \"crank\", point = [-0.06",
       "joints[0].journal.body is \"crank\"", "the name of a body"},
      {"film = \"short_dynamic\"", "film = \"short_dynamik\"", "joints[0].film is \"short_dynamik\"", "short_dynamic"},
      {"[stabilisation]", "redundant = \"maybe\"\n[stabilisation]", "unknown key joints[1].redundant", "allowed are"},
      {"name = \"engine\"", "name = \"engine\"\nredundant = \"maybe\"", "redundant is \"maybe\"",
       "\"refuse\" or \"allow\""},
      {"name = \"engine\"", "name = \"engine\"\nredundant = \"allow\"", "none of the 12 rows", "\"refuse\""},
      {"[output]", "[[sensors]]\nname = \"s\"\ntype = \"turn\"\n[output]", "sensors[0].type is \"turn\"",
       "one of reaction, point, distance, angle, spring"},
      {"[output]", "[[sensors]]\nname = \"s\"\ntype = \"reaction\"\nconstraint = \"none\"\n[output]",
       "sensors[0].constraint is \"none\"", "the name of a constraint:"},
      {"[output]", "[[sensors]]\nname = \"s\"\ntype = \"spring\"\nspring = \"none\"\n[output]",
       "sensors[0].spring is \"none\"", "the name of a spring: \"thrust\""},
      {"[output]", "[[sensors]]\nname = \"crankshaft\"\ntype = \"point\"\nbody = \"crankshaft\"\n[output]",
       "sensors[0].name is \"crankshaft\"", "a name that no body, joint, constraint or other sensor has"},
      {"[output]",
       "[[sensors]]\nname = \"s\"\ntype = \"distance\"\nfirst = {body = \"crankshaft\"}\nsecond = {body = "
       "\"crankshaft\"}\n[output]",
       "sensors[0].second is on the same body as first", "another body"},
      {"free_length = 0.1 ", "free_lenght = 0.1 ", "springs[0].free_length is missing", "did you mean free_length"},
      {"point = [-0.1, 0.0, 0.0]}", "point = [-0.2, 0.0, 0.0]}", "springs[0].second is where first is", "above 0"},
      {"point = [0.06, 0.0, 0.0], axis", "point = [0.06, 1e-3, 0.0], axis", "starts at eccentricity ratio",
       "eccentricity ratios in [0, 1)"},
      {"point = [0.06, 0.0, 0.0], axis = [1.0, 0.0, 0.0]}\njournal = {body = \"crankshaft\", point = [0.06, 0.0, 0.0]}",
       "point = [0.06, 0.0, 0.0], axis = [1.0, 0.0, 0.0]}\njournal = {body = \"crankshaft\", point = [0.06, 0.0, 0.0], "
       "axis = [1.0, 0.01, 0.0]}",
       "starts with a tilt of", "tilts below"},
  };
  check_refusals(engine, "any.toml", all);
  // A line of the file, where there is one.
  CHECK_THAT(refusal(changed(engine, "mass = 4.0 ", "mass = -4.0 ")), Contains("any.toml:14: "));
}

TEST_CASE("scene in space: redundant constraints are refused with names and rank, and left out where that is allowed") {
  const std::string twice =
      changed(read_text(folder + "top.toml"), "[stabilisation]",
              "[[constraints]]\nname = \"again\"\ntype = \"spherical\"\nfirst = {body = "
              "\"ground\"}\nsecond = {body = \"top\", point = [0.0, 0.0, -0.06]}\n[stabilisation]");
  CHECK_THAT(refusal(twice), Contains("constraint \"again\" repeats what others fix already: \"tip\"") &&
                                 Contains("6 rows of rank 3") && Contains("redundant = \"allow\""));
  SpatialScene scene =
      parse_spatial_scene(changed(twice, "dimension = 3", "dimension = 3\nredundant = \"allow\""), "any");
  scene.run.duration = 0.05;
  scene.run.output_interval = 0.01;
  const SpatialTrajectory run = simulate_spatial(scene);
  CHECK(run.outcome.status == RunStatus::finished);
  CHECK(run.left_out == std::vector<std::string>{"again", "again", "again"});
  CHECK(run.rank == 3);
  // Where they contradict each other, nothing is allowed.
  CHECK_THAT(refusal(changed(changed(twice, "dimension = 3", "dimension = 3\nredundant = \"allow\""),
                             "point = [0.0, 0.0, -0.06]}\n[stab", "point = [0.0, 0.0, -0.05]}\n[stab")),
             Contains("the constraints are conflicting"));
}

TEST_CASE("scene in space: the plane's reader says that it is one, and what runs it") {
  CHECK(scene_dimension(SceneFile(folder + "top.toml")) == 3);
  CHECK(scene_dimension(SceneFile(std::filesystem::path(LUBJOINT_SOURCE_DIR) / "data/scenes/journal.toml")) == 2);
  CHECK_THROWS_WITH(load_scene(folder + "top.toml"),
                    Contains("top.toml:6: dimension is 3; allowed is 2 here") && Contains("simulate, cost and bench"));
  const std::string text = read_text(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/journal.toml");
  CHECK_THROWS_WITH(parse_scene("dimension = 5\n" + text, "any.toml"),
                    Contains("any.toml:1: dimension is 5; allowed is 2, or 3 in space"));
}

TEST_CASE("scene in space: what ships starts on its constraints, with the columns that are documented") {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    INFO(entry.path());
    SpatialScene scene = load_spatial_scene(entry.path());
    const auto prepared = prepare_spatial(scene);
    const double mechanism = scene_units(scene).mechanism;
    // The numbers of the file have sixteen digits.
    CHECK(prepared.found.correction.position < 1e-14 * mechanism);
    CHECK(prepared.found.correction.spin < 1e-12 * scene_units(scene).rate);  // likewise, over the levers
    scene.run.duration /= 100;
    scene.run.output_interval = scene.run.duration / 4;
    const SpatialTrajectory run = simulate_spatial(scene);
    REQUIRE(run.outcome.status == RunStatus::finished);
    const TrajectoryTable table = trajectory_table(scene, run);
    const auto has = [&](const std::string& column) {
      return std::find(table.columns.begin(), table.columns.end(), column) != table.columns.end();
    };
    for (const SpatialSceneBody& body : scene.bodies) {
      for (const char* quantity : {"x", "y", "z", "e0", "e1", "e2", "e3", "vx", "vy", "vz", "wx", "wy", "wz"})
        CHECK(has(body.name + "." + quantity));
    }
    for (const SpatialSceneJoint& joint : scene.joints) {
      for (const char* quantity :
           {"ex", "ey", "ez", "eccentricity_ratio", "tilt", "sliding", "fx", "fy", "fz", "film_thickness"})
        CHECK(has(joint.plane.name + "." + quantity));
    }
    for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
  }
}

TEST_CASE("top: it precesses steadily, at the rate that its file says") {
  const SpatialScene scene = load_spatial_scene(folder + "top.toml");
  const SpatialTrajectory run = simulate_spatial(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  const double start = scene.bodies[0].position.z();
  for (const SpatialSample& sample : run.samples) CHECK(std::abs(sample.state[2] - start) < 1e-9);  // of the tolerance
  const double rate = scene.bodies[0].velocity.x() / -scene.bodies[0].position.y();                 // W of the start
  const double angle = rate * scene.run.duration;
  const double radius = -scene.bodies[0].position.y();
  CHECK(run.samples.back().state[0] == Approx(radius * std::sin(angle)).margin(1e-8));   // of the tolerance, in 2 s
  CHECK(run.samples.back().state[1] == Approx(-radius * std::cos(angle)).margin(1e-8));  // likewise
}

}  // namespace space_scene_test

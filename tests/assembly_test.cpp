// Loops of scenes closed from rough guesses, against closed forms; named points; the text that is written.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_assembly.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

namespace assembly_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

/// A four-bar: crank 1, coupler 4, rocker 3, ground 4, all in metres; its driver at an angle and 2 rad/s. The guesses
/// are as rough as a sketch.
std::string four_bar(double angle, double crank = 1) {
  std::ostringstream text;
  text.precision(17);
  text << R"(name = "four-bar"
duration = 0.1
# a comment µ that stays
[[bodies]]
name = "crank"
mass = 1.0
inertia = 0.1
angle = 0.9  # as sketched
points = {inner = [)"
       << -crank / 2 << ", 0.0], outer = [" << crank / 2 << R"(, 0.0]}
[[bodies]]
name = "coupler"
mass = 4.0
inertia = 5.0
position = [2.0, 2.0]
points = {near = [-2.0, 0.0], far = [2.0, 0.0]}
[[bodies]]
name = "rocker"
mass = 3.0
inertia = 2.0
position = [4.0, 1.5]
angle = 1.5
spin = 0.5
points = {"low end" = [-1.5, 0.0], high = [1.5, 0.0]}
[[constraints]]
name = "crank-bearing"
type = "revolute"
first = {body = "ground"}
second = {body = "crank", point = "inner"}
[[constraints]]
name = "crank-pin"
type = "revolute"
first = {body = "crank", point = "outer"}
second = {body = "coupler", point = "near"}
[[constraints]]
name = "rocker-bearing"
type = "revolute"
first = {body = "ground", point = [4.0, 0.0]}
second = {body = "rocker", point = "low end"}
[[constraints]]
name = "motor"
type = "driver"
body = "crank"
speed = 2.0
angle = )"
       << angle << R"(
[[joints]]
name = "pin"
film = "short_dynamic"
viscosity = 0.1
length = 0.1
journal_radius = 0.1
clearance = 1e-3
bearing = {body = "coupler", point = "far"}
journal = {body = "rocker", point = "high"}
)";
  return text.str();
}

/// A scene whose places are guesses.
Scene rough(const std::string& text, const std::string& name) { return SceneFile(text, name).rough_scene(); }

/// Places of the pin between coupler and rocker: where two circles meet; the upper one first.
std::array<Vector2<double>, 2> pin_places(double angle) {
  const Vector2<double> a(std::cos(angle), std::sin(angle));
  const Vector2<double> b(4, 0);
  const Vector2<double> way = b - a;
  const double distance = way.norm();
  const double along = (distance * distance + 16 - 9) / (2 * distance);
  const double across = std::sqrt(16 - along * along);
  const Vector2<double> n(-way.y() / distance, way.x() / distance);
  const Vector2<double> foot = a + along / distance * way;
  return {Vector2<double>(foot + across * n), Vector2<double>(foot - across * n)};
}

Vector2<double> pin_of(const std::vector<double>& y) {  // of the rocker
  return {y[6] + 1.5 * std::cos(y[8]), y[7] + 1.5 * std::sin(y[8])};
}

}  // namespace

TEST_CASE("assembly: a four-bar closes in two ways, which are the meetings of two circles, and moves as it must") {
  for (const double angle : {0.3, 1.2, 2.5, -2.0}) {
    const Scene scene = rough(four_bar(angle), "four-bar.toml");
    const SceneAssembly assembly = assemble_scene(scene);
    CHECK(assembly.freedoms == 0);
    REQUIRE(assembly.branches.size() == 2);
    REQUIRE(assembly.signs.size() == 1);
    CHECK(assembly.signs[0].name == "crank-pin, pin, rocker-bearing");
    const auto places = pin_places(angle);
    const Vector2<double> crank_pin(std::cos(angle), std::sin(angle));
    for (const AssemblyBranch& branch : assembly.branches) {
      // Rounding of places of some metres, and what the last step of Newton's method leaves of it.
      const Vector2<double> pin = pin_of(branch.state);
      const bool upper = (pin - places[0]).norm() < 1e-12;
      CHECK((upper || (pin - places[1]).norm() < 1e-12));
      const Vector2<double> first = pin - crank_pin;
      const Vector2<double> second = Vector2<double>(4, 0) - pin;
      CHECK(branch.signs[0] == (first.x() * second.y() - first.y() * second.x() > 0 ? 1 : -1));
      CHECK(std::remainder(branch.state[2] - angle, 2 * std::numbers::pi) == Approx(0).margin(1e-14));
      // The pin's velocity, of the rocker, is the slope of its place over the crank's angle, times 2 rad/s.
      const double h = 1e-5;
      const std::size_t which = upper ? 0 : 1;
      const Vector2<double> slope = (pin_places(angle + h)[which] - pin_places(angle - h)[which]) / (2 * h);
      const double spin = branch.state[9 + 8];
      const Vector2<double> arm = pin - Vector2<double>(4, 0);
      const Vector2<double> velocity(-spin * arm.y(), spin * arm.x());
      CHECK((velocity - 2 * slope).norm() < 1e-8);  // h² and rounding over h
    }
    CHECK(assembly.branches[0].signs[0] == -assembly.branches[1].signs[0]);
  }
}

TEST_CASE("assembly: the text that is written keeps its words, reads back as the branch, and runs") {
  const SceneFile file(four_bar(0.9), "four-bar.toml");
  const Scene scene = file.rough_scene();
  for (const double angle : {0.9, 1.7}) {
    const AssemblyRequest request{{{"motor", angle}}, {}, 50};
    const SceneAssembly assembly = assemble_scene(scene, request);
    for (const AssemblyBranch& branch : assembly.branches) {
      const std::string text = assembled_text(file, scene, request, branch);
      CHECK_THAT(text, Contains("# a comment µ that stays") && Contains("# as sketched"));
      const Scene again = parse_scene(text, "again.toml");
      CHECK(scene_start<double>(again) == branch.state);
      CHECK(std::get<Driver<double>>(again.constraints.back().constraint).angle == angle);
      // Nothing is left to correct, and the journal is at its centre.
      const SceneAssembly once_more = assemble_scene(again);
      CHECK(once_more.branches[0].correction.position < 1e-13);
      CHECK(once_more.branches[0].correction.spin < 1e-12);
    }
  }
}

TEST_CASE("assembly: a journal far outside its bearing is a guess, and no start of a run") {
  CHECK_THROWS_WITH(parse_scene(four_bar(0.9), "s.toml"), Contains("joints[0].journal is at eccentricity ratio"));
  CHECK_NOTHROW(rough(four_bar(0.9), "s.toml"));
}

TEST_CASE("assembly: a slider-crank has its slider on either side, told apart by the way along its guide") {
  const std::string text = R"(name = "crank"
duration = 1.0
[[bodies]]
name = "crank"
mass = 1.0
inertia = 1.0
[[bodies]]
name = "rod"
mass = 1.0
inertia = 1.0
position = [2.0, 0.5]
[[bodies]]
name = "slider"
mass = 1.0
inertia = 1.0
position = [3.0, 0.0]
[[constraints]]
name = "bearing"
type = "revolute"
first = {body = "ground"}
second = {body = "crank"}
[[constraints]]
name = "crank-pin"
type = "revolute"
first = {body = "crank", point = [1.0, 0.0]}
second = {body = "rod", point = [-1.0, 0.0]}
[[constraints]]
name = "gudgeon-pin"
type = "revolute"
first = {body = "rod", point = [1.0, 0.0]}
second = {body = "slider"}
[[constraints]]
name = "guide"
type = "translational"
first = {body = "ground"}
axis = [1.0, 0.0]
second = {body = "slider"}
)";
  const Scene scene = parse_scene(text, "crank.toml");
  // Without a driver one coordinate is free; a body's angle may be held for the assembly alone.
  CHECK(assemble_scene(scene).freedoms == 1);
  const SceneAssembly assembly = assemble_scene(scene, {{{"crank", 0.7}}, {}, 200});
  CHECK(assembly.freedoms == 0);
  REQUIRE(assembly.branches.size() == 2);
  REQUIRE(assembly.signs.size() == 1);
  CHECK(assembly.signs[0].name == "crank-pin to gudgeon-pin along guide");
  for (const AssemblyBranch& branch : assembly.branches) {
    const double x = std::cos(0.7) + branch.signs[0] * std::sqrt(4 - std::sin(0.7) * std::sin(0.7));
    CHECK(branch.state[6] == Approx(x).epsilon(1e-12));  // rounding, and Newton's last step
    CHECK(branch.state[7] == Approx(0).margin(1e-12));
  }
  CHECK(assembly.branches[0].signs[0] == 1);  // as sketched
}

TEST_CASE("assembly: what can't be closed, and names that are not there, are refused by name") {
  const auto scene_of = [](double angle, double crank) { return rough(four_bar(angle, crank), "four-bar.toml"); };
  // A crank of 12 m does not turn in a four-bar of 4, 3 and 4 m.
  CHECK_THROWS_WITH(
      assemble_scene(scene_of(3.1, 12)),
      Contains("four-bar.toml: constraints: the constraints are conflicting: no position near the start") &&
          Contains("neither did 200 other starts"));
  CHECK_THROWS_WITH(assemble_scene(scene_of(1, 1), {{{"moter", 1.0}}, {}, 10}),
                    Contains("driver or body \"moter\" is not there") && Contains("did you mean motor?"));
  CHECK_THROWS_WITH(assemble_scene(scene_of(1, 1), {{}, {"pim"}, 10}),
                    Contains("joint \"pim\" is not there") && Contains("did you mean pin?"));
  // The driver holds the crank already.
  CHECK_THROWS_WITH(assemble_scene(scene_of(1, 1), {{{"crank", 1.0}}, {}, 10}),
                    Contains("\"crank\" is conflicting") && Contains("\"motor\""));
  // With the joint open, coupler and rocker are free.
  CHECK(assemble_scene(scene_of(1, 1), {{}, {"pin"}, 10}).freedoms == 2);
}

TEST_CASE("assemble: the command prints a scene that reads back, or JSON, or a list, and refuses mistakes in words") {
  const TemporaryFolder folder;
  const std::string file = folder.write("four-bar.toml", four_bar(0.9));
  const SceneAssembly assembly = assemble_scene(rough(four_bar(0.9), file), {{{"motor", 1.2}}, {}, 200});
  for (const std::string branch : {"1", "2"}) {
    const ProgramResult written = lubjoint_program({"assemble", file, "--angle", "motor=1.2", "--branch", branch});
    INFO(written.err);
    CHECK(written.status == 0);
    const Scene scene = parse_scene(written.out, file);
    CHECK(scene_start<double>(scene) == assembly.branches[branch == "1" ? 0 : 1].state);
  }
  const ProgramResult json = lubjoint_program({"assemble", file, "--json"});
  CHECK(json.status == 0);
  CHECK(nlohmann::json::parse(json.out)["branches"].size() == 2);
  const ProgramResult list = lubjoint_program({"assemble", file, "--list"});
  CHECK(list.status == 0);
  CHECK_THAT(list.out, Contains("2 branches from the guesses and"));
  const auto refused = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"assemble", file};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramResult result = lubjoint_program(words);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    return result.err;
  };
  CHECK_THAT(refused({"--branch", "99"}), Contains("--branch is 99; allowed is a number from 1 to 2"));
  CHECK_THAT(refused({"--branch", "0"}), Contains("--branch is 0; allowed is a number from 1 to 2"));
  CHECK_THAT(refused({"--angle", "motor=x"}), Contains("--angle is \"motor=x\"; allowed is NAME=VALUE"));
  CHECK_THAT(refused({"--angle", "moter=1"}), Contains("did you mean motor?"));
  // One output at a time: none of these is without effect.
  CHECK_THAT(refused({"--json", "--list"}), Contains("--json") && Contains("--list"));
  CHECK_THAT(refused({"--json", "--branch", "1"}), Contains("--json") && Contains("--branch"));
  CHECK_THAT(refused({"--list", "--branch", "1"}), Contains("--list") && Contains("--branch"));
}

TEST_CASE("named points: what a body does not name is refused with what it does") {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = four_bar(1);
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const Scene scene = rough(four_bar(1), "s.toml");
  CHECK(scene.joints[0].bearing.point == Vector2<double>(2, 0));
  CHECK(scene.bodies[2].points.size() == 2);
  CHECK_THROWS_WITH(
      rough(with("point = \"far\"", "point = \"fat\""), "s.toml"),
      Contains("joints[0].bearing.point is \"fat\"; allowed is [x, y] [m], or a point of body \"coupler\"") &&
          Contains("did you mean far?"));
  CHECK_THROWS_WITH(rough(with("first = {body = \"ground\"}", "first = {body = \"ground\", point = \"a\"}"), "s.toml"),
                    Contains("constraints[0].first.point is \"a\"; allowed is [x, y] [m], inertial"));
  CHECK_THROWS_WITH(rough(with("far = [2.0, 0.0]", "far = [2.0]"), "s.toml"),
                    Contains("bodies[1].points.far is") && Contains("an array of two finite numbers"));
  CHECK_THROWS_WITH(rough(with("points = {near = [-2.0, 0.0], far = [2.0, 0.0]}", ""), "s.toml"),
                    Contains("body \"coupler\" names no points"));
}

TEST_CASE("scene: a table that nobody asks for is refused first, by its own name") {
  CHECK_THROWS_WITH(parse_scene("[[springz]]\nname = \"a\"\n", "s.toml"),
                    Contains("s.toml:1: unknown key springz; allowed are") && Contains("did you mean springs?"));
  CHECK_THROWS_WITH(parse_scene("name = \"s\"\n[integrater]\nname = \"dopri5\"\n", "s.toml"),
                    Contains("s.toml:2: unknown key integrater") && Contains("did you mean integrator?"));
}

}  // namespace assembly_test

// What a scene file may not say of springs, loads, sensors and singular positions.
#include <catch2/catch.hpp>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "lubjoint/scene/trajectory_table.hpp"
#include "support/temporary_folder.hpp"

namespace scene_forces_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

const std::string head = R"(name = "s"
duration = 1.0
[[bodies]]
name = "rod"
mass = 1.0
inertia = 1.0
[[bodies]]
name = "rotor"
mass = 1.0
inertia = 1.0
position = [1.0, 0.0]
spin = {held = 5.0}
[[constraints]]
name = "pin"
type = "revolute"
first = {body = "ground", point = [0.0, 0.0]}
second = {body = "rod", point = [0.0, 0.0]}
)";

/// The message of a scene's refusal, with the line of the head's end taken from its line; none if it is accepted.
std::string refusal(const std::string& tail) {
  const TemporaryFolder folder;
  try {
    load_scene(folder.write("s.toml", head + tail));
    return "accepted";
  } catch (const SceneError& error) {
    return error.what();
  }
}

const std::string ends = "first = {body = \"ground\", point = [0.0, 1.0]}\nsecond = {body = \"rod\"}\n";

}  // namespace

TEST_CASE("scene springs: a spring or a damper is read, everything else is refused with its line") {
  const std::string spring = "[[springs]]\nname = \"a\"\n";  // lines 18 and 19
  CHECK(refusal(spring + ends + "stiffness = 1.0\nfree_length = 0.5\n") == "accepted");
  CHECK(refusal(spring + ends + "stiffness = 0.0\ndamping = 1.0\n") == "accepted");
  CHECK(refusal(spring + "revolute = \"pin\"\nstiffness = 1.0\nfree_angle = 0.5\n") == "accepted");
  const auto refused = [&](const std::string& tail, int line, const std::string& words) {
    const std::string message = refusal(spring + tail);
    CHECK_THAT(message, Contains("s.toml:" + std::to_string(line) + ": springs[0]") && Contains(words) &&
                            (Contains("allowed") || Contains("required")));
  };
  refused(ends + "free_length = 0.5\n", 18, "springs[0].stiffness is missing");
  refused(ends + "stiffness = -1.0\n", 22, "stiffness is -1");
  refused(ends + "stiffness = 1.0\n", 18, "free_length is missing");
  refused(ends + "stiffness = 0.0\ndamping = 1.0\nfree_length = 1.0\n", 24,
          "free_length is given where stiffness is 0");
  refused(ends + "stiffness = 0.0\n", 22, "stiffness is 0 in a spring without damping or preload");
  CHECK_THAT(refusal(spring + ends + "stiffness = 1.0\nfree_length = 0.5\nfree_angle = 0.1\n"),
             Contains("s.toml:24: unknown key springs[0].free_angle; allowed are"));
  refused("first = {body = \"rod\"}\nsecond = {body = \"rod\", point = [1.0, 0.0]}\nstiffness = 1.0\n", 21,
          "second is on the same body as first");
  refused("first = {body = \"ground\"}\nsecond = {body = \"rod\"}\nstiffness = 1.0\nfree_length = 0.1\n", 21,
          "the spring has length 0");
  refused("revolute = \"pins\"\nstiffness = 1.0\n", 20, "the name of a constraint of type \"revolute\": \"pin\"");
  refused("revolute = \"pin\"\nstiffness = 1.0\n", 18, "free_angle is missing");
  refused("revolute = \"pin\"\nstiffness = 0.0\ndamping = 1.0\nfree_angle = 0.0\n", 23, "free_angle is given");
  const std::string twice = spring + ends + "stiffness = 1.0\nfree_length = 0.5\n";
  CHECK_THAT(refusal(twice + twice), Contains("springs[1].name is \"a\"; allowed is a name that no other spring has"));
}

TEST_CASE("scene loads: point, frame, harmonic and unbalance are read, and what has no effect is refused") {
  const std::string load = "[[loads]]\n";
  const std::string rod = "body = \"rod\"\n";
  CHECK(refusal(load + rod + "force = [1.0, 0.0]\npoint = [0.1, 0.0]\nframe = \"body\"\n") == "accepted");
  CHECK(refusal(load + rod + "moment = 1.0\nharmonic = {frequency = 2.0}\n") == "accepted");
  CHECK(refusal(load + "body = \"rotor\"\nunbalance = {mass_radius = 1e-4, phase = 0.5}\n") == "accepted");
  const auto refused = [&](const std::string& tail, const std::string& words) {
    CHECK_THAT(refusal(load + tail),
               Contains("loads[0]") && Contains(words) && (Contains("allowed") || Contains("required")));
  };
  refused(rod + "moment = 1.0\npoint = [0.1, 0.0]\n", "point is given for a moment alone");
  refused(rod + "moment = 1.0\nframe = \"body\"\n", "frame is given for a moment alone");
  refused(rod + "force = [1.0, 0.0]\nframe = \"rotor\"\n", "frame is \"rotor\"; allowed is \"inertial\" or \"body\"");
  refused(rod + "force = [1.0, 0.0]\nharmonic = {phase = 1.0}\n", "speed is missing, and so is frequency");
  refused(rod + "force = [1.0, 0.0]\nharmonic = {speed = 1.0, frequency = 1.0}\n", "speed is given beside frequency");
  refused(rod + "force = [1.0, 0.0]\nharmonic = {speed = 0.0}\n", "speed is 0");
  refused(rod + "force = [0.0, 0.0]\nharmonic = {speed = 1.0}\n", "harmonic is given for a force and a moment of 0");
  refused(rod + "unbalance = {mass_radius = 1e-4}\n", "unbalance is on body \"rod\", whose spin is not held");
  refused("body = \"rotor\"\nforce = [1.0, 0.0]\nunbalance = {mass_radius = 1e-4}\n", "unknown key loads[0].force");
  refused("body = \"rotor\"\nunbalance = {mass_radius = 0.0}\n", "mass_radius is 0");
}

TEST_CASE("scene sensors: each kind is read and names its columns, what it can't measure is refused") {
  const auto sensor = [](const std::string& name, const std::string& rest) {
    return "[[sensors]]\nname = \"" + name + "\"\n" + rest;
  };
  const TemporaryFolder folder;
  const std::string spring = "[[springs]]\nname = \"a\"\n" + ends + "stiffness = 1.0\nfree_length = 0.5\n";
  const Scene scene = load_scene(folder.write(
      "s.toml", head + spring + sensor("r", "type = \"reaction\"\nconstraint = \"pin\"\n") +
                    sensor("p", "type = \"point\"\nbody = \"rod\"\npoint = [0.5, 0.0]\n") +
                    sensor("d", "type = \"distance\"\nfirst = {body = \"rod\"}\nsecond = {body = \"rotor\"}\n") +
                    sensor("w", "type = \"angle\"\nbody = \"rod\"\nagainst = \"rotor\"\n") +
                    sensor("t", "type = \"spring\"\nspring = \"a\"\n")));
  const MultibodyTrajectory run = simulate_multibody(scene);
  const TrajectoryTable table = trajectory_table(scene, run);
  const std::vector<std::string> last(table.columns.end() - 12, table.columns.end());
  CHECK(last == std::vector<std::string>{"r.fx", "r.fy", "r.moment", "p.x", "p.y", "p.vx", "p.vy", "d.distance",
                                         "d.rate", "w.angle", "w.rate", "t.tension"});
  CHECK(*table.rows[0][table.columns.size() - 1] == Approx(0.5));   // 1 N/m on half a metre
  CHECK(*table.rows[0][table.columns.size() - 2] == Approx(-5.0));  // the rotor turns, the rod does not
  CHECK(*table.rows[0][table.columns.size() - 5] == Approx(1.0));   // distance
  const auto refused = [&](const std::string& name, const std::string& rest, const std::string& words) {
    CHECK_THAT(refusal(sensor(name, rest)), Contains("sensors[0]") && Contains(words) && Contains("allowed"));
  };
  refused("r", "type = \"reaction\"\nconstraint = \"pins\"\n", "the name of a constraint: \"pin\"");
  refused("r", "type = \"reactions\"\n", "type is \"reactions\"; allowed is one of reaction");
  refused("t", "type = \"spring\"\nspring = \"a\"\n", "nothing: the scene has no spring");
  refused("d", "type = \"distance\"\nfirst = {body = \"rod\"}\nsecond = {body = \"rod\"}\n", "on the same body");
  refused("w", "type = \"angle\"\nbody = \"rod\"\nagainst = \"rod\"\n", "against is \"rod\"");
  refused("p", "type = \"point\"\nbody = \"ground\"\n", "body is \"ground\"");
  for (const std::string taken : {"rod", "pin", "rotor.spin"}) {
    refused(taken, "type = \"point\"\nbody = \"rod\"\n", "no body, joint, constraint or other sensor has");
  }
}

TEST_CASE("scene: singular positions are passed with projection alone") {
  const std::string table = "[stabilisation]\nmethod = \"projection\"\n";
  CHECK(refusal(table + "singular_positions = \"pass\"\n") == "accepted");
  CHECK(refusal(table + "singular_positions = \"stop\"\n") == "accepted");
  CHECK_THAT(refusal(table + "singular_positions = \"go\"\n"), Contains("\"stop\" or \"pass\""));
  CHECK_THAT(refusal("[stabilisation]\nmethod = \"baumgarte\"\nsingular_positions = \"pass\"\n"),
             Contains("s.toml:20: stabilisation.singular_positions is \"pass\" with Baumgarte's terms"));
}

}  // namespace scene_forces_test

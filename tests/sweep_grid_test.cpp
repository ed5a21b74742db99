// Grids of values, and the scenes that they stand for.
#include "oracle/sweep/sweep_grid.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "oracle/files/quoted_csv.hpp"
#include "support/scene_text.hpp"

namespace sweep_grid_test {

using namespace lubjoint;
using namespace lubjoint::test;
using namespace lubjoint::reports;
using Catch::Contains;

namespace {

const std::string slider_crank = LUBJOINT_SOURCE_DIR "/data/scenes/slider-crank.toml";

std::vector<double> numbers(const std::string& text) {
  std::vector<double> values;
  for (const SceneValue& value : parse_swept_key("key=" + text).values) values.push_back(std::get<double>(value));
  return values;
}

SweepGrid grid_of(const std::vector<std::string>& texts) {
  std::vector<SweptKey> keys;
  for (const std::string& text : texts) keys.push_back(parse_swept_key(text));
  return SweepGrid(keys);
}

}  // namespace

TEST_CASE("sweep: equal distances have exact ends and the doubles that people write between them") {
  CHECK(numbers("0.1:0.5:5") == std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5});
  CHECK(numbers("1e-4:5e-4:5") == std::vector<double>{1e-4, 2e-4, 3e-4, 4e-4, 5e-4});
  CHECK(numbers("1e-4:3e-4:3") == std::vector<double>{1e-4, 2e-4, 3e-4});
  CHECK(numbers("5:-1:4") == std::vector<double>{5, 3, 1, -1});
  CHECK(numbers("-3:-3:1") == std::vector<double>{-3});
  const std::vector<double> fine = numbers("0.04:0.4:1001");
  CHECK(fine.front() == 0.04);
  CHECK(fine.back() == 0.4);
  for (std::size_t i = 1; i < fine.size(); ++i) CHECK(fine[i] > fine[i - 1]);
}

TEST_CASE("sweep: equal ratios have exact ends, and decades are decades") {
  CHECK(numbers("log:1e-4:10:6") == std::vector<double>{1e-4, 1e-3, 1e-2, 1e-1, 1, 10});
  const std::vector<double> values = numbers("log:0.04:0.4:8");
  CHECK(values.front() == 0.04);
  CHECK(values.back() == 0.4);
  for (std::size_t i = 1; i < values.size(); ++i) {
    CHECK(std::abs(values[i] / values[i - 1] / std::pow(10, 1.0 / 7) - 1) <
          1e-14);  // two values of 15 digits, 5e-15 each
  }
}

TEST_CASE("sweep: lists hold numbers, truth values and texts") {
  const SweptKey swept = parse_swept_key("joints[0].film=short_half,1e-3,true,+2,false,none");
  CHECK(swept.key == "joints[0].film");
  CHECK(swept.values ==
        std::vector<SceneValue>{std::string("short_half"), 1e-3, true, 2.0, false, std::string("none")});
  CHECK(shown(swept.values[1]) == "0.001");
  CHECK(shown(swept.values[2]) == "true");
}

TEST_CASE("sweep: what is no set of values is refused with its text and what is allowed") {
  const auto refused = [](const std::string& text, const std::string& words) {
    INFO(text);
    CHECK_THROWS_WITH(parse_swept_key(text), Contains("--vary " + text) && Contains(words) && Contains("allowed is"));
  };
  refused("joints[0].clearance", "no key and values");
  refused("=1:2:3", "no key and values");
  refused("a=", "an empty value");
  refused("a=1,,2", "an empty value");
  refused("a=1:2", "not two bounds and a number");
  refused("a=1:2:3:4", "not two bounds and a number");
  refused("a=log:1:2", "not two bounds and a number");
  refused("a=1:b:3", "bound \"b\"");
  refused("a=nan:1:3", "bound \"nan\"");
  refused("a=1:inf:3", "bound \"inf\"");
  refused("a=0x1:2:3", "bound \"0x1\"");
  refused("a=1:2:0", "number of values \"0\"");
  refused("a=1:2:-1", "number of values \"-1\"");
  refused("a=1:2:2.5", "number of values \"2.5\"");
  refused("a=1:2:1000001", "a whole number from 1 to 1000000");
  refused("a=1:2:1", "one value between two bounds");
  refused("a=log:0:1:3", "not above 0");
  refused("a=log:-2:-1:3", "not above 0");
}

TEST_CASE("sweep: the points are all combinations, numbered alike in whatever order the keys were given") {
  const SweepGrid grid = grid_of({"b=1,2", "a=x,y,z"});
  const SweepGrid other = grid_of({"a=x,y,z", "b=1,2"});
  REQUIRE(grid.size() == 6);
  REQUIRE(other.size() == 6);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < 6; ++i) {
    names.push_back(grid.name(i));
    CHECK(other.name(i) == grid.name(i));
  }
  CHECK(names.front() == "point 0 (a = x, b = 1)");
  CHECK(names[1] == "point 1 (a = x, b = 2)");
  CHECK(names.back() == "point 5 (a = z, b = 2)");
  CHECK_THROWS_WITH(grid_of({}), Contains("--vary is missing"));
  CHECK_THROWS_WITH(grid_of({"a=1,2", "b=1", "a=3"}), Contains("--vary a: given twice"));
  CHECK_THROWS_WITH(grid_of({"a=1:2:1000", "b=1:2:1001"}), Contains("at most 1000000"));
  for (const char* name : {"name", "bodies[0].name", "joints[12].name", "constraints[1].name"}) {
    CHECK_THROWS_WITH(grid_of({std::string(name) + "=a,b"}), Contains("a name"));
  }
  CHECK(grid_of({"integrator.name=radau_iia5,dopri5"}).size() == 2);
}

TEST_CASE("sweep: a changed scene is the one whose file says so") {
  const SceneFile file(slider_crank);
  const Scene scene = file.scene({{"joints[0].clearance", 1e-4},
                                  {"joints.gudgeon-pin.viscosity", 0.04},
                                  {"joints[0].film", std::string("short_half")},
                                  {"bodies[1].mass", 0.5},
                                  {"bodies.slider.position[1]", 1e-5},
                                  {"joints[0].journal.point[0]", 2e-5},
                                  {"gravity[1]", -9.81},
                                  {"duration", 1.0},
                                  {"output.energy_ledger", false},
                                  {"bodies[0].angle", 0.25}});
  CHECK(scene.joints[0].clearance == 1e-4);
  CHECK(scene.joints[0].viscosity == 0.04);
  CHECK(scene.joints[0].film == "short_half");
  CHECK(scene.bodies[1].mass == 0.5);
  CHECK(scene.bodies[2].position.y() == 1e-5);
  CHECK(scene.joints[0].journal.point.x() == 2e-5);
  CHECK(scene.gravity.y() == -9.81);
  CHECK(scene.run.duration == 1.0);
  CHECK_FALSE(scene.energy_ledger);
  CHECK(scene.bodies[0].angle == 0.25);  // the file leaves it out
  const Scene unchanged = file.scene();
  CHECK(unchanged.joints[0].clearance == 2e-4);
  CHECK(unchanged.energy_ledger);
}

TEST_CASE("sweep: tables that a file leaves out are made for the keys in them") {
  const TemporaryFolder folder;
  const std::string text = read_text(journal_scene_file);
  const SceneFile file(folder.write("short.toml", text.substr(0, text.find("[integrator]"))));
  const Scene scene = file.scene({{"integrator.relative_tolerance", 1e-5}, {"output.energy_ledger", true}});
  CHECK(scene.run.relative_tolerance == 1e-5);
  CHECK(scene.energy_ledger);
}

TEST_CASE("sweep: keys are numbered, names with points in them too") {
  const SceneFile file(slider_crank);
  CHECK(file.numbered_key("joints.gudgeon-pin.clearance") == "joints[0].clearance");
  CHECK(file.numbered_key("bodies.rod.position[0]") == "bodies[1].position[0]");
  CHECK(file.numbered_key("constraints.motor.speed") == "constraints[3].speed");
  CHECK(file.numbered_key("duration") == "duration");
  CHECK(file.numbered_key("stabilisation.alpha") == "stabilisation.alpha");
  const TemporaryFolder folder;
  const SceneFile dotted(folder.write("s.toml", journal_text().with("bodies[0].name", "\"shaft.v2\"")));
  CHECK(dotted.numbered_key("bodies.shaft.v2.mass") == "bodies[0].mass");
}

TEST_CASE("sweep: a key that leads to no value is refused with what there is") {
  const SceneFile file(slider_crank);
  const auto refused = [&](const std::string& key, const std::string& words) {
    INFO(key);
    CHECK_THROWS_WITH(file.numbered_key(key),
                      Contains("slider-crank.toml: key \"" + key + "\"") && Contains(words) && Contains("allowed is"));
  };
  refused("joint[0].clearance", "joint is not there; allowed is one of");
  refused("joint[0].clearance", "did you mean joints?");
  refused("joints[1].clearance", "joints has no such element; allowed is joints[0], or by name: joints.gudgeon-pin");
  refused("joints[-1].clearance", "no such element");
  refused("joints[x].clearance", "no such element");
  refused("joints[0.clearance", "no such element");
  refused("joints.pin.clearance", "no such element");
  refused("bodies[3].mass", "bodies[0] to bodies[2]");
  refused("joints", "is an array");
  refused("gravity", "gravity is an array; allowed is gravity[0]");
  refused("gravity[2]", "no such element");
  refused("joints[0]", "joints[0] is a table");
  refused("joints[0]clearance", "is a table; allowed is joints[0].KEY");
  refused("joints[0].bearing", "is a table");
  refused("joints[0].clearance.more", "is a single value");
  refused("", "a name is missing");
  refused("joints[0].", "a name is missing");
  refused(".clearance", "a name is missing");
}

TEST_CASE("sweep: impossible values are refused as those of a file, with key, value and line") {
  const SceneFile file(journal_scene_file);
  const auto refused = [&](const SceneChange& change, std::size_t line, const std::string& words) {
    INFO(change.key);
    CHECK_THROWS_WITH(file.scene({change}), Contains("journal.toml:" + std::to_string(line) + ": ") && Contains(words));
  };
  refused({"joints[0].clearance", 0.02}, journal_text().field("joints[0].clearance").line,
          "joints[0].clearance is 0.02 m; allowed is less than journal_radius, 0.0098 m");
  refused({"joints[0].clearance", -1.0}, journal_text().field("joints[0].clearance").line, "is -1");
  refused({"joints[0].film", std::string("short_hal")}, journal_text().field("joints[0].film").line,
          "did you mean short_half?");
  refused({"joints[0].film", 1.0}, journal_text().field("joints[0].film").table_line, "joints[0].film is 1");
  refused({"bodies[0].mas", 1.0}, journal_text().field("bodies[0].name").table_line,
          "unknown key bodies[0].mas; allowed are");
  refused({"bodies[0].position[0]", 1.0}, journal_text().field("joints[0].journal").line, "eccentricity ratio 5000");
  refused({"integratr.rtol", 1.0}, 1, "unknown key integratr");
}

TEST_CASE("quoted CSV: fields with commas and quotes come back as they were, in one line") {
  for (const std::string text : {"plain", "a, b", "joint \"pin\" stops", "\"", ",", ",\"\",", ""}) {
    const std::string row = quoted_field(text) + "," + quoted_field("next");
    CHECK(split_quoted(row) == std::vector<std::string>{text, "next"});
  }
  CHECK(quoted_field("two\nlines") == "two lines");
}

}  // namespace sweep_grid_test

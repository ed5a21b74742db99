// Warnings of what a scene's author has probably not meant, and of films that are too thin.
#include "oracle/results/scene_warnings.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "lubjoint/scene/scene_file.hpp"
#include "support/run_program.hpp"

using namespace lubjoint;
using namespace lubjoint::reports;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

const std::string data = LUBJOINT_SOURCE_DIR "/data/";

/// All of them in one text.
std::string joined(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& each : warnings) text += each + "\n";
  return text;
}

std::string corrections(Scene scene) {
  scene.run.duration = 1e-5;  // the start alone is of interest
  scene.run.output_interval = 1e-5;
  return joined(correction_warnings(scene, simulate_multibody(scene)));
}

}  // namespace

TEST_CASE("warnings: none of the scenes that ship is warned of for units or corrections") {
  for (const char* folder : {"scenes", "examples"}) {
    for (const auto& entry : std::filesystem::directory_iterator(data + folder)) {
      const Scene scene = load_scene(entry.path());
      INFO(entry.path());
      CHECK(joined(unit_warnings(scene)).empty());
      if (!is_free_journal(scene)) CHECK(corrections(scene).empty());
    }
  }
}

TEST_CASE("warnings: a start that is moved by more than 1 % is named, with what was given and needed") {
  const Scene four_bar = load_scene(data + "examples/four-bar.toml");
  const Scene ideal = load_scene(data + "scenes/slider-crank-ideal.toml");
  Scene scene = ideal;
  scene.bodies[2].position.x() += 3e-3;
  CHECK_THAT(corrections(scene),
             Contains("body \"slider\" was moved") && Contains("position (0.173, 0) m given, (0.17,"));
  scene = ideal;
  scene.bodies[1].angle = 0.05;
  CHECK_THAT(corrections(scene), Contains("body \"rod\"") && Contains("angle 0.05 rad given"));
  scene = four_bar;
  scene.bodies[0].spin *= 30 / std::numbers::pi;  // 1500: given in rpm
  CHECK_THAT(corrections(scene), Contains("body \"crank\"") && Contains("spin 1500 rad/s given, 157.08 needed: rpm?"));
  scene = four_bar;
  scene.bodies[1].velocity *= 1.005;  // less than 1 %
  CHECK(corrections(scene).empty());
}

TEST_CASE("warnings: sizes and speeds that can hardly be meant") {
  const Scene four_bar = load_scene(data + "examples/four-bar.toml");
  Scene scene = four_bar;
  scene.joints[0].clearance = 1e-7;
  CHECK_THAT(joined(unit_warnings(scene)), Contains("\"pin\"") && Contains("c/R = 1.01e-05"));
  scene = four_bar;
  scene.joints[0].clearance = 1e-3;
  CHECK_THAT(joined(unit_warnings(scene)), Contains("c/R"));
  scene = four_bar;
  scene.joints[0].journal_radius = 9.9;  // in millimetres
  scene.joints[0].clearance = 0.1;
  CHECK_THAT(joined(unit_warnings(scene)), Contains("is larger than the mechanism"));
  for (const double factor : {30 / std::numbers::pi, std::numbers::pi / 30}) {
    scene = four_bar;
    scene.bodies[0].spin *= factor;
    CHECK_THAT(joined(unit_warnings(scene)), Contains("driver \"motor\"") && Contains("rpm?"));
  }
  scene = four_bar;
  scene.bodies[0].spin *= 180 / std::numbers::pi;
  CHECK_THAT(joined(unit_warnings(scene)), Contains("degrees?"));
}

TEST_CASE("warnings: a film under the safe thickness, which is 3 um for a bearing of 20 mm") {
  const std::string thin = data + "scenes/slider-crank-c0.5-mu0.04.toml";
  CHECK(safe_film_thickness(load_scene(thin).joints[0]) == Approx(3e-6).epsilon(1e-14));
  CHECK_THAT(lubjoint_program({"simulate", thin}).err,
             Contains("joint \"gudgeon-pin\" is 0.453 um thin") && Contains("less than the 3 um that are safe"));
  CHECK(lubjoint_program({"simulate", data + "scenes/slider-crank.toml"}).err.find("safe") == std::string::npos);
  const ProgramResult rows =
      lubjoint_program({"sweep", thin, "--vary", "joints.gudgeon-pin.viscosity=0.04,0.4", "--rtol", "1e-6"});
  CHECK_THAT(rows.out, Contains("gudgeon-pin.min_film_over_safe"));
}

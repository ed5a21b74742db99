// Warnings of what a scene's author has probably not meant, and of films that are too thin.
#include "oracle/results/scene_warnings.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "oracle/laws/model_error.hpp"
#include "oracle/results/spatial_report.hpp"
#include "oracle/results/squeeze_reynolds.hpp"
#include "support/embedded_scene.hpp"
#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace scene_warnings_test {

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
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data + folder)) {
      if (entry.path().extension() != ".toml") continue;
      INFO(entry.path());
      if (scene_dimension(SceneFile(entry.path())) == 3) {
        SpatialScene in_space = load_spatial_scene(entry.path());
        in_space.run.duration = in_space.run.output_interval = 1e-5;  // the start alone is of interest
        CHECK(joined(run_warnings(in_space, simulate_spatial(in_space))).empty());
        continue;
      }
      const Scene scene = load_scene(entry.path());
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

TEST_CASE("warnings: the oil's inertia, by the squeeze Reynolds number, where the scene has its density") {
  Scene scene = load_scene(journal_scene_file);
  CHECK_FALSE(squeeze_reynolds(scene, simulate_journal(scene)));
  scene.joints[0].density = 850;
  const JournalTrajectory run = simulate_journal(scene);
  const auto film = squeeze_reynolds(scene, run);
  REQUIRE(film);
  // No squeeze of it is as fast as its spin: ρ ω c²/μ.
  CHECK(film->number == Approx(850 * scene.bodies[0].spin * 2e-4 * 2e-4 / 0.4).epsilon(1e-14));  // rounding
  CHECK(squeeze_reynolds_warning(scene.joints[0], film).empty());
  CHECK_THAT(squeeze_reynolds_text(film), Contains("squeeze Reynolds number 0.00445"));
  scene.joints[0].density = 2e5;  // just above 1
  CHECK_THAT(squeeze_reynolds_warning(scene.joints[0], squeeze_reynolds(scene, run)),
             Contains("is 1.05 at 0 s, above 1"));

  // In a mechanism the squeeze is faster: the rate of e as the bearing sees it, from differences of its places.
  Scene crank = load_scene(data + "scenes/slider-crank-c0.5-mu0.04.toml");
  crank.joints[0].density = 850;
  const MultibodyTrajectory motion = simulate_multibody(crank);
  const auto of_crank = squeeze_reynolds(crank, 0, motion);
  REQUIRE(of_crank);
  const SceneJoint& joint = crank.joints[0];
  const auto seen = [&](const MultibodySample& s) {
    const double angle = joint.bearing.on_ground() ? 0 : s.state[3 * joint.bearing.body + 2];
    const Vector2<double>& e = s.joints[0].eccentricity;
    return Vector2<double>(std::cos(angle) * e.x() + std::sin(angle) * e.y(),
                           -std::sin(angle) * e.x() + std::cos(angle) * e.y());
  };
  double fastest = 0;
  for (std::size_t i = 1; i + 1 < motion.samples.size(); ++i) {
    const double span = motion.samples[i + 1].t - motion.samples[i - 1].t;
    fastest = std::max(fastest, (seen(motion.samples[i + 1]) - seen(motion.samples[i - 1])).norm() / span);
  }
  CHECK(of_crank->rate == Approx(fastest / joint.clearance).epsilon(0.1));  // differences over two output times
  CHECK(of_crank->number == Approx(850 * of_crank->rate * 5e-4 * 5e-4 / 0.04).epsilon(1e-14));
}

TEST_CASE("density in a scene: printed and warned of in simulate; refused where there is no oil") {
  const TemporaryFolder folder;
  const SceneText& text = journal_text();
  const SceneField& viscosity = text.field("joints[0].viscosity");
  const std::string given = text.replaced(viscosity, "viscosity = 0.4\ndensity = 2e5");
  const ProgramResult run = lubjoint_program({"simulate", folder.write("dense.toml", given)});
  CHECK_THAT(run.out, Contains("inertia    squeeze Reynolds number 1.05"));
  CHECK_THAT(run.err, Contains("squeeze Reynolds number of joint \"bearing\" is 1.05"));
  CHECK(lubjoint_program({"simulate", journal_scene_file}).out.find("inertia") == std::string::npos);
  for (const char* density : {"0", "-850"}) {
    const std::string wrong = text.replaced(viscosity, std::string("viscosity = 0.4\ndensity = ") + density);
    CHECK_THROWS_WITH(load_scene(folder.write("wrong.toml", wrong)), Contains("density is ") && Contains("kg/m^3"));
  }
  const std::string dry = text.with("joints[0].film", "\"none\"");
  const std::string contact =
      "\n[joints.contact]\nbearing_modulus = 2e11\nbearing_poisson = 0.3\njournal_modulus = 2e11\n"
      "journal_poisson = 0.3\nrestitution = 0.5\nmin_impact_speed = 1e-3\n[integrator]";
  std::string with_contact = dry;
  with_contact.replace(with_contact.find("\n[integrator]"), 13, contact);
  with_contact.replace(with_contact.find("viscosity = 0.4"), 15, "density = 850");
  CHECK_THROWS_WITH(load_scene(folder.write("dry.toml", with_contact)),
                    Contains("density") && Contains("there is no oil"));
}

TEST_CASE("warnings in space: an embedded mechanism is warned of as in the plane") {
  const Embedding in(some_plane(2));
  const Scene four_bar = load_scene(data + "examples/four-bar.toml");
  Scene scene = four_bar;
  scene.joints[0].clearance = 1e-7;
  scene.bodies[0].spin *= 30 / std::numbers::pi;
  const std::string words = joined(unit_warnings(scene));
  CHECK_THAT(words, Contains("c/R") && Contains("rpm?"));
  CHECK(joined(unit_warnings(in.scene(scene))) == words);
  CHECK(joined(unit_warnings(in.scene(four_bar))).empty());

  // A start that is moved, by the body's name.
  SpatialScene moved = in.scene(load_scene(data + "scenes/slider-crank-ideal.toml"));
  moved.redundant = RedundantConstraints::allow;
  moved.run.duration = moved.run.output_interval = 1e-5;
  CHECK(correction_warnings(moved, simulate_spatial(moved)).empty());
  moved.bodies[0].spin *= 30 / std::numbers::pi;
  CHECK_THAT(joined(run_warnings(moved, simulate_spatial(moved))),
             Contains("start of body \"crank\" was moved onto the constraints: spin [0, 0, ") && Contains("rpm?"));
  moved = in.scene(load_scene(data + "scenes/slider-crank-ideal.toml"));
  moved.redundant = RedundantConstraints::allow;
  moved.run.duration = moved.run.output_interval = 1e-5;
  moved.bodies[1].position += 0.01 * Vector3<double>(1, 2, 3);
  CHECK_THAT(joined(run_warnings(moved, simulate_spatial(moved))),
             Contains("start of body \"rod\" was moved onto the constraints: position ["));

  // The oil's inertia, and the law's error at the states that are visited.
  Scene crank = load_scene(data + "scenes/slider-crank-c0.5-mu0.04.toml");
  crank.joints[0].density = 850;
  crank.run.duration /= 4;
  crank.run.stop_at_outputs = true;
  SpatialScene in_space = in.scene(crank);
  allow_what_is_redundant(in_space);
  const MultibodyTrajectory flat = simulate_multibody(crank);
  const auto seen = seen_motions(in_space, 0, simulate_spatial(in_space));
  REQUIRE(seen.size() == flat.samples.size());
  CHECK(squeeze_reynolds(crank.joints[0], seen)->number ==
        Approx(squeeze_reynolds(crank, 0, flat)->number).epsilon(1e-6));  // of the tolerance
  std::vector<JournalMotion<double>> motions;
  for (const SeenMotion& each : seen) motions.push_back(each.motion);
  CHECK(visited_model_error(crank.joints[0], motions).median ==
        Approx(visited_model_error(crank, 0, flat).median).epsilon(1e-3));  // a film's stiffness times that
}

TEST_CASE("warnings in space: simulate says them") {
  std::string text = read_text(data + "scenes/space/spatial-slider-crank.toml");
  const std::size_t at = text.find("viscosity = 0.4");
  REQUIRE(at != std::string::npos);
  text.insert(at, "density = 1e9\n");
  const TemporaryFolder folder;
  const ProgramResult run = lubjoint_program({"simulate", folder.write("dense.toml", text)});
  INFO(run.err);
  CHECK(run.status == 0);
  CHECK_THAT(run.err, Contains("squeeze Reynolds number of joint \"gudgeon-pin\" is "));
  CHECK_THAT(run.err, Contains("is off the force of a film of the bearing's real length"));
}

}  // namespace scene_warnings_test

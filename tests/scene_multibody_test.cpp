#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"

namespace scene_multibody_test {

using namespace lubjoint;
using Catch::Contains;

namespace {

const std::string scenes = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/";

/// What is said of a shipped scene in which one text is replaced by another; "" if nothing.
std::string message_of(const std::string& name, const std::string& old_text, const std::string& new_text) {
  std::ifstream stream(scenes + name);
  std::ostringstream text;
  text << stream.rdbuf();
  std::string content = text.str();
  const std::size_t at = content.find(old_text);
  REQUIRE(at != std::string::npos);
  content.replace(at, old_text.size(), new_text);
  const auto file = std::filesystem::temp_directory_path() / "lubjoint-scene-multibody-test.toml";
  std::ofstream(file) << content;
  try {
    simulate_multibody([&] {
      Scene scene = load_scene(file);
      scene.run.duration = 1e-5;
      return scene;
    }());
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("every scene that ships runs to its end") {
  for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
    if (entry.path().extension() != ".toml") continue;
    INFO(entry.path());
    const Scene scene = load_scene(entry.path());
    const RunOutcome outcome =
        is_free_journal(scene) ? simulate_journal(scene).outcome : simulate_multibody(scene).outcome;
    CHECK(outcome.status == RunStatus::finished);
    CHECK(outcome.message.empty());
    CHECK(scene.name == entry.path().stem());
  }
}

TEST_CASE("a free journal runs by its own path, and the constrained one gives the same motion") {
  Scene scene = load_scene(scenes + "journal.toml");
  scene.run.duration = 0.02;
  CHECK(is_free_journal(scene));
  const JournalTrajectory journal = simulate_journal(scene);
  const MultibodyTrajectory general = simulate_multibody(scene);
  REQUIRE(journal.samples.size() == general.samples.size());
  const auto& state = journal.samples.back().state;
  const Vector2<double> e = general.samples.back().joints[0].eccentricity / scene.joints[0].clearance;
  CHECK((e - Vector2<double>(state[0], state[1])).norm() < 1e-6);  // two runs at 1e-8
}

TEST_CASE("bad multibody scenes are refused: file, line, key, what was given, what is allowed") {
  const auto crank = [](const std::string& from, const std::string& to) {
    return message_of("slider-crank.toml", from, to);
  };
  const auto impact = [](const std::string& from, const std::string& to) {
    return message_of("impact.toml", from, to);
  };
  CHECK_THAT(crank("type = \"revolute\"", "type = \"hinge\""),
             Contains("constraints[0].type is \"hinge\"") && Contains("translational, driver") && Contains(".toml:"));
  CHECK_THAT(crank("axis = [1.0, 0.0]", "axis = [0.0, 0.0]"), Contains("axis") && Contains("a direction"));
  CHECK_THAT(crank("axis = ", "axes = "), Contains("axis is missing"));
  CHECK_THAT(crank("speed = ", "sped = "), Contains("speed is missing"));
  CHECK_THAT(crank("angle = 0.0 ", "angel = 0.0 "),
             Contains("unknown key") && Contains("did you mean constraints[3].angle"));
  const std::string stabilisation = "[stabilisation]\nmethod = ";
  CHECK_THAT(crank("# [stabilisation]", stabilisation + "\"magic\""), Contains("\"baumgarte\" or \"projection\""));
  CHECK_THAT(crank("# [stabilisation]", stabilisation + "\"baumgarte\"\nalpha = -1.0"),
             Contains("stabilisation.alpha is -1"));
  CHECK_THAT(crank("energy_ledger = true", "energy_ledger = 1"), Contains("true or false"));
  CHECK_THAT(crank("mass = 0.21", "mass = -0.21"), Contains("bodies[1].mass"));
  CHECK_THAT(crank("first = {body = \"crank\"", "first = {body = \"rod\""), Contains("another body"));
  CHECK_THAT(
      crank("journal = {body = \"slider\", point = [0.0, 0.0]}", "journal = {body = \"slider\", point = [0.001, 0.0]}"),
      Contains("joints[0].journal is at eccentricity ratio 5"));
  CHECK_THAT(crank("name = \"guide\"", "name = \"crank-pin\""),
             Contains("a name that no other constraint or joint has"));
  CHECK_THAT(impact("e1 = 1e-5", "e1 = 5e-6"), Contains("transition.e1 is 5e-06 m") && Contains("more than e0"));
  CHECK_THAT(impact("restitution = 0.9", "restitution = 1.9"), Contains("a number in [0, 1]"));
  CHECK_THAT(impact("film = \"pinkus_sternlicht\"", "film = \"none\""), Contains("transition"));
  CHECK_THAT(impact("transition = {e0 = 5e-6, e1 = 1e-5}", ""), Contains("contact is given without a transition"));
  CHECK_THAT(impact("bearing_poisson = 0.3", "bearing_poisson = 0.6"), Contains("bearing_poisson is 0.6"));
}

}  // namespace scene_multibody_test

// An engine that nobody here wrote: its slider-crank moves as the golden trajectory says.
#include <catch2/catch.hpp>

#include "lubjoint/scene/scene_file.hpp"
#include "oracle/measure/bench/golden_reference.hpp"
#include "oracle/measure/bench/simbody_case.hpp"

namespace simbody_test {

using namespace lubjoint;
using namespace lubjoint::reports;

namespace {

Scene shipped(const std::string& name) {
  return load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/" + name + ".toml");
}

/// Largest |Δe|/c of Simbody's motion from the golden trajectory of the scene that ships.
double apart(const Scene& scene, const GoldenReference& golden, double accuracy) {
  const MethodRun run = simbody_case(scene, golden.times, golden.seen)->run("simbody_cpodes", accuracy, {1, 60});
  INFO(run.message);
  REQUIRE(run.finished);
  return run.error;
}

// Simbody's accuracy is a share of metres and radians: 1e-12 of the rod is 6e-10 of a clearance of 0.2 mm, and
// thousands of steps add up. Measured: 1.5e-8 and 2.6e-8.
constexpr double accuracy = 1e-12;
constexpr double allowed = 1e-7;

}  // namespace

TEST_CASE("Simbody: the slider-crank's golden trajectories are reached, the closer the higher its accuracy") {
  for (const char* name : {"slider-crank", "slider-crank-c0.5-mu0.04"}) {
    CAPTURE(name);
    const Scene scene = shipped(name);
    const auto golden = golden_reference(scene);
    REQUIRE(golden.has_value());
    const double close = apart(scene, *golden, accuracy);
    CHECK(close < allowed);
    const double less_close = apart(scene, *golden, 1e-9);
    CHECK(less_close < 3e-5);  // three decades of accuracy
    CHECK(less_close > 10 * close);
  }
}

TEST_CASE("Simbody: another viscosity, mass, inertia, length or side is noticed") {
  const Scene scene = shipped("slider-crank");
  const auto golden = golden_reference(scene);
  REQUIRE(golden.has_value());
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> changes = {
      {"viscosity", [](Scene& s) { s.joints[0].viscosity *= 1.001; }},
      {"length", [](Scene& s) { s.joints[0].length *= 1.001; }},
      {"slider's mass", [](Scene& s) { s.bodies[2].mass *= 1.001; }},
      {"rod's inertia", [](Scene& s) { s.bodies[1].inertia *= 1.001; }},
      {"side of the bearing", [](Scene& s) { std::swap(s.joints[0].bearing, s.joints[0].journal); }},
  };
  for (const auto& [what, change] : changes) {
    CAPTURE(what);
    Scene changed = scene;
    change(changed);
    CHECK(apart(changed, *golden, 1e-9) > 100 * allowed);
  }
}

}  // namespace simbody_test

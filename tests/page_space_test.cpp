// The run in space that the page shows: its checks say no to what is wrong, its animation is what was computed.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "oracle/page/sections.hpp"
#include "support/packed_numbers.hpp"
#include "support/page_content.hpp"

namespace page_space_test {

using namespace lubjoint;
using namespace lubjoint::reports::page;
using namespace lubjoint::test;
using Catch::Matchers::Contains;

namespace {

const SpaceExample& example() { return quick_page_content().space; }

std::vector<SpacePin> reference() {
  std::vector<double> times;
  for (const SpatialSample& sample : example().run.samples) times.push_back(sample.t);
  times.erase(times.begin());
  return space_reference(example().scene, times);
}

}  // namespace

TEST_CASE("page in space: the run agrees, and each check fails where what it judges is wrong") {
  CHECK(example().verdict.in_letters() == "yes ABCDEFG");
  const std::vector<SpacePin> right = reference();
  using Falsify = std::function<void(SpatialTrajectory&, std::vector<SpacePin>&)>;
  const auto failed = [&](const Falsify& falsify) {
    SpatialTrajectory run = example().run;
    std::vector<SpacePin> expected = right;
    falsify(run, expected);
    std::string whats;
    for (const reports::Check& check : space_checks(example().scene, run, expected)) {
      if (check.outcome == reports::CheckOutcome::failed) whats += check.what + ";";
    }
    return whats;
  };
  CHECK(failed([](auto&, auto&) {}).empty());
  CHECK(failed([](auto& run, auto&) { run.outcome.status = RunStatus::stopped; }) == "run;");
  CHECK(failed([](auto& run, auto&) { run.samples[40].joints[0].eccentricity.x() += 1e-5 * 2e-4; }) == "e/c;");
  CHECK(failed([](auto&, auto& pins) { pins[40].force.z() *= 1.001; }) == "joint force;");
  CHECK(failed([](auto&, auto& pins) { pins[40].force.z() = std::nan(""); }) == "joint force;");
  CHECK(failed([](auto&, auto& pins) { pins.pop_back(); }) == "e/c;joint force;");
  CHECK(failed([](auto&, auto& pins) { pins.clear(); }) == "e/c;joint force;");
  CHECK(failed([](auto& run, auto&) { run.drift.position = 1e-8; }) == "constraints;");
  CHECK(failed([](auto& run, auto&) { run.joints[0].tilt.value = 1e-6; }) == "tilt;");
  CHECK(failed([](auto& run, auto&) { run.drift.norm = 1e-8; }) == "Euler parameters;");
  CHECK(failed([](auto& run, auto&) { run.energy_residual = 1e-3 * run.energy_scale; }) == "energy;");
  SpatialTrajectory unkept = example().run;
  unkept.energy_residual.reset();
  CHECK(space_checks(example().scene, unkept, right).back().outcome == reports::CheckOutcome::not_checked);
}

TEST_CASE("page in space: minimal coordinates are of the scene's numbers, and of a spatial slider-crank alone") {
  const auto of_scene = spatial_slider_crank_of(example().scene);
  const mechanisms::SpatialSliderCrank<double> published;
  CHECK(of_scene.crank_length == published.crank_length);
  CHECK(of_scene.rod_length == Approx(published.rod_length).epsilon(1e-15));
  CHECK(of_scene.offset_y == published.offset_y);
  CHECK(of_scene.offset_z == published.offset_z);
  CHECK(of_scene.crank_centre == 0);  // balanced
  CHECK(crank_speed_of(example().scene) == 6);
  SpatialScene other = example().scene;
  other.constraints[1].name = "another";
  CHECK_THROWS_WITH(spatial_slider_crank_of(other), Contains("no such constraint \"crank-pin\""));
  other = example().scene;
  other.joints[0].plane.film = "short_half";
  CHECK_THROWS_WITH(spatial_slider_crank_of(other), Contains("pinkus_sternlicht"));
  // A heavier rod moves otherwise.
  other = example().scene;
  other.bodies[1].mass *= 1.01;
  const SpacePin changed = space_reference(other, {0.1}).front();
  const SpacePin usual = space_reference(example().scene, {0.1}).front();
  CHECK((changed.force - usual.force).norm() > 1e-3 * usual.force.norm());
}

TEST_CASE("page in space: the animation shows the states of the run, and the journal where its bodies have it") {
  const auto data = nlohmann::json::parse(space_animation_json(example()));
  const auto& samples = example().run.samples;
  REQUIRE(data["frames"] == samples.size());
  CHECK(data["end"] == samples.back().t);
  REQUIRE(data["bodies"].size() == 3);
  CHECK(data["bodies"][0]["arms"] == nlohmann::json::parse("[[0.0, 0.0, 0.08]]"));
  CHECK(data["bodies"][1]["arms"] == nlohmann::json::parse("[[-0.15, 0.0, 0.0], [0.15, 0.0, 0.0]]"));
  CHECK(data["bodies"][2]["arms"].empty());
  CHECK(data["axes"].size() == 2);  // of the crank, of the guide
  CHECK(data["pin"]["body"] == 1);
  const auto eccentricity = numbers<std::int16_t>(data["eccentricity"]);
  const auto force = numbers<float>(data["force"]);
  const auto film = numbers<float>(data["film"]);
  REQUIRE(eccentricity.size() == 2 * samples.size());
  REQUIRE(force.size() == 2 * samples.size());
  REQUIRE(film.size() == samples.size());
  std::array<std::vector<float>, 3> positions;
  std::array<std::vector<std::int16_t>, 3> turns;
  for (std::size_t b = 0; b < 3; ++b) {
    positions[b] = numbers<float>(data["bodies"][b]["position"]);
    turns[b] = numbers<std::int16_t>(data["bodies"][b]["turn"]);
    REQUIRE(positions[b].size() == 3 * samples.size());
    REQUIRE(turns[b].size() == 4 * samples.size());
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const SpatialJointSample& pin = samples[i].joints[0];
    const double ratio = std::hypot(eccentricity[2 * i], eccentricity[2 * i + 1]) / 32767;
    CHECK(std::abs(ratio - pin.eccentricity_ratio) < 1.0 / 32767);
    CHECK(std::hypot(force[2 * i], force[2 * i + 1]) == Approx(pin.force.norm()).epsilon(1e-6));
    CHECK(film[i] == static_cast<float>(pin.film_thickness));
    for (std::size_t b = 0; b < 3; ++b) {
      bool same = true;
      const double* state = &samples[i].state[7 * b];
      for (std::size_t k = 0; k < 3; ++k) same = same && positions[b][3 * i + k] == static_cast<float>(state[k]);
      for (std::size_t k = 0; k < 4; ++k) {
        same = same && std::abs(turns[b][4 * i + k] / 32767.0 - state[3 + k]) <= 0.5 / 32767;
      }
      CHECK(same);
    }
    // Along the rod lies the slider's centre, seen from the end of the rod.
    const SpatialMotion<double> rod = spatial_motion_in(samples[i].state.data(), 3, 1);
    const SpatialMotion<double> slider = spatial_motion_in(samples[i].state.data(), 3, 2);
    const Vector3<double> from_rod =
        rotation_matrix(rod.parameters).transpose() * Vector3<double>(slider.position - rod.position);
    const double c = example().scene.joints[0].plane.clearance;
    CHECK(std::abs(eccentricity[2 * i] / 32767.0 - (from_rod.x() - 0.15) / c) < 1e-4);
    CHECK(std::abs(eccentricity[2 * i + 1] / 32767.0 - from_rod.y() / c) < 1e-4);
  }
  SpaceExample empty = example();
  empty.run.samples.clear();
  CHECK(space_animation_json(empty) == "null");
}

}  // namespace page_space_test

// The plane in space: what a scene of the plane does does not depend on how its plane lies.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>

#include "lubjoint/motion/contact_events.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "support/embedded_scene.hpp"
#include "support/scenes.hpp"

namespace space_embedding_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

const std::string data = std::string(LUBJOINT_SOURCE_DIR) + "/data/";

/// Every scene of the plane that ships and that space has the parts of.
std::vector<std::string> planar_scenes() {
  std::vector<std::string> files;
  for (const char* folder : {"scenes", "scenes/benchmarks", "scenes/machines", "examples"}) {
    for (const auto& entry : std::filesystem::directory_iterator(data + folder)) {
      if (entry.path().extension() != ".toml") continue;
      if (scene_dimension(SceneFile(entry.path())) == 3) continue;
      const Scene scene = load_scene(entry.path());
      bool fits = true;
      for (const SceneBody& body : scene.bodies) fits = fits && body.mass > 0;
      if (fits) files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Largest distance of mass centres between the runs in the plane and in space, at the samples.
double distance(const MultibodyTrajectory& flat, const SpatialTrajectory& space, const Embedding& in) {
  REQUIRE(flat.samples.size() == space.samples.size());
  double largest = 0;
  for (std::size_t i = 0; i < flat.samples.size(); ++i) {
    const std::vector<double> wanted = in.state(flat.samples[i].state, flat.samples[i].t);
    const std::size_t n = flat.samples[i].state.size() / 6;
    for (std::size_t k = 0; k < 7 * n; ++k) {
      if (k % 7 < 3) largest = std::max(largest, std::abs(space.samples[i].state[k] - wanted[k]));
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("plane in space: every scene has the plane's accelerations at equal states") {
  std::size_t scenes = 0;
  unsigned number = 0;
  for (const std::string& file : planar_scenes()) {
    Scene flat = load_scene(file);
    flat.run.duration /= 20;
    flat.run.output_interval = flat.run.duration / 10;
    if (flat.joints.empty() || !flat.joints[0].contact) flat.run.absolute_tolerance = flat.run.relative_tolerance;
    const MultibodyTrajectory run = simulate_multibody(flat);
    const auto plane = planar_system<double>(flat);
    const Embedding in(some_plane(++number));
    SpatialScene space = in.scene(flat);
    SpatialSystem<double> system = spatial_system<double>(space);
    std::vector<double> start = scene_start<double>(space);
    const auto found =
        assemble_spatial_start(system, 0.0, scene_units(space).mechanism, start, RedundantConstraints::allow);
    INFO(file << ", rows left out: " << found.left_out.size());
    auto w = system.workspace<double>();
    auto v = plane.workspace<double>();
    double scale = 0;  // of rounding: forces that cancel, and those of films on their levers, in the whole run
    for (auto each = run.samples.rbegin(); each != run.samples.rend(); ++each) {  // the start, where films rest, last
      const MultibodySample& sample = *each;
      std::vector<JointMemory<double>> memory;
      for (std::size_t j = 0; j < flat.joints.size() && !flat.joints.empty(); ++j) {
        if (!flat.joints[j].contact) continue;
        plane.evaluate_kinematics(sample.t, sample.state.data(), v);
        memory.resize(flat.joints.size());
        memory[j] = detail::starting_memory(plane.joints()[j], plane.journal_motion(j, v));
      }
      plane.evaluate(sample.t, sample.state.data(), memory, v);
      system.evaluate(sample.t, in.state(sample.state).data(), memory, w);
      const std::vector<double> wanted = in.accelerations(v.accelerations);
      double worst = 0;
      for (std::size_t k = 0; k < v.forces.size(); ++k)
        scale = std::max(scale, std::abs(v.forces[k]) * plane.inverse_mass(k / 3)[k % 3]);
      for (std::size_t j = 0; j < flat.joints.size(); ++j) {
        for (const SceneAnchor* at : {&flat.joints[j].bearing, &flat.joints[j].journal}) {
          if (at->on_ground()) continue;
          const SceneBody& body = flat.bodies[at->body];
          scale = std::max(scale, v.joints[j].total().norm() * (1 / body.mass + at->point.norm() / body.inertia));
        }
      }
      for (std::size_t k = 0; k < wanted.size(); ++k) {
        scale = std::max(scale, std::abs(wanted[k]));
        worst = std::max(worst, std::abs(wanted[k] - w.accelerations[k]));
      }
      INFO("t = " << sample.t << ", scale " << scale);
      // A film or a contact sees places in its gap.
      double of_places = 0, reach = 0;  // how far from the origin, where places are rounded [m]
      const std::vector<double> there = in.state(sample.state);
      for (std::size_t k = 0; k < 7 * flat.bodies.size(); ++k)
        reach = k % 7 < 3 ? std::max(reach, std::abs(there[k])) : reach;
      for (std::size_t j = 0; j < sample.joints.size(); ++j) {
        const double gap = std::max(std::abs(sample.joints[j].film_thickness), 1e-6 * flat.joints[j].clearance);
        // Roundings of half a unit: of the turn's products and sums, the shift, and the difference of two points.
        constexpr double places = 8 * std::numeric_limits<double>::epsilon() / 2;
        // A force grows with the gap's power of -5/2 near the wall, and with ε before.
        constexpr double growth = 3;
        of_places = std::max(of_places, growth * places * (reach + scene_units(space).mechanism) / gap);
      }
      CHECK(worst <= (1e-12 + of_places) * (scale + 1));
    }
    ++scenes;
  }
  CHECK(scenes >= 15);
}

TEST_CASE("plane in space: a mechanism with a lubricated joint takes the plane's way to 1e-9 of a clearance") {
  for (const char* name : {"slider-crank", "slider-crank-c0.5-mu0.4", "journal"}) {
    Scene flat = load_scene(data + "scenes/" + name + ".toml");
    set_tolerance(flat, 1e-12);
    flat.run.duration /= 8;
    flat.run.output_interval = flat.run.duration / 40;
    flat.run.stop_at_outputs = true;  // no sample is interpolated
    const Embedding in(some_plane(3));
    SpatialScene space = in.scene(flat);
    allow_what_is_redundant(space);
    const SpatialTrajectory run = simulate_spatial(space);
    REQUIRE(run.outcome.status == RunStatus::finished);
    const MultibodyTrajectory wanted = simulate_multibody(flat);
    INFO(name << ": steps " << wanted.outcome.steps << " and " << run.outcome.steps << ", seconds "
              << wanted.wall_seconds << " and " << run.wall_seconds);
    CHECK(distance(wanted, run, in) < 1e-9 * flat.joints[0].clearance);  // what is asked for
  }
}

TEST_CASE("plane in space: redundant rows of an ideal mechanism are left out, and the way is the plane's") {
  Scene flat = load_scene(data + "scenes/slider-crank-ideal.toml");
  set_tolerance(flat, 1e-11);
  flat.run.duration /= 4;
  flat.run.output_interval = flat.run.duration / 20;
  flat.run.stop_at_outputs = true;
  const Embedding in(some_plane(1));
  SpatialScene space = in.scene(flat);
  CHECK_THROWS_AS(simulate_spatial(space), SceneError);
  space.redundant = RedundantConstraints::allow;
  const SpatialTrajectory run = simulate_spatial(space);
  REQUIRE(run.outcome.status == RunStatus::finished);
  CHECK(run.left_out.size() == 3);  // a loop of the plane: three of its out-of-plane conditions
  CHECK(run.rank + 3 == run.rows);
  CHECK(run.drift.left_out_position < 1e-10);                        // as the constraints that are kept
  CHECK(distance(simulate_multibody(flat), run, in) < 1e-9 * 0.05);  // of the crank
}

TEST_CASE("plane in space: bodies without ground take the plane's way when everything moves along") {
  // Two bodies joined by a film, nothing else: a rod that carries a bearing, and a journal that flies in it.
  Scene flat = load_scene(data + "scenes/journal.toml");
  flat.gravity = {0, 0};
  flat.loads.clear();
  SceneBody rod = body("rod", 0.3, 4e-4, {0.02, 0.01}, 0.4);
  rod.spin = 20;
  flat.bodies.push_back(rod);
  flat.joints[0].bearing = {1, {-0.02, 0.01}};
  const double c = std::cos(0.4);
  const double s = std::sin(0.4);
  flat.bodies[0].position = {0.02 + (-0.02 * c - 0.01 * s) + 5e-5, 0.01 + (-0.02 * s + 0.01 * c) - 8e-5};
  flat.bodies[0].velocity = {0.02 * 20 * s - 0.01 * 20 * c, -0.02 * 20 * c - 0.01 * 20 * s};  // with its bearing
  set_tolerance(flat, 1e-12);
  flat.run.duration = 0.02;
  flat.run.output_interval = 1e-3;
  flat.run.stop_at_outputs = true;
  const MultibodyTrajectory wanted = simulate_multibody(flat);
  REQUIRE(wanted.outcome.status == RunStatus::finished);
  for (const double speed : {0.0, 3.0}) {
    Plane plane = some_plane(2);
    plane.velocity = {speed, -0.5 * speed, 0.2 * speed};
    const Embedding in(plane);
    const SpatialTrajectory run = simulate_spatial(in.scene(flat));
    REQUIRE(run.outcome.status == RunStatus::finished);
    INFO(speed);
    CHECK(distance(wanted, run, in) < 1e-9 * flat.joints[0].clearance);  // what is asked for
  }
}

}  // namespace space_embedding_test

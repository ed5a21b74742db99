#include <array>
#include <boost/math/tools/roots.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/scenes.hpp"
#include "support/temporary_folder.hpp"

namespace contact_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

const std::string scenes = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/";

/// A journal thrown along x against the wall of a dry bearing.
Scene thrown_journal(double speed, double restitution) {
  Scene scene;
  scene.file = scene.name = "thrown";
  scene.bodies = {body("journal", 0.13, 2.5e-4, {0, 0})};
  scene.bodies[0].velocity = {speed, 0};
  scene.joints = {dry_joint({ground_body, {0, 0}}, {0, {0, 0}}, restitution)};
  scene.run.duration = 0.0002 / speed + 2e-4;
  scene.energy_ledger = true;
  set_tolerance(scene, 1e-10);
  return scene;
}

/// v₁ of d v₀ − ln(1 + d v₀) = −d v₁ − ln(1 − d v₁), d = 3(1 − c_r²)/(4 v₀).
double exact_exit_speed(double speed, double restitution) {
  const double d = 3 * (1 - restitution * restitution) / (4 * speed);
  const double left = d * speed - std::log1p(d * speed);
  const auto gap = [&](double v) { return -d * v - std::log1p(-d * v) - left; };
  std::uintmax_t iterations = 100;
  const auto root = boost::math::tools::toms748_solve(gap, 1e-6 * speed, std::min(speed, (1 - 1e-12) / d),
                                                      boost::math::tools::eps_tolerance<double>(50), iterations);
  return root.first;
}

}  // namespace

TEST_CASE("dry impact: the exit speed is the exact one, whatever the speed and the restitution") {
  for (const double speed : {0.1, 1.0}) {
    for (const double restitution : {0.3, 0.7, 0.95}) {
      const MultibodyTrajectory run = simulate_multibody(thrown_journal(speed, restitution));
      INFO("speed " << speed << ", restitution " << restitution << ' ' << run.outcome.message);
      REQUIRE(run.events.size() >= 2);
      CHECK(std::abs(-run.events[1].normal_speed / exact_exit_speed(speed, restitution) - 1) <
            1e-7);  // tolerance × stiffness
      CHECK(*run.energy_residual < 100 * 1e-10 * run.energy_scale);
    }
  }
}

TEST_CASE("contact: a start in penetration is read, and an elastic wall gives back the work that it would have taken") {
  const TemporaryFolder folder;
  const double depth = 2e-6;
  const std::string text = R"(name = "inside-the-wall"
duration = 2e-4
[[bodies]]
name = "journal"
mass = 0.13
inertia = 2.5e-4
position = [2.02e-4, 0.0]
[[joints]]
name = "bearing"
film = "none"
journal_radius = 0.0098
clearance = 0.0002
bearing = {body = "ground", point = [0.0, 0.0]}
journal = {body = "journal", point = [0.0, 0.0]}
[joints.contact]
bearing_modulus = 207e9
bearing_poisson = 0.3
journal_modulus = 207e9
journal_poisson = 0.3
restitution = 1.0
min_impact_speed = 1e-3
[integrator]
relative_tolerance = 1e-10
)";
  const MultibodyTrajectory run = simulate_multibody(load_scene(folder.write("scene.toml", text)));
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  REQUIRE(!run.events.empty());
  const double modulus = 1 / (2 * (1 - 0.3 * 0.3) / 207e9);
  const double stiffness = 4.0 / 3 * std::sqrt(0.01 * 0.0098 / 0.0002) * modulus;
  const double work = 0.4 * stiffness * std::pow(depth, 2.5);  // of Kδ^{3/2}
  const double exit = std::sqrt(2 * work / 0.13);
  CHECK(std::abs(-run.events[0].normal_speed / exit - 1) < 1e-7);  // tolerance × stiffness, and depth to 1e-14/2e-6
  // Without contact such a start is still refused, and the message names it as the way out.
  std::string oiled = text.substr(0, text.find("[joints.contact]"));
  oiled.replace(oiled.find("\"none\""), 6, "\"pinkus_sternlicht\"\nviscosity = 0.4\nlength = 0.04");
  CHECK_THROWS_WITH(load_scene(folder.write("oiled.toml", oiled)), Contains("eccentricity ratio 1.01"));
}

TEST_CASE("contact: entry is located to 1e-12 s") {
  const MultibodyTrajectory run = simulate_multibody(thrown_journal(0.7, 0.5));
  REQUIRE(!run.events.empty());
  CHECK(std::abs(run.events[0].t - 0.0002 / 0.7) < 1e-12);
  CHECK(std::abs(run.events[0].normal_speed - 0.7) < 1e-12);  // a free flight: rounding
}

TEST_CASE("contact: of several journals that touch within one step each does at its own time, and leaves as if alone") {
  constexpr double clearance = 0.0002;
  constexpr double restitution = 0.7;
  // Far apart; 2e-7 s apart, the first joint first and last; together to the bit.
  const std::vector<std::array<double, 3>> cases = {
      {0.7, 0.5, 0.6}, {0.7, 0.6995, 0.6993}, {0.6993, 0.7, 0.6995}, {0.7, 0.7, 0.7}};
  for (const auto& speeds : cases) {
    Scene scene = thrown_journal(speeds[0], restitution);
    for (std::size_t i = 1; i < speeds.size(); ++i) {
      const double place = 0.1 * static_cast<double>(i);
      scene.bodies.push_back(body("journal " + std::to_string(i), 0.13, 2.5e-4, {place, 0}));
      scene.bodies[i].velocity = {speeds[i], 0};
      scene.joints.push_back(dry_joint({ground_body, {place, 0}}, {i, {0, 0}}, restitution));
    }
    scene.run.duration = clearance / 0.5 + 2e-4;
    const MultibodyTrajectory run = simulate_multibody(scene);
    INFO(speeds[0] << ' ' << speeds[1] << ' ' << speeds[2] << ' ' << run.outcome.message);
    REQUIRE(run.outcome.status == RunStatus::finished);
    std::array<std::vector<ContactEvent>, 3> of_joint;
    for (std::size_t k = 0; k < run.events.size(); ++k) {
      if (k > 0) CHECK(run.events[k].t >= run.events[k - 1].t);
      of_joint[run.events[k].joint].push_back(run.events[k]);
    }
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      INFO("journal " << i);
      REQUIRE(of_joint[i].size() == 2);  // in and out
      CHECK(of_joint[i][0].to == ContactPhase::dry);
      CHECK(std::abs(of_joint[i][0].t - clearance / speeds[i]) < 1e-12);  // a free flight; 0.1 m rounds to 1e-17 m
      CHECK(std::abs(of_joint[i][0].normal_speed - speeds[i]) < 1e-12);
      CHECK(std::abs(-of_joint[i][1].normal_speed / exact_exit_speed(speeds[i], restitution) - 1) <
            1e-7);  // tolerance x stiffness
    }
  }
}

TEST_CASE("impact scene: film, blend and dry contact, with a force that is continuous across every event") {
  const Scene scene = load_scene(scenes + "impact.toml");
  const MultibodyTrajectory run = simulate_multibody(scene);
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  REQUIRE(run.events.size() >= 4);
  CHECK(run.joints[0].eccentricity.value > scene.joints[0].clearance);
  bool dry = false;
  for (const ContactEvent& event : run.events) {
    dry = dry || event.to == ContactPhase::dry;
    CHECK(event.force_jump < 1e-9 * run.joints[0].force.value);
  }
  CHECK(dry);
  CHECK(*run.energy_residual < 100 * scene.run.relative_tolerance * run.energy_scale);
}

TEST_CASE("a joint without transition stops at its wall with a message, and has no events before") {
  Scene scene = load_scene(scenes + "impact.toml");
  scene.joints[0].transition.reset();
  scene.joints[0].contact.reset();
  const MultibodyTrajectory run = simulate_multibody(scene);
  CHECK(run.events.empty());
  CHECK(run.outcome.mode_changes == 0);
  for (const MultibodySample& sample : run.samples) {
    CHECK(sample.joints[0].eccentricity_ratio < 1);
    CHECK(std::isfinite(sample.joints[0].force.norm()));
  }
}

TEST_CASE("friction turns a spinning journal's rebound, and its work is in the ledger") {
  Scene scene = thrown_journal(1.0, 0.8);
  scene.bodies[0].spin = 300;
  scene.joints[0].contact->friction = 0.1;
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  const auto& last = run.samples.back().state;
  CHECK(last[4] < -1e-3);  // the wall holds the spinning surface back: the journal leaves downwards
  CHECK(last[5] < 300);
  CHECK(*run.energy_residual < 100 * 1e-10 * run.energy_scale);
}

TEST_CASE("slider-crank with 0.5 mm and a thin oil: with a transition it touches, and the force stays continuous") {
  Scene scene = load_scene(scenes + "slider-crank-c0.5-mu0.04.toml");
  scene.joints[0].transition = SceneTransition{2e-6, 4e-6};
  scene.joints[0].contact = dry_joint({}, {0, {0, 0}}, 0.9).contact;
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  REQUIRE(run.events.size() >= 2);
  CHECK(run.joints[0].eccentricity.value > scene.joints[0].clearance);
  for (const ContactEvent& event : run.events) CHECK(event.force_jump < 1e-9 * run.joints[0].force.value);
  CHECK(*run.energy_residual < 100 * scene.run.relative_tolerance * run.energy_scale);
}

TEST_CASE("a half film slides on its jump while it blends into contact, and the force stays continuous at both seams") {
  Scene scene = load_scene(scenes + "slider-crank-c0.5-mu0.04.toml");
  scene.joints[0].film = "long_half_eq5";
  scene.joints[0].transition = SceneTransition{5e-5, 6e-5};  // so wide that it is in the blend for most of the time
  scene.joints[0].contact = dry_joint({}, {0, {0, 0}}, 0.9).contact;
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  std::size_t blended = 0;
  for (const ContactEvent& event : run.events) {
    CHECK(event.force_jump < 1e-9 * run.joints[0].force.value);
    for (const JointSlide& slide : run.slides) {
      if (slide.start < event.t && event.t < slide.end) ++blended;
    }
  }
  CHECK(blended > 0);
  CHECK(*run.energy_residual < 100 * scene.run.relative_tolerance * run.energy_scale);
}

}  // namespace contact_test

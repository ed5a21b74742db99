// A rotor with an unbalance in its film, against the linear coefficients of its steady state.
#include <catch2/catch.hpp>

#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/linear_response.hpp"
#include "support/scenes.hpp"

namespace unbalance_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

/// Largest distance from that orbit of a run that starts on it, in clearances.
double distance_from_linear(Scene scene, double unbalance, double factor) {
  const JournalEquilibrium rest = journal_equilibrium(scene);
  const double c = scene.joints[0].clearance;
  const double omega = scene.bodies[0].spin;
  const Eigen::Vector2cd z = linear_response(scene, rest, unbalance, factor);
  const auto orbit = [&](double t) { return on_linear_orbit(scene, rest, z, t); };
  SceneLoad load;
  load.unbalance = SceneUnbalance{unbalance, 0};
  scene.loads.push_back(load);
  scene.bodies[0].spin_is_held = true;
  scene.bodies[0].position = scene.joints[0].bearing.point + orbit(0);
  scene.bodies[0].velocity = (std::complex<double>(0, omega) * z).real();
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  double largest = 0;
  for (const MultibodySample& sample : run.samples) {
    largest = std::max(largest, (sample.joints[0].eccentricity - orbit(sample.t)).norm() / c);
  }
  return largest;
}

}  // namespace

TEST_CASE("unbalance: the synchronous orbit is that of the linear coefficients, to first order in the unbalance") {
  Scene scene = load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/journal.toml");
  set_tolerance(scene, 1e-11);
  scene.run.duration = 0.36;  // three revolutions
  scene.run.output_interval = 0.004;
  for (const std::string law : {"pinkus_sternlicht", "short_dynamic"}) {
    INFO(law);
    scene.joints[0].film = law;
    const double c = scene.joints[0].clearance;
    const double unit = 1e-3 * c / linear_response(scene, journal_equilibrium(scene), 1, 1).norm();
    // The orbit is 1e-3 of a clearance wide, what is left of second order: a quarter at half the unbalance.
    const double whole = distance_from_linear(scene, unit, 1);
    const double half = distance_from_linear(scene, unit / 2, 1);
    CHECK(whole < 1e-5);
    CHECK(whole / half == Approx(4).epsilon(0.02));  // third order: 1e-3, and the run's 1e-9 of 1e-6
    // A stiffness wrong by a part in a hundred is an error of first order.
    CHECK(distance_from_linear(scene, unit, 1.01) / distance_from_linear(scene, unit / 2, 1.01) < 2.5);
  }
}

}  // namespace unbalance_test

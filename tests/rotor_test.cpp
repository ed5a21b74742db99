// The rigid rotor that ships: its orbit against the linear coefficients, its threshold of stability by simulation
// against Routh's criterion, and the whirl beyond it.
#include <catch2/catch.hpp>
#include <numbers>

#include "lubjoint/film/rotor_threshold.hpp"
#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/periodic_orbit.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/scene_period.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/linear_response.hpp"
#include "support/scenes.hpp"

namespace rotor_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

Scene rotor() { return load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/machines/rotor.toml"); }

/// The rotor without its unbalance, of any mass under the weight that it has: a free journal.
Scene loaded_rotor(double mass) {
  Scene scene = rotor();
  scene.loads.clear();
  SceneLoad weight;
  weight.force = scene.bodies[0].mass * scene.gravity;
  scene.loads.push_back(weight);
  scene.gravity = {0, 0};
  scene.bodies[0].mass = mass;
  scene.bodies[0].velocity = {0, 0};
  return scene;
}

/// Distance of a run from a place, at its samples, in clearances.
struct Deviation {
  std::vector<double> t;
  std::vector<Vector2<double>> place;
};

Deviation deviation(const Scene& scene, const Vector2<double>& rest) {
  const JournalTrajectory run = simulate_journal(scene);
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  Deviation result;
  for (const JournalSample& sample : run.samples) {
    result.t.push_back(sample.t);
    result.place.emplace_back(sample.state[0] - rest.x(), sample.state[1] - rest.y());
  }
  return result;
}

/// Root of the mean square of a deviation over a window, weighted so that its ends count for nothing: how many turns
/// fit into it does not matter.
double size_between(const Deviation& d, double from, double to) {
  double sum = 0;
  double weights = 0;
  for (std::size_t i = 0; i < d.t.size(); ++i) {
    if (d.t[i] < from || d.t[i] > to) continue;
    const double s = std::sin(std::numbers::pi * (d.t[i] - from) / (to - from));
    sum += s * s * s * s * d.place[i].squaredNorm();
    weights += s * s * s * s;
  }
  return std::sqrt(sum / weights);
}

/// Rate at which a small whirl about the place of rest grows [1/s].
double growth_rate(double mass) {
  Scene scene = loaded_rotor(mass);
  set_tolerance(scene, 1e-12);
  const JournalEquilibrium rest = journal_equilibrium(scene);
  const double revolution = 2 * std::numbers::pi / scene.bodies[0].spin;
  scene.bodies[0].position = scene.joints[0].clearance * (rest.eccentricity + Vector2<double>(1e-4, 0));
  scene.run.duration = 160 * revolution;
  scene.run.output_interval = revolution / 16;
  const Deviation d = deviation(scene, rest.eccentricity);
  // Half a whirl is a revolution: forty of them a window. What else the start has stirred has died out by then.
  const double early = size_between(d, 40 * revolution, 80 * revolution);
  const double late = size_between(d, 120 * revolution, 160 * revolution);
  return std::log(late / early) / (80 * revolution);
}

double critical_mass() {
  const Scene scene = loaded_rotor(1);
  const JournalEquilibrium rest = journal_equilibrium(scene);
  return routh_threshold<double>(rest.stiffness, rest.damping).critical_mass;
}

}  // namespace

TEST_CASE("rotor: the scene as it ships stays on an orbit near the one of its linear coefficients") {
  const Scene ships = rotor();
  const JournalEquilibrium rest = journal_equilibrium(loaded_rotor(ships.bodies[0].mass));
  // Largest distance of a run from the linear orbit, in clearances.
  const auto distance = [&](const Scene& scene, double factor) {
    const Eigen::Vector2cd z = linear_response(scene, rest, scene.loads[0].unbalance->mass_radius, factor);
    const MultibodyTrajectory run = simulate_multibody(scene);
    INFO(run.outcome.message);
    REQUIRE(run.outcome.status == RunStatus::finished);
    double largest = 0;
    for (const MultibodySample& sample : run.samples) {
      const Vector2<double> off = sample.joints[0].eccentricity - on_linear_orbit(scene, rest, z, sample.t);
      largest = std::max(largest, off.norm() / scene.joints[0].clearance);
    }
    return largest;
  };
  // The same with a share of its unbalance, over a revolution of its periodic orbit.
  const auto of_share = [&](double share, double factor) {
    Scene scene = rotor();
    scene.loads[0].unbalance->mass_radius *= share;
    const PeriodicOrbit orbit = periodic_orbit(scene, *scene_period(scene), 1e-6);
    scene.bodies[0].position = {orbit.state[0], orbit.state[1]};
    scene.bodies[0].velocity = {orbit.state[3], orbit.state[4]};
    scene.run.duration = orbit.period;
    scene.run.output_interval = orbit.period / 64;
    return distance(scene, factor);
  };
  const double shipped = distance(ships, 1);
  const double whole = of_share(1, 1);
  const double half = of_share(0.5, 1);
  const double quarter = of_share(0.25, 1);
  const double size =
      linear_response(ships, rest, ships.loads[0].unbalance->mass_radius, 1).norm() / ships.joints[0].clearance;
  INFO("orbit " << size << ", distances " << shipped << ", " << whole << ", " << half << ", " << quarter);
  CHECK(shipped == Approx(whole).epsilon(0.01));  // it starts on its orbit; a sixty-fourth of a turn between samples
  CHECK(shipped < size * size);                   // of second order in the orbit's size, with a factor below 1
  // Of second order in the unbalance; what is left is of third order, and halves.
  CHECK(half / quarter == Approx(4).epsilon(0.1));
  CHECK(std::abs(half / quarter - 4) < std::abs(whole / half - 4));
  // A stiffness wrong by a tenth is an error of first order.
  CHECK(of_share(0.25, 1.1) / of_share(0.125, 1.1) < 2.5);
}

TEST_CASE("machines: a ledger of energy closes in every scene that ships, whatever it has in it") {
  const std::string folder = std::string(LUBJOINT_SOURCE_DIR) + "/data/";
  for (const std::string file : {"scenes/machines/rotor.toml", "scenes/machines/big-end.toml", "examples/shaker.toml",
                                 "examples/lever.toml", "scenes/machines/engine.toml"}) {
    INFO(file);
    Scene scene = load_scene(folder + file);
    scene.energy_ledger = true;
    const MultibodyTrajectory run = simulate_multibody(scene);
    INFO(run.outcome.message);
    REQUIRE(run.outcome.status == RunStatus::finished);
    REQUIRE(run.energy_residual);
    INFO(*run.energy_residual / run.energy_scale << " in " << run.outcome.steps << " steps");
    // Some thousand steps, each off by a tolerance at most.
    CHECK(*run.energy_residual < 1000 * scene.run.relative_tolerance * run.energy_scale);
    CHECK(run.energy_scale > 0);
  }
}

TEST_CASE("rotor: the threshold of stability by simulation is Routh's, within a part in a thousand") {
  const double critical = critical_mass();
  CHECK(critical > 10);  // the scene is stable
  for (const double factor : {0.999, 1.001}) {
    const double rate = growth_rate(factor * critical);
    const JournalEquilibrium rest = journal_equilibrium(loaded_rotor(factor * critical));
    CHECK((rate > 0) == (factor > 1));
    // A deviation of 1e-4 is linear to 1e-8; the windows' weights leave next to nothing of the whirl's own swing.
    CHECK(rate == Approx(rest.eigenvalues[0].real()).epsilon(0.01));
  }
  // The critical mass of an oil that is a tenth thicker is not this one's: a whirl has one sign on both sides of it.
  Scene other = loaded_rotor(1);
  other.joints[0].viscosity *= 1.1;
  const JournalEquilibrium thicker = journal_equilibrium(other);
  const double wrong = routh_threshold<double>(thicker.stiffness, thicker.damping).critical_mass;
  CHECK((growth_rate(0.999 * wrong) > 0) == (growth_rate(1.001 * wrong) > 0));
}

TEST_CASE("rotor: above the threshold a whirl of nearly half the spin grows, and stays inside its bearing") {
  const double mass = 1.5 * critical_mass();
  Scene scene = loaded_rotor(mass);
  set_tolerance(scene, 1e-9);
  const JournalEquilibrium rest = journal_equilibrium(scene);
  const double spin = scene.bodies[0].spin;
  const double revolution = 2 * std::numbers::pi / spin;
  scene.bodies[0].position = scene.joints[0].clearance * (rest.eccentricity + Vector2<double>(1e-4, 0));
  scene.run.duration = 400 * revolution;
  scene.run.output_interval = revolution / 32;
  const Deviation d = deviation(scene, rest.eccentricity);
  const auto middle_of = [&](std::size_t from, std::size_t to) {
    Vector2<double> middle(0, 0);
    for (std::size_t i = from; i < to; ++i) middle += d.place[i] / static_cast<double>(to - from);
    return middle;
  };
  /// Turns about a place over a stretch, per revolution of the spin.
  const auto whirl_ratio = [&](std::size_t from, std::size_t to, const Vector2<double>& middle) {
    double angle = 0;
    for (std::size_t i = from + 1; i < to; ++i) {
      const Vector2<double> a = d.place[i - 1] - middle;
      const Vector2<double> b = d.place[i] - middle;
      angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return angle / (d.t[to - 1] - d.t[from]) / spin;
  };
  const std::size_t n = d.t.size();
  double largest = 0;
  for (std::size_t i = n / 2; i < n; ++i) largest = std::max(largest, d.place[i].norm());
  const double late = whirl_ratio(n - 32 * 40, n, middle_of(n - 32 * 40, n));
  INFO("late orbit " << largest << ", whirl ratio " << late);
  CHECK(largest > 0.3);                     // it has grown by a factor of thousands
  CHECK(late == Approx(0.5).margin(0.03));  // oil whirl
  // While it is small it turns as the eigenvalue says.
  const double linear = std::abs(rest.eigenvalues[0].imag()) / spin;
  // About the place of rest; the ends of the stretch, of ten turns, leave less than a fiftieth of it.
  CHECK(whirl_ratio(32 * 4, 32 * 24, Vector2<double>(0, 0)) == Approx(linear).epsilon(0.02));
}

}  // namespace rotor_test

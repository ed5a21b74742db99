// The four-stroke engine that ships, and its big end under a load diagram: tables, periodic orbits, and the mobility
// method as the limit of a light journal.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "lubjoint/scene/periodic_orbit.hpp"
#include "lubjoint/scene/scene_period.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/mechanisms/engine_tables.hpp"
#include "oracle/mechanisms/mobility_orbit.hpp"
#include "oracle/mechanisms/slider_crank.hpp"
#include "support/csv.hpp"
#include "support/scenes.hpp"
#include "support/temporary_folder.hpp"

namespace engine_test {

using namespace lubjoint;
using namespace lubjoint::test;
using namespace lubjoint::mechanisms;
using Catch::Contains;

namespace {

const std::string shipped_scenes = LUBJOINT_SOURCE_DIR "/data/scenes/";
const std::string machines = shipped_scenes + "machines/";

/// A table that ships, or, where it is asked for, the one that is computed in its place.
std::string shipped(const std::string& name, const std::string& computed) {
  const std::string file = machines + "tables/" + name;
  if (std::getenv("LUBJOINT_REWRITE_DOCUMENTATION") != nullptr) std::ofstream(file) << computed;
  return read_text(file);
}

/// The numbers of a table, row by row.
std::vector<std::vector<double>> numbers_of(const std::string& text) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || std::isalpha(static_cast<unsigned char>(line[0])) || line[0] == '#') continue;
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(std::stod(field));
  }
  return rows;
}

void check_same(const std::string& name, const std::string& computed) {
  const auto there = numbers_of(shipped(name, computed));
  const auto here = numbers_of(computed);
  INFO(name);
  REQUIRE(there.size() == here.size());
  double largest = 0;
  for (const auto& row : here) {
    for (const double value : row) largest = std::max(largest, std::abs(value));
  }
  for (std::size_t i = 0; i < here.size(); ++i) {
    REQUIRE(there[i].size() == here[i].size());
    for (std::size_t k = 0; k < here[i].size(); ++k)
      CHECK(there[i][k] == Approx(here[i][k]).epsilon(1e-11).margin(1e-12 * largest));  // the digits that it has
  }
}

/// ê of the only joint, at the times of a table's rows.
std::vector<Vector2<double>> orbit_of(Scene scene, double mass, const std::vector<double>& t) {
  scene.bodies[0].mass = mass;
  set_tolerance(scene, 1e-10);
  const PeriodicOrbit orbit = periodic_orbit(scene, *scene_period(scene), 1e-9);
  scene.bodies[0].position = {orbit.state[0], orbit.state[1]};
  scene.bodies[0].velocity = {orbit.state[3], orbit.state[4]};
  scene.run.output_interval = scene.run.duration / static_cast<double>(t.size() - 1);
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  REQUIRE(run.samples.size() == t.size());
  std::vector<Vector2<double>> places;
  for (const MultibodySample& sample : run.samples)
    places.emplace_back(sample.joints[0].eccentricity / scene.joints[0].clearance);
  return places;
}

double largest_distance(const std::vector<Vector2<double>>& a, const std::vector<Vector2<double>>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

}  // namespace

TEST_CASE("engine: its tables are those of the cycle that it states") {
  check_same("engine-gas-force.csv", gas_force_table({}));
  check_same("big-end-load.csv", big_end_table({}, {}));
  // The cycle itself: an adiabatic gas without heat comes back to its intake; with it, heat becomes work.
  EngineCycle cold;
  cold.heat = 0;
  const double pi = boost::math::constants::pi<double>();
  CHECK(cold.closed_pressure(3 * pi) == Approx(cold.intake).epsilon(1e-12));
  const EngineCycle engine;
  const auto power = [&](double angle) {  // p dV
    const double h = 1e-5;
    return engine.closed_pressure(angle) * (engine.volume(angle + h) - engine.volume(angle - h)) / (2 * h);
  };
  double work = 0;
  const int pieces = 4000;
  for (int i = 0; i < pieces; ++i) work += power(pi + 2 * pi * (i + 0.5) / pieces) * 2 * pi / pieces;
  const double inner = (engine.closed_pressure(3 * pi) - engine.intake) * engine.volume(pi) / (engine.isentropic - 1);
  const double burnt = engine.heat * (1 - std::exp(-engine.wiebe_end));
  CHECK(work + inner == Approx(burnt).epsilon(1e-5));  // first law; differences and a sum of midpoints
  // Newton and Euler once more: a rod with its mass centre at mid-length and no gas.
  SliderCrank<double> ideal;
  EngineCycle still;
  still.crank = ideal.crank_length;
  still.rod = ideal.rod_length;
  still.intake = still.exhaust = still.ambient;
  const EngineMasses masses{ideal.rod_mass, ideal.rod_inertia, ideal.rod_length / 2, ideal.slider_mass};
  for (const double angle : {0.3, 2.0, 3.1}) {
    const Vector2<double> load = big_end_load(still, masses, 500, angle);
    const Vector2<double> known = ideal_reactions(ideal, Motion<double>{angle, 500.0, 0.0}).crank_pin;
    CHECK((load + known).norm() < 1e-10 * known.norm());  // rounding
  }
}

TEST_CASE("engine: the scenes, what they say of the cycle, and the cycle's own numbers are the same") {
  const EngineCycle engine;
  const EngineMasses masses;
  const Scene scene = load_scene(machines + "engine.toml");
  const auto& crank = scene.bodies[0];
  const auto& rod = scene.bodies[1];
  const auto& piston = scene.bodies[2];
  const SceneJoint& big_end = scene.joints[0];
  const SceneJoint& gudgeon = scene.joints[1];
  REQUIRE((crank.name == "crank" && rod.name == "rod" && piston.name == "piston"));
  CHECK(big_end.journal.point == Vector2<double>(engine.crank, 0));
  CHECK(big_end.bearing.point == Vector2<double>(-masses.rod_centre, 0));
  CHECK(gudgeon.bearing.point.x() == Approx(engine.rod - masses.rod_centre).epsilon(1e-15));  // a difference's rounding
  CHECK(is_zero(gudgeon.journal.point));
  CHECK(rod.mass == masses.rod);
  CHECK(rod.inertia == masses.rod_inertia);
  CHECK(piston.mass == masses.piston);
  CHECK(std::get<Driver<double>>(scene.constraints[2].constraint).speed == engine_speed());
  const Scene alone = load_scene(machines + "big-end.toml");
  CHECK(alone.bodies[0].spin == engine_speed());
  const SceneJoint& bearing = alone.joints[0];
  CHECK(bearing.length == big_end.length);
  CHECK(bearing.journal_radius == big_end.journal_radius);
  CHECK(bearing.clearance == big_end.clearance);
  CHECK(bearing.viscosity == big_end.viscosity);
  // The words at the head of the file.
  std::string words;
  std::istringstream lines(read_text(machines + "engine.toml"));
  for (std::string line; std::getline(lines, line) && !line.empty() && line[0] == '#';)
    words +=
        line.substr(line.find_first_not_of("# ") == std::string::npos ? line.size() : line.find_first_not_of("# ")) +
        " ";
  const auto number = [](double value) {
    std::ostringstream text;
    text << value;
    return text.str();
  };
  CHECK_THAT(words,
             Contains("throw " + number(1e3 * engine.crank) + " mm, rod " + number(1e3 * engine.rod) + " mm, bore " +
                      number(1e3 * engine.bore) + " mm, compression ratio " + number(engine.compression_ratio) +
                      "; intake at " + number(1e-5 * engine.intake) + " bar, exhaust at " +
                      number(1e-5 * engine.exhaust) + " bar, outside " + number(1e-5 * engine.ambient) + " bar"));
  CHECK_THAT(words, Contains("kappa = " + number(engine.isentropic) + ":"));
  CHECK_THAT(words,
             Contains("Q = " + number(engine.heat) + " J put in as x_b = 1 - exp(-" + number(engine.wiebe_end) + " s^" +
                      number(engine.wiebe_shape + 1) + "), s from 0 to 1 over " + number(engine.combustion_degrees) +
                      " degrees from " + number(360 - engine.ignition_degrees) + " before the dead centre"));
  CHECK_THAT(words, Contains("over the " + number(engine.blowdown_degrees) + " degrees after 540") &&
                        Contains("over the " + number(engine.overlap_degrees) + " before 720"));
  CHECK_THAT(words, Contains(number(engine_speed_rpm) + " rpm"));
}

TEST_CASE("engine: the scene starts on its periodic orbit, and its big end carries the load diagram") {
  const Scene scene = load_scene(machines + "engine.toml");
  CHECK(*scene_period(scene) == Approx(0.04).epsilon(1e-12));
  const MultibodyTrajectory run = simulate_multibody(scene);
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  const MultibodySample& first = run.samples.front();
  const MultibodySample& last = run.samples.back();
  for (std::size_t j = 0; j < 2; ++j) {
    const double c = scene.joints[j].clearance;
    CHECK((first.joints[j].eccentricity - last.joints[j].eccentricity).norm() <
          1e-5 * c);  // places in digits of 1e-16 m
  }
  CHECK(*run.energy_residual < 1e-5 * run.energy_scale);  // a thousand times the tolerance, over a thousand steps
  // Largest difference of the big end's force from that of ideal joints.
  const auto off = [&](const MultibodyTrajectory& motion) {
    double largest = 0;
    for (const MultibodySample& sample : motion.samples) {
      const double angle = std::min(engine_speed() * sample.t, 4 * std::numbers::pi);
      const Vector2<double> ideal = big_end_load({}, {}, engine_speed(), angle);
      largest = std::max(largest, (sample.joints[0].force - ideal).norm());
    }
    return largest;
  };
  double peak = 0;
  for (double degrees = 0; degrees < 720; degrees += 0.1)
    peak = std::max(peak, big_end_load({}, {}, engine_speed(), EngineCycle::radians(degrees)).norm());
  const double whole = off(run);
  // Largest sizes differ by no more than the vectors do; a hundredth for what lies between the samples.
  CHECK(std::abs(run.joints[0].force.value - peak) <= 1.01 * whole);
  // Half the clearances with a quarter of the viscosity are films of the same forces at the same eccentricity ratios
  // and rates: all that the clearances do is halved, and the difference tends to 0 with them. It starts half-way from
  // the ideal mechanism's start.
  Scene half = scene;
  for (SceneJoint& joint : half.joints) {
    joint.clearance /= 2;
    joint.viscosity /= 4;
  }
  const EngineCycle engine;
  const EngineMasses masses;
  const double crank_pin_speed = engine.crank * engine_speed();
  SceneBody& rod = half.bodies[1];
  SceneBody& piston = half.bodies[2];
  rod.position = (rod.position + Vector2<double>(engine.crank + masses.rod_centre, 0)) / 2;
  rod.angle /= 2;
  rod.velocity = (rod.velocity + Vector2<double>(0, crank_pin_speed * (1 - masses.rod_centre / engine.rod))) / 2;
  rod.spin = (rod.spin - crank_pin_speed / engine.rod) / 2;
  piston.position = (piston.position + Vector2<double>(engine.crank + engine.rod, 0)) / 2;
  piston.velocity /= 2;
  const MultibodyTrajectory halved = simulate_multibody(half);
  INFO(halved.outcome.message);
  REQUIRE(halved.outcome.status == RunStatus::finished);
  INFO(whole / peak << " of the peak, and " << off(halved) / peak);
  CHECK(whole / off(halved) == Approx(2).epsilon(0.05));  // the next order is as small as the first one is
}

TEST_CASE("engine: shooting finds the periodic orbit from another start, and says when there is none") {
  Scene scene = load_scene(machines + "engine.toml");
  const std::vector<double> shipped_start = [&] {
    std::vector<double> y;
    for (const SceneBody& body : scene.bodies) y.insert(y.end(), {body.position.x(), body.position.y(), body.angle});
    return y;
  }();
  scene.bodies[1].position += Vector2<double>(-4e-6, 3e-6);
  const PeriodicOrbit orbit = periodic_orbit(scene, *scene_period(scene), 1e-5);
  CHECK(orbit.miss <= 1e-5);
  CHECK(orbit.growth() == -1);
  for (std::size_t i = 0; i < shipped_start.size(); ++i) {
    if (i % 3 != 2)
      CHECK(std::abs(orbit.state[i] - shipped_start[i]) < 2e-5 * scene.joints[1].clearance);  // the two misses
  }
  // No motion repeats after a third of a cycle.
  CHECK_THROWS_AS(periodic_orbit(scene, 0.013, 1e-6), SceneError);
  CHECK_THROWS_WITH(periodic_orbit(load_scene(shipped_scenes + "journal.toml"), 0.1, 1e-6), Contains("has no period"));
  CHECK_FALSE(scene_period(load_scene(shipped_scenes + "slider-crank-torque.toml")));
}

TEST_CASE("big end: the orbit of a light journal is the mobility method's, at first order in its mass") {
  const Scene scene = load_scene(machines + "big-end.toml");
  const auto rows = numbers_of(read_text(machines + "tables/big-end-load.csv"));
  std::vector<double> t, fx, fy;
  for (const auto& row : rows) {
    t.push_back(row[0]);
    fx.push_back(row[1]);
    fy.push_back(row[2]);
  }
  const SceneJoint& joint = scene.joints[0];
  const Bearing<double> bearing(joint.length, joint.journal_radius, joint.clearance);
  const auto limit = [&](int steps) {
    return mobility_orbit<ShortDynamic>(bearing, Lubricant<double>(joint.viscosity), scene.bodies[0].spin / 2,
                                        PeriodicLoad(t, fx, fy), steps);
  };
  const std::vector<Vector2<double>> massless = limit(8);
  CHECK(largest_distance(massless, limit(16)) < 1e-9);  // the oracle's own steps
  const auto whole = orbit_of(scene, 0.4, t);
  const auto half = orbit_of(scene, 0.2, t);
  const auto quarter = orbit_of(scene, 0.1, t);
  const double d1 = largest_distance(whole, massless);
  const double d2 = largest_distance(half, massless);
  const double d3 = largest_distance(quarter, massless);
  INFO(d1 << ", " << d2 << ", " << d3);
  CHECK(d2 / d3 == Approx(2).epsilon(0.05));  // first order; the next term halves as well
  CHECK(std::abs(d2 / d3 - 2) < std::abs(d1 / d2 - 2) + 1e-3);
  CHECK(d3 > 1e-7);  // far above what the runs are good to
  // As it ships the journal is light enough.
  CHECK(largest_distance(orbit_of(scene, scene.bodies[0].mass, t), massless) < 1e-6);
  // A bearing one part in a thousand wider is another orbit.
  const auto other = mobility_orbit<ShortDynamic>(
      Bearing<double>(joint.length, joint.journal_radius, 1.001 * joint.clearance), Lubricant<double>(joint.viscosity),
      scene.bodies[0].spin / 2, PeriodicLoad(t, fx, fy), 8);
  CHECK(largest_distance(other, massless) > 1e-4);
}

}  // namespace engine_test

// Periods of scenes, and periodic orbits by shooting: against linear oscillators in closed form, and as a user asks for
// them.
#include "lubjoint/scene/periodic_orbit.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/scene_period.hpp"
#include "support/run_program.hpp"
#include "support/scenes.hpp"
#include "support/temporary_folder.hpp"

namespace periodic_orbit_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

const std::string data = std::string(LUBJOINT_SOURCE_DIR) + "/data/";

constexpr double rate = 7;  // of the shaking [rad/s]
constexpr double mass = 1.5;
constexpr double stiffness = 100;
constexpr double amplitude = 0.02;
constexpr double phase = 0.6;

/// A carriage that is moved to and fro along x, and a mass on a spring with a damper before it, on the same guide.
Scene shaken(double damping) {
  Scene scene;
  scene.file = scene.name = "shaken";
  scene.bodies = {body("carriage", 2, 1, {amplitude * std::cos(phase), 0}), body("mass", mass, 1, {1, 0})};
  const Vector2<double> along(1, 0);
  SlideDriver<double> driver{{}, along, {0, {0, 0}}, 0, 0, 0};
  driver.shape = std::make_shared<const MotionShape<double>>(MotionShape<double>{amplitude, rate, phase});
  scene.constraints = {{"guide", Translational<double>{{}, along, {0, {0, 0}}, 0}},
                       {"other-guide", Translational<double>{{}, along, {1, {0, 0}}, 0}},
                       {"drive", driver}};
  TranslationalSpring<double> spring{{0, {0, 0}}, {1, {0, 0}}, 0, 0, 0, 0};
  spring.stiffness = stiffness;
  spring.damping = damping;
  spring.free_length = 1;
  scene.springs = {{"spring", spring}};
  set_tolerance(scene, 1e-9);
  return scene;
}

Scene driven(double speed, double acceleration, std::shared_ptr<const MotionShape<double>> shape) {
  Scene scene;
  scene.file = scene.name = "driven";
  scene.bodies = {body("crank", 1, 1, {0, 0})};
  scene.constraints = {{"pin", Revolute<double>{{}, {0, {0, 0}}}},
                       {"motor", Driver<double>{ground_body, 0, 0, speed, acceleration, std::move(shape)}}};
  return scene;
}

}  // namespace

TEST_CASE("period: a motor repeats with its revolution, a swing with its own, a motion that goes on or a table never") {
  const double pi = std::numbers::pi;
  const auto swing = std::make_shared<const MotionShape<double>>(MotionShape<double>{0.1, 4, 0});
  const auto table = std::make_shared<const MotionShape<double>>(
      MotionShape<double>{0, 0, 0,
                          std::make_shared<const TableCurves<1>>(
                              std::vector<double>{0, 1}, std::vector<std::array<TableCurves<1>::Cubic, 1>>(1), false)});
  CHECK(*scene_period(driven(-2, 0, nullptr)) == Approx(pi).epsilon(1e-14));
  CHECK(*scene_period(driven(0, 0, swing)) == Approx(pi / 2).epsilon(1e-14));
  CHECK(*scene_period(driven(2, 0, swing)) == Approx(pi).epsilon(1e-14));
  CHECK(*scene_period(driven(6, 0, swing)) == Approx(pi).epsilon(1e-14));  // three revolutions, two swings
  CHECK_FALSE(scene_period(driven(0, 0, nullptr)));
  CHECK_FALSE(scene_period(driven(2, 0.1, nullptr)));
  CHECK_FALSE(scene_period(driven(2, 0, table)));
  CHECK_FALSE(scene_period(driven(std::sqrt(2.0), 0, swing)));
  Scene scene = shaken(1);
  CHECK(*scene_period(scene) == Approx(2 * pi / rate).epsilon(1e-14));
  std::get<SlideDriver<double>>(scene.constraints[2].constraint).speed = 1e-3;
  CHECK_FALSE(scene_period(scene));
}

TEST_CASE("periodic orbit: a shaken mass is where its linear equation says, and its multiplier is known to its doubt") {
  const std::complex<double> i(0, 1);
  const double pi = std::numbers::pi;
  const double period = 2 * pi / rate;
  for (const double damping : {0.8, 0.0, -0.8}) {
    INFO("damping " << damping);
    const Scene scene = shaken(damping);
    const PeriodicOrbit orbit = periodic_orbit(scene, *scene_period(scene), 1e-7);
    const std::complex<double> spring = stiffness + i * rate * damping;
    const std::complex<double> place = amplitude * std::polar(1.0, phase) * spring / (spring - mass * rate * rate);
    // The miss over what a period leaves of a deviation (its multipliers are e^{±9i} or so), and the run's own error.
    CHECK(std::abs(orbit.state[3] - (1 + place.real())) < 1e-6);
    CHECK(std::abs(orbit.state[6 + 3] - (i * rate * place).real()) < 1e-5);
    const double multiplier = std::exp(-damping / (2 * mass) * period);
    INFO(orbit.largest_multiplier << " +- " << orbit.multiplier_doubt << ", exactly " << multiplier);
    CHECK(std::abs(orbit.largest_multiplier - multiplier) <= orbit.multiplier_doubt);
    CHECK(orbit.multiplier_doubt < 1e-2);
    // What no damper holds can't be told from what one holds hardly.
    CHECK(orbit.growth() == (damping > 0 ? -1 : damping < 0 ? 1 : 0));
  }
  // What rests free drifts from where it is as time goes by: both multipliers are 1, with one eigenvector.
  Scene free = shaken(0);
  free.springs.clear();
  CHECK(periodic_orbit(free, *scene_period(free), 1e-7).growth() == 0);
  PeriodicOrbit unknown;
  unknown.largest_multiplier = std::numeric_limits<double>::quiet_NaN();
  CHECK(unknown.growth() == 0);
}

TEST_CASE("periodic: the command prints a scene that reads back and repeats, or JSON, and refuses mistakes in words") {
  const std::string file = data + "scenes/machines/rotor.toml";
  const ProgramResult written = lubjoint_program({"periodic", file});
  INFO(written.err);
  CHECK(written.status == 0);
  CHECK_THAT(written.err, Contains("period       0.01047197551 s") && Contains("small deviations die out"));
  const Scene scene = parse_scene(written.out, file);
  const ProgramResult json = lubjoint_program({"periodic", file, "--json"});
  CHECK(json.status == 0);
  const auto orbit = nlohmann::json::parse(json.out);
  CHECK(orbit["period"].get<double>() == Approx(2 * std::numbers::pi / 600).epsilon(1e-14));
  CHECK(orbit["miss"].get<double>() <= 1e-7);  // 100 times the scene's tolerance
  CHECK(orbit["largest_multiplier"].get<double>() + orbit["multiplier_doubt"].get<double>() < 1);
  CHECK(orbit["state"].get<std::vector<double>>() == scene_start<double>(scene));
  // A mass on a spring without a damper, pushed to and fro.
  const TemporaryFolder folder;
  const std::string undamped = folder.write("undamped.toml", R"(name = "undamped"
duration = 1.0
[[bodies]]
name = "mass"
mass = 1.5
inertia = 1.0
position = [1.0, 0.0]
[[constraints]]
name = "guide"
type = "translational"
first = {body = "ground", point = [0.0, 0.0]}
axis = [1.0, 0.0]
second = {body = "mass"}
[[springs]]
name = "spring"
first = {body = "ground", point = [0.0, 0.0]}
second = {body = "mass"}
stiffness = 100.0
free_length = 1.0
[[loads]]
body = "mass"
force = [1.0, 0.0]
harmonic = {speed = 7.0}
[integrator]
relative_tolerance = 1e-9
)");
  const ProgramResult open = lubjoint_program({"periodic", undamped});
  INFO(open.err);
  CHECK(open.status == 0);
  CHECK_THAT(open.err, Contains("period       0.897597901 s") && Contains("it can't be told from 1"));
  const auto refused = [](const std::vector<std::string>& words) {
    const ProgramResult result = lubjoint_program(words);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    return result.err;
  };
  CHECK_THAT(refused({"periodic", data + "scenes/slider-crank-torque.toml"}),
             Contains("--period is missing, and nothing in the scene says how long one is"));
  CHECK_THAT(refused({"periodic", file, "--period", "0"}), Contains("--period is 0; allowed is a time above 0 [s]"));
  CHECK_THAT(refused({"periodic", file, "--tolerance", "0"}),
             Contains("--tolerance is 0; allowed is a number above 0"));
  CHECK_THAT(refused({"periodic", data + "scenes/journal.toml", "--period", "1"}), Contains("has no period"));
}

}  // namespace periodic_orbit_test

// Springs, dampers and moving loads, against motions in closed form and in one coordinate.
#include <array>
#include <boost/numeric/odeint.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "lubjoint/scene/trajectory_table.hpp"
#include "support/scenes.hpp"

namespace spring_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

Scene empty_scene(double duration) {
  Scene scene;
  scene.file = scene.name = "springs";
  scene.run.duration = duration;
  scene.run.output_interval = duration / 50;
  scene.energy_ledger = true;
  set_tolerance(scene, 1e-10);
  return scene;
}

/// Largest difference of a coordinate of body 0 from a function of time.
template <class Exact>
double difference(const MultibodyTrajectory& run, std::size_t coordinate, const Exact& exact) {
  double largest = 0;
  for (const MultibodySample& sample : run.samples) {
    largest = std::max(largest, std::abs(sample.state[coordinate] - exact(sample.t)));
  }
  return largest;
}

void check_ledger(const Scene& scene, const MultibodyTrajectory& run) {
  REQUIRE(run.energy_residual);
  // Some hundred steps of 1e-10 of the energies that there are, or of the unit in which the ledger's tolerance is
  // given.
  CHECK(*run.energy_residual < 1000 * 1e-10 * std::max(run.energy_scale, scene_units(scene).energy));
}

/// x of m ẍ = −k(x − x₀) − c ẋ, x(0) = x₀ + a, ẋ(0) = v.
double damped(double t, double m, double k, double c, double a, double v) {
  const double delta = c / (2 * m);
  const double omega = std::sqrt(k / m - delta * delta);
  return std::exp(-delta * t) * (a * std::cos(omega * t) + (v + delta * a) / omega * std::sin(omega * t));
}

}  // namespace

TEST_CASE("spring: a mass on a preloaded spring with damper moves as the damped oscillator, by every integrator") {
  const double m = 0.7;
  const double k = 40;
  const double c = 1.1;
  const double preload = 3;
  Scene scene = empty_scene(2);
  scene.bodies = {body("mass", m, 1e-3, {1.0, 0})};
  scene.bodies[0].velocity = {0.4, 0};
  scene.springs = {{"spring", TranslationalSpring<double>{{}, {0, {0, 0}}, k, c, 0.8, preload}}};
  const double rest = 0.8 - preload / k;
  const auto exact = [&](double damping) {
    return [=](double t) { return rest + damped(t, m, k, damping, 1.0 - rest, 0.4); };
  };
  for (const std::string integrator : {"radau_iia5", "rosenbrock4", "dopri5", "fehlberg78", "bulirsch_stoer"}) {
    INFO(integrator);
    scene.integrator = integrator;
    const MultibodyTrajectory run = simulate_multibody(scene);
    REQUIRE(run.outcome.status == RunStatus::finished);
    CHECK(difference(run, 0, exact(c)) < 1e-8);            // a hundred steps of 1e-10
    CHECK(difference(run, 0, exact(c * 1.00001)) > 1e-7);  // the check sees a damper that is wrong in its fifth digit
    check_ledger(scene, run);
    const std::vector<double>& last = run.samples.back().ledger;
    REQUIRE(last.size() == 2 + ledger_names.size());
    CHECK(last.back() < -1);  // what the damper took [J]
  }
}

TEST_CASE("spring: elastic energy is potential energy, and a spring without damper has no work of its own") {
  Scene scene = empty_scene(1);
  scene.bodies = {body("mass", 2, 1e-3, {0.3, 0.4})};
  scene.bodies[0].velocity = {0.8, -0.6};  // round the spring's end, not through it
  scene.springs = {{"spring", TranslationalSpring<double>{{}, {0, {0, 0}}, 100, 0, 0.2, 5}}};
  const MultibodyTrajectory run = simulate_multibody(scene);
  const std::vector<double>& first = run.samples.front().ledger;
  REQUIRE(first.size() == 2 + ledger_terms);
  CHECK(first[1] == Approx(100 * 0.3 * 0.3 / 2 + 5 * 0.3));
  check_ledger(scene, run);
  const TrajectoryTable table = trajectory_table(scene, run);
  CHECK(table.columns.back() == "work.constraints");
}

TEST_CASE("spring: a rod on a pin with a spring and damper at its tip moves as its angle's own equation says") {
  // Pin at the origin, rod along the angle, spring from a point of the ground to a point beside the rod's axis.
  const double m = 0.4;
  const double inertia = 3e-3;
  const double a = 0.15;
  const double k = 250;
  const double c = 0.9;
  const double free_length = 0.2;
  const std::array<double, 2> anchor{0.25, 0.31};
  const std::array<double, 2> tip{0.29, 0.02};  // from the pin, in the rod's axes
  Scene scene = empty_scene(1);
  scene.gravity = {0, -9.81};
  const double start = 0.3;
  scene.bodies = {body("rod", m, inertia, {a * std::cos(start), a * std::sin(start)}, start)};
  scene.constraints = {{"pin", Revolute<double>{{}, {0, {-a, 0}}}}};
  scene.springs = {
      {"spring", TranslationalSpring<double>{
                     {ground_body, {anchor[0], anchor[1]}}, {0, {tip[0] - a, tip[1]}}, k, c, free_length, 0}}};
  scene.sensors = {{"tension", SpringSensor{0}},
                   {"way", DistanceSensor{{ground_body, {anchor[0], anchor[1]}}, {0, {tip[0] - a, tip[1]}}}}};
  using Angle = std::array<double, 2>;
  const auto pull = [&](const Angle& y, double stiffness) {  // along the length, and its derivative by the angle
    const double x = std::cos(y[0]) * tip[0] - std::sin(y[0]) * tip[1];
    const double h = std::sin(y[0]) * tip[0] + std::cos(y[0]) * tip[1];
    const double length = std::hypot(x - anchor[0], h - anchor[1]);
    const double slope = (-(x - anchor[0]) * h + (h - anchor[1]) * x) / length;  // dL/dθ
    return std::array<double, 3>{stiffness * (length - free_length) + c * slope * y[1], slope, length};
  };
  const auto own = [&](double stiffness) {
    Angle y{start, 0};
    std::vector<std::array<double, 3>> states;
    const auto rate = [&](const Angle& at, Angle& out, double) {
      const auto [tension, slope, length] = pull(at, stiffness);
      out = {at[1], (-tension * slope - m * 9.81 * a * std::cos(at[0])) / (inertia + m * a * a)};
    };
    std::vector<double> times;
    for (int i = 0; i <= 50; ++i) times.push_back(i * scene.run.output_interval);
    boost::numeric::odeint::integrate_times(
        boost::numeric::odeint::make_controlled(1e-13, 1e-13, boost::numeric::odeint::runge_kutta_fehlberg78<Angle>()),
        rate, y, times.begin(), times.end(), 1e-4, [&](const Angle& at, double) {
          const auto [tension, slope, length] = pull(at, stiffness);
          states.push_back({at[0], tension, length});
        });
    return states;
  };
  const auto expected = own(k);
  const auto wrong = own(k * 1.0001);
  for (const std::string integrator : {"radau_iia5", "dopri5"}) {
    scene.integrator = integrator;
    const MultibodyTrajectory run = simulate_multibody(scene);
    REQUIRE(run.outcome.status == RunStatus::finished);
    REQUIRE(run.samples.size() == expected.size());
    double off = 0;
    double off_wrong = 0;
    double tension_off = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      off = std::max(off, std::abs(run.samples[i].state[2] - expected[i][0]));
      off_wrong = std::max(off_wrong, std::abs(run.samples[i].state[2] - wrong[i][0]));
      tension_off = std::max(tension_off, std::abs(run.samples[i].sensors[0] - expected[i][1]));
      CHECK(std::abs(run.samples[i].sensors[1] - expected[i][2]) < 1e-8);  // a length off by as little as the angle
    }
    CHECK(off < 1e-8);        // some hundred steps of 1e-10
    CHECK(off_wrong > 1e-6);  // the check sees a stiffness that is wrong in its fourth digit
    CHECK(tension_off < 250 * 1e-8);
    check_ledger(scene, run);
  }
}

TEST_CASE("spring: two discs on one pin twist against each other with their reduced inertia") {
  const double first = 2e-3;
  const double second = 5e-3;
  const double k = 0.8;
  const double c = 2e-3;
  Scene scene = empty_scene(1);
  scene.bodies = {body("first", 1, first, {0, 0}, 0.2), body("second", 2, second, {0, 0}, 1.0)};
  scene.constraints = {{"pin", Revolute<double>{{0, {0, 0}}, {1, {0, 0}}}}};
  scene.springs = {{"twist", RotationalSpring<double>{0, 1, k, c, 0.5}}};
  scene.sensors = {{"between", AngleSensor{0, 1}}};
  const MultibodyTrajectory run = simulate_multibody(scene);
  const double reduced = first * second / (first + second);
  double largest = 0;
  for (const MultibodySample& sample : run.samples) {
    largest = std::max(largest, std::abs(sample.sensors[0] - (0.5 + damped(sample.t, reduced, k, c, 0.3, 0))));
    // Their angular momentum stays what it was.
    CHECK(std::abs(first * sample.state[8] + second * sample.state[11]) < 1e-9);
  }
  CHECK(largest < 1e-8);  // some hundred steps of 1e-10
  check_ledger(scene, run);
}

TEST_CASE("spring: the exact Jacobian is that of central differences") {
  Scene scene = empty_scene(1);
  scene.bodies = {body("first", 1, 0.1, {0.1, 0.2}, 0.3), body("second", 2, 0.2, {1.1, 0.5}, -0.4)};
  scene.constraints = {{"pin", Revolute<double>{{}, {0, {-0.2, 0.1}}}},
                       {"joint", Revolute<double>{{0, {0.4, 0}}, {1, {-0.5, 0}}}}};
  scene.springs = {{"spring", TranslationalSpring<double>{{0, {0.1, 0.3}}, {1, {0.2, -0.1}}, 30, 2, 0.4, 1}},
                   {"twist", RotationalSpring<double>{0, 1, 3, 0.2, 0.1}}};
  SceneLoad load{1, {3, -2}, 0.7};
  load.point = {0.1, 0.2};
  load.turns_with_body = true;
  load.harmonic = SceneHarmonic{5, 0.4};
  scene.loads = {load};
  const auto system = planar_system<double>(scene);
  MultibodyOde<double> ode(system, true);
  std::vector<double> y = scene_start<double>(scene);
  for (std::size_t i = 6; i < y.size(); ++i) y[i] = 0.3 * std::sin(1.0 + 2.0 * static_cast<double>(i));
  y.resize(ode.dimension(), 0.0);
  Eigen::MatrixXd jacobian;
  ode.jacobian(y, jacobian, 0.2);
  std::vector<double> low(y.size());
  std::vector<double> high(y.size());
  std::vector<double> slope(y.size());
  const double h = 1e-5;
  const auto differences_agree = [&](const auto& exact) {
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double size = 1 + std::abs(exact(i));
      CHECK(std::abs((high[i] - low[i]) / (2 * h) - exact(i)) < 1e-7 * size);  // h² and rounding/h, times 100
    }
  };
  for (std::size_t k = 0; k < ode.mechanical_states(); ++k) {
    std::vector<double> at = y;
    at[k] = y[k] - h;
    ode.rate(at, low, 0.2);
    at[k] = y[k] + h;
    ode.rate(at, high, 0.2);
    differences_agree(
        [&](std::size_t i) { return jacobian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)); });
  }
  ode.time_slope(y, slope, 0.2);
  ode.rate(y, low, 0.2 - h);
  ode.rate(y, high, 0.2 + h);
  differences_agree([&](std::size_t i) { return slope[i]; });
}

TEST_CASE("spring: one that comes to length 0 stops the run by its name, one that passes beside it does not") {
  Scene scene = empty_scene(1);
  scene.bodies = {body("mass", 1, 1e-3, {0.1, 0})};
  scene.bodies[0].velocity = {-3, 0};
  scene.springs = {{"coil", TranslationalSpring<double>{{}, {0, {0, 0}}, 50, 0, 0.1, 0}}};
  for (const std::string integrator : {"radau_iia5", "dopri5", "fehlberg78"}) {
    INFO(integrator);
    scene.integrator = integrator;
    scene.bodies[0].position = {0.1, 0};
    const MultibodyTrajectory stopped = simulate_multibody(scene);
    CHECK(stopped.outcome.status == RunStatus::stopped);
    CHECK_THAT(stopped.outcome.message, Contains("spring \"coil\" has length 0 at 0.03"));
    scene.bodies[0].position = {0.1, 0.002};
    CHECK(simulate_multibody(scene).outcome.status == RunStatus::finished);
  }
  scene.bodies[0].position = {0, 0};
  CHECK_THROWS_WITH(simulate_multibody(scene), Contains("springs[0] \"coil\" has length 0 at the start"));
}

TEST_CASE("loads: a harmonic one, one that turns with its body, and one at a point move bodies as in closed form") {
  Scene scene = empty_scene(2);
  scene.bodies = {body("mass", 2, 0.1, {0, 0})};
  SceneLoad load{0, {3, 0}, 0.5};
  load.harmonic = SceneHarmonic{7, 0.6};
  scene.loads = {load};
  const auto swing = [](double t, double amplitude) {  // twice the integral of A cos(7t + 0.6), from rest
    return amplitude / 49 * (std::cos(0.6) - std::cos(7 * t + 0.6) - 7 * t * std::sin(0.6));
  };
  MultibodyTrajectory run = simulate_multibody(scene);
  CHECK(difference(run, 0, [&](double t) { return swing(t, 1.5); }) < 1e-8);
  CHECK(difference(run, 2, [&](double t) { return swing(t, 5); }) < 1e-8);
  check_ledger(scene, run);

  load = {0, {3, 0}, 0};
  load.turns_with_body = true;
  scene.loads = {load};
  scene.bodies[0].spin = 2;
  run = simulate_multibody(scene);
  CHECK(difference(run, 0, [](double t) { return 1.5 / 4 * (1 - std::cos(2 * t)); }) < 1e-8);
  CHECK(difference(run, 1, [](double t) { return 1.5 / 4 * (2 * t - std::sin(2 * t)); }) < 1e-8);
  check_ledger(scene, run);

  load = {0, {0, -2}, 0};
  load.point = {0.3, 0};  // a pendulum's moment about a mass centre that falls
  scene.loads = {load};
  scene.bodies[0].spin = 0;
  run = simulate_multibody(scene);
  CHECK(difference(run, 1, [](double t) { return -t * t / 2; }) < 1e-8);
  for (const MultibodySample& s : run.samples) {  // ½Iφ̇² = F·(drop of the point) = 0.6 sin(−φ)
    CHECK(std::abs(0.05 * s.state[5] * s.state[5] + 0.6 * std::sin(s.state[2])) < 1e-8);
  }
  check_ledger(scene, run);
}

TEST_CASE("loads: an unbalance moves a journal as an offset of its mass centre does") {
  Scene scene = load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/journal.toml");
  set_tolerance(scene, 1e-10);
  scene.run.duration = 0.1;
  scene.run.output_interval = 1e-3;
  scene.bodies[0].spin_is_held = true;
  const double offset = 2e-5;
  const double phase = 0.7;
  Scene turned = scene;
  SceneLoad unbalance;
  unbalance.unbalance = SceneUnbalance{scene.bodies[0].mass * offset, phase};
  turned.loads.push_back(unbalance);
  const Vector2<double> along(std::cos(phase), std::sin(phase));
  Scene off = scene;
  off.joints[0].journal.point = -offset * along;
  off.bodies[0].position += offset * along;
  off.bodies[0].velocity += offset * off.bodies[0].spin * Vector2<double>(-along.y(), along.x());
  const MultibodyTrajectory first = simulate_multibody(turned);
  const MultibodyTrajectory second = simulate_multibody(off);
  const MultibodyTrajectory without = simulate_multibody(scene);
  double largest = 0;
  double effect = 0;
  for (std::size_t i = 0; i < first.samples.size(); ++i) {
    const Vector2<double>& e = first.samples[i].joints[0].eccentricity;
    largest = std::max(largest, (e - second.samples[i].joints[0].eccentricity).norm());
    effect = std::max(effect, (e - without.samples[i].joints[0].eccentricity).norm());
  }
  CHECK(largest < 1e-8 * scene.joints[0].clearance);  // some hundred steps of 1e-10
  CHECK(effect > 1000 * 1e-8 * scene.joints[0].clearance);
}

}  // namespace spring_test

#include <algorithm>
#include <catch2/catch.hpp>

#include "lubjoint/multibody/assembly.hpp"
#include "lubjoint/ode/radau_iia.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/scenes.hpp"

namespace multibody_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

const std::string scenes = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/";

std::string assembly_error(const Scene& scene) {
  const auto system = planar_system<double>(scene);
  auto y = scene_start<double>(scene);
  try {
    assemble_start(system, 0.0, 0.1, y);
  } catch (const ConstraintError& error) {
    return error.what();
  }
  return {};
}

/// Van der Pol's oscillator, for steppers of both kinds.
const auto rate = [](const auto& x, auto& dxdt, double) {
  dxdt[0] = x[1];
  dxdt[1] = 5 * (1 - x[0] * x[0]) * x[1] - x[0];
};
const auto slope = [](const auto& x, auto& j, double) {
  j(0, 0) = 0;
  j(0, 1) = 1;
  j(1, 0) = -10 * x[0] * x[1] - 1;
  j(1, 1) = 5 * (1 - x[0] * x[0]);
};

template <std::size_t N, class State>
double van_der_pol(State x, double tolerance) {
  State tolerances = x;
  for (auto& each : tolerances) each = tolerance;
  RadauIIA5<double, N> stepper(tolerance, tolerances);
  double t = 0;
  double dt = 1e-3;
  while (t < 4) {
    dt = std::min(dt, 4 - t);
    stepper.try_step(std::make_pair(rate, slope), x, t, dt);
  }
  return x[0];
}

}  // namespace

TEST_CASE("radau_iia5: a run-time number of states takes the fixed one's steps") {
  for (const double tolerance : {1e-4, 1e-8}) {
    const double fixed = van_der_pol<2>(std::array<double, 2>{2.0, 0.5}, tolerance);
    const double run_time = van_der_pol<run_time_size>(std::vector<double>{2.0, 0.5}, tolerance);
    CHECK(std::abs(fixed - run_time) < 1e-12);  // rounding of some hundred steps, amplified by the oscillator
  }
}

TEST_CASE("constrained equations: the exact Jacobian equals differences in 64-bit significands") {
  for (const std::string name : {"slider-crank.toml", "slider-crank-ideal.toml"}) {
    Scene scene = load_scene(scenes + name);
    scene.stabilisation = {false, 300, 500};
    const auto system = planar_system<double>(scene);
    const auto wide = planar_system<long double>(scene);
    auto w = wide.workspace<long double>();
    MultibodyOde<double> ode(system, false);
    std::vector<double> y = scene_start<double>(scene);
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[i] += (2 * i < y.size() ? 1e-5 : 1e-2) * std::sin(3.0 * static_cast<double>(i + 1));
    }
    Eigen::MatrixXd jacobian;
    ode.jacobian(y, jacobian, 1e-4);
    const std::size_t n = system.coordinates();
    const auto acceleration = [&](std::size_t column, long double step) {
      std::vector<long double> x(y.begin(), y.end());
      x[column] += step;
      wide.evaluate(1e-4L, x.data(), {}, w);
      return w.accelerations;
    };
    double largest = 0;
    double scale = 0;
    for (std::size_t column = 0; column < 2 * n; ++column) {
      const long double h = column < n ? 1e-11L : 1e-7L;
      const auto above = acceleration(column, h);
      const auto below = acceleration(column, -h);
      for (std::size_t i = 0; i < n; ++i) {
        const auto slope_i = static_cast<double>((above[i] - below[i]) / (2 * h));
        const double exact = jacobian(static_cast<int>(n + i), static_cast<int>(column));
        const double unit = column < n ? 1 : 1e3;  // columns of velocities are a rate smaller
        largest = std::max(largest, unit * std::abs(exact - slope_i));
        scale = std::max(scale, unit * std::abs(exact));
      }
    }
    INFO(name);
    CHECK(largest < 1e-8 * scale);  // truncation (h/e)² = 1e-12 and (h/v)² = 1e-10, rounding 1e-19 × 1e8 m/s² over h
  }
}

TEST_CASE("a constraint that repeats others is named, with the others and the rank") {
  Scene scene = load_scene(scenes + "slider-crank-ideal.toml");
  const SceneConstraint guide = scene.constraints[2];
  scene.constraints.push_back({"second-guide", guide.constraint});
  const std::string message = assembly_error(scene);
  CHECK_THAT(message, Contains("\"second-guide\" repeats") && Contains("\"guide\"") && Contains("11 rows of rank 9"));
}

TEST_CASE("two drivers of one body are conflicting if their speeds or accelerations differ, and repeat if not") {
  Scene scene = load_scene(scenes + "slider-crank-ideal.toml");
  const auto motor = std::find_if(scene.constraints.begin(), scene.constraints.end(), [](const auto& each) {
    return std::holds_alternative<Driver<double>>(each.constraint);
  });
  REQUIRE(motor != scene.constraints.end());
  Driver<double> second = std::get<Driver<double>>(motor->constraint);
  const std::string first_name = motor->name;
  const auto with_second = [&](const Driver<double>& driver) {
    Scene both = scene;
    both.constraints.push_back({"second-motor", driver});
    return assembly_error(both);
  };
  CHECK_THAT(with_second(second), Contains("\"second-motor\" repeats"));
  Driver<double> other = second;
  other.speed *= 1.01;
  CHECK_THAT(with_second(other), Contains("\"second-motor\" is conflicting: it demands another velocity") &&
                                     Contains("\"" + first_name + "\""));
  other = second;
  other.acceleration += 1;
  CHECK_THAT(with_second(other), Contains("\"second-motor\" is conflicting: it demands another acceleration"));
  other = second;
  other.angle += 0.1;
  CHECK_THAT(with_second(other), Contains("the constraints are conflicting: no position"));
}

TEST_CASE("constraints that contradict each other: the open one is named, with its gap") {
  Scene scene = load_scene(scenes + "slider-crank-ideal.toml");
  scene.constraints.push_back({"wall", GroundConstraint<double>{2, {0.2, 0.0}, 0.0}});  // beyond crank and rod together
  const std::string message = assembly_error(scene);
  CHECK_THAT(message, Contains("the constraints are conflicting: no position near the start fulfils them all") &&
                          Contains("rank"));
  CHECK_THROWS_WITH(simulate_multibody(scene), Contains("constraints: the constraints are conflicting"));
}

TEST_CASE("a start that misses its constraints is brought onto them, and the correction is reported") {
  Scene scene = load_scene(scenes + "slider-crank-ideal.toml");
  scene.bodies[1].position.y() += 1e-4;
  scene.bodies[1].velocity.setZero();
  const auto system = planar_system<double>(scene);
  auto y = scene_start<double>(scene);
  const StartCorrection<double> correction = assemble_start(system, 0.0, 0.06, y);
  CHECK(correction.position > 1e-5);
  CHECK(correction.position < 2e-4);
  CHECK(correction.velocity > 1);
  auto w = system.workspace<double>();
  system.evaluate_kinematics(0.0, y.data(), w);
  for (std::size_t row = 0; row < system.constraint_rows(); ++row) {
    CHECK(std::abs(w.rows[row].value) < 1e-15);               // 4 roundings of 0.1 m
    CHECK(std::abs(system.constraint_rate(row, w)) < 1e-11);  // roundings of 500 rad/s × condition
  }
}

TEST_CASE("projection keeps constraints at rounding, Baumgarte within the tolerance") {
  Scene scene = load_scene(scenes + "slider-crank.toml");
  scene.coordinates = SceneCoordinates::absolute;
  scene.stabilisation = {true, 0, 0};
  const ConstraintDrift projected = simulate_multibody(scene).drift;
  CHECK(projected.position < 1e-14);  // roundings of 0.17 m and of the driver's 12 rad
  scene.stabilisation = {false, 5, 5};
  const ConstraintDrift kept = simulate_multibody(scene).drift;
  CHECK(kept.position < 1e-8);  // 500 steps of 1e-8 clearances, and a driver's angle in units of 1/60 m
  CHECK(kept.position > projected.position);
}

TEST_CASE("pendulum chain: energy is kept to the tolerance, for every integrator") {
  Scene scene = pendulum_chain(3, 1.0);
  scene.run.duration = 2;
  set_tolerance(scene, 1e-10);
  for (const std::string integrator : {"radau_iia5", "dopri5", "fehlberg78"}) {
    scene.integrator = integrator;
    const MultibodyTrajectory run = simulate_multibody(scene);
    INFO(integrator << ' ' << run.outcome.message);
    REQUIRE(run.outcome.status == RunStatus::finished);
    CHECK(*run.energy_residual < 100 * 1e-10 * run.energy_scale);
    const auto& ledger = run.samples.back().ledger;
    const auto& start = run.samples.front().ledger;
    // No load, driver, film or contact: the sum itself is kept, but for what drift does.
    CHECK(std::abs(ledger[0] + ledger[1] - start[0] - start[1]) < 1e-7 * run.energy_scale);
  }
}

TEST_CASE("the cost of a chain's equations grows with its length, not with a power of it") {
  // Counted, not timed: the envelope of a chain's Schur complement has a constant width.
  for (const std::size_t n : {10u, 100u}) {
    const auto system = planar_system<double>(pendulum_chain(n, 0.3));
    auto w = system.workspace<double>();
    const auto y = scene_start<double>(pendulum_chain(n, 0.3));
    system.evaluate(0.0, y.data(), {}, w);
    CHECK(w.schur.stored() <= 4 * system.constraint_rows());
  }
}

TEST_CASE("a double pendulum keeps its energy to 1e-9 over a thousand periods with the tight setting") {
  Scene scene = pendulum_chain(2, 0.5);
  scene.run.duration = 600;  // periods of 0.6 s
  scene.run.output_interval = 6;
  scene.integrator = "fehlberg78";
  set_tolerance(scene, 1e-13);
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  const auto energy = [](const MultibodySample& sample) { return sample.ledger[0] + sample.ledger[1]; };
  for (const MultibodySample& sample : run.samples) {
    CHECK(std::abs(energy(sample) / energy(run.samples.front()) - 1) < 1e-9);
  }
}

}  // namespace multibody_test

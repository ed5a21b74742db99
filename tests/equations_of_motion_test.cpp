#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>

#include "lib/src/choose_integrator.hpp"
#include "lubjoint/film/short_full.hpp"
#include "lubjoint/motion/stop_words.hpp"
#include "lubjoint/multibody/assembly.hpp"
#include "lubjoint/multibody/free_journal.hpp"
#include "lubjoint/ode/complex_shift_solver.hpp"
#include "lubjoint/ode/radau_iia5_dense.hpp"
#include "lubjoint/ode/second_order_solver.hpp"
#include "lubjoint/ode/step_interpolant.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/scenes.hpp"

namespace equations_of_motion_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

const std::string scenes = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/";

/// Largest |Φ̇| of any row.
double worst_rate(const PlanarSystem<double>& system, const std::vector<double>& y) {
  auto w = system.workspace<double>();
  system.evaluate_kinematics(0.0, y.data(), w);
  double worst = 0;
  for (std::size_t row = 0; row < system.constraint_rows(); ++row) {
    worst = std::max(worst, std::abs(system.constraint_rate(row, w)));
  }
  return worst;
}

/// A rod on a pin at the origin, its other end in an oil film; at an angle at which it accelerates in x and y.
Scene rod_in_a_film() {
  Scene scene = load_scene(scenes + "impact.toml");
  const double angle = 0.7;
  const Vector2<double> along(std::cos(angle), std::sin(angle));
  SceneJoint joint = scene.joints[0];
  joint.contact.reset();
  joint.transition.reset();
  joint.bearing = {ground_body, {0.2 * along.x() + 1e-5, 0.2 * along.y() - 8e-5}};
  joint.journal = {0, {0.1, 0}};
  scene.bodies = {body("rod", 0.3, 2e-3, {0.1 * along.x(), 0.1 * along.y()}, angle)};
  scene.constraints = {{"pin", Revolute<double>{{ground_body, {0, 0}}, {0, {-0.1, 0}}}}};
  scene.joints = {joint};
  return scene;
}

}  // namespace

TEST_CASE("free journal: a load in any direction accelerates with its sign") {
  const FreeJournal<ShortFull> journal(
      LubricatedJoint<ShortFull, double>(Bearing<double>(0.04, 0.01, 2e-4), Lubricant<double>(0.4)),
      {0.5, {3, -5}, 0, 0});
  JournalState<double> rate{};
  journal.rate({0, 0, 0, 0}, rate);  // no film force without motion
  CHECK(rate[2] == Approx(3 / (0.5 * 2e-4)));
  CHECK(rate[3] == Approx(-5 / (0.5 * 2e-4)));
}

TEST_CASE("step interpolant: where rates are not to be relied on, it is the cubic through places and velocities") {
  const auto q = [](double t) { return 1 + 2 * t - 3 * t * t + 4 * t * t * t; };
  const auto v = [](double t) { return 2 - 6 * t + 12 * t * t; };
  StepInterpolant<std::vector<double>> step;
  step.t_old = 0.5;
  step.t_new = 2;
  step.y_old = {q(0.5), v(0.5)};
  step.y_new = {q(2), v(2)};
  step.rate_old = {v(0.5), 1e9};  // of no use
  step.rate_new = {v(2), -1e9};
  step.smooth_rates = false;
  std::vector<double> y;
  for (const double t : {0.5, 0.7, 1.3, 1.9, 2.0}) {
    step.state_at(t, 1, y);
    CHECK(y[0] == Approx(q(t)).epsilon(1e-13));
    CHECK(y[1] == Approx(v(t)).epsilon(1e-13));
  }
}

TEST_CASE("step interpolant: with its middle, places are of degree 8 and integrals of degree 5") {
  const auto power = [](double t, int k) { return std::pow(t - 0.3, k); };
  for (int k = 0; k <= 9; ++k) {
    INFO("degree " << k);
    const auto state = [&](double t) {
      return std::vector<double>{power(t, k), k == 0 ? 0 : k * power(t, k - 1), power(t, k)};
    };
    const auto rate = [&](double t) {
      const double slope = k == 0 ? 0 : k * power(t, k - 1);
      return std::vector<double>{slope, k < 2 ? 0 : k * (k - 1) * power(t, k - 2), slope};
    };
    StepInterpolant<std::vector<double>> step;
    step.t_old = 0.5;
    step.t_new = 2;
    step.y_old = state(0.5);
    step.y_new = state(2);
    step.rate_old = rate(0.5);
    step.rate_new = rate(2);
    step.has_middle = true;
    step.y_middle = state(1.25);
    step.rate_middle = rate(1.25);
    std::vector<double> y;
    double place = 0;
    double integral = 0;
    for (const double t : {0.5, 0.7, 1.2, 1.25, 1.3, 1.9, 2.0}) {
      step.state_at(t, 1, y);
      const double size = power(2, k);
      place = std::max({place, std::abs(y[0] - state(t)[0]) / size, std::abs(y[1] - state(t)[1]) / size});
      integral = std::max(integral, std::abs(y[2] - state(t)[2]) / size);
      CHECK(step.integral_at(t, 2) == y[2]);
    }
    // Rounding, of derivatives up to 72 times the value; or what a power too many leaves.
    if (k <= 8) CHECK(place < 1e-13);
    if (k == 9) CHECK(place > 1e-6);
    if (k <= 5) CHECK(integral < 1e-13);
    if (k == 6) CHECK(integral > 1e-4);
  }
}

TEST_CASE("second-order systems are recognised by their Jacobian, and nothing else is") {
  Eigen::MatrixXd j = Eigen::MatrixXd::Zero(6, 6);  // two coordinates, two rows of work
  j.block(0, 2, 2, 2).setIdentity();
  j.block(2, 0, 4, 4).setConstant(7);
  CHECK(second_order_coordinates(j) == 2);
  CHECK(second_order_coordinates(Eigen::MatrixXd(j.topLeftCorner(4, 4))) == 2);
  for (const auto& [row, column] : {std::pair(0, 0), {1, 2}, {0, 3}, {2, 4}, {5, 5}, {0, 4}}) {
    Eigen::MatrixXd other = j;
    other(row, column) += 1;
    INFO(row << ' ' << column);
    CHECK(second_order_coordinates(other) == 0);
  }
  CHECK(second_order_coordinates(Eigen::MatrixXd(Eigen::MatrixXd::Identity(4, 4))) == 0);
}

TEST_CASE("complex shift: the equivalent real system of long numbers has the same solution") {
  using Long = boost::multiprecision::cpp_bin_float_50;
  using Matrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;
  Matrix j(2, 2);
  j << 1, 2, 3, 5;
  ComplexShiftSolver<Long, Eigen::Dynamic> solver(2);
  const Long alpha = 4, beta = 7;
  solver.factorise(j, alpha, beta);
  Vector x(2), y(2);
  x << 1, -2;
  y << 3, 5;
  const Vector r = x, s = y;
  solver.solve_in_place(x, y);
  // (α + iβ − J)(x + iy) = r + is
  const Vector real = alpha * x - beta * y - j * x - r;
  const Vector imaginary = alpha * y + beta * x - j * y - s;
  CHECK(real.norm() < 1e-45);  // 50 digits
  CHECK(imaginary.norm() < 1e-45);
}

TEST_CASE("dense output knows where its last step began") {
  using State = std::array<double, 1>;
  RadauIIA5Dense<double, 1> stepper{RadauIIA5<double, 1>(1e-6, {1e-6})};
  const auto f = [](const State& x, State& dxdt, double) { dxdt[0] = -x[0]; };
  const auto slope = [](const State&, Eigen::Matrix<double, 1, 1>& j, double) { j(0, 0) = -1; };
  stepper.initialize({2.0}, 0.5, 1e-3);
  for (int step = 0; step < 3; ++step) {
    const State before = stepper.current_state();
    const double t_before = stepper.current_time();
    stepper.do_step(std::make_pair(f, slope));
    CHECK(stepper.previous_state() == before);
    CHECK(stepper.previous_time() == t_before);
    CHECK(stepper.current_state()[0] == Approx(2 * std::exp(0.5 - stepper.current_time())).epsilon(1e-6));
  }
}

TEST_CASE("numbers in messages have ten digits") { CHECK(lubjoint::detail::number(1.0 / 3) == "0.3333333333"); }

TEST_CASE("auto: an explicit method where stability asks for fewer than four times the steps of accuracy") {
  const auto choice = [](double pilot_steps, double stability_steps, double tolerance, bool smooth = true) {
    return lubjoint::detail::choose_integrator({true, pilot_steps, 3.3 * stability_steps, smooth}, tolerance).name;
  };
  CHECK(choice(100, 1590, 1e-7) == "fehlberg78");  // accuracy: 100 steps at 1e-4 are 398 at 1e-7
  CHECK(choice(100, 1590, 1e-7, false) == "dopri5");
  CHECK(choice(100, 1595, 1e-7) == "radau_iia5");
  CHECK(choice(100, 399, 1e-4) == "dopri5");
  CHECK(choice(100, 401, 1e-4) == "radau_iia5");
  CHECK(lubjoint::detail::choose_integrator({false, 1, 0, true}, 1e-7).name == "radau_iia5");
  // Order 9 where tolerances are tight, in independent coordinates.
  const auto of_stiff = [](bool independent, double tolerance) {
    return lubjoint::detail::choose_integrator({true, 100, 1e6, false, independent}, tolerance).name;
  };
  CHECK(of_stiff(true, 1e-10) == "radau_iia9");
  CHECK(of_stiff(true, 1.1e-10) == "radau_iia5");
  CHECK(of_stiff(false, 1e-10) == "radau_iia5");
  // Below 4e-8 an explicit method follows what dies out: at 1e-10 with 400^(1/5) = 3.31 times the steps of stability.
  CHECK(choice(100, 1920, 1e-10) == "radau_iia5");  // 4 times the 1585 of accuracy are 6340
  CHECK(choice(100, 1910, 1e-10) == "fehlberg78");
  // Of order 9 it is 398 steps there, each of 7.5 explicit ones.
  const auto of_tight = [](double stability_steps, bool smooth) {
    return lubjoint::detail::choose_integrator({true, 100, 3.3 * stability_steps, smooth, true}, 1e-10).name;
  };
  CHECK(of_tight(910, false) == "radau_iia9");
  CHECK(of_tight(890, false) == "dopri5");
  CHECK(of_tight(910, true) == "fehlberg78");
  CHECK(of_tight(1920, true) == "radau_iia9");
}

TEST_CASE("equations of motion: the derivative with respect to time is exact, and its vector needs no size") {
  Scene scene = load_scene(scenes + "slider-crank.toml");
  scene.energy_ledger = false;
  scene.stabilisation = {false, 30, 40};  // what a driver's angle enters by
  const auto system = planar_system<double>(scene);
  auto y = scene_start<double>(scene);
  assemble_start(system, 0.0, 0.1, y);
  MultibodyOde<double> ode(system, false);
  std::vector<double> slope, before = y, after = y;
  ode.time_slope(y, slope, 1e-3);
  REQUIRE(slope.size() == y.size());
  ode.rate(y, before, 0.0);
  ode.rate(y, after, 2e-3);
  double largest = 0;
  for (std::size_t i = 0; i < y.size(); ++i) largest = std::max(largest, std::abs(slope[i]));
  CHECK(largest > 1);
  // A driver's angle is linear in time, and so are these terms.
  for (std::size_t i = 0; i < y.size(); ++i) CHECK(std::abs((after[i] - before[i]) / 2e-3 - slope[i]) < 1e-8 * largest);
}

TEST_CASE("equations of motion: the exact Jacobian of a body that a constraint and a film hold equals differences") {
  const Scene scene = rod_in_a_film();
  const auto system = planar_system<double>(scene);
  auto y = scene_start<double>(scene);
  y[3] = 2e-3, y[4] = 0.03, y[5] = 0.2;
  MultibodyOde<double> ode(system, false);
  Eigen::MatrixXd exact;
  ode.jacobian(y, exact, 0.0);
  std::vector<double> low = y, high = y;
  for (std::size_t column = 0; column < y.size(); ++column) {
    const double h = column < 3 ? 1e-9 : 1e-6;  // of clearances of 2e-4, and of speeds
    std::vector<double> x = y;
    x[column] = y[column] - h;
    ode.rate(x, low, 0.0);
    x[column] = y[column] + h;
    ode.rate(x, high, 0.0);
    for (std::size_t row = 0; row < y.size(); ++row) {
      const double size = exact.row(static_cast<Eigen::Index>(row)).cwiseAbs().maxCoeff();
      const double entry = exact(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
      INFO(row << ' ' << column);
      CHECK(std::abs((high[row] - low[row]) / (2 * h) - entry) < 1e-4 * size + 1e-9);  // rounding over h
    }
  }
}

TEST_CASE("constraints that are all but the same count as the same, in the rank, too") {
  Scene scene;
  scene.name = "rod";
  scene.bodies = {body("rod", 0.3, 2e-3, {0.1, 0})};
  scene.constraints = {{"pin", Revolute<double>{{ground_body, {0, 0}}, {0, {-0.1, 0}}}},
                       {"near", Revolute<double>{{ground_body, {1e-12, 0}}, {0, {-0.1 + 1e-12, 0}}}}};
  const auto system = planar_system<double>(scene);
  auto y = scene_start<double>(scene);
  CHECK_THROWS_WITH(assemble_start(system, 0.0, 0.1, y),
                    Contains("\"near\" repeats what others fix already: \"pin\";") && Contains("4 rows of rank 2"));
}

TEST_CASE("ledger: the power of a load is its force times the velocity and its moment times the spin") {
  Scene scene;
  scene.bodies = {body("first", 1, 1, {0, 0}), body("second", 2, 3, {1, 0})};
  scene.loads = {{0, {1, 2}, 0.5}, {1, {-3, 4}, 0.25}};
  const auto system = planar_system<double>(scene);
  MultibodyOde<double> ode(system, true);
  std::vector<double> y(ode.dimension(), 100.0), rate(ode.dimension());
  const std::vector<double> velocities{4, 5, 6, 7, 8, 9};
  std::copy(velocities.begin(), velocities.end(), y.begin() + 6);
  ode.rate(y, rate, 0.0);
  const std::size_t loads = 12 + static_cast<std::size_t>(LedgerTerm::loads);
  CHECK(rate[loads] == Approx(1 * 4 + 2 * 5 + 0.5 * 6 - 3 * 7 + 4 * 8 + 0.25 * 9));
}

TEST_CASE("velocities that violate constraints are brought onto them, all rows, at the start and by projection") {
  const Scene scene = load_scene(scenes + "slider-crank.toml");
  const auto system = planar_system<double>(scene);
  auto y = scene_start<double>(scene);
  assemble_start(system, 0.0, 0.1, y);
  const auto consistent = y;
  const StartCorrection<double> none = assemble_start(system, 0.0, 0.1, y);
  CHECK(none.position < 1e-12);
  CHECK(none.angle < 1e-12);
  CHECK(none.velocity < 1e-10);
  CHECK(none.spin < 1e-9);
  auto w = system.workspace<double>();
  const std::size_t sliding = system.coordinates() + 6;  // along its guide: no constraint minds
  for (std::size_t i = system.coordinates(); i < y.size(); ++i) {
    if (i == sliding) continue;
    INFO(i);
    y = consistent;
    y[i] += 0.3;
    CHECK(worst_rate(system, y) > 1e-3);
    auto projected = y;
    project_onto_constraints(system, 0.0, projected, w);
    CHECK(worst_rate(system, projected) < 1e-9);  // of speeds of 30 m/s and 524 rad/s
    const StartCorrection<double> change = assemble_start(system, 0.0, 0.1, y);
    CHECK(worst_rate(system, y) < 1e-9);
    CHECK(std::max(change.velocity, change.spin) > 1e-3);
  }
}

TEST_CASE("a driver's extremes are those of its moment, however small") {
  Scene scene;
  scene.name = "rod";
  scene.gravity = {0, -9.81};
  scene.bodies = {body("rod", 0.1, 1e-4, {0.05, 0})};
  scene.bodies[0].velocity = {0, 0.5};
  scene.bodies[0].spin = 10;
  scene.constraints = {{"pin", Revolute<double>{{ground_body, {0, 0}}, {0, {-0.05, 0}}}},
                       {"motor", Driver<double>{ground_body, 0, 0, 10, 0}}};
  scene.run.duration = 2 * std::acos(-1.0) / 10;
  scene.run.output_interval = scene.run.duration / 10;
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.drivers.size() == 1);
  const double weight_moment = 0.1 * 9.81 * 0.05;
  CHECK(run.drivers[0].max_moment.value == Approx(weight_moment).epsilon(1e-6));
  CHECK(run.drivers[0].min_moment.value == Approx(-weight_moment).epsilon(1e-6));
}

TEST_CASE("steps that end at outputs end there to the bit") {
  Scene scene = pendulum_chain(1, 0.3);
  scene.run.duration = 0.3;
  scene.run.output_interval = 0.007;
  scene.run.stop_at_outputs = true;
  for (const char* integrator : {"radau_iia5", "dopri5", "fehlberg78"}) {
    scene.integrator = integrator;
    const MultibodyTrajectory run = simulate_multibody(scene);
    REQUIRE(run.outcome.status == RunStatus::finished);
    REQUIRE(run.samples.size() == 44);
    for (std::size_t i = 0; i + 1 < run.samples.size(); ++i) {
      CHECK(run.samples[i].t == static_cast<double>(i) * scene.run.output_interval);
    }
    CHECK(run.samples.back().t == 0.3);
  }
}

TEST_CASE("a first step that is far too long is shortened, not taken for the end") {
  Scene scene = load_scene(scenes + "journal.toml");
  scene.run.duration = 1e3;  // the first trial is a millionth of it, a hundred times what the film bears
  scene.run.output_interval = 100;
  for (const char* integrator : {"radau_iia5", "rosenbrock4"}) {
    scene.integrator = integrator;
    const JournalTrajectory run = simulate_journal(scene);
    INFO(run.outcome.message);
    CHECK(run.outcome.status == RunStatus::finished);
    CHECK(run.outcome.rejected_steps > 0);
  }
}

}  // namespace equations_of_motion_test

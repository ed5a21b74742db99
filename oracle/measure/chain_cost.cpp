#include "oracle/measure/chain_cost.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lubjoint/motion/constrained_radau.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "oracle/measure/timing.hpp"

namespace lubjoint::reports {

namespace {

constexpr std::array<std::size_t, 11> lengths = {1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000};
constexpr std::size_t first_of_fit = 50;

/// Rods of 0.1 m on pins, the first on the ground, hanging askew under gravity.
Scene pendulums(std::size_t count) {
  Scene scene;
  scene.name = "chain";
  scene.gravity = {0, -9.81};
  const double half = 0.05;
  const double angle = 0.3;
  const Vector2<double> along(std::sin(angle), -std::cos(angle));
  for (std::size_t i = 0; i < count; ++i) {
    SceneBody rod;
    rod.name = "rod" + std::to_string(i);
    rod.mass = 0.1;
    rod.inertia = 1e-4;
    rod.position = half * static_cast<double>(2 * i + 1) * along;
    rod.angle = angle;
    scene.bodies.push_back(rod);
    SceneAnchor above;
    if (i > 0) above = {i - 1, {0, -half}};
    scene.constraints.push_back({"pin" + std::to_string(i), Revolute<double>{above, {i, {0, half}}}});
  }
  return scene;
}

ChainCost cost_of(std::size_t bodies, std::size_t rounds) {
  const Scene scene = pendulums(bodies);
  const PlanarSystem<double> system = planar_system<double>(scene);
  MultibodyOde<double> ode(system, false);
  const std::vector<double> y = scene_start<double>(scene);
  std::vector<double> rate = y;
  ode.rate(y, rate, 0.0);
  SystemWorkspace<double>& w = ode.workspace();
  std::vector<TimedPiece> quick{repeated([&] { ode.rate(y, rate, 0.0); }), repeated([&] { system.factorise(w); }),
                                repeated([&] { system.solve(w); })};
  const std::vector<Timing> parts = time_in_turn(quick, rounds, 1e-4);
  // A step as a run makes it, with a new Jacobian and new factors, but for the memory that the first one takes.
  ConstrainedMotionJacobian<double> derivatives(ode);
  ConstrainedJacobian<double> jacobian;
  const StepTolerance<double, run_time_size> tolerance{0, std::vector<double>(y.size(), 1e-8), 1e-6, 0};
  ConstrainedRadau<double> stepper(ode, tolerance);
  std::vector<TimedPiece> slow{repeated([&] { derivatives.evaluate(0.0, y, jacobian); }), repeated([&] {
                                 stepper.reset();
                                 std::vector<double> x = y;
                                 double t = 0;
                                 double dt = 1e-5;
                                 stepper.try_step(ode, x, t, dt);
                               })};
  const std::size_t few = std::max<std::size_t>(3, rounds / 10);
  const std::vector<Timing> implicit = time_in_turn(slow, bodies < 20 ? rounds : few, 1e-4);
  return {bodies,
          system.constraint_rows(),
          w.schur.stored(),
          parts[0].nanoseconds(),
          parts[1].nanoseconds(),
          parts[2].nanoseconds(),
          implicit[0].nanoseconds(),
          implicit[1].nanoseconds()};
}

}  // namespace

std::vector<ChainCost> chain_cost(std::size_t rounds) {
  std::vector<ChainCost> rows;
  rows.reserve(lengths.size());
  for (const std::size_t bodies : lengths) rows.push_back(cost_of(bodies, rounds));
  return rows;
}

double growth_exponent(const std::vector<ChainCost>& rows, double ChainCost::*time) {
  double count = 0;
  double x = 0;
  double y = 0;
  double xx = 0;
  double xy = 0;
  for (const ChainCost& row : rows) {
    if (row.bodies < first_of_fit) continue;
    const double log_n = std::log(static_cast<double>(row.bodies));
    const double log_t = std::log(row.*time);
    count += 1;
    x += log_n;
    y += log_t;
    xx += log_n * log_n;
    xy += log_n * log_t;
  }
  return (count * xy - x * y) / (count * xx - x * x);
}

nlohmann::ordered_json chain_json(const std::vector<ChainCost>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ChainCost& row : rows) {
    list.push_back({{"bodies", row.bodies},
                    {"constraint_rows", row.constraint_rows},
                    {"schur_stored", row.schur_stored},
                    {"rhs_ns", row.rhs},
                    {"factorisation_ns", row.factorisation},
                    {"solve_ns", row.solve},
                    {"jacobian_ns", row.jacobian},
                    {"implicit_step_ns", row.implicit_step}});
  }
  return {{"chain", list},
          {"exponents",
           {{"rhs", growth_exponent(rows, &ChainCost::rhs)},
            {"factorisation", growth_exponent(rows, &ChainCost::factorisation)},
            {"solve", growth_exponent(rows, &ChainCost::solve)},
            {"jacobian", growth_exponent(rows, &ChainCost::jacobian)},
            {"implicit_step", growth_exponent(rows, &ChainCost::implicit_step)}}}};
}

std::string chain_text(const std::vector<ChainCost>& rows) {
  std::string text = fmt::format(
      "a chain of pendulums: one right-hand side, and what an implicit integrator adds\n\n"
      "{:>6} {:>6} {:>9} {:>12} {:>10} {:>14} {:>10} {:>14} {:>14}\n"
      "{:>6} {:>6} {:>9} {:>12} {:>10} {:>14} {:>10} {:>14} {:>14}\n",
      "bodies", "rows", "envelope", "right side", "per body", "factorisation", "solve", "Jacobian", "implicit step", "",
      "", "", "[ns]", "[ns]", "[ns]", "[ns]", "[us]", "[us]");
  for (const ChainCost& row : rows) {
    text += fmt::format("{:>6} {:>6} {:>9} {:>12.0f} {:>10.1f} {:>14.0f} {:>10.0f} {:>14.1f} {:>14.1f}\n", row.bodies,
                        row.constraint_rows, row.schur_stored, row.rhs, row.rhs / static_cast<double>(row.bodies),
                        row.factorisation, row.solve, row.jacobian / 1e3, row.implicit_step / 1e3);
  }
  text += fmt::format("{:>23} {:>12.2f} {:>10} {:>14.2f} {:>10.2f} {:>14.2f} {:>14.2f}\n", "exponent from n = 50",
                      growth_exponent(rows, &ChainCost::rhs), "", growth_exponent(rows, &ChainCost::factorisation),
                      growth_exponent(rows, &ChainCost::solve), growth_exponent(rows, &ChainCost::jacobian),
                      growth_exponent(rows, &ChainCost::implicit_step));
  text +=
      "\nAll costs of a chain are O(n): the envelope of its Schur complement has a constant width, the exact Jacobian\n"
      "of the equations takes three passes however long it is, and an implicit step factorises sparse matrices.\n";
  return text;
}

}  // namespace lubjoint::reports

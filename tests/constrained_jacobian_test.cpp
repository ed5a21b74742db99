// Sparse matrices of implicit steps: the systems that they solve are those of the full Jacobian.
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "lubjoint/motion/constrained_radau.hpp"
#include "lubjoint/ode/radau_integrator.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/scenes.hpp"

namespace constrained_jacobian_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

/// A chain askew and in motion, with a spring between rods that are no neighbours, a damper, and a driver on the first.
Scene busy_chain(std::size_t n) {
  Scene scene = pendulum_chain(n, 0.3);
  scene.energy_ledger = false;
  for (std::size_t b = 0; b < n; ++b) {
    scene.bodies[b].spin = 2;
    scene.bodies[b].velocity = 2.0 * perpendicular(scene.bodies[b].position);
  }
  scene.springs.push_back(
      {"spring", TranslationalSpring<double>{{0, {0.01, 0}}, {3, {-0.02, 0.01}}, 30, 0.5, 0.2, 0.0}});
  scene.constraints.push_back({"motor", Driver<double>{ground_body, 0, 0.3, 2.0, 0.0}});
  return scene;
}

struct Chain {
  explicit Chain(const Scene& scene)
      : system(planar_system<double>(scene)), ode(system, false), start(scene_start<double>(scene)) {
    assemble_start(system, 0.0, 0.1, start);
  }
  PlanarSystem<double> system;
  MultibodyOde<double> ode;
  std::vector<double> start;
};

}  // namespace

TEST_CASE("sparse Jacobian: its solutions are those of the full one, real and complex, of chains and closed loops") {
  const Scene slider_crank = load_scene(LUBJOINT_SOURCE_DIR "/data/scenes/slider-crank.toml");
  for (const Scene& scene : {busy_chain(8), slider_crank}) {
    CAPTURE(scene.name);
    Chain chain(scene);
    ConstrainedMotionJacobian<double> derivatives(chain.ode);
    ConstrainedJacobian<double> sparse;
    derivatives.evaluate(0.0, chain.start, sparse);
    REQUIRE(sparse.allFinite());
    Eigen::MatrixXd full;
    chain.ode.jacobian(chain.start, full, 0.0);
    const Eigen::Index size = full.rows();
    ConstrainedShiftedSolver<double, 1> solver(size);
    for (const double shift : {1e2, 1e5}) {
      solver.factorise(sparse, shift, {0.7 * shift}, {0.8 * shift});
      Eigen::VectorXd r(size), s(size), x(size);
      for (Eigen::Index i = 0; i < size; ++i) {
        r(i) = std::sin(1.0 + static_cast<double>(i * i));
        s(i) = std::cos(2.0 + static_cast<double>(i * i));
      }
      solver.solve(r, x);
      const Eigen::MatrixXd shifted = shift * Eigen::MatrixXd::Identity(size, size) - full;
      const Eigen::VectorXd expected = shifted.partialPivLu().solve(r);
      CHECK((x - expected).norm() < 1e-9 * expected.norm());  // conditions of 1e6 lose so much of 1e-16
      const std::complex<double> complex_shift(0.7 * shift, 0.8 * shift);
      const Eigen::MatrixXcd complex_shifted = complex_shift * Eigen::MatrixXcd::Identity(size, size) - full;
      Eigen::VectorXcd right(size);
      right.real() = r;
      right.imag() = s;
      const Eigen::VectorXcd solution = complex_shifted.partialPivLu().solve(right);
      solver.solve_in_place(0, r, s);
      CHECK((r - solution.real()).norm() < 1e-9 * solution.norm());  // likewise
      CHECK((s - solution.imag()).norm() < 1e-9 * solution.norm());  // likewise
    }
  }
}

TEST_CASE("sparse Jacobian: a chain of any length takes as many passes") {
  for (const std::size_t n : {10, 100, 1000}) {
    Chain chain(pendulum_chain(n, 0.1));
    CHECK(ConstrainedMotionJacobian<double>(chain.ode).passes() == 3);
  }
}

TEST_CASE("sparse Jacobian: steps of Radau IIA are those with the full one") {
  Chain chain(busy_chain(15));
  const StepTolerance<double, run_time_size> tolerance{0, std::vector<double>(chain.start.size(), 1e-8), 1e-8, 0};
  RadauIntegrator<double, run_time_size, 3> full(tolerance);
  ConstrainedRadau<double> sparse(chain.ode, tolerance);
  std::vector<double> one = chain.start, other = chain.start;
  double t_one = 0, dt_one = 1e-4, t_other = 0, dt_other = 1e-4;
  for (int i = 0; i < 40; ++i) {
    full.try_step(chain.ode, one, t_one, dt_one);
    sparse.try_step(chain.ode, other, t_other, dt_other);
  }
  CHECK(full.counts().accepted == sparse.counts().accepted);
  CHECK(full.counts().newton_iterations == sparse.counts().newton_iterations);
  CHECK(t_other ==
        Approx(t_one).epsilon(1e-6));  // steps follow error estimates, which have the rounding of the factors
  double apart = 0;
  const double dt = t_one - t_other;
  for (std::size_t i = 0; i < one.size() / 2; ++i)
    apart = std::max(apart, std::abs(one[i] - other[i] - dt * one[one.size() / 2 + i]));
  CHECK(apart < 1e-9);  // likewise
}

TEST_CASE("long chains: the ledger closes over a driver's and a damper's work") {
  Scene scene = busy_chain(15);
  scene.energy_ledger = true;
  scene.coordinates = SceneCoordinates::absolute;
  scene.run.duration = 0.5;
  scene.run.output_interval = 0.05;
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    CAPTURE(tolerance);
    set_tolerance(scene, tolerance);
    const MultibodyTrajectory run = simulate_multibody(scene);
    REQUIRE(run.outcome.status == RunStatus::finished);
    CHECK(*run.energy_residual < 100 * tolerance * run.energy_scale);  // 0.4 to 8 tolerances of a step were measured
  }
}

TEST_CASE("long chains: a scene of 300 pendulums starts, runs and keeps its energy") {
  Scene scene = pendulum_chain(300, 0.05);
  scene.run.duration = 0.02;
  scene.run.output_interval = 0.01;
  set_tolerance(scene, 1e-9);
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  CHECK(run.outcome.coordinates == "absolute");
  CHECK(run.outcome.coordinates_reason.find("300 degrees of freedom") == 0);
  CHECK(*run.energy_residual < 300 * 0.1 * 9.81 * 1e-10);  // the weight of every rod, off by its tolerance
}

}  // namespace constrained_jacobian_test

// SUNDIALS as an opponent: what it is given is right.
#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/scene/scene_file.hpp"
#include "oracle/measure/bench/half_size_solver.hpp"
#include "oracle/measure/bench/sundials_method.hpp"

namespace sundials_test {

using namespace lubjoint;
using namespace lubjoint::reports;

namespace {

Scene shipped(const std::string& name) {
  return load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/" + name + ".toml");
}

/// The largest difference of a Jacobian from central differences, both with every state in its own unit, over the
/// largest element.
double off(const std::vector<double>& jacobian, const std::vector<double>& units,
           const std::function<std::vector<double>(std::size_t column, double step)>& shifted) {
  const std::size_t n = units.size();
  double worst = 0;
  double largest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double h = 1e-5 * units[k];
    const std::vector<double> up = shifted(k, h);
    const std::vector<double> down = shifted(k, -h);
    for (std::size_t i = 0; i < n; ++i) {
      const double scale = units[k] / units[i];
      const double exact = jacobian[k * n + i] * scale;
      worst = std::max(worst, std::abs((up[i] - down[i]) / (2 * h) * scale - exact));
      largest = std::max(largest, std::abs(exact));
    }
  }
  return worst / largest;
}

}  // namespace

TEST_CASE("SUNDIALS: CVODE's and IDA's Jacobians are those of the residual, in every formulation") {
  for (const char* name : {"journal", "slider-crank", "slider-crank-ideal", "slider-crank-torque"}) {
    const BenchScene scene = bench_scene(shipped(name));
    for (const auto& each : scene.cases) {
      auto plain = each->plain_problem(1);  // tolerances of 1: the states' own units
      if (!plain) continue;
      CAPTURE(name, each->formulation());
      const std::size_t n = plain->start.size();
      CHECK(plain->second_order);
      std::vector<double> y = plain->start;
      // Off the start, where the film is not defined by a direction: a tenth of a unit each, in no pattern.
      for (std::size_t i = 0; i < n; ++i) y[i] += 0.1 * plain->absolute_tolerance[i] * std::sin(1.0 + 2.0 * double(i));
      const double t = 0.3 * plain->duration;
      std::vector<double> slope(n);
      plain->rate(t, y.data(), slope.data());
      const auto rate = [&](std::size_t k, double h) {
        std::vector<double> at = y;
        std::vector<double> out(n);
        at[k] += h;
        plain->rate(t, at.data(), out.data());
        return out;
      };
      // Differences over 1e-5 of a unit: 1e-10 of truncation, and 1e-9 of rounding in coordinates of 850 clearances.
      constexpr double allowed = 1e-7;
      CHECK(off(sundials_jacobian("cvode_bdf", *plain, t, y, 0), plain->absolute_tolerance, rate) < allowed);
      const double c = 1 / (1e-3 * plain->duration);
      const auto residual = [&](double sign) {
        return [&, sign](std::size_t k, double h) {
          std::vector<double> at = y;
          std::vector<double> rates = slope;
          at[k] += h;
          rates[k] += sign * c * h;
          return sundials_residual(*plain, t, at, rates);
        };
      };
      const auto newton = sundials_jacobian("ida", *plain, t, y, c);
      CHECK(off(newton, plain->absolute_tolerance, residual(1)) < allowed);
      CHECK(off(newton, plain->absolute_tolerance, residual(-1)) > 1e3 * allowed);  // another matrix is noticed
    }
  }
  CHECK_THROWS_AS(sundials_jacobian("cvode_adams", PlainProblem{}, 0, {1}, 0), std::invalid_argument);
}

TEST_CASE("SUNDIALS: the linear systems at half their size have the solution of the whole ones") {
  SUNContext context = nullptr;
  REQUIRE(SUNContext_Create(nullptr, &context) == 0);
  constexpr sunindextype n = 6;
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n, n);
  whole.topLeftCorner(3, 3).diagonal().setConstant(2.5);
  whole.topRightCorner(3, 3).diagonal().setConstant(-0.75);
  for (int i = 3; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) whole(i, j) = std::cos(7.0 * i + 3.0 * j * j) + (i == j ? 3 : 0);
  }
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(n, -1, 2);
  SUNMatrix matrix = SUNDenseMatrix(n, n, context);
  std::copy(whole.data(), whole.data() + n * n, SM_DATA_D(matrix));
  N_Vector x = N_VNew_Serial(n, context);
  N_Vector r = N_VNew_Serial(n, context);
  std::copy(right.data(), right.data() + n, N_VGetArrayPointer(r));
  SUNLinearSolver solver = half_size_solver(n, context);
  REQUIRE(SUNLinSolSetup(solver, matrix) == 0);
  REQUIRE(SUNLinSolSolve(solver, matrix, x, r, 0) == 0);
  const Eigen::VectorXd found = Eigen::Map<Eigen::VectorXd>(N_VGetArrayPointer(x), n);
  CHECK((found - whole.lu().solve(right)).norm() < 1e-14 * n * right.norm());  // rounding
  SM_ELEMENT_D(matrix, 3, 3) = SM_ELEMENT_D(matrix, 4, 3) = SM_ELEMENT_D(matrix, 5, 3) = 0;
  SM_ELEMENT_D(matrix, 3, 0) = SM_ELEMENT_D(matrix, 4, 0) = SM_ELEMENT_D(matrix, 5, 0) = 0;
  CHECK(SUNLinSolSetup(solver, matrix) == 1);  // singular: CVODE tries a shorter step
  SUNLinSolFree(solver);
  N_VDestroy(x);
  N_VDestroy(r);
  SUNMatDestroy(matrix);
  SUNContext_Free(&context);
}

TEST_CASE("SUNDIALS: each method reaches its tolerance's error on a film, in coordinates of either size") {
  for (const char* name : {"journal", "slider-crank"}) {
    for (const auto& each : bench_scene(shipped(name)).cases) {
      if (each->formulation() == "joint") continue;
      if (!each->plain_problem(1e-9)) {  // in functions of its own, or in space
        CHECK_THROWS_AS(each->run("ida", 1e-9, {1, 20}), std::invalid_argument);
        continue;
      }
      for (const char* method : {"cvode_bdf", "cvode_adams_newton", "ida"}) {
        CAPTURE(name, each->formulation(), method);
        const MethodRun run = each->run(method, 1e-9, {1, 20});
        INFO(run.message);
        CHECK(run.finished);
        CHECK(run.error < 1e-6);  // a thousand tolerances: what thousands of steps accumulate
        CHECK(run.jacobian_evaluations > 0);
      }
    }
  }
}

}  // namespace sundials_test

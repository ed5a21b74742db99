#include <catch2/catch.hpp>

#include "lubjoint/ode/radau_iia5.hpp"
#include "support/initial_value_problems.hpp"

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;
namespace odeint = boost::numeric::odeint;

namespace {

/// A of Radau IIA(5) as printed: Hairer and Wanner II, table IV.5.6.
template <class R>
Eigen::Matrix<R, 3, 3> printed_matrix() {
  using std::sqrt;
  const R s = sqrt(R(6));
  Eigen::Matrix<R, 3, 3> a;
  a << (88 - 7 * s) / 360, (296 - 169 * s) / 1800, (-2 + 3 * s) / 225,  //
      (296 + 169 * s) / 1800, (88 + 7 * s) / 360, (-2 - 3 * s) / 225,   //
      (16 - s) / 36, (16 + s) / 36, R(1) / 9;
  return a;
}

template <class R>
double tableau_defect() {
  const RadauTableau<R>& tab = RadauTableau<R>::instance();
  Eigen::Matrix<R, 3, 3> blocks;
  blocks << tab.gamma, R(0), R(0), R(0), tab.alpha, -tab.beta, R(0), tab.beta, tab.alpha;
  const Eigen::Matrix<R, 3, 3> a_inverse = printed_matrix<R>().inverse();
  const Eigen::Matrix<R, 3, 3> defect = tab.t_inverse * a_inverse * tab.t - blocks;
  return static_cast<double>(defect.norm() / std::numeric_limits<R>::epsilon());
}

/// A controlled run to the end of the problem; error and accepted steps.
template <class R, class Problem>
std::pair<double, double> controlled_run(const Problem& problem, const R& tolerance) {
  using State = typename Problem::State;
  State absolute;
  absolute.fill(tolerance);
  RadauIIA5<R, Problem::dimension> stepper(tolerance, absolute);
  const auto system = odeint_system<R>(problem);
  State x = problem.exact(R(0));
  R t = 0;
  R dt = R(1e-3);
  const R end = R(Problem::duration);
  while (t < end) {
    dt = std::min<R>(dt, end - t);
    if (end - t - dt < R(1e-12)) dt = end - t;
    stepper.try_step(system, x, t, dt);
  }
  return {distance(x, problem.exact(t)), static_cast<double>(stepper.counts().accepted)};
}

/// Fixed steps: every error is accepted. Exact for linear problems alone, whose stages need no second iteration.
template <class Problem>
double fixed_step_error(const Problem& problem, int steps, double* inside = nullptr) {
  using State = typename Problem::State;
  State absolute;
  absolute.fill(1e20);
  RadauIIA5<double, Problem::dimension> stepper(0.5, absolute);
  const auto system = odeint_system<double>(problem);
  State x = problem.exact(0);
  double t = 0;
  for (int i = 0; i < steps; ++i) {
    double dt = Problem::duration / steps;
    const double t_old = t;
    REQUIRE(stepper.try_step(system, x, t, dt) == odeint::success);
    for (int k = 1; inside != nullptr && k < 8; ++k) {
      State between;
      const double at = t_old + (t - t_old) * k / 8;
      stepper.state_at(at, between);
      *inside = std::max(*inside, distance(between, problem.exact(at)));
    }
  }
  return distance(x, problem.exact(t));
}

}  // namespace

TEST_CASE("radau tableau: T⁻¹A⁻¹T is the real eigenvalue and the complex pair, to rounding, A as printed") {
  CHECK(tableau_defect<double>() < 500);       // rounding of an inverse and two products, condition number 30
  CHECK(tableau_defect<long double>() < 500);  // the same
}

TEST_CASE("radau tableau: the abscissae are the roots of d²/dx² x²(x − 1)³, and the eigenvalues those of A⁻¹") {
  const RadauTableau<double>& tab = RadauTableau<double>::instance();
  for (int i = 0; i < 3; ++i) {
    const double c = tab.c(i);
    CHECK(std::abs(2 * (c - 1) * (10 * c * c - 8 * c + 1)) < 1e-15);     // rounding; half the second derivative
    CHECK(std::abs(printed_matrix<double>().row(i).sum() - c) < 1e-15);  // rounding; Σ_j a_ij = c_i
  }
  for (const std::complex<double> z : {std::complex<double>(tab.gamma, 0), {tab.alpha, tab.beta}}) {
    // det(zI − A⁻¹) = z³ − 9z² + 36z − 60, from the denominator 1 − 3z/5 + 3z²/20 − z³/60 of the stability function
    CHECK(std::abs(((z - 9.0) * z + 36.0) * z - 60.0) < 1e-12);  // rounding of terms of size 200
  }
  CHECK(tab.beta > 0);
}

TEST_CASE("radau: observed order 5 against accepted steps on an autonomous nonlinear problem") {
  std::vector<double> steps;
  std::vector<double> error;
  for (const long double tolerance : {1e-6L, 1e-8L, 1e-10L, 1e-12L, 1e-14L}) {
    const auto run = controlled_run<long double>(Logistic<long double>(), tolerance);
    steps.push_back(run.second);
    error.push_back(run.first);
    CHECK(run.first < 10 * static_cast<double>(tolerance));  // the promise: error of the order of the tolerance
  }
  const double order = observed_order(steps, error);
  INFO("order " << order);
  CHECK(order > 4.7);  // 5, less what the controller scatters over eight decades
  CHECK(order < 5.5);  // the same
}

TEST_CASE("radau: observed order 5 against accepted steps on a non-autonomous problem") {
  std::vector<double> steps;
  std::vector<double> error;
  for (const long double tolerance : {1e-6L, 1e-8L, 1e-10L, 1e-12L, 1e-14L}) {
    const auto run = controlled_run<long double>(Driven<long double>(), tolerance);
    steps.push_back(run.second);
    error.push_back(run.first);
  }
  const double order = observed_order(steps, error);
  INFO("order " << order);
  CHECK(order > 4.7);  // as above
  CHECK(order < 5.5);  // as above
}

TEST_CASE("radau: observed order 5 with fixed steps on a linear non-autonomous problem, 3 or more between the steps") {
  double coarse_inside = 0;
  double fine_inside = 0;
  const double coarse = fixed_step_error(ProtheroRobinson<double>{-1}, 4, &coarse_inside);
  const double fine = fixed_step_error(ProtheroRobinson<double>{-1}, 16, &fine_inside);
  const double order = std::log(coarse / fine) / std::log(4);
  INFO("order " << order << ", inside " << std::log(coarse_inside / fine_inside) / std::log(4));
  CHECK(order > 4.8);                                              // 5 as the step goes to 0
  CHECK(order < 5.5);                                              // the same
  CHECK(std::log(coarse_inside / fine_inside) / std::log(4) > 3);  // the collocation polynomial
  CHECK(fine_inside > fine);
}

TEST_CASE("radau: a stiff problem costs no more steps than a mild one, and stays on its solution") {
  const auto mild = controlled_run<double>(ProtheroRobinson<double>{-1}, 1e-8);
  const auto stiff = controlled_run<double>(ProtheroRobinson<double>{-1e6}, 1e-8);
  CHECK(stiff.second <= 2 * mild.second);
  CHECK(stiff.first < 1e-7);                                            // ten times the tolerance
  CHECK(fixed_step_error(ProtheroRobinson<double>{-1e6}, 20) < 1e-10);  // h⁴/|λ|: 1e-4/1e6
}

TEST_CASE("radau: van der Pol's oscillator at 1/ε = 1e6 ends where the literature says, in few steps") {
  const auto f = [](const std::array<double, 2>& x, std::array<double, 2>& dxdt, double) {
    dxdt = {x[1], ((1 - x[0] * x[0]) * x[1] - x[0]) * 1e6};
  };
  const auto j = [](const std::array<double, 2>& x, auto& m, double) {
    m << 0, 1, (-2 * x[0] * x[1] - 1) * 1e6, (1 - x[0] * x[0]) * 1e6;
  };
  RadauIIA5<double, 2> stepper(1e-9, {1e-9, 1e-9});
  std::array<double, 2> x{2, 0};
  double t = 0;
  double dt = 1e-6;
  while (t < 2) {
    dt = std::min(dt, 2 - t);
    stepper.try_step(std::make_pair(f, j), x, t, dt);
  }
  // Test Set for IVP Solvers, Van der Pol: reference solution at t = 2.
  CHECK(x[0] == Approx(1.706167732170483).epsilon(1e-7));    // tolerance, a hundred times in two fast transitions
  CHECK(x[1] == Approx(-0.8928097010247975).epsilon(1e-7));  // the same
  CHECK(stepper.counts().accepted < 2000);
}

TEST_CASE("radau: a rate that is not finite, or outside its domain, rejects the step and halves it") {
  const auto j = [](const std::array<double, 1>&, auto& m, double) { m << 0; };
  const auto stops = [](const std::array<double, 1>& x, std::array<double, 1>& dxdt, double) {
    if (x[0] >= 1) throw std::domain_error("beyond the wall");
    dxdt = {1};
  };
  const auto breaks = [](const std::array<double, 1>& x, std::array<double, 1>& dxdt, double) {
    dxdt = {x[0] >= 1 ? std::nan("") : 1};
  };
  const auto check = [&](const auto& f) {
    RadauIIA5<double, 1> stepper(1e-6, {1e-6});
    std::array<double, 1> x{0.5};
    double t = 0;
    double dt = 0.75;
    CHECK(stepper.try_step(std::make_pair(f, j), x, t, dt) == odeint::fail);
    CHECK(x[0] == 0.5);
    CHECK(t == 0);
    CHECK(dt == 0.375);
    CHECK(stepper.counts().rejected == 1);
    CHECK(stepper.try_step(std::make_pair(f, j), x, t, dt) == odeint::success);
    CHECK(x[0] == Approx(0.875).epsilon(1e-15));  // rounding: the problem is linear
    // A wall comes nearer than any step: no state beyond it is ever accepted, not even as the end of a step.
    for (int i = 0; i < 200; ++i) stepper.try_step(std::make_pair(f, j), x, t, dt);
    CHECK(x[0] < 1);
    CHECK(x[0] > 0.999);
  };
  check(stops);
  check(breaks);
  const auto bad_jacobian = [](const std::array<double, 1>&, auto& m, double) { m << std::nan(""); };
  RadauIIA5<double, 1> stepper(1e-6, {1e-6});
  std::array<double, 1> x{0.5};
  double t = 0;
  double dt = 0.1;
  CHECK(stepper.try_step(std::make_pair(stops, bad_jacobian), x, t, dt) == odeint::fail);
  CHECK(x[0] == 0.5);
}

TEST_CASE("radau: tolerances that are zero, negative, not a number or not below 1 are refused") {
  using Stepper = RadauIIA5<double, 2>;
  for (const double bad : {0.0, -1e-6, 1.0, 2.0, std::nan("")}) {
    CHECK_THROWS_WITH(Stepper(bad, {1e-6, 1e-6}), Contains("relative tolerance") && Contains("(0, 1)"));
  }
  for (const double bad : {0.0, -1e-6, std::nan("")}) {
    CHECK_THROWS_WITH(Stepper(1e-6, {1e-6, bad}), Contains("absolute tolerance") && Contains("above 0"));
  }
}

TEST_CASE("radau: in long double the error goes below what double can hold") {
  const auto run = controlled_run<long double>(Logistic<long double>(), 1e-18L);
  CHECK(run.first < 1e-16);  // double: 2e-16 a step and hundreds of steps
}

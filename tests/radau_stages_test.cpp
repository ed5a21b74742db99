// Stages of Radau IIA that each have a part of the Jacobian of their own.
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "lubjoint/ode/radau_iia.hpp"
#include "support/initial_value_problems.hpp"

namespace radau_stages_test {

using namespace lubjoint;
using namespace lubjoint::test;
namespace odeint = boost::numeric::odeint;

namespace {

/// A mass on a squeeze film, thrown to 1 − q = 4e-6, and a spring that changes: q̈ = W cos ωt − s(t) q − k(q) q̇,
/// k = κ (1 − q²)^(−3/2).
struct Squeezed {
  using State = std::array<double, 2>;
  double share = 1;  ///< of the film's slopes that are handed out as its part

  static double damping(double q) { return 0.05 / std::pow(1 - q * q, 1.5); }
  static double slope(double q) { return 3 * q / (1 - q * q) * damping(q); }
  static double spring(double t) { return 2 + std::sin(3 * t); }

  static void rate(const State& x, State& dxdt, double t) {
    if (!(std::abs(x[0]) < 1)) throw std::domain_error("beyond the wall");
    dxdt = {x[1], 30 * std::cos(2 * t) - spring(t) * x[0] - damping(x[0]) * x[1]};
  }
  static void jacobian(const State& x, Eigen::Matrix2d& j, double t) {
    j << 0, 1, -spring(t) - slope(x[0]) * x[1], -damping(x[0]);
  }
  void force_part(const State& x, Eigen::Matrix2d& j, double) const {
    const double not_to_be_read = std::numeric_limits<double>::quiet_NaN();
    j << not_to_be_read, not_to_be_read, -share * slope(x[0]) * x[1], -share * damping(x[0]);
  }
};

/// What RadauIIA takes, with the film's part and without.
auto plain(const Squeezed&) {
  return std::make_pair([](const auto& x, auto& dxdt, double t) { Squeezed::rate(x, dxdt, t); },
                        [](const auto& x, auto& j, double t) { Squeezed::jacobian(x, j, t); });
}
auto with_part(const Squeezed& film, bool has_one = true) {
  const auto rate = plain(film).first;
  const auto jacobian = plain(film).second;
  const auto part = [film](const auto& x, auto& j, double t) { film.force_part(x, j, t); };
  const auto has = [has_one] { return has_one; };
  struct Parts {
    decltype(rate) first;
    decltype(jacobian) second;
    decltype(part) force_part;
    decltype(has) has_force_part;
  };
  return Parts{rate, jacobian, part, has};
}

struct Run {
  Squeezed::State end;
  StepperCounts counts;
};

template <int Stages, class System>
Run run(const System& system, double tolerance, bool looks_inside = false) {
  RadauIIA<double, 2, Stages> stepper(tolerance, {tolerance, tolerance});
  stepper.use_absolute_tolerance_only();
  Squeezed::State x{0, 0};
  double t = 0;
  double dt = 1e-6;
  while (t < 10) {
    dt = std::min(dt, 10 - t);
    if (stepper.try_step(system, x, t, dt) == odeint::fail || !looks_inside) continue;
    Squeezed::State inside;
    Squeezed::State slope;
    REQUIRE(stepper.middle(system, inside, slope));
    Squeezed::State rate;
    Squeezed::rate(inside, rate, t);
    CHECK(std::abs(slope[0] - inside[1]) < 1e-3);  // q̇ = v there, to what the iterations leave
  }
  return {x, stepper.counts()};
}

/// ∂f/∂x of equations of motion with some work, q̇ = v and the rows of v̇ and of work at random.
Eigen::MatrixXd some_jacobian(Eigen::Index m, Eigen::Index works, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  Eigen::MatrixXd j = Eigen::MatrixXd::Zero(2 * m + works, 2 * m + works);
  for (Eigen::Index i = 0; i < m; ++i) j(i, m + i) = 1;
  for (Eigen::Index i = m; i < j.rows(); ++i) {
    for (Eigen::Index k = 0; k < 2 * m; ++k) j(i, k) = (k < m ? 1e4 : 1e2) * number(random);
  }
  return j;
}

/// |Σ_j (A⁻¹)_ij x_j/h − J_i x_i − r_i| of the largest row, in |r|.
template <int N, int Stages>
double stage_defect(Eigen::Index m, Eigen::Index works, std::mt19937& random) {
  using Solver = StageSolver<double, N, Stages>;
  const auto& a_inverse = RadauTableau<double, Stages>::instance().a_inverse;
  const Eigen::Index n = 2 * m + works;
  const double h = 0.01;
  const typename Solver::Matrix rest = some_jacobian(m, works, random);
  typename Solver::Jacobians own;
  typename Solver::AllStages r;
  for (auto& each : own) {
    each = some_jacobian(m, works, random);
    each.topRows(m).setConstant(std::numeric_limits<double>::quiet_NaN());  // not to be read, as the rows of work
    each.bottomRows(works).setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  for (auto& each : r) each = Eigen::VectorXd::Random(n);
  typename Solver::AllStages x = r;
  Solver solver;
  solver.factorise(rest, own, m, h);
  solver.solve_in_place(x);
  double largest = 0;
  typename Solver::Vector filtered = r[0];
  solver.filter(r[0], filtered);
  for (int i = 0; i < Stages; ++i) {
    const auto at = static_cast<std::size_t>(i);
    Eigen::MatrixXd whole = rest;
    whole.middleRows(m, m) += own[at].middleRows(m, m);
    if (i == Stages / 2) {
      const Eigen::VectorXd left = RadauTableau<double, Stages>::instance().gamma / h * filtered - whole * filtered;
      largest = std::max(largest, (left - r[0]).cwiseAbs().maxCoeff());
    }
    Eigen::VectorXd defect = -(whole * x[at]) - r[at];
    for (int j = 0; j < Stages; ++j) defect += a_inverse(i, j) / h * x[static_cast<std::size_t>(j)];
    largest = std::max(largest, defect.cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace

TEST_CASE("radau tableau: A takes powers to their integrals up to each abscissa, and A⁻¹ back") {
  const auto check = []<int Stages>(std::integral_constant<int, Stages>) {
    const auto& tab = RadauTableau<double, Stages>::instance();
    for (int k = 0; k < Stages; ++k) {
      const Eigen::Matrix<double, Stages, 1> powers = tab.c.array().pow(k);
      const Eigen::Matrix<double, Stages, 1> integrals = tab.c.array().pow(k + 1) / (k + 1);
      CHECK((tab.a * powers - integrals).cwiseAbs().maxCoeff() < 2e-16);          // a unit of rounding of 1
      CHECK((tab.a_inverse * integrals - powers).cwiseAbs().maxCoeff() < 2e-14);  // A⁻¹ has elements up to 40
    }
  };
  check(std::integral_constant<int, 3>());
  check(std::integral_constant<int, 5>());
}

TEST_CASE(
    "radau stages: the solver's increments fulfil the equations of all stages, works among them, and the filter its "
    "own") {
  std::mt19937 random(1);
  // Of right sides of 1; the increments' terms are up to 1e4 of it, and so is the condition.
  for (int trial = 0; trial < 10; ++trial) {
    CHECK((stage_defect<4, 3>(2, 0, random)) < 1e-9);
    CHECK((stage_defect<4, 5>(2, 0, random)) < 1e-9);
    for (const Eigen::Index works : {0, 3}) {
      CHECK((stage_defect<Eigen::Dynamic, 3>(1, works, random)) < 1e-9);
      CHECK((stage_defect<Eigen::Dynamic, 5>(4, works, random)) < 1e-9);
    }
  }
}

TEST_CASE("radau stages: with a part of the Jacobian for each stage the motion is the same, for less") {
  const auto check = []<int Stages>(std::integral_constant<int, Stages>) {
    CAPTURE(Stages);
    const Squeezed film;
    const Squeezed::State exact = run<8 - Stages>(plain(film), 1e-12).end;  // by the other method
    for (const double tolerance : {1e-5, 1e-8}) {
      CAPTURE(tolerance);
      const Run one = run<Stages>(plain(film), tolerance);
      const Run own = run<Stages>(with_part(film), tolerance);
      CHECK(distance(one.end, exact) < 20 * tolerance);  // what a thousand steps sum up to
      CHECK(distance(own.end, exact) < 20 * tolerance);
      CHECK(own.counts.newton_iterations < one.counts.newton_iterations);
      CHECK(own.counts.jacobians < one.counts.jacobians / 5);
      // A system that says that it has none is as one that knows of none.
      const Run none = run<Stages>(with_part(film, false), tolerance);
      CHECK(none.end == one.end);
      CHECK(none.counts.newton_iterations == one.counts.newton_iterations);
      // The part serves iterations alone: a wrong one takes more of them, and finds the same.
      const Run wrong = run<Stages>(with_part(Squeezed{0.7}), tolerance);
      CHECK(distance(wrong.end, exact) < 20 * tolerance);
      CHECK(wrong.counts.newton_iterations > own.counts.newton_iterations);
      // A look inside changes nothing.
      const Run looked_at = run<Stages>(with_part(film), tolerance, true);
      CHECK(looked_at.end == own.end);
      CHECK(looked_at.counts.newton_iterations == own.counts.newton_iterations);
    }
  };
  check(std::integral_constant<int, 3>());
  check(std::integral_constant<int, 5>());
}

}  // namespace radau_stages_test

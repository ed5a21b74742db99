#include <catch2/catch.hpp>

#include "lubjoint/ode/radau_iia.hpp"
#include "support/initial_value_problems.hpp"

namespace radau_test {

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

/// A of s stages from its definition: it integrates powers below s from 0 to each abscissa.
template <class R, int Stages>
Eigen::Matrix<R, Stages, Stages> collocation_matrix() {
  const auto& c = RadauTableau<R, Stages>::instance().c;
  Eigen::Matrix<R, Stages, Stages> powers;
  Eigen::Matrix<R, Stages, Stages> integrals;
  for (int i = 0; i < Stages; ++i) {
    R power(1);
    for (int k = 0; k < Stages; ++k) {
      powers(i, k) = power;
      power *= c(i);
      integrals(i, k) = power / R(k + 1);
    }
  }
  return integrals * powers.inverse();
}

template <class R, int Stages>
double tableau_defect(const Eigen::Matrix<R, Stages, Stages>& a) {
  const auto& tab = RadauTableau<R, Stages>::instance();
  Eigen::Matrix<R, Stages, Stages> blocks = Eigen::Matrix<R, Stages, Stages>::Zero();
  blocks(0, 0) = tab.gamma;
  for (std::size_t pair = 0; pair < tab.alpha.size(); ++pair) {
    const auto first = static_cast<Eigen::Index>(2 * pair + 1);
    blocks.template block<2, 2>(first, first) << tab.alpha[pair], -tab.beta[pair], tab.beta[pair], tab.alpha[pair];
  }
  const Eigen::Matrix<R, Stages, Stages> defect = tab.t_inverse * a.inverse() * tab.t - blocks;
  return static_cast<double>(defect.norm() / std::numeric_limits<R>::epsilon());
}

/// A controlled run to the end of the problem; error and accepted steps.
template <int Stages, class R, class Problem>
std::pair<double, double> controlled_run(const Problem& problem, const R& tolerance) {
  using State = typename Problem::State;
  State absolute;
  absolute.fill(tolerance);
  RadauIIA<R, Problem::dimension, Stages> stepper(tolerance, absolute);
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
template <int Stages, class Problem>
double fixed_step_error(const Problem& problem, int steps, double* inside = nullptr) {
  using State = typename Problem::State;
  State absolute;
  absolute.fill(1e20);
  RadauIIA<double, Problem::dimension, Stages> stepper(0.5, absolute);
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
  // Rounding of an inverse and two products, condition number 30.
  CHECK(tableau_defect<double, 3>(printed_matrix<double>()) < 500);
  CHECK(tableau_defect<long double, 3>(printed_matrix<long double>()) < 500);
  // Of the matrix of powers of the abscissae, too, condition number 2000, and of its inverse.
  CHECK(tableau_defect<double, 3>(collocation_matrix<double, 3>()) < 1000);
  CHECK(tableau_defect<double, 5>(collocation_matrix<double, 5>()) < 20000);
  CHECK(tableau_defect<long double, 5>(collocation_matrix<long double, 5>()) < 20000);
}

TEST_CASE("radau tableau: the last row of A is a quadrature that is exact below degree 2s − 1, and not beyond") {
  const auto miss = []<int Stages>(std::integral_constant<int, Stages>, int degree) {
    const auto a = collocation_matrix<long double, Stages>();
    const auto& c = RadauTableau<long double, Stages>::instance().c;
    long double sum = 0;
    for (int i = 0; i < Stages; ++i) sum += a(Stages - 1, i) * std::pow(c(i), static_cast<long double>(degree));
    return static_cast<double>(std::abs(sum - 1.0L / (degree + 1)));
  };
  for (int degree = 0; degree < 5; ++degree) CHECK(miss(std::integral_constant<int, 3>(), degree) < 1e-17);  // rounding
  for (int degree = 0; degree < 9; ++degree) CHECK(miss(std::integral_constant<int, 5>(), degree) < 1e-16);  // rounding
  // ∫M²x/(x − 1)-like remainders: those of x⁵ and x⁹.
  CHECK(miss(std::integral_constant<int, 3>(), 5) > 1e-4);
  CHECK(miss(std::integral_constant<int, 5>(), 9) > 1e-6);
}

TEST_CASE("radau tableau: the abscissae are the roots of d²/dx² x²(x − 1)³, and the eigenvalues those of A⁻¹") {
  const auto& tab = RadauTableau<double, 3>::instance();
  for (int i = 0; i < 3; ++i) {
    const double c = tab.c(i);
    CHECK(std::abs(2 * (c - 1) * (10 * c * c - 8 * c + 1)) < 1e-15);     // rounding; half the second derivative
    CHECK(std::abs(printed_matrix<double>().row(i).sum() - c) < 1e-15);  // rounding; Σ_j a_ij = c_i
  }
  for (const std::complex<double> z : {std::complex<double>(tab.gamma, 0), {tab.alpha[0], tab.beta[0]}}) {
    // det(zI − A⁻¹) = z³ − 9z² + 36z − 60, from the denominator 1 − 3z/5 + 3z²/20 − z³/60 of the stability function
    CHECK(std::abs(((z - 9.0) * z + 36.0) * z - 60.0) < 1e-12);  // rounding of terms of size 200
  }
  CHECK(tab.beta[0] > 0);
  const auto& more = RadauTableau<double, 5>::instance();
  for (const std::complex<double> z :
       {std::complex<double>(more.gamma, 0), {more.alpha[0], more.beta[0]}, {more.alpha[1], more.beta[1]}}) {
    // From the denominator Σ binomial(5, j) (9 − j)!/9! (−z)ʲ.
    CHECK(std::abs(((((z - 25.0) * z + 300.0) * z - 2100.0) * z + 8400.0) * z - 15120.0) < 1e-9);  // of terms of 1e5
  }
  CHECK(more.beta[0] > 0);
  CHECK(more.beta[1] > 0);
}

TEST_CASE("radau: observed order 5 against accepted steps on an autonomous nonlinear problem") {
  std::vector<double> steps;
  std::vector<double> error;
  for (const long double tolerance : {1e-6L, 1e-8L, 1e-10L, 1e-12L, 1e-14L}) {
    const auto run = controlled_run<3, long double>(Logistic<long double>(), tolerance);
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
    const auto run = controlled_run<3, long double>(Driven<long double>(), tolerance);
    steps.push_back(run.second);
    error.push_back(run.first);
  }
  const double order = observed_order(steps, error);
  INFO("order " << order);
  CHECK(order > 4.7);  // as above
  CHECK(order < 5.5);  // as above
}

TEST_CASE("radau: observed order 9 against accepted steps, autonomous and not") {
  const auto order_of = [](const auto& problem) {
    std::vector<double> steps;
    std::vector<double> error;
    for (const long double tolerance : {1e-11L, 1e-12L, 1e-13L, 1e-14L, 3e-15L, 1e-15L, 3e-16L, 1e-16L, 3e-17L}) {
      const auto run = controlled_run<5, long double>(problem, tolerance);
      steps.push_back(run.second);
      error.push_back(run.first);
      CHECK(run.first < 10 * static_cast<double>(tolerance));  // the promise: error of the order of the tolerance
    }
    return observed_order(steps, error);
  };
  for (const double order : {order_of(Logistic<long double>()), order_of(Driven<long double>())}) {
    INFO("order " << order);
    CHECK(order > 8.3);   // 9, less what the controller scatters over four decades of error
    CHECK(order < 10.7);  // the same, and what is left of the start: a few of twenty steps
  }
}

TEST_CASE(
    "radau: observed order 2s − 1 with fixed steps on a linear non-autonomous problem, s or more between the steps") {
  const auto check = []<int Stages>(std::integral_constant<int, Stages>, int few, double at_least, double at_most) {
    double coarse_inside = 0;
    double fine_inside = 0;
    const double coarse = fixed_step_error<Stages>(ProtheroRobinson<double>{-1}, few, &coarse_inside);
    const double fine = fixed_step_error<Stages>(ProtheroRobinson<double>{-1}, 4 * few, &fine_inside);
    const double order = std::log(coarse / fine) / std::log(4);
    const double inside = std::log(coarse_inside / fine_inside) / std::log(4);
    INFO("order " << order << ", inside " << inside);
    CHECK(order > at_least);
    CHECK(order < at_most);
    CHECK(inside > Stages);  // the collocation polynomial
    CHECK(fine_inside > fine);
  };
  check(std::integral_constant<int, 3>(), 4, 4.8, 5.5);  // 5 as the step goes to 0
  check(std::integral_constant<int, 5>(), 1, 8.6, 9.6);  // 9, likewise
}

TEST_CASE("radau: a step that is let end inside is the shorter step, and a look inside changes nothing") {
  const auto check = []<int Stages>(std::integral_constant<int, Stages>) {
    using Stepper = RadauIIA<double, 2, Stages>;
    using State = std::array<double, 2>;
    const auto system = odeint_system<double>(Driven<double>());
    const auto begin = [&](Stepper& stepper, State& x, double& t) {
      double dt = 0.4;
      x = Driven<double>::exact(0.5);
      t = 0.5;
      REQUIRE(stepper.try_step(system, x, t, dt) == odeint::success);
      return dt;
    };
    const State tolerances{1e-3, 1e-3};
    State x;
    double t;
    Stepper looked_at(1e-3, tolerances);
    State inside{};
    State slope{};
    CHECK_FALSE(looked_at.middle(system, inside, slope));  // no step yet
    double dt = begin(looked_at, x, t);
    State one{};
    State between{};
    Stepper short_step(1e-3, tolerances);
    State y = Driven<double>::exact(0.5);
    double s = 0.5;
    double ds = (t - 0.5) / 2;
    REQUIRE(short_step.try_step(system, y, s, ds) == odeint::success);
    REQUIRE(looked_at.middle(system, inside, slope));
    State rate{};
    Driven<double>::rate(inside, rate, s);
    CHECK(distance(rate, slope) < 1e-4);  // as is the state below, over a fifth of a second
    looked_at.state_at(s, between);
    // Both to what Newton's iterations leave, 0.03 of 0.1 τ^{2/3} or of 0.1 τ^{3/5}; the polynomial is further off.
    CHECK(distance(inside, y) < 1e-4);
    CHECK(distance(inside, Driven<double>::exact(s)) < distance(between, Driven<double>::exact(s)) / 10);
    const auto counts = looked_at.counts();
    // The next step is, bit by bit, the one that nobody has looked before.
    Stepper plain(1e-3, tolerances);
    double d_plain = begin(plain, one, t);
    CHECK(counts.newton_iterations == plain.counts().newton_iterations);
    double t_plain = t;
    REQUIRE(plain.try_step(system, one, t_plain, d_plain) == odeint::success);
    REQUIRE(looked_at.try_step(system, x, t, dt) == odeint::success);
    CHECK(t == t_plain);
    CHECK(x == one);
    CHECK(dt == d_plain);
    // Let end inside, it goes on from there.
    Stepper cut(1e-3, tolerances);
    begin(cut, x, t);
    REQUIRE(cut.end_at(system, s, x));
    CHECK(x == inside);  // half of the step, by the same iterations
    t = s;
    double rest = 0.2;
    REQUIRE(cut.try_step(system, x, t, rest) == odeint::success);
    CHECK(t == s + 0.2);
    CHECK(distance(x, Driven<double>::exact(t)) < 1e-3);  // the tolerance
    cut.reset();
    CHECK_FALSE(cut.middle(system, inside, slope));
  };
  check(std::integral_constant<int, 3>());
  check(std::integral_constant<int, 5>());
}

TEST_CASE(
    "radau: a step whose error will be too large is left at once, and the next starts from its stages and is the "
    "same") {
  const auto check = []<int Stages>(std::integral_constant<int, Stages>) {
    using Stepper = RadauIIA<double, 2, Stages>;
    using State = std::array<double, 2>;
    const auto system = odeint_system<double>(Driven<double>());
    const State tolerances{1e-8, 1e-8};
    const auto begin = [&](Stepper& stepper, State& x, double& t) {
      x = Driven<double>::exact(0.5);
      t = 0.5;
      double dt = 0.05;
      REQUIRE(stepper.try_step(system, x, t, dt) == odeint::success);
    };
    State x;
    double t;
    Stepper retried(1e-8, tolerances);
    begin(retried, x, t);
    double dt = 0.8;
    const auto iterations_of_try = [&] {
      const std::size_t before = retried.counts().newton_iterations;
      retried.try_step(system, x, t, dt);
      return retried.counts().newton_iterations - before;
    };
    CHECK(iterations_of_try() == 3);  // which say that it is in vain: of order 5 they would go on to 8, of order 9 to 6
    REQUIRE(retried.counts().rejected == 1);
    double h = 0;
    std::size_t of_retry = 0;
    while (retried.counts().accepted == 1) {
      CHECK(dt != h / 2);  // which would say that Newton's iterations do not converge
      h = dt;
      of_retry = iterations_of_try();
    }

    Stepper fresh(1e-8, tolerances);
    State y;
    double s;
    begin(fresh, y, s);
    fresh.reset();
    double ds = h;
    const std::size_t before = fresh.counts().newton_iterations;
    REQUIRE(fresh.try_step(system, y, s, ds) == odeint::success);
    const std::size_t from_nothing = fresh.counts().newton_iterations - before;
    INFO(of_retry << " iterations, from nothing " << from_nothing);
    CHECK(t == s);
    CHECK(of_retry <= 3);
    CHECK(of_retry < from_nothing);
    CHECK(distance(x, y) < 1e-9);  // what Newton's iterations may leave of 0.1 τ^{2/3} or 0.1 τ^{3/5}
  };
  check(std::integral_constant<int, 3>());
  check(std::integral_constant<int, 5>());
}

TEST_CASE("radau: a stiff problem costs no more steps than a mild one, and stays on its solution") {
  const auto check = []<int Stages>(std::integral_constant<int, Stages>) {
    const auto mild = controlled_run<Stages, double>(ProtheroRobinson<double>{-1}, 1e-8);
    const auto stiff = controlled_run<Stages, double>(ProtheroRobinson<double>{-1e6}, 1e-8);
    CHECK(stiff.second <= 2 * mild.second);
    CHECK(stiff.first < 1e-7);                                                    // ten times the tolerance
    CHECK(fixed_step_error<Stages>(ProtheroRobinson<double>{-1e6}, 20) < 1e-10);  // h⁴/|λ| at most: 1e-4/1e6
  };
  check(std::integral_constant<int, 3>());
  check(std::integral_constant<int, 5>());
}

TEST_CASE(
    "radau: the Jacobian is that of the guessed middle stage, or of the start where there is no guess or no film") {
  // y' = −λ(t) (y − cos t), λ = 100/(1.1 − t)²: in steps of a tenth of what is left λ grows by a quarter.
  using State = std::array<double, 1>;
  const auto rate_of = [](double t) { return 100 / ((1.1 - t) * (1.1 - t)); };
  const auto f = [&](const State& x, State& dxdt, double t) { dxdt = {-rate_of(t) * (x[0] - std::cos(t))}; };
  struct Run {
    std::vector<double> shares;  ///< of the step, at which the Jacobian was
    std::size_t iterations = 0;
    double error = 0;
  };
  const auto run = [&]<int Stages>(std::integral_constant<int, Stages>, bool has_no_middle) {
    RadauIIA<double, 1, Stages> stepper(1e-4, {1e-4});
    State x{1};
    double t = 0;
    Run result;
    for (int i = 0; i < 20; ++i) {
      const double start = t;
      const double h = (1.1 - t) / 10;
      const auto j = [&](const State&, auto& m, double when) {
        if (has_no_middle && when > start) throw std::domain_error("beyond the wall");
        result.shares.push_back((when - start) / h);
        m << -rate_of(when);
      };
      double dt = h;
      REQUIRE(stepper.try_step(std::make_pair(f, j), x, t, dt) == odeint::success);
    }
    result.iterations = stepper.counts().newton_iterations;
    result.error = std::abs(x[0] - std::cos(t));
    return result;
  };
  const auto check = [&]<int Stages>(std::integral_constant<int, Stages> stages, double middle) {
    const Run ahead = run(stages, false);
    const Run behind = run(stages, true);
    INFO(ahead.iterations << " iterations, with the start's Jacobians " << behind.iterations);
    REQUIRE(ahead.shares.size() > 10);
    CHECK(ahead.shares[0] == 0);
    for (std::size_t i = 1; i < ahead.shares.size(); ++i)
      CHECK(ahead.shares[i] == Approx(middle).epsilon(1e-12));  // rounding of a time
    CHECK(behind.shares == std::vector<double>(behind.shares.size(), 0.0));
    CHECK(10 * (ahead.shares.size() + ahead.iterations) < 9 * (behind.shares.size() + behind.iterations));
    CHECK(ahead.error < 1e-3);  // ten tolerances
    CHECK(behind.error < 1e-3);
  };
  check(std::integral_constant<int, 3>(), (4 + std::sqrt(6)) / 10);
  check(std::integral_constant<int, 5>(), RadauTableau<double, 5>::instance().c(2));
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
    // A wall comes nearer than any step: the end of one is not evaluated, and beyond it by no more than what Newton's
    // iterations leave.
    for (int i = 0; i < 200; ++i) stepper.try_step(std::make_pair(f, j), x, t, dt);
    CHECK(x[0] < 1 + 1.1e-7);  // √τ of √3 (τ + τ|x|), a stage's share of the norm, with the estimate's τ = 1e-5
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

TEST_CASE("radau: an iteration evaluates each stage, the start of a motion its rate, and the end of a step nothing") {
  int evaluations = 0;
  const auto f = [&](const std::array<double, 1>& x, std::array<double, 1>& dxdt, double) {
    ++evaluations;
    dxdt = {-x[0] * x[0]};
  };
  const auto j = [](const std::array<double, 1>& x, auto& m, double) { m << -2 * x[0]; };
  RadauIIA5<double, 1> stepper(1e-6, {1e-6});
  std::array<double, 1> x{1};
  double t = 0;
  double dt = 1e-3;
  for (int i = 0; i < 20; ++i) REQUIRE(stepper.try_step(std::make_pair(f, j), x, t, dt) == odeint::success);
  CHECK(evaluations == 1 + 3 * static_cast<int>(stepper.counts().newton_iterations));
  CHECK(x[0] == Approx(1 / (1 + t)).epsilon(1e-5));  // a few tolerances
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
  const auto run = controlled_run<3, long double>(Logistic<long double>(), 1e-18L);
  CHECK(run.first < 1e-16);  // double: 2e-16 a step and hundreds of steps
}

}  // namespace radau_test

#include "lubjoint/dynamics/steppers.hpp"

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/integrate/integrate_const.hpp>
#include <catch2/catch.hpp>

#include "support/initial_value_problems.hpp"

using namespace lubjoint;
using namespace lubjoint::test;
namespace odeint = boost::numeric::odeint;

namespace {

using Problem = Driven<double>;
using State = Problem::State;

/// Fixed steps of a stepper of the library: tolerances so large that every step is accepted.
template <class Stepper, class System>
double fixed_step_error(int steps, double* inside = nullptr) {
  Stepper stepper(0.5, {1e20, 1e20});
  System system;
  State x = System::exact(0);
  double t = 0;
  for (int i = 0; i < steps; ++i) {
    double dt = System::duration / steps;
    const double t_old = t;
    REQUIRE(stepper.try_step(system, x, t, dt));
    if (inside == nullptr) continue;
    State between;
    const double at = t_old + 0.4 * (t - t_old);
    stepper.state_at(system, at, between);
    *inside = std::max(*inside, distance(between, System::exact(at)));
  }
  return distance(x, System::exact(t));
}

template <class Stepper, class System>
void check_order(double order, int coarse_steps) {
  double coarse_inside = 0;
  double fine_inside = 0;
  const double coarse = fixed_step_error<Stepper, System>(coarse_steps, &coarse_inside);
  const double fine = fixed_step_error<Stepper, System>(2 * coarse_steps, &fine_inside);
  const double observed = std::log2(coarse / fine);
  INFO("observed " << observed << ", inside " << std::log2(coarse_inside / fine_inside));
  CHECK(observed > order - 0.5);  // the order as the step goes to 0, from steps of finite length
  CHECK(observed < order + 1.5);  // the same; a problem may be kinder than the general one
  CHECK(std::log2(coarse_inside / fine_inside) > order - 1);  // the state inside is one step of the same method
}

RadauIIA5<double, 2> radau() { return RadauIIA5<double, 2>(1e-9, {1e-9, 1e-9}); }

constexpr double allowed = 1e-8;  // ten times the tolerance of 1e-9

}  // namespace

TEST_CASE("dopri5: observed order 5, autonomous and not, at the steps and inside them") {
  check_order<Dopri5<2>, Logistic<double>>(5, 40);
  check_order<Dopri5<2>, Driven<double>>(5, 40);
}

TEST_CASE("fehlberg78: observed order 8, autonomous and not, at the steps and inside them") {
  check_order<Fehlberg78<2>, Logistic<double>>(8, 6);
  check_order<Fehlberg78<2>, Driven<double>>(8, 12);
}

TEST_CASE("radau runs in Odeint's integrate_adaptive and ends at the end") {
  State x = Problem::exact(0);
  double last = 0;
  const std::size_t steps = odeint::integrate_adaptive(radau(), odeint_system<double>(Problem()), x, 0.0, 3.0, 1e-3,
                                                       [&](const State&, double t) { last = t; });
  CHECK(last == Approx(3).epsilon(1e-15));  // rounding of the last step
  CHECK(distance(x, Problem::exact(3)) < allowed);
  CHECK(steps > 5);
}

TEST_CASE("radau runs in Odeint's integrate_const and is observed at every multiple of the interval") {
  State x = Problem::exact(0);
  int observed = 0;
  double worst = 0;
  odeint::integrate_const(radau(), odeint_system<double>(Problem()), x, 0.0, 3.0, 0.25, [&](const State& y, double t) {
    CHECK(t == 0.25 * observed);
    worst = std::max(worst, distance(y, Problem::exact(t)));
    ++observed;
  });
  CHECK(observed == 13);
  CHECK(worst < allowed);
}

TEST_CASE("radau with dense output runs in Odeint's integrate_const, its samples inside the steps good to order 3") {
  std::vector<double> steps;
  std::vector<double> error;
  for (const double tolerance : {1e-5, 1e-9, 1e-12}) {
    State x = Problem::exact(0);
    double worst = 0;
    int observed = 0;
    const RadauIIA5Dense<double, 2> dense{RadauIIA5<double, 2>(tolerance, {tolerance, tolerance})};
    const std::size_t count = odeint::integrate_const(dense, odeint_system<double>(Problem()), x, 0.0, 3.0, 0.01,
                                                      [&](const State& y, double t) {
                                                        worst = std::max(worst, distance(y, Problem::exact(t)));
                                                        ++observed;
                                                      });
    CHECK(observed >= 300);
    steps.push_back(static_cast<double>(count));
    error.push_back(worst);
    CHECK(worst < 10 * std::pow(tolerance, 2.0 / 3));  // the embedded estimate's tolerance
  }
  CHECK(observed_order(steps, error) > 3);  // a cubic polynomial: 4 for its error, at least 3
}

TEST_CASE("radau with dense output runs in Odeint's integrate_adaptive") {
  State x = Problem::exact(0);
  const RadauIIA5Dense<double, 2> dense(radau());
  odeint::integrate_adaptive(dense, odeint_system<double>(Problem()), x, 0.0, 3.0, 1e-3);
  CHECK(distance(x, Problem::exact(3)) < allowed);
}

TEST_CASE("radau with dense output gives up with a message where no step succeeds") {
  const auto f = [](const std::array<double, 1>& x, std::array<double, 1>& dxdt, double) {
    if (x[0] >= 1) throw std::domain_error("beyond the wall");
    dxdt = {1};
  };
  const auto j = [](const std::array<double, 1>&, auto& m, double) { m << 0; };
  RadauIIA5Dense<double, 1> dense(RadauIIA5<double, 1>(1e-6, {1e-6}));
  dense.initialize({1 - 1e-3}, 1.0, 1.0);
  const auto run = [&] {
    for (int i = 0; i < 1000; ++i) dense.do_step(std::make_pair(f, j));
  };
  CHECK_THROWS_WITH(run(), Catch::Contains("step length has shrunk"));
  CHECK(dense.current_state()[0] < 1);
}

TEST_CASE("a rate outside its domain rejects an explicit step and halves it, and the state stays") {
  struct Wall {
    void rate(const State& x, State& dxdt, double) const {
      if (x[0] >= 1) throw std::domain_error("beyond the wall");
      dxdt = {1, 0};
    }
  } wall;
  const auto check = [&wall](auto stepper) {
    State x{0.5, 0};
    double t = 0;
    double dt = 1;
    CHECK_FALSE(stepper.try_step(wall, x, t, dt));
    CHECK(x == State{0.5, 0});
    CHECK(t == 0);
    CHECK(dt == 0.5);
    dt = 0.25;
    CHECK(stepper.try_step(wall, x, t, dt));
    CHECK(x[0] == Approx(0.75).epsilon(1e-15));  // rounding
  };
  check(Dopri5<2>(1e-6, {1e-6, 1e-6}));
  check(Fehlberg78<2>(1e-6, {1e-6, 1e-6}));
}

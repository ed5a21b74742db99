#include "lubjoint/ode/integrators.hpp"

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/integrate/integrate_const.hpp>
#include <catch2/catch.hpp>

#include "lubjoint/ode/radau_iia5_dense.hpp"
#include "support/initial_value_problems.hpp"

namespace integrators_test {

using namespace lubjoint;
using namespace lubjoint::test;
namespace odeint = boost::numeric::odeint;

namespace {

using Problem = Driven<double>;
using State = Problem::State;

/// A problem with an exact solution, as the integrators see it. Counts its evaluations.
template <class P>
class ProblemSystem final : public OdeSystem<double, 2> {
 public:
  void rate(const State& y, State& dydt, const double& t) override {
    ++evaluations;
    P::rate(y, dydt, t);
  }
  void jacobian(const State& y, Jacobian& j, const double& t) override { P::jacobian(y, j, t); }
  void time_slope(const State& y, State& slope, const double& t) override { P::time_slope(y, slope, t); }

  double evaluations = 0;
};

std::unique_ptr<Integrator<double, 2>> made(const std::string& name, double tolerance) {
  return make_integrator<2>(name, {tolerance, {tolerance, tolerance}, tolerance});
}

struct ControlledRun {
  double steps;
  double error;
  double evaluations;
};

/// From the start to the end of the problem; largest error at any step.
template <class P>
ControlledRun controlled_run(const std::string& name, double tolerance) {
  ProblemSystem<P> system;
  const auto method = made(name, tolerance);
  State y = P::exact(0);
  double t = 0;
  double dt = 1e-3;
  ControlledRun run{0, 0, 0};
  while (t < P::duration) {
    dt = std::min(dt, P::duration - t);
    REQUIRE(dt > 1e-12);
    if (!method->try_step(system, y, t, dt)) continue;
    ++run.steps;
    run.error = std::max(run.error, distance(y, P::exact(t)));
    if (P::duration - t < 1e-13) break;
  }
  run.evaluations = system.evaluations;
  CHECK(static_cast<double>(method->counts().accepted) == run.steps);
  return run;
}

/// Slope of error against steps. A method with a step control shows its order along a series of tolerances.
template <class P>
double order_of(const std::string& name, double loose, double tight) {
  const ControlledRun coarse = controlled_run<P>(name, loose);
  const ControlledRun fine = controlled_run<P>(name, tight);
  INFO(name << ": " << coarse.steps << " steps, error " << coarse.error << "; " << fine.steps << " steps, error "
            << fine.error);
  CHECK(fine.error < 200 * tight);  // the promise: of the order of the tolerance, over a few hundred steps
  return std::log(coarse.error / fine.error) / std::log(fine.steps / coarse.steps);
}

/// Fixed steps: tolerances so large that every step is accepted.
template <class P>
double fixed_step_error(const std::string& name, int steps) {
  ProblemSystem<P> system;
  const auto method = make_integrator<2>(name, {0.5, {1e20, 1e20}, 0.5});
  State y = P::exact(0);
  double t = 0;
  for (int i = 0; i < steps; ++i) {
    double dt = P::duration / steps;
    REQUIRE(method->try_step(system, y, t, dt));
  }
  return distance(y, P::exact(t));
}

RadauIIA5<double, 2> radau() { return RadauIIA5<double, 2>(1e-9, {1e-9, 1e-9}); }

constexpr double allowed = 1e-8;  // ten times the tolerance of 1e-9

}  // namespace

TEST_CASE("Integrators: observed order of every method of fixed order, autonomous and not") {
  struct Expected {
    const char* name;
    double order;
    int steps;
  };
  for (const Expected& each :
       {Expected{"rosenbrock4", 4, 40}, Expected{"dopri5", 5, 40}, Expected{"fehlberg78", 8, 6}}) {
    const double autonomous = std::log2(fixed_step_error<Logistic<double>>(each.name, each.steps) /
                                        fixed_step_error<Logistic<double>>(each.name, 2 * each.steps));
    const double driven = std::log2(fixed_step_error<Driven<double>>(each.name, 2 * each.steps) /
                                    fixed_step_error<Driven<double>>(each.name, 4 * each.steps));
    INFO(each.name << ": observed " << autonomous << " and, where f depends on time, " << driven);
    // The order as the step goes to 0, from steps of finite length; a problem may be kinder than the general one.
    CHECK(autonomous > each.order - 0.5);
    CHECK(driven > each.order - 0.5);
    CHECK(autonomous < each.order + 1.5);
    CHECK(driven < each.order + 1.5);
  }
  // Radau's stages need a tolerance: its order is seen along a series of them, from some twenty steps on. The step
  // control scatters the error by a factor of 2 either way: 0.6 of an order over five decades of tolerance.
  for (const double observed :
       {order_of<Logistic<double>>("radau_iia5", 1e-7, 1e-12), order_of<Driven<double>>("radau_iia5", 1e-7, 1e-12)}) {
    CHECK(observed > 4.4);
    CHECK(observed < 5.6);
  }
  // Of order 9 double precision sees but ten to thirty steps, a third of them at the start: more than its order.
  for (const double observed :
       {order_of<Logistic<double>>("radau_iia9", 1e-6, 1e-10), order_of<Driven<double>>("radau_iia9", 1e-6, 1e-10)}) {
    CHECK(observed > 8);
  }
  CHECK(2 * controlled_run<Driven<double>>("radau_iia9", 1e-12).steps <
        controlled_run<Driven<double>>("radau_iia5", 1e-12).steps);
}

TEST_CASE("Integrators: methods of variable order gain steadily more per step than any low order") {
  for (const char* name : {"bulirsch_stoer", "adams_bashforth_moulton"}) {
    const double autonomous = order_of<Logistic<double>>(name, 1e-4, 1e-11);
    const double driven = order_of<Driven<double>>(name, 1e-4, 1e-11);
    INFO(name << ": " << autonomous << ", " << driven);
    CHECK(autonomous > 5);  // they choose their order themselves: above 5 at such tolerances
    CHECK(driven > 5);
  }
}

TEST_CASE("Integrators: states of run-time size take the same steps as states of a fixed size") {
  class Sized final : public OdeSystem<double, run_time_size> {
   public:
    void rate(const State& y, State& dydt, const double& t) override {
      std::array<double, 2> d{};
      Problem::rate({y[0], y[1]}, d, t);
      dydt.assign(d.begin(), d.end());
    }
    void jacobian(const State& y, Jacobian& j, const double& t) override {
      j.resize(2, 2);
      Problem::jacobian({y[0], y[1]}, j, t);
    }
    void time_slope(const State& y, State& slope, const double& t) override {
      std::array<double, 2> s{};
      Problem::time_slope({y[0], y[1]}, s, t);
      slope.assign(s.begin(), s.end());
    }
  };
  for (const std::string_view name : method_names()) {
    INFO(name);
    ProblemSystem<Problem> fixed_system;
    Sized sized_system;
    const auto fixed = made(std::string(name), 1e-7);
    const auto sized = make_integrator<run_time_size>(name, {1e-7, {1e-7, 1e-7}, 1e-7});
    State y = Problem::exact(0);
    std::vector<double> z(y.begin(), y.end());
    double t = 0;
    double s = 0;
    double dt = 1e-3;
    double ds = 1e-3;
    for (int i = 0; i < 40; ++i) {
      fixed->try_step(fixed_system, y, t, dt);
      sized->try_step(sized_system, z, s, ds);
    }
    CHECK(t > 0);
    CHECK(s == Approx(t).epsilon(1e-9));  // sums in another order: rounding, carried by the step control
    CHECK(z[0] == Approx(y[0]).epsilon(1e-9));
  }
}

TEST_CASE("Integrators: a rate outside its domain rejects the step, halves it, and the state stays") {
  class Wall final : public OdeSystem<double, 2> {
   public:
    void rate(const State& x, State& dxdt, const double&) override {
      if (x[0] >= 1) throw std::domain_error("beyond the wall");
      dxdt = {1, 0};
    }
    void jacobian(const State&, Jacobian& j, const double&) override { j.setZero(); }
    void time_slope(const State&, State& slope, const double&) override { slope.fill(0); }
  } wall;
  for (const std::string_view name : method_names()) {
    INFO(name);
    const auto method = made(std::string(name), 1e-6);
    const State before{1 - 1e-9, 0};
    State x = before;
    double t = 0;
    double dt = 1;
    // In a first step no state changes by more than its tolerance, or, with stiff methods, a thousandth of its unit.
    const bool is_multistep = name == "bulirsch_stoer" || name == "adams_bashforth_moulton";
    const double allowed_change = 1e-6 * (1 + before[0]);
    const double tried = is_multistep ? allowed_change : is_stiff_integrator(name) ? 1e3 * allowed_change : 1;
    CHECK_FALSE(method->try_step(wall, x, t, dt));
    CHECK(x == before);
    CHECK(t == 0);
    CHECK(dt == Approx(tried / 2).epsilon(1e-12));  // rounding
    dt = 2.5e-10;
    CHECK(method->try_step(wall, x, t, dt));
    CHECK(x[0] == Approx(before[0] + t).epsilon(1e-14));  // rounding; the rate is constant
  }
}

TEST_CASE("Integrators: a name that is not one of theirs is refused") {
  CHECK_THROWS_WITH(made("euler", 1e-6), Catch::Contains("no integrator \"euler\""));
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
  CHECK(dense.current_state()[0] < 1 + 1.1e-7);  // what Newton's iterations leave: as in the test of the stepper
}

}  // namespace integrators_test

#include <catch2/catch.hpp>
#include <functional>

#include "lib/src/multibody_simulation.hpp"
#include "lubjoint/motion/multibody_run.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "support/scenes.hpp"

namespace trial_steps_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

using Method = Integrator<double, run_time_size>;
using State = std::vector<double>;

/// What a run has asked of its integrator.
struct Requests {
  std::vector<double> tried;  ///< lengths of the trial steps
  std::size_t resets = 0;
  std::size_t end_rates = 0;
};

/// Trial steps as a test wants them.
class ScriptedSteps final : public Method {
 public:
  using TrialStep = std::function<bool(System&, State&, double& t, double& dt)>;

  ScriptedSteps(
      TrialStep step, Requests& requests, std::function<void()> on_reset = [] {})
      : step_(std::move(step)), requests_(requests), on_reset_(std::move(on_reset)) {}
  bool try_step(System& system, State& y, double& t, double& dt) override {
    requests_.tried.push_back(dt);
    return step_(system, y, t, dt);
  }
  void reset() override {
    ++requests_.resets;
    on_reset_();
  }
  std::unique_ptr<Method> fresh() const override { return std::make_unique<ScriptedSteps>(*this); }
  bool end_rate(State&) const override {
    ++requests_.end_rates;
    return false;
  }
  std::size_t looks_inside() const override { return 2; }
  /// As an implicit method's, whose samples inside a step are on the interpolant.
  StepperCounts counts() const override {
    StepperCounts made;
    made.jacobians = requests_.tried.size();
    return made;
  }

 private:
  TrialStep step_;
  Requests& requests_;
  std::function<void()> on_reset_;
};

/// A stone thrown at 3 and 2 m/s.
Scene stone() {
  Scene scene;
  scene.name = "stone";
  scene.gravity = {0, -10};
  scene.bodies = {body("stone", 0.3, 2e-3, {1, 4})};
  scene.bodies[0].velocity = {3, 2};
  scene.run.duration = 0.5;
  scene.run.output_interval = 0.1;
  return scene;
}

/// (q, q̇) of the stone.
State thrown(double t) { return {1 + 3 * t, 4 + 2 * t - 5 * t * t, 0, 3, 2 - 10 * t, 0}; }

/// The stone's flight of 0.5 s by trial steps of a test.
struct StoneRun {
  Scene scene = stone();
  detail::PreparedScene prepared = detail::prepare(scene);
  MultibodyOde<double> ode{prepared.system, false};
  Requests requests;
  MultibodyRun<double> run;

  StoneRun(ScriptedSteps::TrialStep step, ConstraintUpkeep upkeep)
      : run(ode, scene.run, std::make_unique<ScriptedSteps>(std::move(step), requests), upkeep) {}
  RunOutcome outcome() { return run.run(prepared.start); }
};

/// A trial step that comes to the stone's place at a time.
ScriptedSteps::TrialStep throw_to(double end) {
  return [end](auto&, State& y, double& t, double&) {
    t = end;
    y = thrown(t);
    return true;
  };
}

/// The shaft of the impact scene in oil alone, so thick that it does not come near the wall.
Scene shaft_in_oil() {
  Scene scene = load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/impact.toml");
  scene.joints[0].contact.reset();
  scene.joints[0].transition.reset();
  scene.joints[0].viscosity = 0.05;
  scene.energy_ledger = false;
  set_tolerance(scene, 1e-8);
  return scene;
}

}  // namespace

TEST_CASE("a trial step that ends beyond the wall is tried again at half its length") {
  const Scene scene = shaft_in_oil();
  const detail::PreparedScene prepared = detail::prepare(scene);
  const StepTolerance<double, run_time_size> tolerance{0, scene_tolerances<double>(scene), 1e-8};
  const auto run_with_fault_at = [&](std::size_t fault, Requests& requests) {
    const auto method = make_integrator<run_time_size>("dopri5", tolerance);
    const auto step = [&](OdeSystem<double, run_time_size>& system, State& y, double& t, double& dt) {
      if (requests.tried.size() != fault) return method->try_step(system, y, t, dt);
      y[0] += 10 * scene.joints[0].clearance;
      t += dt;
      dt *= 3;
      return true;
    };
    MultibodyOde<double> ode(prepared.system, false);
    MultibodyRun<double> run(ode, scene.run, std::make_unique<ScriptedSteps>(step, requests, [&] { method->reset(); }),
                             ConstraintUpkeep::by_accelerations);
    const RunOutcome outcome = run.run(prepared.start);
    return std::pair(outcome, run.state());
  };
  Requests undisturbed;
  const auto [plain, end] = run_with_fault_at(0, undisturbed);
  Requests disturbed;
  const auto [halved, same_end] = run_with_fault_at(20, disturbed);
  REQUIRE(plain.status == RunStatus::finished);
  REQUIRE(halved.status == RunStatus::finished);
  REQUIRE(disturbed.tried.size() > 21);
  CHECK(disturbed.tried[20] == Approx(disturbed.tried[19] / 2).epsilon(1e-9));  // t + dt − t rounds
  CHECK(disturbed.resets == undisturbed.resets + 1);
  CHECK(halved.rejected_steps >= 1);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(std::abs(same_end[i] - end[i]) < 1e-6 * scene.joints[0].clearance);  // a hundred tolerances
  }
}

TEST_CASE("samples inside a step are of the rates at both of its ends, the run's first step too") {
  StoneRun stone(throw_to(0.5), ConstraintUpkeep::by_accelerations);
  CHECK(stone.outcome().steps == 1);
  CHECK(stone.requests.end_rates == 1);  // the method's own, if it has a better one
  REQUIRE(stone.run.recorder().samples().size() == 6);
  for (const MultibodySample& sample : stone.run.recorder().samples()) {
    for (std::size_t i = 0; i < 6; ++i) {
      CHECK(sample.state[i] == Approx(thrown(sample.t)[i]).epsilon(0).margin(1e-13));  // of 4 m: rounding
    }
  }
}

TEST_CASE("a projected state's rate is the method's own, too") {
  StoneRun stone(throw_to(0.5), ConstraintUpkeep::by_projection);
  CHECK(stone.outcome().steps == 1);
  CHECK(stone.requests.end_rates == 2);  // at the step's end, and at the point that it is projected to
}

TEST_CASE("a run that gets on well and then no further is stopped within two windows of trial steps") {
  const auto half_then_hardly = [](auto&, State& y, double& t, double&) {
    t += t == 0 ? 0.25 : 0.5e-12;
    y = thrown(t);
    return true;
  };
  StoneRun stone(half_then_hardly, ConstraintUpkeep::by_accelerations);
  const RunOutcome outcome = stone.outcome();
  CHECK(outcome.status == RunStatus::stopped);
  CHECK_THAT(outcome.message, Contains("stopped at t = 0.25") && Contains("trial steps have brought less than"));
  CHECK(stone.requests.tried.size() < 2 * stall_limit);
}

TEST_CASE("the words of a step limit name what would need fewer") {
  CHECK_THAT(detail::step_limit_words(500, false, 0.5), Contains("500 steps") && Contains("radau_iia5"));
  CHECK_THAT(detail::step_limit_words(500, true, 0.5), Contains("looser relative_tolerance"));
  CHECK_THAT(detail::step_limit_words(500, true, 1e-7), Contains("a film as thin as this"));
  CHECK_THAT(detail::step_limit_words(500, true, -1e-7), Contains("looser relative_tolerance"));  // in contact
}

TEST_CASE("after a start no state changes by more than its tolerance in the first step of an extrapolation") {
  struct Slopes final : OdeSystem<double, run_time_size> {
    void rate(const State&, State& dydt, const double&) override { dydt = {3e-4, -8e-3}; }
    void jacobian(const State&, Jacobian&, const double&) override {}
    void time_slope(const State&, State&, const double&) override {}
  } slopes;
  for (const char* name : {"bulirsch_stoer", "adams_bashforth_moulton"}) {
    INFO(name);
    const auto method = make_integrator<run_time_size>(name, {0, {1e-3, 2e-2}, 1e-3});
    State y{0, 0};
    double t = 0;
    double dt = 1e5;
    REQUIRE(method->try_step(slopes, y, t, dt));
    CHECK(t == Approx(2.5));  // 8e-3 t = 2e-2: the faster in units of its tolerance
    CHECK(y[1] == Approx(-2e-2));
  }
}

}  // namespace trial_steps_test

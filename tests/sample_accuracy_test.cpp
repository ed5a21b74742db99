// How near to the motion samples are, and the warnings of what leaves them further off.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/ode/step_interpolant.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/results/film_resolution.hpp"
#include "support/stress_scenes.hpp"

namespace sample_accuracy_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

TEST_CASE("stress: where a step may change the force by a tenth, a warning says that no digit of it is known") {
  Scene scene = scene_named("journal-clearance-2mm");
  // 5τ/2h of 0.099 and 0.101.
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 0.0396 * 0.5;
  CHECK_FALSE(leaves_no_digit(scene, 0.5));
  CHECK_THAT(resolution_warning(scene, scene.joints.front(), 0.5), !Contains("no digit"));
  scene.run.relative_tolerance = 0.0404 * 0.5;
  CHECK(leaves_no_digit(scene, 0.5));
  CHECK_THAT(resolution_warning(scene, scene.joints.front(), 0.5),
             Contains("no digit of velocities and forces is known") && Contains("Tolerance 1e-04 would resolve it"));
}

TEST_CASE("multibody: on a half film's jump samples have the force of sliding, whatever the integrator") {
  // Slow impact in thin oil: the reference slides for most of its time. One side's force is off by up to 0.4 there.
  Scene scene = with_law(scene_named("impact-slow"), "long_half_eq5");
  scene.integrator = "dopri5";
  const StressReference reference = stored_references().of(scene);
  REQUIRE(reference.whole());
  const MultibodyTrajectory run = simulate_multibody(scene);
  REQUIRE(run.samples.size() == reference.rows.size() + 1);
  std::size_t near = 0;
  for (std::size_t i = 0; i < reference.rows.size(); ++i) {
    const Vector2<double> off = run.samples[i + 1].joints.front().force - reference.rows[i].force;
    if (off.norm() < 5e-3 * reference.force_unit) ++near;  // what tolerances of 1e-6 do to a stiff film
  }
  CHECK(near == reference.rows.size());
  CHECK(!run.slides.empty());
  CHECK(simulate_multibody(with_law(scene, "long_full")).slides.empty());
}

TEST_CASE("multibody: samples inside the long steps of extrapolation are as good as the steps") {
  StressSettings settings = small_settings();
  settings.integrators = {"bulirsch_stoer", "fehlberg78"};
  settings.laws = {"short_full"};
  for (const StressCell& cell : run_stress(cases_named({"impact-slow"}), settings)) {
    INFO(cell.integrator << ": " << cell.message);
    CHECK(cell.status == StressStatus::finished);
    CHECK(cell.deviation.rate.value_or(1) < 5e-5);  // fifty tolerances; 1e-3 by a quintic through a step's ends
  }
}

TEST_CASE("journal: samples inside the long steps of extrapolation are as good as the steps") {
  StressSettings settings = small_settings();
  settings.integrators = {"bulirsch_stoer"};
  settings.laws = {"short_dynamic"};
  const StressCell cell = run_stress(cases_named({"journal-clearance-2mm"}), settings).front();
  CHECK(cell.status == StressStatus::finished);
  CHECK(cell.deviation.place.value_or(1) < 5e-6);  // five tolerances; 1.7e-4 by a quintic through a step's ends
  CHECK(cell.deviation.rate.value_or(1) < 5e-5);   // fifty; 2.1e-3 by the quintic's derivative
}

TEST_CASE("stress: a run further off than its tolerance has warned of that") {
  StressSettings settings = small_settings();
  settings.laws = {"short_full"};
  settings.integrators = {"rosenbrock4"};
  settings.most_steps = 20'000;  // of the references, which are runs of tighter tolerances
  // 1e-6 clearances in a film of 2e-5, and a journal that creeps along the wall.
  const StressCell cell = run_stress(cases_named({"journal-load-1e9N"}), settings).front();
  CHECK(cell.status == StressStatus::coarse);
  CHECK(cell.deviation.over_expected > 1);
  CHECK(cell.deviation.over_warned <= 1);
  CHECK_THAT(cell.message, Contains("of the thinnest film") && Contains("would resolve it"));

  // Of a free journal's two tolerances the coarser one counts, as in `simulate`.
  settings.integrators = {"dopri5"};
  for (const auto tolerance : {&RunSettings::absolute_tolerance, &RunSettings::relative_tolerance}) {
    auto cases = cases_named({"journal-clearance-2mm"});
    cases.front().scene.run.*tolerance = 0.9;
    CHECK_THAT(run_stress(cases, settings).front().message, Contains("tolerance of 9e-01 clearances"));
  }
}

TEST_CASE("stress: samples inside the long steps of stiff runs are as good as the steps") {
  // A film thousands of times faster than the step: the rate at a step's end is the step's error times its eigenvalue.
  StressSettings settings = small_settings();
  settings.integrators = {"radau_iia5", "rosenbrock4"};
  for (const StressCell& cell : run_stress(cases_named({"journal-mass-1e-6kg", "journal-load-1e6N"}), settings)) {
    INFO(cell.scenario << ' ' << cell.law << ' ' << cell.integrator << ": " << cell.message);
    CHECK(cell.status == StressStatus::finished);
    CHECK(cell.deviation.place.value_or(1) < 1e-3);  // a thousand tolerances; 0.01 to 0.7 by the rates themselves
  }
}

TEST_CASE("interpolant: in a short step velocities have their own rounding, not that of places over the step") {
  // q = sin t + 100. The rounding of q over a step of 1e-9 s is 1.4e-5.
  StepInterpolant<std::array<double, 2>> step;
  for (const double length : {1e-9, 1e-5, 0.1}) {
    step.t_old = 0.7;
    step.t_new = 0.7 + length;
    step.y_old = {std::sin(step.t_old) + 100, std::cos(step.t_old)};
    step.y_new = {std::sin(step.t_new) + 100, std::cos(step.t_new)};
    step.rate_old = {std::cos(step.t_old), -std::sin(step.t_old)};
    step.rate_new = {std::cos(step.t_new), -std::sin(step.t_new)};
    for (const double share : {0.1, 0.5, 0.8}) {
      const double t = step.t_old + share * (step.t_new - step.t_old);
      std::array<double, 2> y{};
      step.state_at(t, 1, y);
      INFO(length << ' ' << share);
      // Two roundings of a number above 64; or, of the quintic, h⁶ q⁽⁶⁾ s³(1 − s)³ / 720.
      CHECK(std::abs(y[0] - std::sin(t) - 100) <= std::max(3e-14, std::pow(length, 6) / 46080));
      // A few roundings; or, of its derivative, h⁵ q⁽⁶⁾ / 13000.
      CHECK(std::abs(y[1] - std::cos(t)) <= std::max(5e-16, std::pow(length, 5) / 13000));
    }
  }
}

TEST_CASE("unseen: Fehlberg's estimate misses what happens inside its steps of an impact, and the run says how much") {
  Scene scene = with_law(scene_named("impact-as-shipped"), "long_half");
  const StressReference reference = stored_references().of(scene);
  REQUIRE(reference.whole());
  const auto error = [&](const char* integrator) {
    scene.integrator = integrator;
    const MultibodyTrajectory run = simulate_multibody(scene);
    REQUIRE(run.samples.size() == reference.rows.size() + 1);
    double largest = 0;
    for (std::size_t i = 0; i < reference.rows.size(); ++i) {
      const Vector2<double> place = run.samples[i + 1].joints.front().eccentricity / scene.joints.front().clearance;
      largest = std::max(largest, (place - reference.rows[i].place).norm());
    }
    return largest;
  };
  double thinnest = scene.joints.front().transition->e1 / scene.joints.front().clearance;  // of a run that touches
  const auto warning = [&](const char* integrator) {
    return unseen_warning(scene, scene.joints.front(), integrator, thinnest);
  };
  for (const double tolerance : {1e-6, 1e-8}) {
    scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
    const double unseen = error("fehlberg78");
    CHECK(unseen > 100 * error("dopri5"));  // which sees it
    CHECK(unseen < unseen_error(scene, scene.joints.front(), "fehlberg78", thinnest));
    CHECK_THAT(warning("fehlberg78"), Contains("film and contact change places"));
    CHECK(warning("dopri5").empty());
  }

  thinnest += 1e-6;
  CHECK(warning("fehlberg78").empty());  // of one that does not

  // A kink costs the tightest tolerances alone.
  scene = with_law(scene_named("journal-tolerance-1e-14"), "pinkus_sternlicht");
  CHECK_THAT(warning("fehlberg78"), Contains("kink where the squeeze changes sign"));
  CHECK(warning("radau_iia5").empty());
  scene = with_law(scene, "short_full");
  CHECK(warning("fehlberg78").empty());
}

}  // namespace sample_accuracy_test

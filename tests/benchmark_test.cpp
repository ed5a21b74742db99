// Published problems: the numbers themselves by other means, what runs give, and that a wrong mechanism is seen.
#include "oracle/results/benchmark.hpp"

#include <array>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/numeric/odeint.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/mechanisms/andrews.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"

namespace benchmark_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;
using Json = nlohmann::ordered_json;

namespace {

const std::string data = std::string(LUBJOINT_SOURCE_DIR) + "/data/";
const std::string literature = data + "literature/benchmarks.csv";
const std::string scenes = data + "scenes/benchmarks";

double published(const std::string& problem, const std::string& quantity, double t) {
  for (const CsvRow& row : read_csv(literature)) {
    if (row.at("problem") == problem && row.at("quantity") == quantity && number(row.at("t")) == t)
      return number(row.at("published"));
  }
  FAIL(problem << " " << quantity);
  return 0;
}

constexpr std::array<const char*, 7> angles = {"beta", "Theta", "gamma", "phi", "delta", "Omega", "epsilon"};

/// The end of Andrews' mechanism in extended precision: as good as the tolerance, far beyond doubles.
std::array<long double, 7> andrews_end(long double tolerance) {
  using Mechanism = mechanisms::Andrews<long double>;
  const Mechanism mechanism;
  Mechanism::State y = Mechanism::start({-0.0617138900142764496358948458001L, 0.0L, 0.455279819163070380255912382449L,
                                         0.222668390165885884674473185609L, 0.487364979543842550225598953530L,
                                         -0.222668390165885884674473185609L, 1.23054744454982119249735015568L});
  REQUIRE(mechanism.open(y) < 1e-18L);  // rounding of 0.07 m
  boost::numeric::odeint::integrate_adaptive(
      boost::numeric::odeint::make_controlled(
          tolerance, tolerance, boost::numeric::odeint::runge_kutta_fehlberg78<Mechanism::State, long double>()),
      std::cref(mechanism), y, 0.0L, 0.03L, 1e-5L);
  return Mechanism::relative(y);
}

/// Angle of the N-four-bar's rods from the vertical and its rate: all windows stay parallelograms.
using RodAngle = std::array<double, 2>;

/// The same a time later, by the angle's own equation.
RodAngle rods_later(RodAngle y, double time) {
  const auto rate = [](const RodAngle& at, RodAngle& out, double) { out = {at[1], 7.0 / 6 * 9.81 * std::sin(at[0])}; };
  boost::numeric::odeint::integrate_adaptive(
      boost::numeric::odeint::make_controlled(1e-13, 1e-13, boost::numeric::odeint::runge_kutta_fehlberg78<RodAngle>()),
      rate, y, 0.0, time, 1e-3);
  return y;
}

}  // namespace

TEST_CASE("benchmark: Andrews' mechanism ends where its angles' own equations end, by two integrators") {
  const auto exact = andrews_end(1e-16L);
  const auto coarser = andrews_end(1e-14L);
  for (std::size_t k = 0; k < 7; ++k) CHECK(std::abs(exact[k] - coarser[k]) < 1e-13L);
  Scene scene = load_scene(scenes + "/andrews.toml");
  // Fehlberg's two hundred steps of 1e-13 leave some 1e-12 at 1e3 rad/s, Radau's thousand of 1e-12 2e-10.
  for (const auto& [integrator, tolerance, bound] :
       {std::tuple{"fehlberg78", 1e-13, 1e-11}, std::tuple{"radau_iia5", 1e-12, 5e-10}}) {
    INFO(integrator);
    scene.integrator = integrator;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
    const MultibodyTrajectory run = simulate_multibody(scene);
    REQUIRE(run.outcome.status == RunStatus::finished);
    for (std::size_t k = 0; k < 7; ++k) {
      INFO(angles[k]);
      CHECK(std::abs(run.samples.back().sensors[2 * k] - static_cast<double>(exact[k])) < bound);
    }
  }
}

TEST_CASE(
    "benchmark: the published end of Andrews' mechanism is 1.1e-9 and 1.4e-9 off in the angles that turn, and less "
    "else") {
  const auto exact = andrews_end(1e-16L);
  for (std::size_t k = 0; k < 7; ++k) {
    INFO(angles[k]);
    const double off =
        std::abs(published("andrews", std::string(angles[k]) + ".angle", 0.03) - static_cast<double>(exact[k]));
    if (k < 2) {  // K1 and K2 turn at a thousand radians a second: what the published run's steps have left
      CHECK(off > (k == 0 ? 1.1e-9 : 1.4e-9));
      CHECK(off < (k == 0 ? 1.2e-9 : 1.5e-9));
    } else {
      CHECK(off < 2e-11);
    }
  }
}

TEST_CASE("benchmark: a tighter tolerance brings Andrews' mechanism nearer to its exact end, four decades of error") {
  const auto exact = andrews_end(1e-16L);
  Scene scene = load_scene(scenes + "/andrews.toml");
  double before = 1;
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
    scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
    const double error = std::abs(simulate_multibody(scene).samples.back().sensors[0] - static_cast<double>(exact[0]));
    CHECK(error < before / 10);
    before = error;
  }
}

TEST_CASE("benchmark: published numbers of the pendulum and the N-four-bar are those of their closed equations") {
  const double modulus = std::sqrt(0.5);
  for (const double t : {2.0, 5.0, 10.0}) {
    const double s = modulus * boost::math::jacobi_cd(modulus, std::sqrt(9.81) * t);
    CHECK(std::abs(published("pendulum", "P.x", t) + 2 * s * std::sqrt(1 - s * s)) < 1e-13);  // rounding of 31 rad
    CHECK(std::abs(published("pendulum", "P.y", t) + 1 - 2 * s * s) < 1e-13);
  }
  RodAngle y{0, 1};
  for (const double t : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    y = rods_later(y, 1);
    CHECK(std::abs(published("n-four-bar", "tip.x", t) - std::sin(y[0])) < 5.1e-7);  // half the last digit
    CHECK(std::abs(published("n-four-bar", "tip.y", t) - std::cos(y[0])) < 5.1e-7);
  }
}

TEST_CASE("benchmark: every published number is reached, and energy is kept") {
  const ProgramResult result = lubjoint_program({"benchmark", "--json"});
  INFO(result.err);
  CHECK(result.status == 0);
  const Json rows = Json::parse(result.out);
  CHECK(rows.size() == read_csv(literature).size());
  for (const Json& row : rows) {
    INFO(row.dump());
    CHECK(row["agrees"] == true);
    CHECK(std::abs(row["difference"].get<double>()) <= row["allowed"].get<double>());
    CHECK(row["seconds"].get<double>() > 0);
    CHECK(row["energy_drift"].get<double>() < 1e-7);  // the loosest scene's thousand steps of 1e-8, a tenth kept
    CHECK(row["integrator"].is_string());
  }
}

TEST_CASE("benchmark: a wrong mechanism, a coarse run and one that stops do not agree, and unknown names are refused") {
  const TemporaryFolder folder;
  std::string text = read_text(scenes + "/andrews.toml");
  const std::size_t at = text.find("4530.0");
  REQUIRE(at != std::string::npos);
  folder.write("andrews.toml", text.replace(at, 6, "4530.1"));
  const reports::BenchmarkRun wrong = reports::run_benchmark("andrews", literature, folder / "", std::nullopt);
  CHECK_FALSE(wrong.agrees());
  CHECK(reports::benchmark_text({wrong}).find("  no\n") != std::string::npos);
  const ProgramResult coarse = lubjoint_program({"benchmark", "pendulum", "--rtol", "1e-4"});
  CHECK(coarse.status == 1);
  CHECK_THAT(coarse.out, Contains("  no\n"));
  // At a position where the constraints are not independent, a run ends by name unless the scene says otherwise.
  std::string stopping = read_text(scenes + "/n-four-bar.toml");
  const std::string passes = "singular_positions = \"pass\"\n";
  const std::size_t line = stopping.find(passes);
  REQUIRE(line != std::string::npos);
  folder.write("n-four-bar.toml", stopping.erase(line, passes.size()));
  const reports::BenchmarkRun stopped = reports::run_benchmark("n-four-bar", literature, folder / "", std::nullopt);
  CHECK_FALSE(stopped.agrees());
  CHECK_FALSE(stopped.rows.back().computed);
  CHECK_THAT(stopped.message, Contains("singular position") && Contains("singular_positions = \"pass\""));
  const ProgramResult unknown = lubjoint_program({"benchmark", "andrew"});
  CHECK(unknown.status == 2);
  CHECK_THAT(unknown.err, Contains("the problem is \"andrew\"; allowed is") && Contains("andrews"));
  CHECK(lubjoint_program({"benchmark", "--rtol", "2"}).status == 2);
}

TEST_CASE("benchmark: Andrews' work-precision line: errors fall with the tolerance, down to the published digits") {
  const ProgramResult result = lubjoint_program({"benchmark", "andrews", "--work-precision", "--json"});
  CHECK(result.status == 0);
  const auto points = nlohmann::json::parse(result.out);
  REQUIRE(points.size() == 5 * method_names().size());
  for (std::size_t i = 0; i < points.size(); i += 5) {
    INFO(points[i].dump() << points[i + 3].dump());
    CHECK(points[i]["tolerance"] == 1e-4);
    REQUIRE(points[i]["error"].is_number());  // none has stopped
    REQUIRE(points[i + 3]["error"].is_number());
    // 3e-9: what is wrong of the published angles, twice.
    CHECK(points[i + 3]["error"].get<double>() < 1e-3 * points[i]["error"].get<double>() + 3e-9);
    CHECK(points[i + 3]["steps"] > points[i]["steps"]);
  }
  CHECK(points[4]["error"] < 1.5e-9);  // radau_iia5 at 1e-12: what is wrong of the published angles
  CHECK(lubjoint_program({"benchmark", "andrews", "--work-precision", "--rtol", "1e-6"}).status == 2);
}

TEST_CASE("benchmark: a work-precision line has no error where nothing was compared, or not everything was reached") {
  const auto check_no_errors = [](const std::vector<reports::WorkPrecision>& points) {
    REQUIRE(points.size() == 5 * method_names().size());
    for (const reports::WorkPrecision& point : points) {
      INFO(point.integrator << " " << point.tolerance);
      CHECK_FALSE(point.error);
      CHECK(point.steps > 0);
    }
    for (const auto& each : reports::work_precision_json(points)) CHECK(each["error"].is_null());
  };
  // All that is published of it is a residual of energy.
  check_no_errors(reports::work_precision("andrews-a03", literature, scenes));
  // A place is reached, and another one is not: the pendulum's run ends at 10 s.
  const TemporaryFolder folder;
  const std::string header = read_text(literature).substr(0, read_text(literature).find('\n') + 1);
  REQUIRE(header == "problem,quantity,t,published,allowed,source\n");
  const std::string reached = header + "pendulum,P.x,2,-0.793566195343322,1e-9,x\n";
  const std::string file = folder.write("both.csv", reached + "pendulum,P.x,20,0,1e-9,x\n");
  check_no_errors(reports::work_precision("pendulum", file, scenes));
  for (const auto& point : reports::work_precision("pendulum", folder.write("one.csv", reached), scenes)) {
    INFO(point.integrator << " " << point.tolerance);
    REQUIRE(point.error);
    CHECK(*point.error > 0);
  }
}

TEST_CASE("benchmark: projecting every step costs methods with a memory hardly more steps than Baumgarte's terms") {
  Scene scene = load_scene(data + "scenes/slider-crank-ideal.toml");
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-8;
  for (const std::string integrator : {"bulirsch_stoer", "adams_bashforth_moulton"}) {
    scene.integrator = integrator;
    const auto steps = [&](bool projection) {
      scene.stabilisation.projection = projection;
      const MultibodyTrajectory run = simulate_multibody(scene);
      INFO(run.outcome.message);
      REQUIRE(run.outcome.status == RunStatus::finished);
      return run.outcome.steps;
    };
    const std::size_t projected = steps(true);
    const std::size_t stabilised = steps(false);
    INFO(integrator << ": " << projected << " and " << stabilised);
    // A method that began anew after each step would take its first, short one again and again.
    CHECK(projected <= 2 * stabilised);
  }
}

TEST_CASE("singular positions: a run that passes them says so, at every tolerance on the right branch or by a stop") {
  Scene scene = load_scene(scenes + "/n-four-bar.toml");
  scene.run.duration = 3;
  scene.run.output_interval = 1;
  const double exact = std::sin(rods_later({0, 1}, 3)[0]);
  // What deviations of the angle and of its rate by their tolerances at any time before have become at the end, at
  // most, over the tolerance: where the bars are aligned they grow most, and none fades.
  const double rate = scene_units(scene).rate;  // times a tolerance: that of a rate
  double growth = 0;
  for (double t = 0.05; t < 3; t += 0.05) {
    const RodAngle there = rods_later({0, 1}, t);
    const double by = 1e-6;
    const auto grown = [&](const RodAngle& moved) {
      return std::abs(std::sin(rods_later(moved, 3 - t)[0]) - exact) / by;
    };
    growth = std::max(growth, grown({there[0] + by, there[1]}) + grown({there[0], there[1] + by * rate}));
  }
  int finished = 0;
  for (const std::string integrator : {"radau_iia5", "fehlberg78"}) {
    for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
      INFO(integrator << " " << tolerance);
      scene.integrator = integrator;
      scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
      const MultibodyTrajectory run = simulate_multibody(scene);
      if (run.outcome.status == RunStatus::stopped) {
        CHECK_THAT(run.outcome.message, Contains("singular position"));
        continue;
      }
      ++finished;
      CHECK(run.passed.size() == 3);  // bars aligned at 0.714, 1.228 and 2.657 s
      CHECK(std::abs(run.passed.front().t - 0.714355) < 1e-5);
      // A tolerance's deviation of both where they grow most.
      CHECK(std::abs(run.samples.back().sensors[0] - exact) < growth * tolerance);
    }
  }
  CHECK(finished >= 4);
}

}  // namespace benchmark_test

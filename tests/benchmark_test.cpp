// Published problems: the numbers themselves by other means, what runs give, and that a wrong mechanism is seen.
#include "oracle/results/benchmark.hpp"

#include <array>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/numeric/odeint.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/mechanisms/andrews.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"

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
  using Angle = std::array<double, 2>;  // of the rods from the vertical: all windows stay parallelograms
  Angle y{0, 1};
  const auto rate = [](const Angle& at, Angle& out, double) { out = {at[1], 7.0 / 6 * 9.81 * std::sin(at[0])}; };
  for (const double t : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    boost::numeric::odeint::integrate_adaptive(
        boost::numeric::odeint::make_controlled(1e-13, 1e-13, boost::numeric::odeint::runge_kutta_fehlberg78<Angle>()),
        rate, y, t - 1, t, 1e-3);
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
  std::size_t lines = 0;
  for (std::size_t i = 0; i < points.size(); i += 5) {
    INFO(points[i].dump());
    CHECK(points[i]["tolerance"] == 1e-4);
    if (!points[i]["error"].is_number() || !points[i + 3]["error"].is_number())
      continue;  // it stopped, and says nothing
    ++lines;
    // 3e-9: what is wrong of the published angles, twice.
    CHECK(points[i + 3]["error"].get<double>() < 1e-3 * points[i]["error"].get<double>() + 3e-9);
    CHECK(points[i + 3]["steps"] > points[i]["steps"]);
  }
  CHECK(lines >= 4);                   // radau_iia5, rosenbrock4, dopri5, fehlberg78
  CHECK(points[4]["error"] < 1.5e-9);  // radau_iia5 at 1e-12: what is wrong of the published angles
  CHECK(lubjoint_program({"benchmark", "andrews", "--work-precision", "--rtol", "1e-6"}).status == 2);
}

TEST_CASE("singular positions: a run that passes them says so, at every tolerance on the right branch or by a stop") {
  Scene scene = load_scene(scenes + "/n-four-bar.toml");
  scene.run.duration = 3;
  scene.run.output_interval = 1;
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
      // The run's own error, of each position that it passes, beside what six printed digits leave.
      CHECK(std::abs(run.samples.back().sensors[0] + 0.549340) < 40 * tolerance + 1e-6);
    }
  }
  CHECK(finished >= 4);
}

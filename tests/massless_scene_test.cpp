// Scenes of a journal without mass: its film carries the load at every moment.
#include <catch2/catch.hpp>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace massless_scene_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Changes = std::vector<std::pair<std::string, std::string>>;

namespace {

/// Example 1's journal with another mass, its spin held, under 30 N; started off the centre.
std::string text_of(const std::string& mass, const std::string& law, const Changes& changes = {}) {
  std::string text = read_text(journal_scene_file);
  const SceneText given(text);
  text = given.with("bodies[0].mass", mass);
  text = SceneText(text).with("bodies[0].spin", "{held = " + given.field("bodies[0].spin").value + "}");
  text = SceneText(text).with("bodies[0].position", "[2e-5, -1e-5]");
  text = SceneText(text).with("joints[0].film", "\"" + law + "\"");
  for (const auto& [path, value] : changes) text = SceneText(text).with(path, value);
  return text;
}

Scene scene_of(double mass, const std::string& law) {
  std::ostringstream number;
  number << mass;
  Scene scene = parse_scene(text_of(number.str(), law), "massless.toml");
  scene.run.duration = 0.02;
  scene.run.output_interval = 0.002;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-11;
  scene.gravity = {0, 0};
  return scene;
}

const std::vector<std::string> laws_that_move = {"short_full",   "short_dynamic",     "long_full",
                                                 "long_dynamic", "pinkus_sternlicht", "moes_impedance"};

}  // namespace

TEST_CASE("massless scene: a light journal follows it to first order in the mass, by every law that moves it") {
  for (const std::string& law : laws_that_move) {
    const Scene limit = scene_of(0, law);
    REQUIRE(is_massless_journal(limit));
    const JournalTrajectory run = simulate_journal(limit);
    REQUIRE(run.outcome.status == RunStatus::finished);
    const JournalSample& end = run.samples.back();
    std::vector<double> apart;
    for (const double mass : {2e-3, 1e-3, 5e-4}) {
      Scene light = scene_of(mass, law);
      // The limit's own rate at the start: no layer in which the start dies away.
      const auto& start = run.samples.front().state;
      light.bodies[0].velocity = {start[2] * light.joints[0].clearance, start[3] * light.joints[0].clearance};
      const JournalTrajectory with_mass = simulate_journal(light);
      REQUIRE(with_mass.outcome.status == RunStatus::finished);
      const auto& y = with_mass.samples.back().state;
      apart.push_back(std::hypot(y[0] - end.state[0], y[1] - end.state[1]));
    }
    const double order = std::log2(apart[1] / apart[2]);
    INFO(law << ": " << apart[0] << ", " << apart[1] << ", " << apart[2] << ": order " << order);
    CHECK(order == Approx(1).margin(0.05));  // the next term falls with the mass
    CHECK(apart[2] > 1e-9);                  // above what the steps are good to
  }
}

TEST_CASE(
    "massless scene: at every sample the film's force is the load, turned about, and the rate is the mobility's") {
  for (const std::string& law : laws_that_move) {
    INFO(law);
    const Scene scene = scene_of(0, law);
    const JournalTrajectory run = simulate_journal(scene);
    const SceneJoint& joint = scene.joints[0];
    const Bearing<double> bearing(joint.length, joint.journal_radius, joint.clearance);
    const double mean_spin = scene.bodies[0].spin / 2;
    REQUIRE(run.samples.size() == 11);
    for (const JournalSample& sample : run.samples) {
      const auto& y = sample.state;
      const FilmState<double> film(Vector2<double>(y[0], y[1]),
                                   Vector2<double>(y[2] + mean_spin * y[1], y[3] - mean_spin * y[0]));
      const Vector2<double> force = with_film_law<EveryFilmLaw>(
          law, [&]<class Law>() { return film_force<Law>(bearing, Lubricant<double>(joint.viscosity), film); });
      CHECK((force + scene.loads[0].force).norm() <= 1e-11 * force.norm());  // rounding times the condition, 6/q
      CHECK(sample.force == Vector2<double>(-scene.loads[0].force));
    }
    CHECK(run.max_force == Approx(scene.loads[0].force.norm()).epsilon(1e-15));
  }
}

TEST_CASE("massless scene: every integrator runs it to its tolerance, auto among them") {
  const JournalTrajectory fine = simulate_journal(scene_of(0, "short_dynamic"));
  for (const std::string method :
       {"radau_iia9", "rosenbrock4", "dopri5", "fehlberg78", "bulirsch_stoer", "adams_bashforth_moulton", "auto"}) {
    INFO(method);
    Scene scene = scene_of(0, "short_dynamic");
    scene.integrator = method;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-8;
    const JournalTrajectory run = simulate_journal(scene);
    REQUIRE(run.outcome.status == RunStatus::finished);
    for (std::size_t i = 0; i < run.samples.size(); ++i) {
      const auto& x = run.samples[i].state;
      const auto& y = fine.samples[i].state;
      CHECK(std::hypot(x[0] - y[0], x[1] - y[1]) < 1e-5);  // a thousand steps of the tolerance
    }
  }
}

TEST_CASE("massless scene: what makes no sense without mass is refused by name") {
  const auto refused = [](const std::string& text, const std::string& word, const std::string& other) {
    INFO(word);
    CHECK_THROWS_WITH(parse_scene(text, "massless.toml"), Contains(word) && Contains(other));
  };
  refused(text_of("-1", "short_dynamic"), "bodies[0].mass", "-1");
  refused(text_of("0", "short_dynamic", {{"bodies[0].spin", "50"}}), "bodies[0].mass is 0", "held");
  refused(text_of("0", "short_dynamic", {{"bodies[0].velocity", "[0.1, 0]"}}), "bodies[0].velocity", "the load");
  refused(text_of("0", "short_dynamic") + "\nenergy_ledger = true\n", "mass 0", "ledger");
  refused(
      text_of("0", "short_dynamic", {{"joints[0].journal.point", "[1e-3, 0]"}, {"bodies[0].position", "[-1e-3, 0]"}}),
      "mass 0", "off the centres");
  for (const std::string law : {"short_half", "squeeze_long", "butenschoen"}) {
    CHECK_THROWS_WITH(
        simulate_journal(parse_scene(text_of("0", law, {{"joints[0].length", "0.0098"}}), "massless.toml")),
        Contains(law) && Contains("one velocity") && Contains("short_dynamic"));
  }
  CHECK_THROWS_WITH(journal_equilibrium(parse_scene(text_of("0", "short_dynamic"), "massless.toml")),
                    Contains("mass is 0"));
  // Contact needs inertia.
  std::string impact = read_text(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/impact.toml");
  impact = std::regex_replace(impact, std::regex("mass = 0.13"), "mass = 0\nspin = {held = 0}");
  impact = std::regex_replace(impact, std::regex(R"(velocity = \[0.9, -0.3\])"), "velocity = [0, 0]");
  refused(impact, "mass 0", "wall");
}

TEST_CASE("massless scene: the command runs it, and the summary has the load as the force") {
  const TemporaryFolder folder;
  const std::string file = folder.write("light.toml", text_of("0", "short_dynamic"));
  const ProgramResult result = lubjoint_program({"simulate", file, "--duration", "0.01", "--out", folder / "out"});
  INFO(result.err);
  CHECK(result.status == 0);
  CHECK_THAT(result.out, Contains("finished"));
  const ProgramResult half = lubjoint_program({"simulate", file, "--law", "long_half"});
  CHECK(half.status == 2);
  CHECK_THAT(half.err, Contains("long_half") && Contains("one velocity"));
}

}  // namespace massless_scene_test

// Extremes of the later part of a run, and what its summary says became of the motion.
#include "oracle/results/late_extremes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "lubjoint/scene/scene_file.hpp"
#include "oracle/results/motion_words.hpp"
#include "support/run_program.hpp"

namespace late_extremes_test {

using namespace lubjoint;
using namespace lubjoint::reports;
using namespace lubjoint::test;
using Catch::Contains;
using Json = nlohmann::ordered_json;

namespace {

const std::string scenes = LUBJOINT_SOURCE_DIR "/data/scenes/";

Driver<double>& driver_in(Scene& scene) {
  for (SceneConstraint& each : scene.constraints) {
    if (auto* driver = std::get_if<Driver<double>>(&each.constraint)) return *driver;
  }
  throw std::logic_error("no driver");
}

/// e/c of a circle whose radius changes at a rate, about a place.
MotionOutcome of_circle(double rate, const std::optional<double>& period = {}) {
  std::vector<double> t;
  std::vector<Vector2<double>> places;
  for (int i = 0; i <= 300; ++i) {
    t.push_back(i / 300.0);
    const double radius = 0.1 * std::exp(rate * t.back());
    const double angle = 2 * std::numbers::pi * 12 * t.back();
    places.emplace_back(0.3 + radius * std::cos(angle), -0.2 + radius * std::sin(angle));
  }
  return motion_outcome(t, places, period);
}

}  // namespace

TEST_CASE("late extremes: those after the start of a run are the run's own, to the bit") {
  const Scene journal = load_scene(scenes + "journal.toml");
  const JournalTrajectory run = simulate_journal(journal);
  const LateExtremes late = late_extremes(journal, 0);
  CHECK(late.joints[0].force.value == run.max_force);
  CHECK(late.joints[0].force.t == run.t_max_force);
  CHECK(late.joints[0].eccentricity.value == journal.joints[0].clearance - run.min_film_thickness);
  const Scene crank = load_scene(scenes + "slider-crank.toml");
  const MultibodyTrajectory motion = simulate_multibody(crank);
  const LateExtremes all = late_extremes(crank, 0);
  CHECK(all.joints[0].force.value == motion.joints[0].force.value);
  CHECK(all.drivers[0].min_moment.value == motion.drivers[0].min_moment.value);
}

TEST_CASE("late extremes: of the second revolution they are the largest of all its samples, and at later times") {
  for (const char* name : {"slider-crank.toml", "slider-crank-c0.5-mu0.04.toml"}) {
    INFO(name);
    Scene scene = load_scene(scenes + name);
    const double after = start_of_last_revolution(scene);
    CHECK(after == Approx(0.012).epsilon(1e-12));
    const LateExtremes late = late_extremes(scene, after);
    scene.run.output_interval = 4e-6;
    const MultibodyTrajectory run = simulate_multibody(scene);
    double force = 0;
    double eccentricity = 0;
    double moment = 0;
    for (const MultibodySample& sample : run.samples) {
      if (sample.t < after) continue;
      force = std::max(force, sample.joints[0].force.norm());
      eccentricity = std::max(eccentricity, sample.joints[0].eccentricity.norm());
      moment = std::max(moment, sample.driving_moments[0]);
    }
    // A peak between samples 1/3000 of a revolution apart is higher by the square of that, and runs differ by
    // tolerances.
    CHECK(late.joints[0].force.value == Approx(force).epsilon(1e-4));
    CHECK(late.joints[0].eccentricity.value == Approx(eccentricity).epsilon(1e-5));
    CHECK(late.drivers[0].max_moment.value == Approx(moment).epsilon(1e-4));
    for (const double t : {late.joints[0].force.t, late.joints[0].eccentricity.t, late.drivers[0].max_moment.t}) {
      CHECK((t >= after && t <= scene.run.duration));
    }
  }
}

TEST_CASE("late extremes: a start has its own, which the last revolution does not") {
  const Scene scene = load_scene(scenes + "slider-crank-c0.5-mu0.04.toml");
  const MultibodyTrajectory run = simulate_multibody(scene);
  CHECK(run.joints[0].force.t < 1e-3);
  CHECK(late_extremes(scene, start_of_last_revolution(scene)).joints[0].force.value < run.joints[0].force.value / 2);
}

TEST_CASE("late extremes: the last revolution of a driver that speeds up or slows down is one turn") {
  Scene scene = load_scene(scenes + "slider-crank.toml");
  Driver<double>& driver = driver_in(scene);
  for (const double acceleration : {0.0, 5000.0, -5000.0}) {
    driver.acceleration = acceleration;
    const auto angle = [&](double t) { return t * (driver.speed + t * acceleration / 2); };
    const double after = start_of_last_revolution(scene);
    CHECK(angle(scene.run.duration) - angle(after) == Approx(2 * std::numbers::pi).epsilon(1e-12));
  }
  driver.acceleration = 0;
  scene.run.duration = 0.01;
  CHECK_THROWS_WITH(start_of_last_revolution(scene), Contains("before one revolution is made") && Contains("allowed"));
  driver.speed = 0;
  CHECK_THROWS_WITH(start_of_last_revolution(scene), Contains("nothing in the scene is driven round"));
}

TEST_CASE("simulate and sweep: --after and --last-revolution give both extremes with their times") {
  const std::string crank = scenes + "slider-crank.toml";
  const ProgramResult result = lubjoint_program({"simulate", crank, "--last-revolution", "--json"});
  INFO(result.err);
  REQUIRE(result.status == 0);
  const Json summary = Json::parse(result.out);
  const Json& joint = summary["joints"][0];
  CHECK(joint["after"]["t"].get<double>() == Approx(0.012).epsilon(1e-12));
  CHECK(joint["after"]["max_force"] <= joint["max_force"]);
  CHECK(joint["after"]["t_max_force"].get<double>() >= 0.012);
  CHECK(summary["driver"]["after"]["max_moment"] <= summary["driver"]["max_moment"]);
  CHECK_THAT(lubjoint_program({"simulate", crank, "--after", "0.01"}).out, Contains("after        0.01 s"));
  const ProgramResult rows = lubjoint_program(
      {"sweep", crank, "--vary", "joints.gudgeon-pin.clearance=2e-4,1e-4", "--last-revolution", "--json"});
  REQUIRE(rows.status == 0);
  const Json row = Json::parse(rows.out)["rows"][0];
  CHECK(row["gudgeon-pin.max_force"] == joint["max_force"]);
  CHECK(row["gudgeon-pin.t_max_force"] == joint["t_max_force"]);
  CHECK(row["gudgeon-pin.after.max_force"] == joint["after"]["max_force"]);
  CHECK(row["motor.after.min_moment"] == summary["driver"]["after"]["min_moment"]);
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"--after", "0.024"}, {"--after", "-1"}, {"--after", "0.01", "--last-revolution"}}) {
    std::vector<std::string> words{"simulate", crank};
    words.insert(words.end(), wrong.begin(), wrong.end());
    const ProgramResult refused = lubjoint_program(words);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, Contains("--after") && Contains("allowed"));
  }
}

TEST_CASE("summaries: a journal's and a mechanism's have the same keys") {
  const auto keys = [](const Json& object) {
    std::set<std::string> names;
    for (const auto& [name, value] : object.items()) names.insert(name);
    return names;
  };
  const Json journal = Json::parse(lubjoint_program({"simulate", scenes + "journal.toml", "--json"}).out);
  const Json crank = Json::parse(lubjoint_program({"simulate", scenes + "slider-crank.toml", "--json"}).out);
  CHECK(keys(journal) == keys(crank));
  std::set<std::string> of_journal = keys(journal["joints"][0]);
  std::set<std::string> of_crank = keys(crank["joints"][0]);
  of_journal.erase("sliding");
  of_crank.erase("sliding");
  CHECK(of_journal == of_crank);
}

TEST_CASE("what became of a motion: rests, repeats, grows, dies away or goes on, each from places that do") {
  CHECK(of_circle(-20).kind == MotionKind::rests);
  CHECK(of_circle(-20).t < 0.3);
  CHECK(of_circle(1).kind == MotionKind::grows);
  CHECK(of_circle(1).measure == Approx(std::exp(1.0 / 3)).epsilon(0.05));  // the widest of a third is near its end
  CHECK(of_circle(-1).kind == MotionKind::dies_away);
  CHECK(of_circle(1e-3).kind == MotionKind::keeps_on);
  CHECK(of_circle(0, 1.0 / 12).kind == MotionKind::periodic);
  CHECK(of_circle(0, 1.0 / 11).kind == MotionKind::not_periodic);
  CHECK(of_circle(1, 1.0 / 12).kind == MotionKind::not_periodic);
  CHECK(of_circle(0, 0.6).kind == MotionKind::unknown);  // less than two revolutions
  CHECK(motion_outcome({0.0, 1.0}, std::vector<Vector2<double>>(2, Vector2<double>(0, 0)), std::nullopt).kind ==
        MotionKind::unknown);
}

}  // namespace late_extremes_test

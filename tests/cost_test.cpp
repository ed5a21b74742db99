// What the command says about a scene's cost: counts that can be counted by hand, and times that must add up.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace cost_test {

using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

namespace {

const std::string scenes = LUBJOINT_SOURCE_DIR "/data/scenes/";

Json cost_of(const std::string& scene, const Words& more = {}) {
  Words words{"cost", scene, "--json", "--rounds", "9"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramResult result = lubjoint_program(words);
  INFO(result.err);
  REQUIRE(result.status == 0);
  return Json::parse(result.out);
}

Words features(const Json& list) {
  Words names;
  for (const Json& each : list) {
    if (names.empty() || names.back() != each["feature"]) names.push_back(each["feature"]);
  }
  return names;
}

void check_times(const Json& cost) {
  CHECK(cost["rhs_ns"].get<double>() > 0);
  CHECK(cost["jacobian"]["ns"].get<double>() > 0);
  double shares = 0;
  for (const Json& part : cost["parts"]) shares += part["share"].get<double>();
  CHECK(std::abs(shares - 1) < 1e-12);  // rounding: the last part is what the others leave
  for (const char* list : {"left_out", "in_use"}) {
    for (const Json& each : cost[list]) {
      CHECK(each["rhs_ns"].get<double>() > 0);
      CHECK(each["ratio"].get<double>() > 0);
    }
  }
}

}  // namespace

TEST_CASE("cost: the slider-crank's counts are those of its drawing") {
  const Json cost = cost_of(scenes + "slider-crank.toml");
  CHECK(cost["equations"] == "constrained bodies");
  CHECK(cost["bodies"] == 3);
  CHECK(cost["coordinates"] == 9);
  CHECK(cost["states"] == 18 + 5);  // and five terms of the ledger
  CHECK(cost["constraints"] == 4);
  CHECK(cost["constraint_rows"] == 2 + 2 + 2 + 1);  // two pins, a guide, a driver
  CHECK(cost["multipliers"] == 7);
  // Pin to the ground: two directions, two arms; pin of two bodies: twice that; guide: height and angle (its normal is
  // y, and the slider's point its mass centre); driver: angle.
  CHECK(cost["constraint_jacobian_nonzeros"] == 4 + 8 + 2 + 1);
  // Rows begin at the first constraint on the same body: ground pin 1 + 2, crank pin 3 + 4, guide 1 + 2, driver 7.
  CHECK(cost["schur_stored"] == 20);
  CHECK(cost["force_terms"] ==
        Json{{"films", {{"pinkus_sternlicht", 1}}}, {"contacts", 0}, {"loads", 0}, {"weights", 0}});
  CHECK(cost["events"] == Json{{"contact_seams", 0}, {"film_jumps", 0}});
  CHECK(cost["ledger_terms"] == 5);
  CHECK(cost["jacobian"]["passes"] == 3);
  CHECK(features(cost["in_use"]) == Words{"energy ledger", "joints with clearance", "Baumgarte's terms"});
  CHECK(features(cost["left_out"]) == Words{"shear", "contact", "film in ideal pins", "space"});
  check_times(cost);
}

TEST_CASE("cost: a free journal has no multipliers and no solve, and says so") {
  const Json cost = cost_of(scenes + "journal.toml");
  CHECK(cost["equations"] == "free journal");
  CHECK_THAT(cost["message"].get<std::string>(), Contains("no multipliers and no linear solve"));
  CHECK(cost["coordinates"] == 2);
  CHECK(cost["states"] == 4);
  CHECK(cost["multipliers"] == 0);
  CHECK(cost["constraint_jacobian_nonzeros"] == 0);
  CHECK(cost["rhs_jacobian_nonzeros"] == 2 + 8);  // ê̇ = w; ẇ depends on all
  CHECK(cost["schur_stored"] == 0);
  CHECK(cost["by_step"].empty());
  CHECK(features(cost["in_use"]) == Words{"joints with clearance"});
  CHECK(features(cost["left_out"]) == Words{"constrained equations", "energy ledger", "shear", "contact", "space"});
  check_times(cost);
  CHECK(cost_of(scenes + "journal.toml", {"--law", "short_half"})["events"]["film_jumps"] == 1);
}

TEST_CASE("cost: a scene with contact counts its seams, and what it costs without") {
  const Json cost = cost_of(scenes + "impact.toml");
  CHECK(cost["force_terms"]["contacts"] == 1);
  CHECK(cost["events"]["contact_seams"] == 2);
  CHECK(cost["multipliers"] == 0);
  CHECK(features(cost["in_use"]) == Words{"energy ledger", "contact", "joints with clearance"});
  CHECK(features(cost["left_out"]) == Words{"shear", "space"});
  CHECK(cost["phases"].size() == 2);
  check_times(cost);
}

TEST_CASE(
    "cost: a scene in space has seven coordinates a body and thirteen states, and what it is made of is counted") {
  const Json cost = cost_of(scenes + "space/spatial-slider-crank.toml");
  CHECK(cost["equations"] == "constrained bodies in space");
  CHECK(cost["bodies"] == 3);
  CHECK(cost["coordinates"] == 3 * 7);
  CHECK(cost["states"] == 3 * 13 + 5);  // and five terms of the ledger
  CHECK(cost["constraints"] == 4);
  CHECK(cost["multipliers"] == 5 + 3 + 4 + 3);  // a pin, a ball, a sleeve, two faces
  CHECK(cost["force_terms"] ==
        Json{{"films", {{"pinkus_sternlicht", 1}}}, {"contacts", 0}, {"loads", 0}, {"weights", 3}});
  CHECK(cost["jacobian"]["passes"] == 3);
  CHECK(cost["runs_in"] == "independent");
  CHECK(cost["runs_in_reason"] == "3 degrees of freedom in 18 coordinates");
  CHECK(cost["independent_coordinates"].size() == 2);
  CHECK(features(cost["in_use"]) == Words{"energy ledger", "Baumgarte's terms"});
  CHECK(features(cost["left_out"]) == Words{"shear", "contact"});
  check_times(cost);
  const Json top = cost_of(scenes + "space/top.toml");
  CHECK(top["multipliers"] == 3);
  CHECK(top["runs_in"] == "absolute");                  // the scene asks for a stabilisation
  CHECK(top["constraint_jacobian_nonzeros"] == 3 + 6);  // the ball is on the third axis: two arms a row
  check_times(top);
}

TEST_CASE("cost: a planar scene does not pay what it would cost in space, with tables or without") {
  const Json cost = cost_of(scenes + "slider-crank.toml");
  CHECK(cost["left_out"].back()["feature"] == "space");
  CHECK(cost["left_out"].back()["ratio"].get<double>() > 2);     // 4.6 was measured; times of one run, in turn
  const Json engine = cost_of(scenes + "machines/engine.toml");  // its gas force is a table's
  CHECK(engine["left_out"].back()["feature"] == "space");
}

TEST_CASE("cost: the journal's own equations cost less than half of the constrained ones") {
  const Json cost = cost_of(scenes + "journal.toml");
  CHECK(cost["left_out"][0]["feature"] == "constrained equations");
  CHECK(cost["left_out"][0]["ratio"].get<double>() > 2);  // 4 or more was measured; times of one run, in turn
}

TEST_CASE(
    "cost: a chain's Schur complement grows as its length, and every cost of one in proportion, up to 1000 pendulums") {
  const char* const timed[] = {"rhs", "jacobian", "implicit_step"};
  // 1 but for caches; quadratic work would be 2. Another program on the machine may slow the long chains alone, but
  // hardly three times.
  constexpr double allowed = 1.35;
  Json cost;
  std::map<std::string, double> least;
  for (int trial = 0; trial < 3; ++trial) {
    const ProgramResult result = lubjoint_program({"cost", "--chain", "--json", "--rounds", "9"});
    INFO(result.err);
    REQUIRE(result.status == 0);
    cost = Json::parse(result.out);
    bool all = true;
    for (const char* cost_of : timed) {
      const double exponent = cost["exponents"][cost_of].get<double>();
      double& kept = least.try_emplace(cost_of, exponent).first->second;
      kept = std::min(kept, exponent);
      all = all && kept < allowed;
    }
    if (all) break;
  }
  REQUIRE(cost["chain"].size() == 11);
  CHECK(cost["chain"].front()["bodies"] == 1);
  CHECK(cost["chain"].back()["bodies"] == 1000);
  for (const Json& row : cost["chain"]) {
    const auto n = row["bodies"].get<std::size_t>();
    CHECK(row["constraint_rows"] == 2 * n);
    CHECK(row["schur_stored"] == 3 + 7 * (n - 1));  // own block 3; beside the pin before, 4 more
  }
  for (const char* cost_of : timed) {
    CAPTURE(cost_of);
    CHECK(least.at(cost_of) < allowed);
  }
}

TEST_CASE("cost: neither scene nor --chain, both, or too few rounds are refused") {
  const auto refused = [](const Words& words, const std::string& message) {
    const ProgramResult result = lubjoint_program(words);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Contains(message) && Contains("allowed"));
  };
  refused({"cost"}, "a scene is required");
  refused({"cost", scenes + "journal.toml", "--chain"}, "a scene is required, or --chain in its place");
  refused({"cost", "--chain", "--law", "short_half"}, "--law is given");
  refused({"cost", scenes + "journal.toml", "--rounds", "8"}, "--rounds is 8");
  refused({"cost", scenes + "absent.toml"}, "can't be read");
}

}  // namespace cost_test

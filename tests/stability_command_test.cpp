// `coefficients` and `stability`: what a rotor's designer looks up, as programs.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "oracle/results/coefficient_table.hpp"
#include "oracle/results/stability_map.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace stability_command_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

namespace {

/// The short bearing of Friswell et al., Dynamics of Rotating Machines (2010).
const Words friswell{"--viscosity", "0.1", "--length", "0.03", "--radius", "0.05", "--clearance", "1e-4"};
const reports::FilmInBearing friswell_film{"short_half", {0.03, 0.05, 1e-4}, Lubricant<double>(0.1)};

Words command(const std::string& name, const std::string& law, const Words& more) {
  Words words{name, "--law", law};
  words.insert(words.end(), friswell.begin(), friswell.end());
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string refused(const Words& words, const std::string& input = "eccentricity_ratio\n0.5\n") {
  const ProgramResult result = lubjoint_program(words, {.input = input});
  CHECK(result.status == 2);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Contains("allowed") || Contains("required"));
  return result.err;
}

}  // namespace

TEST_CASE("coefficients: Friswell's bearing, as a table over speeds that holds the published one") {
  const ProgramResult result =
      lubjoint_program(command("coefficients", "short_half", {"--speeds", "157.1:200:2", "--load", "525"}));
  REQUIRE(result.status == 0);
  CHECK(result.err.empty());
  CHECK_THAT(result.out, Catch::Matchers::StartsWith("eccentricity_ratio,omega,load,attitude,kxx,kxy,kyx,kyy,cxx,cxy,"
                                                     "cyx,cyy,critical_mass,whirl_ratio\n"));
  const auto rows = parse_csv(result.out);
  REQUIRE(rows.size() == 2);
  const auto at = [&](const char* column) { return std::stod(rows[0].at(column)); };
  // Half a unit of the last published digit.
  CHECK(std::abs(at("eccentricity_ratio") - 0.266272) < 5e-7);
  CHECK(std::abs(at("attitude") * 180 / std::numbers::pi - 70.622) < 5e-4);
  CHECK(std::abs(at("kxx") / 1e6 - 8.81487) < 5e-6);
  CHECK(std::abs(at("kxy") / 1e6 - 25.06177) < 5e-6);
  CHECK(std::abs(at("kyx") / 1e6 + 16.39580) < 5e-6);
  CHECK(std::abs(at("kyy") / 1e6 - 12.80806) < 5e-6);
  CHECK(std::abs(at("cxx") / 1e3 - 294.893) < 5e-4);
  CHECK(std::abs(at("cxy") / 1e3 - 81.914) < 5e-4);
  CHECK(std::abs(at("cyy") / 1e3 - 232.893) < 5e-4);
  CHECK(std::abs(at("critical_mass") - 1472.87) < 5e-3);
  CHECK(std::abs(at("whirl_ratio") - 0.5166) < 5e-5);
  CHECK(at("load") == 525);
}

TEST_CASE("coefficients: dimensionless at ε = ½, inf and an empty whirl ratio where every mass is stable, both spins") {
  const std::string states = "eccentricity_ratio\n0.5\n0.8\n";
  for (const char* omega : {"8", "-8"}) {
    const ProgramResult result = lubjoint_program(
        command("coefficients", "short_half", {"--states", "-", std::string("--omega=") + omega, "--dimensionless"}),
        {.input = states});
    REQUIRE(result.status == 0);
    const auto rows = parse_csv(result.out);
    REQUIRE(rows.size() == 2);
    const double sign = omega[0] == '-' ? -1 : 1;
    // Known to 20 digits; printed in double precision.
    CHECK(std::stod(rows[0].at("kxx")) == Approx(2.9232504981753439929).epsilon(1e-15));
    CHECK(std::stod(rows[0].at("kyx")) == Approx(sign * -0.85769951026357551193).epsilon(1e-15));
    CHECK(std::stod(rows[0].at("cxy")) == Approx(sign * 2.244955497755921797).epsilon(1e-15));
    CHECK(std::stod(rows[0].at("critical_mass")) == Approx(6.4603957523295151749).epsilon(1e-15));
    CHECK(rows[1].at("critical_mass") == "inf");
    CHECK(rows[1].at("whirl_ratio").empty());
  }
}

TEST_CASE("stability: a law that whirls unlike any film at the centre is warned of wherever stability is asked of it") {
  CHECK(reports::stability_warning("long_dynamic").empty());
  CHECK(reports::stability_warning("short_half").empty());
  CHECK(reports::stability_warning("pinkus_sternlicht").empty());
  CHECK_THAT(reports::stability_warning("long_half"), Contains("1.149 times the spin") && Contains("long_dynamic"));
  const Words coefficients = command("coefficients", "long_half", {"--states", "-", "--omega", "8"});
  CHECK_THAT(lubjoint_program(coefficients, {.input = "eccentricity_ratio\n0.5\n"}).err,
             Contains("warning: long_half"));
  const Words stability = command("stability", "long_half", {"--load", "525", "--omega", "157.1", "--json"});
  const ProgramResult asked = lubjoint_program(stability);
  CHECK_THAT(asked.err, Contains("warning: long_half"));
  CHECK_THAT(Json::parse(asked.out)["warning"].get<std::string>(), Contains("1.149"));
  for (const char* law : {"long_half", "short_half"}) {
    const ProgramResult rest = lubjoint_program({"equilibrium", journal_scene_file, "--law", law, "--json"});
    REQUIRE(rest.status == 0);
    CHECK(Json::parse(rest.out)["warning"].is_null() == (std::string(law) == "short_half"));
    CHECK(rest.err.empty() == (std::string(law) == "short_half"));
  }
}

TEST_CASE("stability: threshold by Routh and by eigenvalues, verdict on a mass, and its critical speed") {
  const auto answer = [](const char* mass) {
    const ProgramResult result = lubjoint_program(
        command("stability", "short_half", {"--load", "525", "--omega", "157.1", "--mass", mass, "--json"}));
    REQUIRE(result.status == 0);
    return Json::parse(result.out);
  };
  const Json light = answer("1000");
  CHECK(light["critical_mass"].get<double>() == Approx(1472.87).margin(5e-3));  // published, half a unit
  CHECK(light["critical_mass_by_eigenvalues"].get<double>() ==
        Approx(light["critical_mass"].get<double>()).epsilon(1e-12));
  CHECK(light["stable"] == "yes");
  CHECK(answer("1500")["stable"] == "no");
  REQUIRE(light["critical_speeds"].size() == 1);
  CHECK(light["critical_speeds"][0]["stable_below"] == true);
  const double speed = light["critical_speeds"][0]["omega"];
  const auto at_that_speed = reports::coefficients_under(friswell_film, 525, speed);
  CHECK(at_that_speed->critical_mass == Approx(1000).epsilon(1e-12));  // the speed is that of this mass
  CHECK(reports::rotor_stability(*at_that_speed, at_that_speed->critical_mass * 1.001) ==
        reports::RotorStability::unstable);
  const ProgramResult text =
      lubjoint_program(command("stability", "short_half", {"--load", "525", "--omega", "157.1", "--mass", "1000"}));
  CHECK_THAT(text.out, Contains("critical mass       1472.87 kg (Routh)") && Contains("1472.87 kg (eigenvalues)") &&
                           Contains("(stable below)"));
}

TEST_CASE("stability: the two verdicts disagree, and it is undecided, where a threshold is not the eigenvalues'") {
  reports::CoefficientRow rest = *reports::coefficients_under(friswell_film, 525, 157.1);
  CHECK(reports::rotor_stability(rest, 1000) == reports::RotorStability::stable);
  rest.critical_mass = 900;
  CHECK(reports::rotor_stability(rest, 1000) == reports::RotorStability::undecided);
}

TEST_CASE("stability: full films carry no rotor of any mass, and thick loads every one") {
  const ProgramResult full =
      lubjoint_program(command("stability", "short_full", {"--load", "525", "--omega", "157.1", "--mass", "1"}));
  CHECK_THAT(full.out, Contains("no mass is stable (Routh)") && Contains("no mass is stable (eigenvalues)") &&
                           Contains("stable              no") && Contains("none under this load"));
  const ProgramResult heavy =
      lubjoint_program(command("stability", "short_half", {"--load", "50000", "--omega", "157.1", "--mass", "1"}));
  CHECK_THAT(heavy.out, Contains("every mass is stable (Routh)") && Contains("every mass is stable (eigenvalues)"));
}

TEST_CASE("stability: a scene's rotor, and maps over speed and over load as CSV and plots") {
  const TemporaryFolder folder;
  const std::string out = folder.path() / "map";
  const ProgramResult result = lubjoint_program({"stability", journal_scene_file, "--law", "short_dynamic", "--speeds",
                                                 "log:5:500:5", "--masses", "log:0.01:100:6", "--out", out});
  INFO(result.err);
  REQUIRE(result.status == 0);
  CHECK_THAT(result.out, Contains("load                31.2753 N") && Contains("mass                0.13 kg"));
  const std::string text = read_text(out + "/stability.csv");
  CHECK_THAT(text, Catch::Matchers::StartsWith(
                       "load,omega,mass,eccentricity_ratio,critical_mass,whirl_ratio,growth_rate,stable\n"));
  const auto rows = parse_csv(text);
  REQUIRE(rows.size() == 30);
  int stable = 0;
  for (const CsvRow& row : rows) {
    const bool below =
        row.at("critical_mass") == "inf" || std::stod(row.at("mass")) < std::stod(row.at("critical_mass"));
    CHECK(row.at("stable") == (below ? "yes" : "no"));
    CHECK((std::stod(row.at("growth_rate")) < 0) == below);
    stable += below;
  }
  CHECK((stable > 0 && stable < 30));
  for (const char* picture : {"/stability.svg", "/stability.png"}) CHECK(std::filesystem::exists(out + picture));
  const ProgramResult loads = lubjoint_program(
      command("stability", "long_dynamic",
              {"--load", "1", "--omega", "100", "--loads", "1:1000:4", "--masses", "1:1000:3", "--out", out}));
  REQUIRE(loads.status == 0);
  CHECK(parse_csv(read_text(out + "/stability.csv")).size() == 12);
}

TEST_CASE("coefficients and stability: bad usage is refused by name, with what is allowed") {
  const auto coefficients = [](const Words& more) { return refused(command("coefficients", "short_half", more)); };
  CHECK_THAT(coefficients({}), Contains("--states or --speeds"));
  CHECK_THAT(coefficients({"--states", "-", "--speeds", "1:2:2"}), Contains("--states or --speeds"));
  CHECK_THAT(coefficients({"--states", "-"}), Contains("--omega is missing"));
  CHECK_THAT(coefficients({"--states", "-", "--omega", "0"}), Contains("--omega is 0"));
  CHECK_THAT(coefficients({"--states", "-", "--omega", "5", "--load", "3"}), Contains("--load has no effect"));
  CHECK_THAT(coefficients({"--speeds", "1:2:2"}), Contains("--load is missing"));
  CHECK_THAT(coefficients({"--speeds", "1:2:2", "--load", "-3"}), Contains("--load is -3"));
  CHECK_THAT(coefficients({"--speeds", "1:2:2", "--load", "3", "--omega", "1"}), Contains("--omega has no effect"));
  CHECK_THAT(coefficients({"--speeds", "1:2", "--load", "3"}), Contains("--speeds 1:2") && Contains("LO:HI:N"));
  CHECK_THAT(coefficients({"--speeds=-1:1:3", "--load", "3"}), Contains("a speed of --speeds is 0"));
  CHECK_THAT(coefficients({"--speeds", "1e-300:1:2", "--load", "1e300"}), Contains("--load is 1e+300 N"));
  for (const char* ratio : {"0", "1", "-0.5"}) {
    const Words words = command("coefficients", "short_half", {"--states", "-", "--omega", "5"});
    CHECK_THAT(refused(words, std::string("eccentricity_ratio\n") + ratio + "\n"),
               Contains("standard input:2: ") && Contains("above 0 and below 1"));
  }
  const auto stability = [](const Words& more) { return refused(command("stability", "short_half", more)); };
  const Words loaded{"--load", "525", "--omega", "157.1"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), loaded.begin(), loaded.end());
    return more;
  };
  CHECK_THAT(stability({}), Contains("--load is missing"));
  CHECK_THAT(stability({"--load", "5"}), Contains("--omega is missing"));
  CHECK_THAT(stability(with({"--mass", "0"})), Contains("--mass is 0"));
  CHECK_THAT(stability(with({"--masses", "1:2:2"})), Contains("no effect without --out"));
  CHECK_THAT(stability(with({"--out", "x", "--masses", "1:2:2"})), Contains("either --speeds or --loads"));
  CHECK_THAT(stability(with({"--out", "x", "--speeds", "2:1:2", "--masses", "1:2:2"})), Contains("a range that rises"));
  CHECK_THAT(stability({"--load", "1e300", "--omega", "1"}), Contains("1e+300 N"));
  CHECK_THAT(refused({"stability", journal_scene_file, "--load", "3"}), Contains("takes a scene, or"));
  CHECK_THAT(refused({"stability", journal_scene_file, "--law", "long_hlf"}), Contains("did you mean long_half?"));
  CHECK_THAT(refused({"stability"}), Contains("--law is missing"));
  CHECK_FALSE(std::filesystem::exists("x"));
}

}  // namespace stability_command_test

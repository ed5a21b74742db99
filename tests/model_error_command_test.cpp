// `model-error`: each law against the film of finite length, run as a user runs it.
#include <catch2/catch.hpp>
#include <cmath>
#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "lubjoint/film/every_law.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace model_error_command_test {

using namespace lubjoint::test;
using Catch::Contains;
using Words = std::vector<std::string>;

namespace {

// The journal of the scene: 30 N and the weight of 0.13 kg, turning at 500 rpm.
const Words journal{"--length",    "0.04", "--radius", "0.0098",  "--clearance", "0.0002",
                    "--viscosity", "0.4",  "--load",   "31.2753", "--spin",      "52.35987755982989"};

Words model_error(const Words& more) {
  Words words{"model-error"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The numbers after a law's name in the table of equilibria: eccentricity ratio and attitude [deg].
std::pair<double, double> equilibrium_in(const std::string& text, const std::string& name) {
  std::istringstream lines(text.substr(text.find("Equilibrium under the given load")));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(name + " ")) continue;
    std::istringstream numbers(line.substr(name.size()));
    double ratio = 0;
    double attitude = 0;
    numbers >> ratio >> attitude;
    return {ratio, attitude};
  }
  FAIL("no equilibrium of " << name);
  return {};
}

}  // namespace

TEST_CASE("model-error: a scene and its bearing given by hand say the same, with the equilibrium of each law") {
  const TemporaryFolder folder;
  const ProgramResult of_scene = lubjoint_program(model_error({journal_scene_file, "--out", folder / "out"}));
  const ProgramResult by_hand = lubjoint_program(model_error(journal));
  INFO(of_scene.err << by_hand.err);
  REQUIRE(of_scene.status == 0);
  REQUIRE(by_hand.status == 0);
  CHECK(of_scene.out == by_hand.out);
  CHECK_THAT(of_scene.out, Contains("L/D = 2.041") && Contains("Within 25 % of finite_reynolds"));
  for (const std::string_view law : lubjoint::film_law_names) {
    INFO(law);
    const auto [ratio, attitude] = equilibrium_in(of_scene.out, std::string(law));
    const ProgramResult own =
        lubjoint_program({"equilibrium", journal_scene_file, "--law", std::string(law), "--json"});
    const auto expected = nlohmann::json::parse(own.out);
    CHECK(std::abs(ratio - expected["eccentricity_ratio"].get<double>()) < 5.1e-5);  // four printed digits
    CHECK(std::abs(attitude - 180 / std::numbers::pi * expected["attitude"].get<double>()) < 5.1e-3);  // two
  }
  // Where the ends leak, the journal sinks deeper than the long film says, and where p >= 0 the half film is too weak.
  const double long_half = equilibrium_in(of_scene.out, "long_half").first;
  CHECK(equilibrium_in(of_scene.out, "finite_reynolds, free onset").first > long_half);
  CHECK(equilibrium_in(of_scene.out, "finite_half").first >
        equilibrium_in(of_scene.out, "finite_reynolds, free onset").first);

  CHECK(folder.entries() == std::set<std::string>{"out", "out/model-error-finite_dynamic.png",
                                                  "out/model-error-finite_dynamic.svg",
                                                  "out/model-error-finite_half.png", "out/model-error-finite_half.svg",
                                                  "out/model-error-finite_reynolds.png",
                                                  "out/model-error-finite_reynolds.svg", "out/model-error.csv"});
  std::map<std::string, int> states;
  for (const CsvRow& row : read_csv(folder / "out/model-error.csv")) {
    ++states[row.at("law") + " " + row.at("film")];
    const double error = std::stod(row.at("error"));
    const double uncertainty = std::stod(row.at("uncertainty"));
    CHECK((error >= 0 && std::isfinite(error)));
    CHECK((uncertainty >= 0 && uncertainty < 0.02 * (1 + error)));  // that of the finite film, 1e-3, and of its grid
  }
  CHECK(states.size() == 3 * (lubjoint::every_law_names.size() - 1));  // butenschoen is not made for L/D = 2.04
  CHECK_FALSE(states.contains("butenschoen finite_reynolds"));
  for (const auto& [pair, count] : states) CHECK(count == states.begin()->second);
}

TEST_CASE("model-error: the report begins with its verdict, which is that of its own table") {
  const ProgramResult result = lubjoint_program(model_error(journal));
  REQUIRE(result.status == 0);
  const std::string first = result.out.substr(0, result.out.find('\n'));
  INFO(result.out);
  CHECK_THAT(first, Catch::Matchers::StartsWith("least wrong for this bearing: "));
  // The law with the least median of the table.
  std::string best;
  double least = 1e300;
  double nearest_fit = 1e300;
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string film, law, median, unit;
    words >> film >> law >> median >> unit;
    if (film != "finite_reynolds" || (unit != "%" && unit != "times")) continue;
    const double value = std::stod(median) * (unit == "%" ? 0.01 : 1);
    const auto& at_rest = lubjoint::film_law_names;
    if (std::find(at_rest.begin(), at_rest.end(), law) == at_rest.end()) {
      nearest_fit = std::min(nearest_fit, value);
      continue;
    }
    if (value >= least) continue;
    least = value;
    best = law;
  }
  REQUIRE(!best.empty());
  CHECK((first.find("A fit is nearer: moes_impedance") != std::string::npos) == (nearest_fit < least));
  CHECK_THAT(first, Contains(": " + best + ", median "));
  const double rest = equilibrium_in(result.out, best).first;
  const double real = equilibrium_in(result.out, "finite_reynolds, free onset").first;
  std::ostringstream words;
  words << std::fixed << std::setprecision(3) << "rests at e/c " << rest << " instead of " << real;
  CHECK_THAT(first, Contains(words.str()) && Contains("least film "));
  CHECK(result.out.find("000 %") == std::string::npos);  // "12422 times", not "1242175 %"
  const ProgramResult unloaded = lubjoint_program(model_error({"--length", "0.001", "--radius", "0.01"}));
  CHECK(unloaded.out.substr(0, unloaded.out.find('\n')).find("rests") == std::string::npos);
}

TEST_CASE("model-error: the short laws are right in a short bearing, and say so") {
  const ProgramResult result = lubjoint_program(model_error({"--length", "0.001", "--radius", "0.01"}));
  REQUIRE(result.status == 0);
  CHECK(result.out.find("Equilibrium") == std::string::npos);  // no load is given
  const std::size_t line = result.out.find("Within 5 % of finite_half: ");
  REQUIRE(line != std::string::npos);
  CHECK_THAT(result.out.substr(line, 60), Contains("finite_half: short_half at"));
}

TEST_CASE("model-error: errors by L/D and eccentricity ratio are those of data/model-error.csv") {
  const ProgramResult result = lubjoint_program(model_error({"--lookup"}));
  REQUIRE(result.status == 0);
  const std::vector<CsvRow> made = parse_csv(result.out);
  const std::vector<CsvRow> kept = read_csv(LUBJOINT_SOURCE_DIR "/data/model-error.csv");
  REQUIRE(made.size() == kept.size());
  const auto near = [](double one, double other) {
    return std::abs(one - other) <= 0.06 * other + 1e-3;
  };  // two digits
  double butenschoen = 0, moes = 0, short_dynamic = 0;
  for (std::size_t row = 0; row < made.size(); ++row) {
    const auto value = [&](const char* column) { return number(kept[row].at(column)); };
    const std::string& law = kept[row].at("law");
    INFO(row << " " << law);
    CHECK(made[row].at("law") == law);
    for (const char* column :
         {"length_over_diameter", "eccentricity_ratio", "median", "closing", "sliding", "opening"}) {
      CHECK(near(number(made[row].at(column)), value(column)));
    }
    const double shape = value("length_over_diameter");
    if (law == "butenschoen") CHECK(shape <= 1);  // where his fit ends
    if (value("eccentricity_ratio") > 0.5) continue;
    if (law == "butenschoen" && shape == 1) butenschoen = std::max(butenschoen, value("opening"));
    if (law == "moes_impedance" && shape == 0.25) moes = std::max(moes, value("closing"));
    if (law == "short_dynamic" && shape == 0.125) short_dynamic = std::max(short_dynamic, value("median"));
  }
  CHECK(butenschoen > 0.5);     // the two fits' sum is not the film's force where wedge and opening meet
  CHECK(moes < 0.025);          // 2.5 % against finite-volume solutions at L/D = 1/4
  CHECK(short_dynamic < 0.02);  // nearly the short bearing: (L/D)^2 at L/D = 1/8, and 1/64 is 0.016
  CHECK(lubjoint_program(model_error({"--lookup", "--radius", "0.01"})).status == 2);
}

TEST_CASE("model-error: half a question, or two, is refused") {
  const auto refused = [](const Words& more, const std::string& message) {
    const ProgramResult result = lubjoint_program(model_error(more));
    INFO(result.out << result.err);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Contains(message));
  };
  refused({}, "needs a scene, or --length and --radius");
  refused({journal_scene_file, "--length", "0.04"}, "not both");
  refused({"--length", "0.04", "--radius", "0.01", "--load", "30"}, "all four or none");
  refused({"--length", "0.04", "--radius", "0"}, "--radius");
  refused({"--length", "-1", "--radius", "0.01"}, "length");
  Words backwards = journal;
  backwards[9] = "-30";
  refused(backwards, "--load");
}

}  // namespace model_error_command_test

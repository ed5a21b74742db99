// `losses`: a table of motions in, the same with torques, power and side flow out.
#include <catch2/catch.hpp>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/film/losses.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"

namespace losses_command_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

namespace {

const std::string header = "ex,ey,vx,vy,omega_bearing,omega_journal";
const Bearing<long double> bearing(0.04, 0.0098, 2e-4);
const Lubricant<long double> oil(0.4);

Words arguments(std::string_view law, const Words& more = {}) {
  Words words{"losses",   "--law", std::string(law), "--states", "-",           "--viscosity", "0.4",
              "--length", "0.04",  "--radius",       "0.0098",   "--clearance", "0.0002"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Numbers of a few binary digits, so that they are what the program reads; the last one moves at a right angle to e.
const std::string states = header +
                           ",note\n0.0000625,-0.00003125,0.0078125,0.25,2,50,a\n0,0,0.5,0,0,-30,b\n"
                           "0,0,0,0,0,10,c\n0.000125,0,0,0,0,52.5,d\n";

CsvRow refused(const Words& words, const std::string& input) {
  const ProgramResult result = lubjoint_program(words, {.input = input});
  CHECK(result.status == 2);
  CHECK(result.out.empty());
  return {{"message", result.err}};
}

}  // namespace

TEST_CASE("losses: rows come back as they were, with the library's torques, power and flow to the bit") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const ProgramResult result = lubjoint_program(arguments(Law::name), {.input = states});
    REQUIRE(result.status == 0);
    CHECK_THAT(result.out,
               Catch::Matchers::StartsWith(header + ",note,fx,fy,torque_journal,torque_bearing,power,side_flow\n"));
    const auto rows = parse_csv(result.out);
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].at("note") == "a");
    for (const CsvRow& row : rows) {
      const auto given = [&](const char* name) { return static_cast<long double>(std::stod(row.at(name))); };
      const JournalMotion<long double> motion{Vector2<long double>(given("ex"), given("ey")),
                                              Vector2<long double>(given("vx"), given("vy")), given("omega_bearing"),
                                              given("omega_journal")};
      const auto film = film_state(motion, bearing.clearance());
      const auto losses = film_losses<Law>(bearing, oil, film, motion.journal_spin - motion.bearing_spin);
      CHECK(std::stod(row.at("fx")) == static_cast<double>(losses.force.x()));
      CHECK(std::stod(row.at("fy")) == static_cast<double>(losses.force.y()));
      CHECK(std::stod(row.at("torque_journal")) == static_cast<double>(losses.torque_journal));
      CHECK(std::stod(row.at("torque_bearing")) == static_cast<double>(losses.torque_bearing));
      CHECK(std::stod(row.at("power")) == static_cast<double>(losses.power()));
      const auto flow = side_flow<Law>(bearing, film);
      CHECK(row.at("side_flow").empty() == !flow.has_value());
      if (flow) CHECK(std::stod(row.at("side_flow")) == static_cast<double>(*flow));
      // T_J + T_B + e×F = 0, to the rounding of four printed numbers.
      const long double moment = given("ex") * losses.force.y() - given("ey") * losses.force.x();
      const double sum = std::stod(row.at("torque_journal")) + std::stod(row.at("torque_bearing"));
      CHECK(std::abs(sum + static_cast<double>(moment)) <= 1e-15 * std::abs(std::stod(row.at("torque_journal"))));
    }
  });
}

TEST_CASE("losses: flooded shear costs more, striated is empty where the journal moves along e") {
  const auto rows = [&](const char* shear) {
    const ProgramResult result = lubjoint_program(arguments("short_half", {"--shear", shear}), {.input = states});
    REQUIRE(result.status == 0);
    return parse_csv(result.out);
  };
  const auto film = rows("film");
  const auto flooded = rows("flooded");
  const auto striated = rows("striated");
  CHECK(std::stod(film[3].at("power")) < std::stod(striated[3].at("power")));
  CHECK(std::stod(striated[3].at("power")) < std::stod(flooded[3].at("power")));
  for (const char* column : {"torque_journal", "torque_bearing", "power"}) CHECK(striated[0].at(column).empty());
  CHECK_FALSE(striated[0].at("fx").empty());
  CHECK(striated[0].at("side_flow") == film[0].at("side_flow"));
}

TEST_CASE("losses: bad options and states are refused by name, with what is allowed") {
  CHECK_THAT(refused(arguments("short_hlf"), states)["message"], Contains("did you mean short_half?"));
  CHECK_THAT(refused(arguments("short_half", {"--shear", "floded"}), states)["message"],
             Contains("--shear is \"floded\"") && Contains("did you mean flooded?"));
  CHECK_THAT(refused(arguments("long_dynamic", {"--shear", "striated"}), states)["message"],
             Contains("striated") && Contains("long_dynamic") && Contains("allowed is film or flooded"));
  CHECK_THAT(refused(arguments("short_half"), header + "\n0.0002,0,0,0,0,1\n")["message"],
             Contains("standard input:2: ") && Contains("[0, 1)"));
  CHECK_THAT(refused(arguments("short_half"), header + "\n0,0,nan,0,0,1\n")["message"], Contains(":2: vx is \"nan\""));
  CHECK_THAT(refused(arguments("short_half"), "ex,ey,vx,vy,omega_journal\n0,0,0,0,1\n")["message"],
             Contains("omega_bearing"));
  CHECK_THAT(refused(arguments("short_half"), header + "\n1e-4,0,1e300,0,0,1e300\n")["message"],
             Contains(":2: ") && Contains("range of double precision"));
}

}  // namespace losses_command_test

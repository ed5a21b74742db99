// `mobility`: a table of forces in, the same with the velocities that carry them out.
#include <catch2/catch.hpp>

#include "lubjoint/film/mobility.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"

namespace mobility_command_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

namespace {

const std::string header = "ex_over_c,ey_over_c,fx,fy";
const Bearing<long double> bearing(0.04, 0.0098, 2e-4);
const Lubricant<long double> oil(0.4);

Words arguments(std::string_view law, const std::string& viscosity = "0.4") {
  return {"mobility", "--law", std::string(law), "--states", "-",           "--viscosity", viscosity,
          "--length", "0.04",  "--radius",       "0.0098",   "--clearance", "0.0002"};
}

ProgramResult answer(std::string_view law, const std::string& rows) {
  return lubjoint_program(arguments(law), {.input = header + '\n' + rows});
}

std::string refused(std::string_view law, const std::string& input, const char* viscosity = "0.4") {
  const ProgramResult result = lubjoint_program(arguments(law, viscosity), {.input = input});
  CHECK(result.status == 2);
  CHECK(result.out.empty());
  return result.err;
}

// ê = (½, 0): forces along and across it, closing and opening, and one at the centre.
const std::string forces = "0.5,0,-40,3\n0.5,0,40,3\n0.5,0,2,-8\n0.5,0,-2,0.25\n0,0,3,-4\n0.25,-0.5,0,0\n";

}  // namespace

TEST_CASE("mobility: rows come back as they were, with the library's velocities to the bit and their status") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const ProgramResult result = answer(Law::name, forces);
    REQUIRE(result.status == 0);
    const std::string more = Law::extent == FilmExtent::half ? ",other_ux,other_uy" : "";
    CHECK_THAT(result.out, Catch::Matchers::StartsWith(header + ",ux,uy,status" + more + "\n"));
    const auto rows = parse_csv(result.out);
    REQUIRE(rows.size() == 6);
    for (const CsvRow& row : rows) {
      const auto given = [&](const char* name) { return static_cast<long double>(std::stod(row.at(name))); };
      const Vector2<long double> e(given("ex_over_c"), given("ey_over_c"));
      const auto m = mobility<Law>(bearing, oil, e, Vector2<long double>(given("fx"), given("fy")));
      CHECK(row.at("status") == mobility_status_names[static_cast<std::size_t>(m.status)]);
      REQUIRE(row.at("ux").empty() == !m.velocity.has_value());
      REQUIRE(row.at("uy").empty() == !m.velocity.has_value());
      if (!m.velocity) continue;
      CHECK(std::stod(row.at("ux")) == static_cast<double>(m.velocity->x()));
      CHECK(std::stod(row.at("uy")) == static_cast<double>(m.velocity->y()));
      // The force there is the one given, to the rounding of the printed velocity times the film's condition.
      const FilmState<long double> film(e, Vector2<long double>(std::stod(row.at("ux")), std::stod(row.at("uy"))));
      const Vector2<long double> apart =
          film_force<Law>(bearing, oil, film) - Vector2<long double>(given("fx"), given("fy"));
      CHECK(static_cast<double>(apart.norm()) <= 1e-14 * 50);
    }
  });
}

TEST_CASE("mobility: a half film answers none or two where its force jumps, and names both of two") {
  const auto rows = parse_csv(answer("short_half", "0.5,0,40,0\n0.5,0,-40,0\n0.5,0,-40,30\n").out);
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].at("status") == "two");
  CHECK(rows[0].at("other_ux") == rows[0].at("ux"));
  CHECK(std::stod(rows[0].at("other_uy")) == -std::stod(rows[0].at("uy")));
  CHECK(rows[1].at("status") == "none");
  for (const char* column : {"ux", "uy", "other_ux", "other_uy"}) CHECK(rows[1].at(column).empty());
  CHECK(rows[2].at("status") == "found");
  CHECK(rows[2].at("other_ux").empty());
}

TEST_CASE("mobility: says where it is not proved that a velocity is the only one, and only there") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const ProgramResult result = answer(Law::name, forces);
    const std::string_view name = Law::name;
    if (name == "long_dynamic" || name == "pinkus_sternlicht") {
      CHECK_THAT(result.err, Contains("note: " + std::string(name)) && Contains("measured, not proved"));
    } else {
      CHECK(result.err.empty());
    }
  });
}

TEST_CASE("mobility: bad options and states are refused by name, with what is allowed") {
  CHECK_THAT(refused("short_hlf", header + "\n"), Contains("did you mean short_half?"));
  CHECK_THAT(refused("short_full", header + "\n1,0,1,0\n"), Contains("standard input:2: ") && Contains("[0, 1)"));
  CHECK_THAT(refused("short_full", header + "\n0,0,nan,0\n"), Contains(":2: fx is \"nan\""));
  CHECK_THAT(refused("short_full", "ex_over_c,ey_over_c,fx\n0,0,1\n"), Contains("fy"));
  CHECK_THAT(refused("short_full", header + "\n0,0,1e308,0\n", "1e-6"),
             Contains(":2: ") && Contains("range of double"));
}

}  // namespace mobility_command_test

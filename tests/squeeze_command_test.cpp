// `force`, `losses` and `mobility` of the laws of the squeeze alone.
#include <catch2/catch.hpp>
#include <numbers>

#include "lubjoint/film/every_law.hpp"
#include "lubjoint/film/losses.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"

namespace squeeze_command_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

namespace {

const Bearing<long double> bearing(0.04, 0.0098, 2e-4);
const Lubricant<long double> oil(0.4);

std::vector<CsvRow> answer(const char* command, std::string_view law, const std::string& states) {
  const Words words = {command,    "--law", std::string(law), "--states", "-",           "--viscosity", "0.4",
                       "--length", "0.04",  "--radius",       "0.0098",   "--clearance", "0.0002"};
  const ProgramResult result = lubjoint_program(words, {.input = states});
  REQUIRE(result.status == 0);
  return parse_csv(result.out);
}

double value(const CsvRow& row, const char* name) { return std::stod(row.at(name)); }

}  // namespace

TEST_CASE("force: squeeze laws answer to the bit of the library, with the film of the squeeze and without the wedge") {
  for_each_film_law<SqueezeFilmLaws>([]<class Law>() {
    INFO(Law::name);
    const auto rows = answer("force", Law::name,
                             "eccentricity_ratio,slip_rate,squeeze_rate\n0.5,3,1\n0.5,0,1\n0.75,-2,-0.5\n0,1,2\n");
    REQUIRE(rows.size() == 4);
    for (const CsvRow& row : rows) {
      const PolarFilmState<long double> state(value(row, "eccentricity_ratio"), value(row, "slip_rate"),
                                              value(row, "squeeze_rate"));
      CHECK(value(row, "radial") == static_cast<double>(film_force<Law>(bearing, oil, state).radial));
      CHECK(value(row, "tangential") == 0);
      if (Law::extent == FilmExtent::full) continue;
      const double quarter = std::numbers::pi / 2;
      CHECK(value(row, "theta_s") == (value(row, "squeeze_rate") > 0 ? quarter : -quarter));
      CHECK(value(row, "theta_e") == Approx(value(row, "theta_s") + 2 * quarter).epsilon(1e-15));  // rounding
    }
    CHECK(rows[0].at("radial") == rows[1].at("radial"));
  });
}

TEST_CASE("losses: squeeze laws shear the film of the squeeze, and the bodies' power is the film's") {
  for_each_film_law<SqueezeFilmLaws>([]<class Law>() {
    INFO(Law::name);
    const auto rows =
        answer("losses", Law::name, "ex,ey,vx,vy,omega_bearing,omega_journal\n0.000125,0,0.25,0.5,2,50\n");
    REQUIRE(rows.size() == 1);
    const CsvRow& row = rows[0];
    CHECK(value(row, "fy") == 0);
    // −(F·v + T_J ω_J + T_B ω_B), to the rounding of its terms.
    const double power =
        -(value(row, "fx") * 0.25 + value(row, "torque_journal") * 50 + value(row, "torque_bearing") * 2);
    CHECK(value(row, "power") == Approx(power).epsilon(1e-14));
    CHECK(row.at("side_flow").empty() == (Law::limit == BearingLimit::long_bearing));
  });
}

TEST_CASE("mobility: squeeze laws answer many along the eccentricity, none across it, and found at the centre") {
  for_each_film_law<SqueezeFilmLaws>([]<class Law>() {
    INFO(Law::name);
    const auto rows =
        answer("mobility", Law::name, "ex_over_c,ey_over_c,fx,fy\n0.3,0.4,-3,-4\n0.3,0.4,4,-3\n0,0,1,2\n");
    REQUIRE(rows.size() == 3);
    CHECK(rows[0].at("status") == "many");
    const FilmState<long double> film(Vector2<long double>(0.3, 0.4),
                                      Vector2<long double>(value(rows[0], "ux"), value(rows[0], "uy")));
    CHECK(static_cast<double>(film_force<Law>(bearing, oil, film).norm()) == Approx(5).epsilon(1e-14));  // rounding
    CHECK(rows[1].at("status") == "none");
    CHECK(rows[1].at("ux").empty());
    CHECK(rows[2].at("status") == "found");
  });
}

TEST_CASE("a law that there is not is refused with all that there are, squeeze laws among them") {
  const ProgramResult result = lubjoint_program({"force", "--law", "squeze_long", "--states", "-", "--viscosity", "1",
                                                 "--length", "1", "--radius", "1", "--clearance", "0.1"},
                                                {.input = "eccentricity_ratio,slip_rate,squeeze_rate\n"});
  CHECK(result.status == 2);
  CHECK_THAT(result.err, Contains("did you mean squeeze_long?"));
  CHECK_THROWS_WITH(with_film_law<EveryFilmLaw>("none", []<class Law>() { return 0; }), Contains("squeeze_short"));
}

}  // namespace squeeze_command_test

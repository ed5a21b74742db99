// `coefficients`, `stability`, `mobility` and `losses` with laws of finite length, against other routes to the numbers.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "lubjoint/film/compiled_laws.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/results/losses_table.hpp"
#include "oracle/reynolds/cavitated_elements.hpp"
#include "oracle/reynolds/finite_force.hpp"
#include "support/compiled_films.hpp"
#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace finite_film_commands_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Vec = Vector2<double>;
using Words = std::vector<std::string>;

namespace {

// The bearing of example 1: its tables ship.
constexpr double viscosity = 0.4, length = 0.04, radius = 0.0098, clearance = 2e-4;
const Words bearing = {"--viscosity", "0.4", "--length", "0.04", "--radius", "0.0098", "--clearance", "2e-4"};

Words command(Words words) {
  words.insert(words.end(), bearing.begin(), bearing.end());
  return words;
}

reports::CsvTable table_of(const ProgramResult& result) {
  INFO(result.err);
  REQUIRE(result.status == 0);
  return {result.out, "output"};
}

double value(const reports::CsvTable& table, const char* column, std::size_t row = 0) {
  return table.number(row, table.column(column));
}

std::string text(double x) {
  std::ostringstream stream;
  stream.precision(17);
  stream << x;
  return stream.str();
}

}  // namespace

TEST_CASE("coefficients with finite films: those of the scene's equilibrium, in the load's axes") {
  for (const std::string law : {"finite_full", "finite_dynamic", "finite_reynolds"}) {
    INFO(law);
    const ProgramResult scene = lubjoint_program({"equilibrium", journal_scene_file, "--law", law, "--json"});
    REQUIRE(scene.status == 0);
    const auto rest = nlohmann::json::parse(scene.out);
    const auto entry = [&](const char* name, int i, int j) { return rest.at(name).at(i).at(j).get<double>(); };
    const reports::CsvTable row = table_of(
        lubjoint_program(command({"coefficients", "--law", law, "--speeds", "52.35987755982989:52.35987755982989:1",
                                  "--load", text(30 + 0.13 * 9.81)})));
    CHECK(value(row, "eccentricity_ratio") == Approx(rest.at("eccentricity_ratio").get<double>()).epsilon(1e-9));
    CHECK(value(row, "attitude") == Approx(rest.at("attitude").get<double>()).epsilon(1e-9));
    // The load is along −y: x of the load's axes is −y, y is x.
    for (const auto& [name, prefix] : {std::pair{"stiffness", "k"}, std::pair{"damping", "c"}}) {
      const std::string p(prefix);
      const double size = std::abs(entry(name, 0, 1)) + std::abs(entry(name, 0, 0));
      CHECK(value(row, (p + "xx").c_str()) == Approx(entry(name, 1, 1)).margin(1e-8 * size));
      CHECK(value(row, (p + "yy").c_str()) == Approx(entry(name, 0, 0)).margin(1e-8 * size));
      CHECK(value(row, (p + "xy").c_str()) == Approx(-entry(name, 1, 0)).margin(1e-8 * size));
      CHECK(value(row, (p + "yx").c_str()) == Approx(-entry(name, 0, 1)).margin(1e-8 * size));
    }
  }
}

TEST_CASE("coefficients with finite films: half and dynamic are one film at rest, and answer a squeeze differently") {
  const auto row_of = [](const char* law, const char* ratio) {
    return table_of(lubjoint_program(command({"coefficients", "--law", law, "--states", "-", "--omega", "50"}),
                                     {.input = std::string("eccentricity_ratio\n") + ratio + "\n"}));
  };
  const reports::CsvTable half = row_of("finite_half", "0.6");
  const reports::CsvTable dynamic = row_of("finite_dynamic", "0.6");
  for (const char* same : {"load", "attitude", "kxx", "kxy", "kyx", "kyy"}) {
    CHECK(value(half, same) == Approx(value(dynamic, same)).epsilon(1e-6));  // slopes of tables right to 1e-7
  }
  CHECK(std::abs(value(half, "cxx") / value(dynamic, "cxx") - 1) > 0.01);
  CHECK(value(half, "cxy") == Approx(value(half, "cyx")).epsilon(1e-9));  // a potential on each side
  CHECK(std::abs(value(dynamic, "cxy") / value(dynamic, "cyx") - 1) > 0.01);
}

TEST_CASE(
    "stability with finite films: Routh and eigenvalues agree; half films and places beyond the table are warned of") {
  const auto answer = [](const char* law, const char* load) {
    return lubjoint_program(
        command({"stability", "--law", law, "--load", load, "--omega", "52.36", "--mass", "0.13", "--json"}));
  };
  const ProgramResult light = answer("finite_reynolds", "31");
  REQUIRE(light.status == 0);
  const auto json = nlohmann::json::parse(light.out);
  CHECK(json.at("critical_mass").get<double>() ==
        Approx(json.at("critical_mass_by_eigenvalues").get<double>()).epsilon(1e-6));
  CHECK(json.at("stable") == "yes");
  CHECK(light.err.find("warning") == std::string::npos);
  const ProgramResult heavy = answer("finite_reynolds", "50000");
  CHECK(heavy.status == 0);
  CHECK_THAT(heavy.err, Contains("was measured up to eccentricity ratio 0.95"));
  CHECK_THAT(answer("finite_half", "31").err, Contains("times the spin") && Contains("finite_dynamic"));
}

TEST_CASE("mobility with finite films: the velocity whose force it was; half films have one, none or two") {
  const double scale = viscosity * length * std::pow(radius, 3) / (clearance * clearance);
  for (const std::string_view law : names_of_laws<CompiledLaws>) {
    INFO(law);
    const bool is_half = law == "finite_half";
    std::string states = "ex_over_c,ey_over_c,fx,fy\n";
    std::vector<Vec> velocities;
    with_compiled_law(*shipped_film(law, shipped_scenes_shape), [&](const auto& compiled) {
      for (int i = 0; i < 24; ++i) {
        const Vec e = 0.9 * std::sqrt((i + 0.5) / 24) * Vec(std::cos(2.4 * i), std::sin(2.4 * i));
        const Vec u(std::cos(0.9 * i), std::sin(0.9 * i));
        const Vec force = scale * compiled_force_ratio(compiled, FilmState<double>(e, u));
        states += text(e.x()) + "," + text(e.y()) + "," + text(force.x()) + "," + text(force.y()) + "\n";
        velocities.push_back(u);
      }
    });
    const reports::CsvTable rows = table_of(
        lubjoint_program(command({"mobility", "--law", std::string(law), "--states", "-"}), {.input = states}));
    REQUIRE(rows.rows() == velocities.size());
    for (std::size_t i = 0; i < velocities.size(); ++i) {
      const Vec found(value(rows, "ux", i), value(rows, "uy", i));
      double apart = (found - velocities[i]).norm();
      if (is_half && rows.line(i).find("two") != std::string::npos) {
        apart = std::min(apart, (Vec(value(rows, "other_ux", i), value(rows, "other_uy", i)) - velocities[i]).norm());
      }
      CHECK(apart < 1e-9);  // rounding of the given force, times the film's condition of at most 6/q
    }
  }
  const ProgramResult half = lubjoint_program(command({"mobility", "--law", "finite_half", "--states", "-"}),
                                              {.input = "ex_over_c,ey_over_c,fx,fy\n0.5,0,-40,10\n0.5,0,40,0\n"});
  CHECK_THAT(half.out, Contains(",none,") && Contains(",two,"));
}

TEST_CASE("mobility and losses with finite films: states beyond the table are warned of, once, and others not") {
  const std::string warning = "was measured up to eccentricity ratio 0.95, and is not known at 0.98";
  const auto count = [&](const Words& words, const std::string& states) {
    const ProgramResult result = lubjoint_program(command(words), {.input = states});
    INFO(result.err);
    REQUIRE(result.status == 0);
    std::size_t times = 0;
    for (std::size_t at = 0; (at = result.err.find("is not known at", at)) != std::string::npos; ++at) ++times;
    CHECK((result.err.find(warning) != std::string::npos) == (times == 1));
    return times;
  };
  const Words mobility = {"mobility", "--law", "finite_reynolds", "--states", "-"};
  const std::string forces = "ex_over_c,ey_over_c,fx,fy\n0,0.9,-40,10\n";
  CHECK(count(mobility, forces) == 0);
  CHECK(count(mobility, forces + "0.98,0,-40,10\n0,-0.97,-40,10\n") == 1);  // the farther of the two
  const Words losses = {"losses", "--law", "finite_reynolds", "--shear", "flooded", "--states", "-"};
  const std::string motions = "ex,ey,vx,vy,omega_bearing,omega_journal\n0,1.8e-4,1e-3,2e-3,0,52\n";
  CHECK(count(losses, motions) == 0);
  CHECK(count(losses, motions + "1.96e-4,0,1e-3,2e-3,0,52\n0,-1.94e-4,1e-3,2e-3,0,52\n") == 1);
  CHECK(count({"mobility", "--law", "short_dynamic", "--states", "-"}, forces + "0.98,0,-40,10\n") == 0);  // no table
}

TEST_CASE("losses with finite films: moments and power balance, Petroff's friction, and what a table does not know") {
  const Vec e(1e-4, 2e-5);
  const Vec v(1e-3, 2e-3);
  const double bearing_spin = 1, journal_spin = 52;
  const std::string state = "ex,ey,vx,vy,omega_bearing,omega_journal\n1e-4,2e-5,1e-3,2e-3,1,52\n";
  const auto losses = [&](std::string_view law, const char* shear) {
    return lubjoint_program(command({"losses", "--law", std::string(law), "--shear", shear, "--states", "-"}),
                            {.input = state});
  };
  const double ratio = e.norm() / clearance;
  const double petroff = viscosity * std::pow(radius, 3) * length / clearance * 2 * std::numbers::pi /
                         std::sqrt(1 - ratio * ratio) * (journal_spin - bearing_spin);
  for (const std::string_view law : names_of_laws<CompiledLaws>) {
    INFO(law);
    const reports::CsvTable row = table_of(losses(law, "flooded"));
    const Vec force(value(row, "fx"), value(row, "fy"));
    const double moment = cross(e, force);
    const double on_journal = value(row, "torque_journal");
    const double on_bearing = value(row, "torque_bearing");
    CHECK(on_journal + on_bearing + moment == Approx(0).margin(1e-12 * std::abs(moment)));
    CHECK((on_bearing - on_journal) / 2 == Approx(petroff).epsilon(1e-12));
    // What the bodies lose: forces and torques on both of them.
    const double lost = -(dot(force, v) + on_journal * journal_spin + on_bearing * bearing_spin);
    CHECK(value(row, "power") == Approx(lost).epsilon(1e-12));
    CHECK(value(row, "power") > 0);
    const FilmState<double> film = film_state(JournalMotion<double>{e, v, bearing_spin, journal_spin}, clearance);
    with_compiled_law(*shipped_film(law, shipped_scenes_shape), [&](const auto& compiled) {
      const Vec own =
          film_force(compiled, Bearing<double>(length, radius, clearance), Lubricant<double>(viscosity), film);
      CHECK((force - own).norm() < 1e-12 * own.norm());
    });
    // The side flow by the other solver: along the axis, or by finite elements.
    const double shape = length / (2 * radius);
    const double displaced = 2 * clearance * radius * length * film.velocity.norm();
    const double flow = value(row, "side_flow");
    if (law == "finite_reynolds") {
      const PolarView<double> view = polar_view(film);
      const double a = std::abs(view.state.slip_rate), b = view.state.squeeze_rate;
      const double solved = oracle::cavitated_flow_by_elements({ratio, 1 - ratio, a, b, shape}, 32).value[0];
      CHECK(std::abs(flow - clearance * radius * radius * solved) < 1.2e-3 * displaced);  // 1e-3 and the elements' own
    } else {
      const double solved = oracle::finite_side_flow(oracle::finite_film_of(law), shape, film, {1e-8}).ratio;
      CHECK(std::abs(flow - clearance * radius * length * solved) < 1.1e-6 * displaced);  // 1e-6 and the series' own
      CHECK((flow == 0) == (law == "finite_full"));
    }
    CHECK_THAT(losses(law, "flooded").err, Contains("solved for at each state"));
  }
  CHECK(losses("finite_dynamic", "film").status == 0);
  CHECK(losses("finite_half", "striated").status == 0);
  const ProgramResult refused = losses("finite_reynolds", "striated");
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Contains("finite_reynolds") && Contains("allowed is film or flooded"));
  CHECK_THAT(losses("finite_full", "striated").err, Contains("striated"));
}

TEST_CASE("losses with finite_reynolds: without --shear the oil is sheared where the film carries pressure") {
  const Vec e(1e-4, 2e-5);
  for (const Vec& v : {Vec(1e-3, 2e-3), Vec(-2e-3, 1e-3), Vec(0, 0)}) {
    const double spin = 51;
    const std::string state =
        fmt::format("ex,ey,vx,vy,omega_bearing,omega_journal\n1e-4,2e-5,{},{},1,52\n", v.x(), v.y());
    const ProgramResult result =
        lubjoint_program(command({"losses", "--law", "finite_reynolds", "--states", "-"}), {.input = state});
    CHECK_THAT(result.err, Contains("shear: of where the film carries pressure, solved for at each state"));
    const reports::CsvTable row = table_of(result);
    const FilmState<double> film = film_state(JournalMotion<double>{e, v, 1, 52}, clearance);
    const PolarView<double> view = polar_view(film);
    const double ratio = view.state.eccentricity_ratio;
    // By finite elements, which share no step with what the program solves by.
    const oracle::ScaledCouette solved = oracle::cavitated_couette_by_elements(
        {ratio, 1 - ratio, std::abs(view.state.slip_rate), view.state.squeeze_rate, length / (2 * radius)}, 64);
    const double unit = viscosity * std::pow(radius, 3) * length / clearance * spin;
    const double couette = (value(row, "torque_bearing") - value(row, "torque_journal")) / 2;
    INFO("v " << v.transpose() << ", elements " << solved.error[0] / solved.value[0]);
    CHECK(solved.error[0] < 5e-4 * solved.value[0]);  // else they would say nothing
    CHECK(std::abs(couette / unit - solved.value[0]) <
          reports::solved_couette_tolerance * solved.value[0] + solved.error[0]);
    const Vec force(value(row, "fx"), value(row, "fy"));
    const double lost = -(dot(force, v) + value(row, "torque_journal") * 52 + value(row, "torque_bearing") * 1);
    CHECK(value(row, "power") == Approx(lost).epsilon(1e-12));  // rounding of the printed numbers
    // Neither the whole gap nor the dynamic film.
    CHECK(couette / unit < 0.95 * 2 * std::numbers::pi / std::sqrt(film.q));
    CHECK(couette / unit > 1.05 * couette_integral(film, ShearedGap::dynamic));
  }
}

}  // namespace finite_film_commands_test

// The README's design example: its output is the program's, its sentences are rounded from it.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "oracle/results/stability_map.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"

namespace design_example_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

namespace {

Words command(const std::string& name, const Words& more) {
  Words words{name,   "--law",    "short_dynamic", "--viscosity", "0.02", "--length",
              "0.05", "--radius", "0.05",          "--clearance", "5e-5"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace

TEST_CASE("README: the design example prints what the program prints, and its sentences are rounded from that") {
  const std::string readme = read_text(LUBJOINT_SOURCE_DIR "/README.md");
  const ProgramResult rotor =
      lubjoint_program(command("stability", {"--load", "5000", "--omega", "314.159", "--mass", "500"}));
  REQUIRE(rotor.status == 0);
  CHECK_THAT(readme, Contains(rotor.out));

  // The states in the README are the place of the journal, to six digits.
  const reports::FilmInBearing film{"short_dynamic", {0.05, 0.05, 5e-5}, Lubricant<double>(0.02)};
  const auto rest = reports::coefficients_under(film, 5000, 314.159);
  const double e = 5e-5 * rest->eccentricity_ratio;
  const std::string states = fmt::format("ex,ey,vx,vy,omega_bearing,omega_journal\n{:.5f}e-5,{:.5f}e-6,0,0,0,314.159\n",
                                         1e5 * e * std::sin(rest->attitude), -1e6 * e * std::cos(rest->attitude));
  std::string written = states;  // as printf takes it
  for (std::size_t at = 0; (at = written.find('\n', at)) != std::string::npos;) written.replace(at, 1, "\\n");
  CHECK_THAT(readme, Contains("printf '" + written + "'"));
  const ProgramResult cost = lubjoint_program(command("losses", {"--states", "-"}), {.input = states});
  REQUIRE(cost.status == 0);
  CHECK_THAT(readme, Contains(cost.out));
  const CsvRow row = parse_csv(cost.out)[0];
  const auto number = [&](const char* column) { return std::stod(row.at(column)); };
  CHECK_THAT(readme, Contains(fmt::format("the film is {:.1f} µm thin", 1e6 * 5e-5 * (1 - rest->eccentricity_ratio))));
  CHECK_THAT(readme, Contains(fmt::format("braked by {:.2f} N m", -number("torque_journal"))));
  CHECK_THAT(readme, Contains(fmt::format("dragged along by {:.2f} N m", number("torque_bearing"))));
  CHECK_THAT(readme, Contains(fmt::format("{:.0f} W go into the oil", number("power"))));
  CHECK_THAT(readme, Contains(fmt::format("{:.1f} cm³/s of it leave", 1e6 * number("side_flow"))));
  CHECK_THAT(readme, Contains(fmt::format("a factor of {:.0f} in the mass", rest->critical_mass / 500)));
  const reports::RotorAnswer answer = reports::rotor_answer({film, 5000, 314.159, 500});
  REQUIRE(answer.critical_speeds.size() == 1);
  CHECK_THAT(readme, Contains(fmt::format("and of {:.1f} in speed", answer.critical_speeds[0].omega / 314.159)));

  const double whirl = reports::whirl_ratio_at_the_centre("long_half");
  CHECK_THAT(readme, Contains(fmt::format("up to {:.3f} times the spin", whirl)));
  const auto concentric = [&](const char* law) {  // critical mass over W/(cω²) as ε → 0
    const reports::FilmInBearing other{law, film.bearing, film.oil};
    const auto at = reports::coefficients_at(other, 1e-9, 314.159);
    return at.critical_mass / at.load;
  };
  CHECK_THAT(readme, Contains(fmt::format("threshold of mass {:.1f} times too low",
                                          concentric("long_dynamic") / concentric("long_half"))));
}

}  // namespace design_example_test

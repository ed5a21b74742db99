// `oracle`: forces and pressures by quadrature and of finite length, run as a user runs them.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "lubjoint/film/law_list.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"

namespace oracle_command_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;
using Words = std::vector<std::string>;

namespace {

constexpr double radius = 0.0098;
constexpr double length = 0.04;

Words with_bearing(Words words, const std::string& bearing_length = "0.04") {
  for (const char* word : {"--viscosity", "0.4", "--radius", "0.0098", "--clearance", "0.0002", "--length"}) {
    words.emplace_back(word);
  }
  words.push_back(bearing_length);
  return words;
}

std::string output_of(const Words& words, const std::string& input = {}) {
  const ProgramResult result = lubjoint_program(words, {.input = input});
  INFO(result.err);
  REQUIRE(result.status == 0);
  return result.out;
}

void check_refused(const Words& words, const std::string& message) {
  const ProgramResult result = lubjoint_program(words);
  INFO(result.out << result.err);
  CHECK(result.status == 2);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Contains(message));
}

struct Force {
  double radial, tangential;
};

Force force_in(const CsvRow& row) { return {number(row.at("radial")), number(row.at("tangential"))}; }
double size(const Force& f) { return std::hypot(f.radial, f.tangential); }
double apart(const Force& f, const Force& g) { return std::hypot(f.radial - g.radial, f.tangential - g.tangential); }

// Centre, sliding, closing, opening, near the wall.
const std::string states =
    "eccentricity_ratio,slip_rate,squeeze_rate\n"
    "0,3,1\n0.1,-2,0\n0.5,2,1\n0.5,-2,-1\n0.9,1,0.1\n0.9,0,-1\n0.999,-5,0.5\n0.999999,1,1\n";

Words pressure_of(const std::string& film, Words more = {}) {
  Words words = with_bearing({"oracle", "pressure", "--film", film, "--eccentricity-ratio", "0.6", "--slip-rate", "-40",
                              "--squeeze-rate", "15"});
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace

TEST_CASE("oracle force: agrees with every closed-form law within the error that it states, by every rule") {
  for (const std::string film :
       {"short_full", "short_half", "short_dynamic", "long_full", "long_half", "long_dynamic"}) {
    const auto closed = parse_csv(output_of(with_bearing({"force", "--law", film, "--states", "-"}), states));
    const bool dynamic = film.ends_with("dynamic");
    for (const std::string rule : {"gauss_legendre", "qag", "qags", "cquad"}) {
      INFO(film << " " << rule);
      const std::string csv = output_of(
          with_bearing({"oracle", "force", "--film", film, "--rule", rule, "--rtol", "1e-10", "--states", "-"}),
          states);
      CHECK(first_line(csv) == std::string("eccentricity_ratio,slip_rate,squeeze_rate,radial,tangential,") +
                                   (dynamic ? "theta_s,theta_e," : "") + "radial_error,tangential_error");
      const auto rows = parse_csv(csv);
      REQUIRE(rows.size() == closed.size());
      for (std::size_t i = 0; i < rows.size(); ++i) {
        INFO("e/c " << rows[i].at("eccentricity_ratio"));
        const Force expected = force_in(closed[i]);
        const double stated = std::hypot(number(rows[i].at("radial_error")), number(rows[i].at("tangential_error")));
        CHECK(stated <= 3e-10 * size(expected));  // --rtol is that of each component and, in long films, of a turn
        // The last digits are also the closed form's own.
        CHECK(apart(force_in(rows[i]), expected) <= stated + 1e-13 * size(expected));
        if (!dynamic) continue;
        for (const char* bound : {"theta_s", "theta_e"}) {
          CHECK(std::abs(number(rows[i].at(bound)) - number(closed[i].at(bound))) <
                1e-12);  // rounding of angles to 2 pi
        }
      }
    }
  }
}

TEST_CASE("oracle force: a film of finite length becomes the short film as L/D goes to 0, and is less than the long") {
  const std::string state = "eccentricity_ratio,slip_rate,squeeze_rate\n0.5,-2,1\n";
  for (const std::string extent : {"full", "half", "dynamic"}) {
    std::vector<double> errors;
    for (const char* short_length : {"0.004", "0.001"}) {  // L/D 0.2 and 0.05
      Words words = with_bearing({"oracle", "force", "--film", "finite_" + extent, "--states", "-"}, short_length);
      words.insert(words.end(), {"--rtol", "1e-5"});
      const auto finite = parse_csv(output_of(words, state));
      const auto limit = parse_csv(
          output_of(with_bearing({"force", "--law", "short_" + extent, "--states", "-"}, short_length), state));
      errors.push_back(apart(force_in(finite[0]), force_in(limit[0])) / size(force_in(limit[0])));
    }
    INFO(extent << " " << errors[0] << " " << errors[1]);
    // The half film is cut where the short film has a pressure: there a layer as wide as the bearing is long is lost.
    // The others end where it vanishes, or do not end, and lose the square of L/D.
    const double order = std::log(errors[0] / errors[1]) / std::log(4.0);
    CHECK(std::abs(order - (extent == "half" ? 1 : 2)) < 0.25);  // the next term, at L/D 0.2
    CHECK(errors[1] < 0.05);                                     // L/D
    const auto finite =
        parse_csv(output_of(with_bearing({"oracle", "force", "--film", "finite_" + extent, "--states", "-"}), state));
    const auto infinite =
        parse_csv(output_of(with_bearing({"force", "--law", "long_" + extent, "--states", "-"}), state));
    CHECK(size(force_in(finite[0])) < size(force_in(infinite[0])));
    CHECK(finite[0].contains("theta_s") == (extent == "dynamic"));
  }
}

TEST_CASE("oracle force: Reynolds' film states its error, and its tolerance is kept") {
  const Words words = with_bearing({"oracle", "force", "--film", "finite_reynolds", "--states", "-"});
  const std::string state = "eccentricity_ratio,slip_rate,squeeze_rate\n0.5,-2,1\n0.9,1,0.1\n";
  Words finer = words;
  finer.insert(finer.end(), {"--rtol", "1e-4"});
  const auto coarse = parse_csv(output_of(words, state));
  const auto fine = parse_csv(output_of(finer, state));
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const double stated = std::hypot(number(coarse[i].at("radial_error")), number(coarse[i].at("tangential_error")));
    const double finer_stated = std::hypot(number(fine[i].at("radial_error")), number(fine[i].at("tangential_error")));
    CHECK(stated <= 1e-3 * size(force_in(fine[i])));
    CHECK(finer_stated <= 1e-4 * size(force_in(fine[i])));
    CHECK(apart(force_in(coarse[i]), force_in(fine[i])) <= stated + finer_stated);
  }
  Words onset = words;
  onset.insert(onset.end(), {"--onset", "maximum_film"});
  // In pure sliding a film that begins at the maximum film thickness has another edge: another force.
  const std::string sliding = "eccentricity_ratio,slip_rate,squeeze_rate\n0.5,-2,0\n";
  const Force free = force_in(parse_csv(output_of(words, sliding))[0]);
  CHECK(apart(force_in(parse_csv(output_of(onset, sliding))[0]), free) > 0.1 * size(free));
}

TEST_CASE("oracle pressure: the field is zero at the ends, and its sum over the film is the force") {
  // A simple sum over the printed field, and the adaptive quadrature behind `oracle force`.
  const auto forces = [](const std::string& film) {
    return parse_csv(output_of(with_bearing({"oracle", "force", "--film", film, "--states", "-"}),
                               "eccentricity_ratio,slip_rate,squeeze_rate\n0.6,-40,15\n"))[0];
  };
  for (const std::string film : {"short_half", "long_full", "short_dynamic", "finite_half", "finite_reynolds"}) {
    INFO(film);
    const std::string csv = output_of(pressure_of(film, {"--angles", "721", "--stations", "41"}));
    CHECK(first_line(csv) == "theta,z,pressure");
    const auto rows = parse_csv(csv);
    REQUIRE(rows.size() == 721 * 41);
    Force sum{0, 0};
    double at_ends = 0;
    double largest = 0;
    for (std::size_t i = 0; i < 721; ++i) {
      for (std::size_t j = 0; j < 41; ++j) {
        const CsvRow& row = rows[i * 41 + j];
        const double theta = number(row.at("theta"));
        const double p = number(row.at("pressure"));
        const bool end = j == 0 || j == 40;
        largest = std::max(largest, std::abs(p));
        if (end) at_ends = std::max(at_ends, std::abs(p));
        const double weight =
            (end ? 0.5 : 1) * (i == 0 || i == 720 ? 0.5 : 1) * radius * (2 * std::numbers::pi / 720) * length / 40;
        sum.radial += weight * p * std::cos(theta);
        sum.tangential += weight * p * std::sin(theta);
      }
    }
    CHECK(number(rows.front().at("z")) == -length / 2);
    CHECK(number(rows.back().at("z")) == length / 2);
    if (!film.starts_with("long")) CHECK(at_ends < 1e-14 * largest);  // rounding of a sum of modes
    const CsvRow force = forces(film);
    INFO(sum.radial << " " << sum.tangential << ", " << force.at("radial") << " " << force.at("tangential"));
    // Trapezoids: 41 stations of a parabola lose 1/1600. Half films are cut at an angle where p is not 0, which costs
    // half a step of 2 pi/720 of it.
    CHECK(apart(sum, force_in(force)) < (film.ends_with("half") ? 1e-2 : 2e-3) * size(force_in(force)));
  }
}

TEST_CASE("oracle pressure: --out writes the same field and its plot, and nothing else") {
  const TemporaryFolder folder;
  CHECK(output_of(pressure_of("long_dynamic", {"--out", folder / "out"})).empty());
  CHECK(folder.entries() == std::set<std::string>{"out", "out/pressure.csv", "out/pressure.png", "out/pressure.svg"});
  CHECK(read_text(folder / "out/pressure.csv") == output_of(pressure_of("long_dynamic")));
  CHECK_THAT(read_text(folder / "out/pressure.svg"), Contains("Pressure [MPa]") && Contains("long_dynamic"));
}

TEST_CASE("oracle difference: the law of Pinkus and Sternlicht against the film that it approximates") {
  const TemporaryFolder folder;
  const std::string text = output_of({"oracle", "difference", "--out", folder / "out"});
  CHECK_THAT(text, Contains("median   5.94 %") && Contains("median  15.60 %"));
  CHECK(folder.entries() == std::set<std::string>{"out", "out/pinkus-sternlicht-difference.csv",
                                                  "out/pinkus-sternlicht-difference.png",
                                                  "out/pinkus-sternlicht-difference.svg"});
  CHECK(read_csv(folder / "out/pinkus-sternlicht-difference.csv").size() == 97);
}

TEST_CASE("oracle: films, rules, tolerances and grids that are none are refused with what is allowed") {
  const auto force = [](Words more) {
    Words words = with_bearing({"oracle", "force", "--states", "-"});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  check_refused(force({"--film", "short"}), "short_full, short_half");
  check_refused(force({"--film", "finite_ful"}), "finite_reynolds");
  check_refused(force({"--film", "short_full", "--rule", "simpson"}), "gauss_legendre");
  check_refused(force({"--film", "short_full", "--rtol", "0"}), "1e-15 to 0.1");
  check_refused(force({"--film", "finite_full", "--rtol", "1e-13"}), "1e-12 to 0.1");
  check_refused(force({"--film", "finite_reynolds", "--onset", "early"}), "free, maximum_film");
  check_refused(pressure_of("short_full", {"--angles", "2"}), "3 to 10000");
  check_refused(pressure_of("short_full", {"--stations", "1001"}), "3 to 1000");
  check_refused(with_bearing({"oracle", "pressure", "--film", "short_full", "--eccentricity-ratio", "1", "--slip-rate",
                              "1", "--squeeze-rate", "0"}),
                "eccentricity ratio");
  check_refused({"oracle"}, "a command is missing after \"oracle\"; allowed is one of force, pressure, difference");
  check_refused({"oracle", "presure"}, "there is no command \"presure\" after \"oracle\"");
  check_refused({"oracle", "presure"}, "pressure");
}

}  // namespace oracle_command_test

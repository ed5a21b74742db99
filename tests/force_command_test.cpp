// `force`: a table of states in, the same with forces out.
#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>
#include <random>

#include "lubjoint/film/law_list.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"

namespace force_command_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Words = std::vector<std::string>;

namespace {

const Bearing<double> bearing(0.04, 0.0098, 2e-4);
const Lubricant<double> oil(0.4);

Words arguments(std::string_view law, const std::string& states = "-") {
  return {"force",    "--law", std::string(law), "--states", states,        "--viscosity", "0.4",
          "--length", "0.04",  "--radius",       "0.0098",   "--clearance", "0.0002"};
}

std::string shortest(double value) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

Words lines(const std::string& text) {
  Words list;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) list.push_back(line);
  return list;
}

std::vector<PolarFilmState<double>> states() {
  std::vector<PolarFilmState<double>> list{{0, 0, 0},     {0, 3, 0},      {0, -3, 1},     {0, 0, -1},
                                           {0.5, 0, 0},   {0.5, 0, 1},    {1e-300, 1, 1}, {1 - 1e-12, 1, -1},
                                           {0.9, -50, 2}, {0.5, 1e-30, 1}};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> part(-1, 1);
  for (int i = 0; i < 200; ++i) list.emplace_back(std::abs(part(random)), 100 * part(random), 100 * part(random));
  return list;
}

const std::string header = "eccentricity_ratio,slip_rate,squeeze_rate";

std::string csv(const std::vector<PolarFilmState<double>>& list) {
  std::string text = header + "\n";
  for (const auto& s : list) {
    text += shortest(s.eccentricity_ratio) + "," + shortest(s.slip_rate) + "," + shortest(s.squeeze_rate) + "\n";
  }
  return text;
}

/// The library's force in extended precision, rounded once: what the command prints.
template <FilmLaw Law>
PolarForce<double> rounded_once(const PolarFilmState<double>& s) {
  using Wide = long double;
  const Bearing<Wide> wide(bearing.length(), bearing.radius(), bearing.clearance());
  const auto f = film_force<Law>(wide, Lubricant<Wide>(oil.viscosity()),
                                 PolarFilmState<Wide>(s.eccentricity_ratio, s.slip_rate, s.squeeze_rate));
  return {static_cast<double>(f.radial), static_cast<double>(f.tangential)};
}

}  // namespace

TEST_CASE("force: rows come back as they were, with the library's forces to the bit, for every law") {
  const auto list = states();
  const std::string input = csv(list);
  const Words given = lines(input);
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    constexpr bool dynamic = Law::extent == FilmExtent::dynamic;
    const ProgramResult result = lubjoint_program(arguments(Law::name), {.input = input});
    REQUIRE(result.status == 0);
    CHECK(result.err.empty());
    const Words rows = lines(result.out);
    REQUIRE(rows.size() == given.size());
    CHECK(rows[0] == header + ",radial,tangential" + (dynamic ? ",theta_s,theta_e" : ""));
    for (std::size_t i = 0; i < list.size(); ++i) {
      INFO(given[i + 1]);
      CHECK(rows[i + 1].starts_with(given[i + 1] + ","));
      const Words row = fields(rows[i + 1]);
      REQUIRE(row.size() == (dynamic ? 7 : 5));
      const PolarForce<double> f = rounded_once<Law>(list[i]);
      CHECK(number(row[3]) == f.radial);
      CHECK(number(row[4]) == f.tangential);
      if constexpr (dynamic) {
        const FilmBounds<double> bounds = film_bounds(Law::extent, list[i]);
        CHECK(number(row[5]) == bounds.start);
        CHECK(number(row[6]) == bounds.end);
      }
    }
  });
}

TEST_CASE("force: at the centre any slip is accepted, and is minus twice the tangential pure-squeeze velocity") {
  for_each_film_law([&]<class Law>() {
    INFO(Law::name);
    const ProgramResult result = lubjoint_program(arguments(Law::name), {.input = header + "\n0,3,1\n"});
    REQUIRE(result.status == 0);
    const Words row = fields(lines(result.out)[1]);
    if constexpr (!PolarLaw<Law>) {
      const Vector2<double> e(0, 0);
      const Vector2<double> u(1, -1.5);  // b and -a/2
      const Vector2<double> f = film_force<Law>(bearing, oil, FilmState<double>(e, u));
      CHECK(number(row[3]) == Approx(f.x()).epsilon(1e-15));  // the command's is right to half an ulp, this to four
      CHECK(number(row[4]) == Approx(f.y()).epsilon(1e-15));  // the same
    }
    CHECK(std::isfinite(number(row[3])));
    CHECK(number(row[4]) > 0);  // positive slip drags the journal along
  });
}

TEST_CASE("force: a file, standard input and another order of the columns give the same forces") {
  const TemporaryFolder folder;
  const std::string file = folder.write("states.csv", csv(states()));
  const ProgramResult piped = lubjoint_program(arguments("short_dynamic"), {.input = csv(states())});
  CHECK(lubjoint_program(arguments("short_dynamic", file)).out == piped.out);
  const std::string turned = "id,squeeze_rate,eccentricity_ratio,slip_rate\na b,0.2,0.5,1\n";
  const std::string result = lubjoint_program(arguments("long_half"), {.input = turned}).out;
  const std::string plain = lubjoint_program(arguments("long_half"), {.input = header + "\n0.5,1,0.2\n"}).out;
  CHECK(lines(result)[1].starts_with("a b,0.2,0.5,1,"));
  CHECK(fields(lines(result)[1])[4] == fields(lines(plain)[1])[3]);
}

TEST_CASE("force: a header without rows gives a header without rows") {
  const ProgramResult result = lubjoint_program(arguments("short_full"), {.input = header + "\n"});
  CHECK(result.status == 0);
  CHECK(result.out == header + ",radial,tangential\n");
}

TEST_CASE("force: answers do not depend on the locale") {
  const std::string input = csv(states());
  const std::string reference = lubjoint_program(arguments("long_dynamic"), {.input = input}).out;
  for (const char* locale : {"de_DE.UTF-8", "C.UTF-8"}) {
    CHECK(lubjoint_program(arguments("long_dynamic"), {.input = input, .environment = {{"LC_ALL", locale}}}).out ==
          reference);
  }
}

}  // namespace force_command_test

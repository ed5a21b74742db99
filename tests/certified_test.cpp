// The enclosures, and the writer of the golden data.
#include <unistd.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <clocale>
#include <cstdlib>
#include <filesystem>

#include "lubjoint/scene/equilibrium.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/certified/film_coefficients.hpp"
#include "oracle/certified/film_quadrature.hpp"
#include "oracle/certified/golden.hpp"
#include "oracle/certified/golden_states.hpp"
#include "oracle/certified/golden_table.hpp"
#include "oracle/certified/overlap.hpp"
#include "oracle/files/files.hpp"
#include "oracle/laws/published_forms.hpp"
#include "support/linear_response.hpp"
#include "support/run_program.hpp"

namespace certified_test {

using namespace lubjoint;
using namespace lubjoint::certified;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

using HundredDigits = boost::multiprecision::cpp_bin_float_100;

fs::path golden_folder() { return fs::path(LUBJOINT_SOURCE_DIR) / "data/golden"; }

FilmBalls in_balls(const PolarState& s) { return {Ball(s.epsilon), Ball(s.a), Ball(s.b)}; }

std::vector<Ball> as_vector(const PolarBalls& f) { return {f.radial, f.tangential}; }

/// Does the ball, widened by 1e-40 of size, contain the number?
bool contains(const Ball& ball, const HundredDigits& number, const HundredDigits& size) {
  const WorkingPrecision precision(512);
  const auto as_ball = [](const HundredDigits& x) {
    Ball result;
    arb_set_str(result.get(), x.str(100, std::ios::scientific).c_str(), 512);
    return result;
  };
  const Ball difference = ball - as_ball(number);
  Ball widened = difference;
  arb_add_error(widened.get(), as_ball(size * HundredDigits("1e-40")).get());
  return arb_contains_zero(widened.get()) != 0;
}

/// A folder that is removed at the end.
struct TemporaryFolder {
  const fs::path path = fs::temp_directory_path() / ("lubjoint-certified-" + std::to_string(::getpid()));
  TemporaryFolder() {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~TemporaryFolder() { fs::remove_all(path); }
};

}  // namespace

TEST_CASE("certified: the enclosures of all laws contain the published forms in 100 digits") {
  const WorkingPrecision precision(512);
  std::size_t compared = 0;
  for (const LawEntry& law : laws) {
    for (const PolarState& s : polar_states()) {
      // 100 digits of the dynamic forms lose three digits for each decade of ε.
      if (s.a == 0 && s.b == 0) continue;
      if (law.extent == Extent::dynamic && s.epsilon < 1e-16) continue;
      const auto terms = reports::published_terms<HundredDigits>(law.name, s.epsilon, s.a, s.b);
      const auto total = [](const std::vector<HundredDigits>& list, bool of_sizes) {
        HundredDigits sum = 0;
        for (const HundredDigits& term : list) sum += of_sizes ? HundredDigits(abs(term)) : term;
        return sum;
      };
      const PolarBalls force = force_ratio(law.law, in_balls(s));
      const HundredDigits size = total(terms.radial, true) + total(terms.tangential, true);
      INFO(law.name << " at ε " << s.epsilon << ", a " << s.a << ", b " << s.b);
      CHECK(contains(force.radial, total(terms.radial, false), size));
      CHECK(contains(force.tangential, total(terms.tangential, false), size));
      ++compared;
    }
  }
  CHECK(compared > 3000);
}

TEST_CASE("certified: closed form and rigorous quadrature of the pressure overlap, to 24 digits of |F|") {
  const std::vector<PolarState> states = polar_states();
  for (const LawEntry& law : laws) {
    if (!law.has_pressure) continue;
    for (std::size_t i = static_cast<std::size_t>(law.law); i < states.size(); i += 11) {
      const FilmBalls film = in_balls(states[i]);
      CHECK_NOTHROW(require_overlap([&] { return as_vector(force_ratio(law.law, film)); },
                                    [&] { return as_vector(force_ratio_by_quadrature(law.law, film)); },
                                    std::string(law.name)));
    }
  }
}

TEST_CASE("certified: a law that is wrong by 1e-20 does not overlap with the integral of its pressure") {
  const FilmBalls film{Ball(0.5), Ball(3.0), Ball(2.0)};
  for (const LawEntry& law : laws) {
    if (!law.has_pressure) continue;
    const auto wrong = [&] {
      PolarBalls f = force_ratio(law.law, film);
      Ball& component = law.squeeze_only ? f.radial : f.tangential;
      component = component * (Ball(1) + Ball(1e-20));
      return as_vector(f);
    };
    CHECK_THROWS_WITH(require_overlap(
                          wrong, [&] { return as_vector(force_ratio_by_quadrature(law.law, film)); }, "a wrong law"),
                      Contains("do not overlap") && Contains("a wrong law"));
  }
}

TEST_CASE("certified: Pinkus and Sternlicht's law is the integral of no pressure, and is refused") {
  const FilmBalls film{Ball(0.5), Ball(1), Ball(1)};
  CHECK_THROWS_WITH(force_ratio_by_quadrature(Law::pinkus_sternlicht, film), Contains("no pressure"));
}

TEST_CASE("certified: the shipped rotor's stiffness, damping and linear orbit are those of the enclosures") {
  const lubjoint::Scene ships = lubjoint::load_scene(LUBJOINT_SOURCE_DIR "/data/scenes/machines/rotor.toml");
  lubjoint::Scene alone = ships;
  alone.loads.clear();
  const lubjoint::JournalEquilibrium rest = lubjoint::journal_equilibrium(alone);
  const lubjoint::SceneJoint& joint = ships.joints[0];
  const auto law =
      std::find_if(laws.begin(), laws.end(), [&](const LawEntry& each) { return each.name == joint.film; });
  REQUIRE(law != laws.end());
  const SteadyBalls balls = steady_state(*law, {joint.viscosity, joint.length, joint.journal_radius, joint.clearance,
                                                rest.eccentricity_ratio, ships.bodies[0].spin});
  const auto middle = [](const Ball& ball) { return arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR); };
  const lubjoint::Vector2<double> weight = ships.bodies[0].mass * ships.gravity;
  // Rounding of the law and of ε, by which the load changes some ten times as much.
  CHECK(middle(balls.load) == Approx(weight.norm()).epsilon(1e-13));
  // From the load's frame: x along it, y a quarter-turn counter-clockwise.
  const lubjoint::Vector2<double> along = weight / weight.norm();
  Eigen::Matrix2d turn;
  turn << along.x(), -along.y(), along.y(), along.x();
  Eigen::Matrix2d stiffness;
  Eigen::Matrix2d damping;
  stiffness << middle(balls.kxx), middle(balls.kxy), middle(balls.kyx), middle(balls.kyy);
  damping << middle(balls.cxx), middle(balls.cxy), middle(balls.cyx), middle(balls.cyy);
  lubjoint::JournalEquilibrium certified = rest;
  certified.stiffness = turn * stiffness * turn.transpose();
  certified.damping = turn * damping * turn.transpose();
  // Rounding of derivatives, a hundred units of it.
  CHECK((rest.stiffness - certified.stiffness).norm() < 1e-13 * certified.stiffness.norm());
  CHECK((rest.damping - certified.damping).norm() < 1e-13 * certified.damping.norm());
  const double unbalance = ships.loads[0].unbalance->mass_radius;
  const Eigen::Vector2cd orbit = lubjoint::test::linear_response(ships, certified, unbalance, 1);
  const Eigen::Vector2cd of_library = lubjoint::test::linear_response(ships, rest, unbalance, 1);
  CHECK((orbit - of_library).norm() < 1e-12 * orbit.norm());  // those units by the condition of a system of two rows
  CHECK((orbit - lubjoint::test::linear_response(ships, certified, unbalance, 1.001)).norm() > 1e-5 * orbit.norm());
}

TEST_CASE("certified digits: 30 of them, correct, with half a unit of the last, and exact numbers are exact") {
  const auto numbers = certify([] {
    return std::vector<Ball>{ball_pi(), -(Ball(1) / 3), Ball(0), Ball(-1250), Ball(1e-300), sqrt(Ball(4)) / 1024};
  });
  CHECK(numbers[0].value == "3.14159265358979323846264338328e0");
  CHECK(numbers[0].uncertainty == "5.1e-30");
  CHECK(numbers[1].value == "-3.33333333333333333333333333333e-1");
  CHECK(numbers[1].uncertainty == "5.1e-31");
  CHECK((numbers[2].value == "0" && numbers[2].uncertainty == "0"));
  CHECK((numbers[3].value == "-1.25e3" && numbers[3].uncertainty == "0"));
  CHECK(numbers[4].value == "1.00000000000000002505909183521e-300");  // the double, not the decimal
  CHECK((numbers[5].value == "1.953125e-3" && numbers[5].uncertainty == "0"));
}

TEST_CASE("certified digits: cancellation raises the precision, and a zero that is not known as one is refused") {
  const auto small = certify([] { return std::vector<Ball>{(Ball(1) + Ball(1e-290)) - Ball(1)}; });
  CHECK_THAT(small[0].value, Contains("e-290") || Contains("e-291"));
  const auto hidden_zero = [] { return std::vector<Ball>{sqrt(Ball(2)) * sqrt(Ball(2)) - Ball(2)}; };
  CHECK_THROWS_WITH(certify(hidden_zero), Contains("30 digits"));
}

TEST_CASE("certified golden data: a part made again is the same for any number of threads") {
  for (const unsigned threads : {1u, 3u}) {
    GoldenRun run;
    run.threads = threads;
    run.every = 97;
    for (const auto& difference : check_golden(golden_folder(), run)) FAIL_CHECK(difference.text());
  }
}

TEST_CASE("certified golden data: a locale with decimal commas changes nothing") {
  const TemporaryFolder folder;
  const std::string made =
      "localedef -i de_DE -f UTF-8 '" + (folder.path / "de_DE.UTF-8").string() + "' >/dev/null 2>&1";
  if (std::system(made.c_str()) != 0) {
    WARN("skipped: localedef can't make de_DE.UTF-8 here (Debian package locales)");
    return;
  }
  ::setenv("LOCPATH", folder.path.c_str(), 1);
  const bool set = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  const std::string point = std::localeconv()->decimal_point;
  GoldenRun run;
  run.every = 193;
  const auto differences = check_golden(golden_folder(), run);
  std::setlocale(LC_ALL, "C");
  ::unsetenv("LOCPATH");
  REQUIRE(set);
  REQUIRE(point == ",");  // the locale took effect
  for (const auto& difference : differences) FAIL_CHECK(difference.text());
}

TEST_CASE("certified golden data: a check of some rows says so, and does not speak of every byte") {
  const auto said = [](const std::vector<std::string>& words) {
    const test::ProgramResult result = test::lubjoint_program(words, {.seconds = 300});
    CHECK(result.status == 0);
    return result.out;
  };
  CHECK_THAT(said({"golden", "--check", "--every", "997"}),
             Contains("of the rows one in 997 (") && !Contains("every byte"));
}

TEST_CASE("certified golden data: a flipped digit fails the check, which names file, row and column") {
  const TemporaryFolder folder;
  fs::copy(golden_folder(), folder.path, fs::copy_options::recursive);
  const fs::path file = folder.path / "film_extent.csv";
  GoldenRun run;
  run.every = 97;
  std::string text = reports::read_input(file.string());
  std::size_t row = 0;  // the 98th, which this part of the rows contains
  for (std::size_t line = 0; line <= run.every; ++line) row = text.find('\n', row) + 1;
  const std::size_t at = text.find("3.14159265358979323846264338328e0", row);
  REQUIRE(at < text.find('\n', row));
  text[at + 30] = '7';  // its 30th digit
  reports::write_file(file, text);
  const std::vector<reports::GoldenDifference> differences = check_golden(folder.path, run);
  REQUIRE(differences.size() == 2);
  CHECK_THAT(differences[0].text(), Contains("film_extent.csv: SHA-256"));
  CHECK_THAT(differences[1].text(), Contains("film_extent.csv, line 99 (row 98), column theta_") &&
                                        Contains("off by 3.18e-30 of it"));  // 1e-29/π
}

}  // namespace certified_test

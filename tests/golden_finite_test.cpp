// Golden forces of films of finite length: they are what the solvers give, the laws' tables agree, and a digit that is
// changed is found.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "lubjoint/film/compiled_coefficients.hpp"
#include "oracle/certified/finite_coefficients.hpp"
#include "oracle/certified/finite_flow.hpp"
#include "oracle/certified/finite_length.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "support/compiled_films.hpp"

namespace golden_finite_test {

using namespace lubjoint;
using namespace lubjoint::test;
namespace fs = std::filesystem;

namespace {

const fs::path folder = LUBJOINT_SOURCE_DIR "/data/golden/finite_length";
constexpr const char* file_name = "finite_film_force.csv";
using certified::finite_coefficients_file;
using certified::finite_flow_file;

reports::CsvTable golden_table(const char* name = file_name) {
  return {reports::read_input((folder / name).string()), name};
}

certified::GoldenRun one_in(std::size_t every) {
  certified::GoldenRun run;
  run.threads = 2;
  run.every = every;
  return run;
}

}  // namespace

TEST_CASE("golden finite films: manifest and a part of the forces are those of the solvers") {
  for (const auto& difference : certified::check_finite_golden(folder, one_in(53))) FAIL_CHECK(difference.text());
}

TEST_CASE("golden finite films: a changed digit is found, by the checksum and by the solver") {
  const TemporaryFolder copy;
  fs::copy(folder, copy.path(), fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  std::string text = read_text((copy.path() / file_name).string());
  // The second digit of the first row's first force that has one other than 0.
  const std::size_t row = text.find('\n') + 1;
  std::size_t at = row;
  for (int comma = 0; comma < 5; ++comma) at = text.find(',', at) + 1;
  at = text.find_first_of("123456789", at);
  text[at] = text[at] == '9' ? '1' : static_cast<char>(text[at] + 1);
  std::ofstream(copy.path() / file_name) << text;
  const auto differences = certified::check_finite_golden(copy.path(), one_in(400));
  REQUIRE(differences.size() == 2);
  CHECK_THAT(differences[0].what + differences[1].what, Catch::Contains("more than both uncertainties"));
}

TEST_CASE("golden finite films: two solvers agree to nine digits, to three and a half where the boundary is free") {
  const reports::CsvTable table = golden_table();
  CHECK(table.rows() == certified::finite_golden_states().size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = [&](const char* column) { return table.number(row, table.column(column)); };
    const double size = std::hypot(value("radial"), value("tangential"));
    INFO(table.line(row));
    const bool free = table.line(row).starts_with("finite_reynolds");
    CHECK(value("uncertainty") <= (free ? 3e-4 : 2e-10) * size);  // as data/README.md says
    CHECK(value("uncertainty") > 0);
  }
}

TEST_CASE("golden finite films: the tables that ship have these forces, to what they state") {
  const reports::CsvTable table = golden_table();
  std::size_t compared = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = [&](const char* column) { return table.number(row, table.column(column)); };
    const double shape = value("length_over_diameter");
    if (shape == 4) continue;  // no table ships
    const std::string law = table.line(row).substr(0, table.line(row).find(','));
    const auto film = shipped_film(law, reports::number(shape));
    const PolarFilmState<double> state(value("eccentricity_ratio"), value("slip_rate"), value("squeeze_rate"));
    with_compiled_law(*film, [&](const auto& compiled) {
      const PolarForce<double> force = compiled_polar_force_ratio(compiled, state);
      const double size = std::hypot(value("radial"), value("tangential"));
      INFO(table.line(row));
      CHECK(std::hypot(force.radial - value("radial"), force.tangential - value("tangential")) <=
            film->error * size + value("uncertainty"));
    });
    ++compared;
  }
  CHECK(compared == 4 * 4 * 18);
}

TEST_CASE("golden finite films: coefficients of two solvers agree to six digits, to nearly two on grids") {
  const reports::CsvTable table = golden_table(finite_coefficients_file);
  CHECK(table.rows() == certified::finite_steady_states().size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = [&](const std::string& column) { return table.number(row, table.column(column)); };
    INFO(table.line(row));
    const bool free = table.line(row).starts_with("finite_reynolds");
    for (const std::string matrix : {"k", "c"}) {
      double size = 0;
      for (const std::string axes : {"xx", "xy", "yx", "yy"}) size = std::max(size, std::abs(value(matrix + axes)));
      const double uncertainty = value(matrix == "k" ? "stiffness_uncertainty" : "damping_uncertainty");
      CHECK(uncertainty <= (free ? 1.2e-2 : 1.1e-6) * size);  // as data/README.md says
      CHECK(uncertainty > 0);
    }
    CHECK(value("sommerfeld") == Approx(1 / (M_PI * value("load"))).epsilon(2e-6));  // both are printed to six digits
    // Full films, and those that rupture by Swift and Stieber, have a potential: C is symmetric. Nothing here made it
    // so.
    if (free || table.line(row).starts_with("finite_full")) {
      CHECK(std::abs(value("cxy") - value("cyx")) <= 2 * value("damping_uncertainty"));
    }
  }
}

TEST_CASE("golden finite films: the tables that ship have these coefficients and rest there") {
  const reports::CsvTable table = golden_table(finite_coefficients_file);
  std::map<std::string, double> worst;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = [&](const std::string& column) { return table.number(row, table.column(column)); };
    const double shape = value("length_over_diameter");
    if (shape == 4) continue;  // no table ships
    const std::string name = table.line(row).substr(0, table.line(row).find(','));
    const auto film = shipped_film(name, reports::number(shape));
    const Bearing<double> bearing(2 * shape, 1, 1e-3);
    const double epsilon = value("eccentricity_ratio");
    with_compiled_law(*film, [&]<class Law>(const Law& law) {
      const SteadyPlace<double> place(epsilon);
      const auto force = [&law](const PolarFilmState<double>& state) { return compiled_polar_force_ratio(law, state); };
      const auto rest = steady_film_of<double>(bearing, 1.0, force, place, 1.0, coefficient_ratios(law, place, 1));
      INFO(table.line(row));
      CHECK(std::abs(rest.load - value("load")) <= film->error * rest.load + value("load_uncertainty"));
      CHECK(std::abs(rest.attitude - value("attitude")) <= film->error + value("attitude_uncertainty"));
      const auto held = [&](const auto& matrix, const std::string& letter, const char* bound) {
        const std::array<std::string, 4> axes = {"xx", "xy", "yx", "yy"};
        const double size = matrix.cwiseAbs().maxCoeff() * bearing.clearance();
        for (std::size_t k = 0; k < 4; ++k) {
          const double entry = matrix(static_cast<int>(k / 2), static_cast<int>(k % 2)) * bearing.clearance();
          const double off = std::abs(entry - value(letter + axes[k])) - value(bound);
          worst[name] = std::max(worst[name], off / size);
        }
      };
      held(rest.stiffness, "k", "stiffness_uncertainty");
      held(rest.damping, "c", "damping_uncertainty");
    });
  }
  // Of a matrix's largest entry. What a table's slopes are off is more than its stated error of the force, by what
  // differentiating polynomials of degree 20 costs.
  for (const auto& [name, off] : worst) {
    INFO(name << " " << off);
    CHECK(off <= (name == "finite_reynolds" ? 1e-3 : 3e-6));
  }
  CHECK(worst.size() == 4);
}

TEST_CASE("golden finite films: a changed coefficient is found by making it again") {
  std::string text = reports::read_input((folder / finite_coefficients_file).string());
  CHECK(certified::check_finite_coefficients(text, one_in(41)).empty());
  std::size_t at = text.find('\n') + 1;
  for (int comma = 0; comma < 8; ++comma) at = text.find(',', at) + 1;  // kxx of the first row, which is 0; then kxy
  at = text.find(',', at) + 1;
  at = text.find_first_of("123456789", at);
  text[at] = text[at] == '9' ? '1' : static_cast<char>(text[at] + 1);
  const auto differences = certified::check_finite_coefficients(text, one_in(1000));
  REQUIRE(differences.size() == 1);
  CHECK(differences[0].column == "kxy");
  CHECK_THAT(differences[0].what, Catch::Contains("more than both uncertainties"));
}

TEST_CASE(
    "golden finite films: side flows of two solvers agree to seven digits of what is displaced, to four on grids") {
  const reports::CsvTable table = golden_table(finite_flow_file);
  const auto states = certified::finite_flow_states();
  REQUIRE(table.rows() == states.size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = [&](const char* column) { return table.number(row, table.column(column)); };
    INFO(table.line(row));
    const double a = value("slip_rate"), b = value("squeeze_rate");
    const double displaced = std::hypot(a, 2 * b);  // 2|u|
    const bool free = table.line(row).starts_with("finite_reynolds");
    const bool half = table.line(row).starts_with("finite_half");
    CHECK(value("uncertainty") <= (free ? 3e-4 : half ? 3e-7 : 1e-9) * displaced);  // as data/README.md says
    CHECK(value("uncertainty") > 0);
    CHECK(value("side_flow") < displaced);
    if (!half) CHECK(value("side_flow") > 0);
    // In a short bearing 2|u| leaves, of a half film |a|: the longer the bearing, the less, but for what a half film in
    // squeeze draws in and drives out through its cut ends.
    if (row >= 18 && value("length_over_diameter") > 0.25 && (!half || b == 0)) {
      const double shorter = table.number(row - 18, table.column("side_flow"));
      CHECK(std::abs(value("side_flow")) < std::abs(shorter));
    }
  }
}

TEST_CASE("golden finite films: a changed side flow is found by making it again, and so is a larger uncertainty") {
  const std::string text = reports::read_input((folder / finite_flow_file).string());
  CHECK(certified::check_finite_flow(text, one_in(41)).empty());
  std::size_t at = text.find('\n') + 1;
  for (int comma = 0; comma < 5; ++comma) at = text.find(',', at) + 1;
  std::string changed = text;
  at = changed.find_first_of("123456789", at);
  changed[at] = changed[at] == '9' ? '1' : static_cast<char>(changed[at] + 1);
  const auto differences = certified::check_finite_flow(changed, one_in(1000));
  REQUIRE(differences.size() == 1);
  CHECK(differences[0].column == "side_flow");
  CHECK_THAT(differences[0].what, Catch::Contains("more than both uncertainties"));
  std::string loose = text;
  const std::size_t end = loose.find('\n', at);
  loose.replace(loose.rfind(',', end) + 1, end - loose.rfind(',', end) - 1, "1");
  const auto looser = certified::check_finite_flow(loose, one_in(1000));
  REQUIRE(looser.size() == 1);
  CHECK(looser[0].column == "uncertainty");
  const std::string shorter = text.substr(0, text.rfind('\n', text.size() - 2) + 1);
  CHECK(certified::check_finite_flow(shorter, one_in(1000)).size() == 1);
}

}  // namespace golden_finite_test

// Golden forces of films of finite length: they are what the solvers give, the laws' tables agree, and a digit that is
// changed is found.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "oracle/certified/finite_length.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "support/compiled_films.hpp"

using namespace lubjoint;
using namespace lubjoint::test;
namespace fs = std::filesystem;

namespace {

const fs::path folder = LUBJOINT_SOURCE_DIR "/data/golden/finite_length";
constexpr const char* file_name = "finite_film_force.csv";

reports::CsvTable golden_table() { return {reports::read_input((folder / file_name).string()), file_name}; }

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

// The table of error against run time of the laws, as the command prints it. Times are not judged here.
#include <catch2/catch.hpp>
#include <set>

#include "lubjoint/film/every_law.hpp"
#include "support/compiled_films.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace law_bench_test {

using namespace lubjoint::test;
using Catch::Matchers::Contains;

namespace {

/// Every law that is a table, and the one that it is compared with, has its times; the tables have the errors they
/// state.
void check_compiled_laws(const std::vector<CsvRow>& rows) {
  std::set<std::pair<std::string, std::string>> seen;
  for (const CsvRow& row : rows) {
    const std::string& law = row.at("law");
    const std::string& method = row.at("method");
    INFO(law << " " << method);
    CHECK(seen.emplace(law, method).second);
    CHECK(std::stod(row.at("nanoseconds")) > (method == "simulate" ? 1e4 : 1));  // a run is many evaluations
    if (method == "scalar") CHECK(row.at("over_scalar") == "1");
    if (law == "pinkus_sternlicht") CHECK(row.at("over_pinkus_sternlicht") == "1");
    CHECK(row.at("over_scalar").empty() == (method == "simulate"));
    CHECK(std::stod(row.at("over_pinkus_sternlicht")) > 0);
    const bool is_table = law.starts_with("finite_");
    if (!is_table || method == "jacobian" || method == "simulate") {
      CHECK(row.at("states") == "0");
      CHECK(row.at("largest_error").empty());
      continue;
    }
    CHECK(row.at("states") == "18");  // the golden ones of this L/D
    const double stated = shipped_film(law, shipped_scenes_shape)->error;
    CHECK(std::stod(row.at("largest_error")) <= stated);
    CHECK(std::stod(row.at("median_error")) > 0x1p-52);  // it is an error of the law's own, and no rounding
  }
  for (const char* law : {"pinkus_sternlicht", "finite_full", "finite_half", "finite_dynamic", "finite_reynolds"}) {
    for (const char* method : {"scalar", "jacobian", "batch", "simulate"}) CHECK(seen.contains({law, method}));
  }
}

}  // namespace

TEST_CASE("bench laws: every law has all its methods, with the errors of their precision and times above zero") {
  const TemporaryFolder folder;
  const ProgramResult result =
      lubjoint_program({"bench", "laws", "--quick", "--out", folder / "out"}, {.seconds = 300});
  INFO(result.out << result.err);
  REQUIRE(result.status == 0);
  CHECK_THAT(result.out, Contains("batch") && Contains("times the bound") && Contains("times the batch"));
  std::set<std::pair<std::string, std::string>> seen;
  for (const CsvRow& row : read_csv(folder / "out/bench-laws.csv")) {
    const std::string& method = row.at("method");
    INFO(row.at("law") << " " << method);
    CHECK(seen.emplace(row.at("law"), method).second);
    for (const char* column : {"nanoseconds", "over_bound", "over_batch"}) CHECK(std::stod(row.at(column)) > 0);
    const double median = std::stod(row.at("median_error"));
    const double largest = std::stod(row.at("largest_error"));
    const bool squeeze_only = row.at("law").starts_with("squeeze");  // a quarter of the states has none
    CHECK(std::stoi(row.at("states")) >= (method == "finite_length" ? 4 : squeeze_only ? 37 : 50));
    if (method == "scalar" || method == "batch") {
      CHECK((median > 1e-17 && median < 0x1p-52));  // rounding of a dozen operations, some against each other
      CHECK(largest < 1e-13);                       // the same where terms cancel
    } else if (method == "long_double") {
      CHECK((median > 1e-21 && median < 0x1p-62));  // the same in 64 bits
      CHECK(largest < 1e-16);
    } else if (method == "mobility") {
      CHECK(largest < 1e-12);  // what mobility.hpp promises: rounding times the film's condition, 6/q = 100
    } else if (method == "quadrature") {
      CHECK((median > 1e-17 && median < 1e-14));  // a sum of some dozen terms
    } else {
      CHECK(method == "finite_length");
      CHECK((median > 0.01 && median < 3));  // another film: the model error of the law at L/D 2.04
    }
  }
  for (const std::string_view law : lubjoint::names_of_laws<lubjoint::StateFilmLaws>) {
    for (const char* method : {"scalar", "batch", "long_double", "quadrature", "finite_length"}) {
      const bool is_there = seen.contains({std::string(law), method});
      INFO(law << " " << method);
      CHECK(is_there == (law != "pinkus_sternlicht" || std::string(method) != "quadrature"));  // no pressure of its own
    }
  }
  for (const char* law : {"short_full", "short_dynamic", "long_full", "long_dynamic", "pinkus_sternlicht"}) {
    CHECK(seen.contains({law, "mobility"}));
  }
  const std::vector<CsvRow> batches = read_csv(folder / "out/bench-batch.csv");
  CHECK(batches.size() == 4);
  check_compiled_laws(read_csv(folder / "out/bench-compiled-laws.csv"));
  CHECK(folder.entries() ==
        std::set<std::string>{"out", "out/bench-batch.csv", "out/bench-compiled-laws.csv", "out/bench-laws.csv"});
}

TEST_CASE("bench quadrature, finite-length: every rule on every film, and no error is larger than its estimate") {
  const TemporaryFolder folder;
  const ProgramResult result =
      lubjoint_program({"bench", "quadrature", "finite-length", "--quick", "--out", folder / "out"}, {.seconds = 300});
  INFO(result.out << result.err);
  REQUIRE(result.status == 0);
  const std::set<std::string> written = {"out", "out/bench-finite-length.csv", "out/bench-quadrature.csv"};
  CHECK(folder.entries() == written);
  std::set<std::pair<std::string, std::string>> seen;
  for (const char* file : {"out/bench-quadrature.csv", "out/bench-finite-length.csv"}) {
    for (const CsvRow& row : read_csv(folder / file)) {
      INFO(row.at("film") << " " << row.at("rule") << " 1 - e/c " << row.at("one_minus_ratio"));
      seen.emplace(row.at("film"), row.at("rule"));
      REQUIRE(row.at("error") != "failed");
      const double error = std::stod(row.at("error"));
      const double estimate = std::stod(row.at("estimate"));
      CHECK((error >= 0 && error <= estimate));
      // The tolerance is that of each component and, in long films, of a turn; rounding near the wall comes on top.
      CHECK(estimate < 3 * std::stod(row.at("tolerance")) + 1e-9);
      CHECK(std::stod(row.at("microseconds")) > 0);
    }
  }
  for (const std::string film :
       {"short_full", "short_half", "short_dynamic", "long_full", "long_half", "long_dynamic"}) {
    for (const char* rule : {"gauss_legendre", "qag", "qags", "cquad", "trapezoid"}) {
      INFO(film << " " << rule);
      const bool periodic = film.ends_with("full");  // all that the trapezoidal rule is for
      CHECK(seen.contains({film, rule}) == (periodic || std::string(rule) != "trapezoid"));
    }
  }
  for (const char* film : {"finite_full", "finite_half", "finite_dynamic", "finite_reynolds"}) {
    CHECK(seen.contains({film, "L/D 2.04"}));
  }
}

TEST_CASE("bench: tables that are none, and scenes without their table, are refused before anything is written") {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> wrong = {
      {"bench", "law", "--out", folder / "out"},
      {"bench", "laws", "--scene", journal_scene_file, "--out", folder / "out"},
      {"bench", "--scene", folder / "none.toml", "--out", folder / "out"}};
  const std::vector<std::string> words = {"allowed are laws, quadrature, finite-length, scenes",
                                          "allowed are both or neither", "none.toml"};
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    const ProgramResult result = lubjoint_program(wrong[i]);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Contains(words[i]));
    CHECK(folder.entries().empty());
  }
}

}  // namespace law_bench_test

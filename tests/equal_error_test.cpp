// Who wins a race, and what is said of it: from invented rows, and from those that ship.
#include "oracle/measure/bench/equal_error.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "oracle/files/files.hpp"
#include "oracle/files/golden_files.hpp"
#include "oracle/measure/bench/bench_manifest.hpp"
#include "oracle/measure/bench/bench_tables.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"

namespace equal_error_test {

using namespace lubjoint;
using namespace lubjoint::test;
using namespace lubjoint::reports;
using Catch::Matchers::Contains;

namespace {

const Race race{"s", "absolute"};

struct Line {
  std::string integrator;
  double tolerance;
  double error;
  double seconds;
  double spread = 0.01;
  std::string formulation = "absolute";
};

std::vector<BenchRow> rows_of(const std::vector<Line>& lines) {
  std::vector<BenchRow> rows;
  for (const Line& line : lines) {
    BenchRow row{"s", line.formulation, line.integrator, line.tolerance, {}};
    row.run.finished = true;
    row.run.error = line.error;
    row.run.seconds = line.seconds;
    row.run.spread = line.spread;
    rows.push_back(row);
  }
  return rows;
}

BenchRow stopped(const std::string& integrator, double tolerance) {
  BenchRow row{"s", "absolute", integrator, tolerance, {}};
  row.run.message = out_of_time;
  row.run.seconds = 1e-9;  // of no meaning, and never to be compared
  return row;
}

std::vector<std::string> names(const std::vector<Contender>& contenders) {
  std::vector<std::string> list;
  for (const Contender& each : contenders) list.push_back(each.integrator);
  return list;
}

const std::string measured = std::string(LUBJOINT_SOURCE_DIR) + "/data/measured/bench-scenes";

std::vector<BenchRow> shipped_rows() {
  return read_bench_rows(CsvTable(read_text(measured + ".csv"), "bench-scenes.csv"));
}

}  // namespace

TEST_CASE("equal error: times between tolerances lie on the log-log line, and beyond the last there are none") {
  // Errors fall as the square of the tolerance, times double.
  const auto rows = rows_of({{"ida", 1e-2, 1e-4, 1}, {"ida", 1e-3, 1e-6, 2}, {"ida", 1e-4, 1e-8, 4, 0.3}});
  const auto at = [&](double error) { return time_at_error(rows, race, "ida", error); };
  CHECK(at(1e-4)->seconds == Approx(1).epsilon(1e-14));               // rounding
  CHECK(at(1e-5)->seconds == Approx(std::sqrt(2.0)).epsilon(1e-14));  // halfway on the line
  CHECK(at(1e-7)->seconds == Approx(std::sqrt(8.0)).epsilon(1e-14));
  CHECK(at(1e-2)->seconds == Approx(1).epsilon(1e-14));  // the loosest run is better than asked
  CHECK(at(1e-5)->spread == 0.01);
  CHECK(at(1e-7)->spread == 0.3);  // the larger of the two it lies between
  CHECK_FALSE(at(1e-9).has_value());
  CHECK_FALSE(time_at_error(rows, race, "dopri5", 1e-2).has_value());
  CHECK_FALSE(time_at_error(rows, {"s", "minimal"}, "ida", 1e-2).has_value());
  CHECK(*error_floor(rows, race, "ida") == 1e-8);
}

TEST_CASE("equal error: it is the error that counts, not the tolerance, and the least time of a curve with dents") {
  // The loose run happens to be better than the middle one, in less time.
  const auto rows = rows_of({{"ida", 1e-2, 1e-6, 1}, {"ida", 1e-4, 1e-4, 3}, {"ida", 1e-6, 1e-8, 5}});
  CHECK(time_at_error(rows, race, "ida", 1e-6)->seconds == 1);
  CHECK(time_at_error(rows, race, "ida", 1e-7)->seconds > 3);
  const auto strict =
      rows_of({{"radau_iia5", 1e-2, 1e-6, 2}, {"cvode_bdf", 1e-2, 1e-1, 1}, {"cvode_bdf", 1e-8, 1e-6, 9}});
  CHECK(judge_race(strict, race, 1e-5).order.front().integrator == "radau_iia5");  // at equal tolerance BDF is faster
}

TEST_CASE("equal error: the first of a race, those that tie with it, and those that do not arrive") {
  auto rows = rows_of({{"radau_iia5", 1e-6, 1e-6, 1.00, 0.02},
                       {"dopri5", 1e-6, 1e-6, 1.04, 0.05},
                       {"cvode_bdf", 1e-6, 1e-6, 1.04, 0.01},
                       {"ida", 1e-6, 1e-3, 0.1, 0.01}});
  rows.push_back(stopped("fehlberg78", 1e-6));
  const RaceVerdict verdict = judge_race(rows, race, 1e-5);
  CHECK(names(verdict.order) == std::vector<std::string>{"radau_iia5", "dopri5", "cvode_bdf"});
  CHECK(names(verdict.winners()) == std::vector<std::string>{"radau_iia5", "dopri5"});  // within dopri5's own spread
  CHECK(verdict.fastest(Camp::sundials)->integrator == "cvode_bdf");
  CHECK_FALSE(verdict.fastest(Camp::simbody).has_value());
  CHECK_FALSE(verdict.of("ida").has_value());
  CHECK(recommendation(verdict) == "radau_iia5 or dopri5");
  const RaceVerdict nobody = judge_race(rows, race, 1e-9);
  CHECK(nobody.winners().empty());
  CHECK(recommendation(nobody) == "none reaches it");
}

TEST_CASE("equal error: where CVODE's Adams is faster the recommendation says so, and which of our own comes next") {
  std::vector<Line> lines = {{"radau_iia5", 1e-6, 1e-6, 3}, {"dopri5", 1e-6, 1e-6, 2}, {"cvode_adams", 1e-6, 1e-6, 4}};
  CHECK(recommendation(judge_race(rows_of(lines), race, 1e-5)) == "dopri5");
  lines[2].seconds = 1;
  CHECK(recommendation(judge_race(rows_of(lines), race, 1e-5)) ==
        "cvode_adams; of lubjoint's own dopri5, 2.0 times as long");
  CHECK_THAT(scene_bench_table(rows_of(lines)), Contains("use for 1e-05: cvode_adams; of lubjoint's own dopri5"));
  const std::string words = scene_bench_markdown(rows_of(lines));
  CHECK_THAT(words, Contains("| s | absolute | 3000 | 0.33 cvode_adams | – | cvode_adams, 1000 ms |"));
  CHECK_THAT(words, Contains("- s, absolute coordinates, 1e-05: cvode_adams; of lubjoint's own dopri5"));
  lines[1].seconds = 1.005;  // a tie: our own is named
  CHECK(recommendation(judge_race(rows_of(lines), race, 1e-5)) == "dopri5");
  CHECK(recommendation(judge_race(rows_of({{"ida", 1e-6, 1e-6, 1}}), race, 1e-5)) ==
        "ida; none of lubjoint's own ran and reaches it");
}

TEST_CASE(
    "equal error: Simbody's joint coordinates race against the scene in absolute ones, not against minimal ones") {
  const auto rows = rows_of({{"radau_iia5", 1e-6, 1e-6, 2, 0, "minimal"},
                             {"radau_iia5", 1e-6, 1e-6, 3},
                             {"simbody_cpodes", 1e-6, 1e-6, 1, 0, "joint"}});
  CHECK(races(rows) == std::vector<Race>{{"s", "minimal"}, {"s", "absolute"}});
  CHECK(names(judge_race(rows, race, 1e-5).winners()) == std::vector<std::string>{"simbody_cpodes"});
  CHECK(names(judge_race(rows, {"s", "minimal"}, 1e-5).order) == std::vector<std::string>{"radau_iia5"});
}

TEST_CASE("equal error: space is no race of its own, and costs what other coordinates and the plane are held against") {
  std::vector<Line> lines = {{"radau_iia5", 1e-2, 1e-4, 1, 0, "minimal"},
                             {"radau_iia5", 1e-6, 1e-10, 1, 0, "minimal"},
                             {"radau_iia5", 1e-2, 1e-4, 8},
                             {"radau_iia5", 1e-6, 1e-10, 8},
                             {"radau_iia5", 1e-2, 1e-4, 4, 0, "independent"},
                             {"radau_iia5", 1e-6, 1e-10, 4, 0, "independent"},
                             {"simbody_cpodes", 1e-6, 1e-10, 9, 0, "joint"}};
  const auto without = rows_of(lines);
  CHECK(*time_ratio(without, race, {"s", "minimal"}, "radau_iia5", 1e-9) == Approx(8));
  CHECK_FALSE(time_ratio(without, race, {"s", "embedded"}, "radau_iia5", 1e-9).has_value());
  CHECK_FALSE(time_ratio(without, race, {"s", "minimal"}, "radau_iia5", 1e-12).has_value());
  CHECK_THAT(scene_bench_markdown(without), !Contains("in space"));
  lines.push_back({"radau_iia5", 1e-2, 1e-6, 40, 0, "embedded"});
  const auto rows = rows_of(lines);
  CHECK(races(rows) == races(without));
  CHECK_THAT(scene_bench_markdown(rows), Contains("| s | 8 | 8 | 4 | 4 | 10 | – |"));  // 1e-9 is not reached in space
  CHECK_THAT(scene_bench_table(rows), Contains("embedded coordinates") && Contains("space/plane"));
}

TEST_CASE("equal error: a dash stands where nobody ran or arrived") {
  const std::string words = scene_bench_markdown(rows_of({{"radau_iia5", 1e-6, 1e-6, 3}}));
  CHECK_THAT(words, Contains("| s | absolute | 3000 | – | – | radau_iia5 | – | – | – | – |"));
  CHECK_THAT(scene_bench_table(rows_of({{"radau_iia5", 1e-6, 1e-6, 3}})),
             Contains("CVODE and IDA did not race") && Contains("Simbody did not race"));
}

TEST_CASE("bench rows: what is written is read, and what is no row is refused") {
  auto rows = rows_of({{"ida", 1e-2, 1e-4, 0.25, 0.125}});
  rows.push_back(stopped("dopri5", 1e-3));
  std::string csv = bench_header;
  for (const BenchRow& row : rows) csv += bench_line(row);
  const auto read = read_bench_rows(CsvTable(csv, "t"));
  REQUIRE(read.size() == 2);
  CHECK(read[0].run.error == 1e-4);
  CHECK(read[0].run.spread == 0.125);
  CHECK_FALSE(read[1].run.finished);
  CHECK(read[1].run.message == out_of_time);
  const auto change = [&](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return read_bench_rows(CsvTable(text, "t"));
  };
  CHECK_THROWS_WITH(change(csv, "0.25", "-1"), Contains("t:2: seconds is negative"));
  CHECK_THROWS_WITH(change(csv, "finished", "done"), Contains("allowed are finished, stopped"));
}

TEST_CASE("bench block: a marked table is replaced, and a text without its marks is refused") {
  const std::string begin(bench_block_begin);
  const std::string end(bench_block_end);
  CHECK(with_bench_block("a\n" + begin + "old\n" + end + "b\n", "new\n") == "a\n" + begin + "new\n" + end + "b\n");
  for (const std::string& text : {std::string("a\n"), begin, end + begin, begin + begin + end, begin + end + end}) {
    CHECK_THROWS_WITH(with_bench_block(text, "new\n"), Contains("allowed is a text with the lines"));
  }
}

TEST_CASE("bench block: the README's table is that of the rows that ship") {
  const std::string readme = read_text(std::string(LUBJOINT_SOURCE_DIR) + "/README.md");
  CHECK(with_bench_block(readme, scene_bench_markdown(shipped_rows())) == readme);
}

TEST_CASE("bench block: one command writes the README's table from the rows that ship") {
  const TemporaryFolder folder;
  const std::string readme = read_text(std::string(LUBJOINT_SOURCE_DIR) + "/README.md");
  write_file(folder / "README.md", with_bench_block(readme, "nothing\n"));
  const ProgramResult result =
      lubjoint_program({"bench", "scenes", "--data", std::string(LUBJOINT_SOURCE_DIR) + "/data/measured", "--readme",
                        folder / "README.md"});
  INFO(result.err);
  CHECK(result.status == 0);
  CHECK(read_text(folder / "README.md") == readme);
  CHECK_THAT(result.out, Contains("use for 1e-09: "));
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"bench", "scenes", "--readme", "README.md"},
                                                {"bench", "--data", measured},
                                                {"bench", "scenes", "--data", measured, "--quick"},
                                                {"bench", "scenes", "--data", measured, "--integrator", "dopri5"},
                                                {"bench", "scenes", "--repeats", "0"},
                                                {"bench", "scenes", "--seconds", "-1"},
                                                {"bench", "laws", "--repeats", "3"},
                                                {"bench", "laws", "--integrator", "dopri5"}}) {
    const ProgramResult refused = lubjoint_program(wrong);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, Contains("allowed"));
  }
}

TEST_CASE("bench rows that ship: every integrator on every scene, and the manifest is theirs") {
  const std::string csv = read_text(measured + ".csv");
  CHECK_THAT(measured_by(read_text(measured + ".json"), csv, "manifest"),
             Contains("lubjoint ") && Contains("medians of"));
  CHECK_THROWS_WITH(measured_by(read_text(measured + ".json"), csv + " ", "manifest"), Contains("is not of the"));
  CHECK_THROWS_WITH(measured_by("{}", csv, "manifest"), Contains("\"sha256\" is missing"));
  const auto rows = shipped_rows();
  for (const Race& each : races(rows)) {
    CAPTURE(each.scene, each.formulation);
    const auto ran = integrators_of(rows, each);
    // In space others have minimal coordinates, and so have three of the library's; Simbody is beside absolute ones.
    const bool in_space = each.scene == "spatial-slider-crank";
    // Simbody has a lubricated slider-crank in coordinates of its own, which are no minimal ones.
    const bool film_and_mechanism = each.scene.starts_with("slider-crank") && each.formulation != "minimal" &&
                                    each.scene != "slider-crank-ideal" && each.scene != "slider-crank-torque";
    const std::size_t own_in_space = each.formulation == "minimal" ? 3 : 7;
    const std::size_t others_in_space = each.formulation == "minimal" ? 4 : 1;
    CHECK(ran.size() == (in_space                 ? own_in_space + others_in_space
                         : each.scene == "impact" ? 7
                         : film_and_mechanism     ? 12
                                                  : 11));
  }
  const auto all = races(rows);
  const auto in_space =
      std::count_if(all.begin(), all.end(), [](const Race& each) { return each.scene == "spatial-slider-crank"; });
  // The journal; five cranks in three formulations; three scenes in absolute ones.
  CHECK(all.size() - static_cast<std::size_t>(in_space) == 19);
  // One crank in space in three formulations, and five turned out of their planes.
  std::set<std::string> turned;
  for (const BenchRow& row : rows) {
    if (row.formulation == embedded_coordinates) turned.insert(row.scene);
  }
  CHECK(in_space == 3);
  CHECK(turned.size() == 5);
}

}  // namespace equal_error_test

// The command `reproduce`: its verdicts and files, and the README's tables and sentences, which are of them.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/files/quoted_csv.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace reproduce_command_test {

using namespace lubjoint::test;
using Catch::Matchers::Contains;

namespace {

/// Are two numbers of a table the same to what rounding leaves of them? Differences ("2.8e-04") within a factor of
/// five, or both below 1e-7, where the integrator's errors are; growth of 1e-3/s measured in double precision
/// ("+8.9457e-04") within 1e-3 of itself; all else to the last digit.
bool same_number(const std::string& one, const std::string& other) {
  if (one == other) return true;
  static const std::regex scientific("[+-]?[0-9]+\\.[0-9]+e[+-][0-9]+");
  if (!std::regex_match(one, scientific) || !std::regex_match(other, scientific)) return false;
  const auto mantissa = [](const std::string& text) { return text.find('e'); };
  if (mantissa(one) != mantissa(other)) return false;
  const bool difference = mantissa(one) <= 3;
  if (difference && std::abs(std::stod(one)) < 1e-7 && std::abs(std::stod(other)) < 1e-7) return true;
  const double ratio = std::stod(one) / std::stod(other);
  const double allowed = difference ? 5 : 1.001;
  return ratio < allowed && ratio > 1 / allowed;
}

bool same_line(const std::string& one, const std::string& other) {
  std::istringstream words(one);
  std::istringstream other_words(other);
  std::string word;
  std::string other_word;
  while (words >> word) {
    const std::string unit = word.ends_with(',') || word.ends_with(';') ? word.substr(0, word.size() - 1) : word;
    if (!(other_words >> other_word)) return false;
    const bool same_end = word.size() == unit.size() || other_word.ends_with(word.back());
    if (word.size() != unit.size()) other_word.pop_back();
    if (!same_end || !same_number(unit, other_word)) return false;
  }
  return !(other_words >> other_word);
}

/// Lines of a text that are not empty.
std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

/// Rows of a CSV file whose fields may be quoted.
std::vector<CsvRow> read_quoted_csv(const std::string& path) {
  std::istringstream text(read_text(path));
  std::string line;
  std::getline(text, line);
  const std::vector<std::string> header = lubjoint::reports::split_quoted(line);
  std::vector<CsvRow> rows;
  while (std::getline(text, line)) {
    const std::vector<std::string> values = lubjoint::reports::split_quoted(line);
    REQUIRE(values.size() == header.size());
    CsvRow row;
    for (std::size_t i = 0; i < header.size(); ++i) row[header[i]] = values[i];
    rows.push_back(row);
  }
  return rows;
}

/// What the README shows of an example: its table, and the line before that, if there is one.
/// @param line  begins the line;  @param heading  stands in the table's headings
std::string shown_of(const std::string& output, const std::string& line, const std::string& heading) {
  const std::size_t in_table = output.find(heading);
  REQUIRE(in_table != std::string::npos);
  const std::size_t begin = output.rfind("\n\n", in_table) + 2;
  const std::string table = output.substr(begin, output.find("\n\n", begin) + 1 - begin);
  if (line.empty()) return table;
  const std::size_t at = output.find("\n" + line) + 1;
  return output.substr(at, output.find('\n', at) + 1 - at) + "\n" + table;
}

/// The README's code block that follows a mark is what was printed, but for the digits that rounding leaves open.
/// LUBJOINT_REWRITE_DOCUMENTATION in the environment writes it anew.
void check_readme(const std::string& mark, const std::string& printed) {
  const std::string name = std::string(LUBJOINT_SOURCE_DIR) + "/README.md";
  const std::string text = read_text(name);
  const std::size_t at = text.find("<!-- " + mark + " -->\n```\n");
  REQUIRE(at != std::string::npos);
  const std::size_t begin = text.find("```\n", at) + 4;
  const std::size_t end = text.find("```", begin);
  const std::vector<std::string> shown = lines_of(text.substr(begin, end - begin));
  const std::vector<std::string> lines = lines_of(printed);
  CHECK(lines.size() > 5);
  bool same = shown.size() == lines.size();
  for (std::size_t i = 0; same && i < lines.size(); ++i) same = same_line(shown[i], lines[i]);
  if (!same && std::getenv("LUBJOINT_REWRITE_DOCUMENTATION") != nullptr) {
    std::ofstream(name) << text.substr(0, begin) + printed + text.substr(end);
    same = true;
  }
  INFO("README, " << mark << ":\n" << text.substr(begin, end - begin) << "and now:\n" << printed);
  CHECK(same);
}

/// Sentences of the README that are rounded from the files of `reproduce`.
void check_sentences(const std::vector<CsvRow>& summary, std::size_t rows_of_example_2) {
  const std::string readme = read_text(std::string(LUBJOINT_SOURCE_DIR) + "/README.md");
  const auto of = [&](const char* law, const char* column) {
    for (const CsvRow& row : summary) {
      if (row.at("law") == law) return std::stod(row.at(column));
    }
    throw std::out_of_range(law);
  };
  CHECK_THAT(readme,
             Contains(fmt::format("at {:.0f}e-4 and {:.1f}e-3 per second", 1e4 * of("short_full", "eigenvalue_re"),
                                  1e3 * of("long_full", "eigenvalue_re"))));
  CHECK_THAT(readme, Contains(fmt::format("for the first {:.0f} and {:.0f} ms", 1e3 * of("long_half", "sliding_s"),
                                          1e3 * of("long_half_eq5", "sliding_s"))));
  CHECK_THAT(readme, Contains("1 to 2 % less for the full films"));
  for (const char* law : {"short_full", "long_full"}) {
    const double less = 1 - of(law, "rate_from_start") / of(law, "rate_near");
    CHECK((less > 0.01 && less < 0.02));
  }
  CHECK_THAT(readme, Contains(fmt::format("at ε = {:.3f} (short half) or {:.3f}", of("short_half", "equilibrium_ratio"),
                                          of("pinkus_sternlicht", "equilibrium_ratio"))));
  CHECK_THAT(readme, Contains(fmt::format("at {} times", rows_of_example_2)));
  const lubjoint::SceneJoint joint = lubjoint::load_scene(journal_scene_file).joints[0];
  CHECK_THAT(readme, Contains(fmt::format("L/D = {:.2f}", joint.length / (2 * joint.journal_radius))));
}

}  // namespace

TEST_CASE("README: its tables are told from others by a digit") {
  CHECK(same_line("short_full 0.060298 5.9e-02, +8.9457e-04", "short_full  0.060298 4.1e-02, +8.9460e-04"));
  CHECK_FALSE(same_line("short_full 0.060298", "short_full 0.060299"));
  CHECK_FALSE(same_line("short_full 5.9e-02", "short_full 5.9e-04"));
  CHECK(same_line("2.3e-14", "1.9e-13"));
  CHECK_FALSE(same_line("+8.9457e-04", "-8.9457e-04"));
  CHECK_FALSE(same_line("+8.9457e-04", "+8.9957e-04"));
  CHECK_FALSE(same_line("a yes ABC", "a yes AB–"));
  CHECK_FALSE(same_line("a b", "a"));
  CHECK_FALSE(same_line("a", "a b"));
}

TEST_CASE(
    "reproduce: all eight laws agree, the files that it names are there, and the documentation shows its tables") {
  const TemporaryFolder folder;
  const ProgramResult result = lubjoint_program({"reproduce", "--out", folder / "out"}, {.seconds = 300});
  INFO(result.out << result.err);
  CHECK(result.status == 0);
  for (const std::string_view law : lubjoint::film_law_names) {
    const std::size_t row = result.out.find("\n" + std::string(law) + " ");
    REQUIRE(row != std::string::npos);
    CHECK_THAT(result.out.substr(row + 1, result.out.find('\n', row + 1) - row), Contains("  yes "));
    CHECK(std::filesystem::file_size(folder / ("out/journal-" + std::string(law) + ".csv")) > 10'000);
  }
  const std::vector<CsvRow> summary = read_csv(folder / "out/journal-summary.csv");
  CHECK(summary.size() == 8);
  for (const CsvRow& row : summary) CHECK(row.at("agrees") == "yes");
  check_readme("reproduce", shown_of(result.out, "", "eigenvalue"));
  check_readme("reproduce example 2", shown_of(result.out, "ideal joints:", "cosity"));
  check_sentences(summary, read_csv(folder / "out/slider-crank.csv").size());
  // What the verdicts rest on: a row for each check, and the paper's words for the five laws that the paper has.
  const std::vector<CsvRow> checks = read_quoted_csv(folder / "out/journal-checks.csv");
  CHECK(checks.size() % 8 == 0);
  std::size_t paper_says_nothing = 0;
  for (const CsvRow& row : checks) {
    CHECK(row.at("outcome") != "failed");
    CHECK_FALSE(row.at("reason").empty());
    if (row.at("what") == "the paper's words") paper_says_nothing += row.at("outcome") == "not checked";
  }
  CHECK(paper_says_nothing == 3);
  std::set<std::string> judged;
  for (const CsvRow& row : read_quoted_csv(folder / "out/slider-crank-checks.csv")) {
    CHECK(row.at("outcome") == "passed");
    judged.insert(row.at("what"));
  }
  for (const char* what : {"e/c", "joint force", "driving moment", "film thickness", "least film", "largest force"}) {
    CHECK(judged.contains(what));
  }
  for (const char* plot : {"journal-orbit", "journal-fx", "journal-fy"}) {
    for (const char* extension : {".svg", ".png"}) {
      CHECK(std::filesystem::file_size(folder / (std::string("out/") + plot + extension)) > 1000);
    }
  }
  const auto page = std::filesystem::file_size(folder / "out/report.html");
  CHECK(page > 1'000'000);
  CHECK(page < 6'000'000);  // a page that can be mailed
  CHECK_THAT(result.err, Contains("report.html"));
  for (const std::string& name : folder.entries()) CHECK(name.find(".unfinished-") == std::string::npos);
}

}  // namespace reproduce_command_test

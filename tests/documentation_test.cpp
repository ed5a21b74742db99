// What the documentation shows of the program is what the program prints, and its numbers are those of the files that
// they are said to be of. LUBJOINT_REWRITE_DOCUMENTATION=1 in the environment writes the marked blocks anew:
// ctest --test-dir build/release -R documentation
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "lubjoint/film/every_law.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

namespace documentation_test {

using namespace lubjoint::test;

namespace {

constexpr std::string_view mark = "<!-- run -->\n```\n$ ";
constexpr std::string_view fence = "```\n";

/// Standard output of a line of shell in the checkout, where ./lubjoint is the program that was built.
std::string output_of(std::string line) {
  constexpr std::string_view program = "./lubjoint ";
  const std::size_t place = line.find(program);
  REQUIRE(place != std::string::npos);
  line.replace(place, program.size(), "'" LUBJOINT_PROGRAM "' ");
  FILE* pipe = ::popen(("cd '" LUBJOINT_SOURCE_DIR "' && " + line + " 2>/dev/null").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string output;
  char buffer[4096];
  for (std::size_t got = 0; (got = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) output.append(buffer, got);
  ::pclose(pipe);
  return output;
}

/// The text with every marked block as the program prints it.
std::string renewed(const std::string& text, int& blocks) {
  std::string result;
  std::size_t at = 0;
  while (true) {
    const std::size_t begin = text.find(mark, at);
    if (begin == std::string::npos) break;
    const std::size_t command = begin + mark.size();
    const std::size_t line_end = text.find('\n', command);
    const std::size_t end = text.find(fence, line_end);
    REQUIRE(end != std::string::npos);
    result += text.substr(at, line_end + 1 - at) + output_of(text.substr(command, line_end - command));
    at = end;
    ++blocks;
  }
  return result + text.substr(at);
}

/// The first block of a language in a file.
std::string block_of(const std::string& file, const std::string& language) {
  const std::string text = read_text(LUBJOINT_SOURCE_DIR + file);
  const std::size_t open = text.find("```" + language + "\n");
  REQUIRE(open != std::string::npos);
  const std::size_t begin = text.find('\n', open) + 1;
  return text.substr(begin, text.find(fence, begin) - begin);
}

struct Ending {
  int status;
  std::string output;  ///< both streams
};

/// Runs a line of shell in the checkout with a text as its standard input.
Ending ended(const std::string& line, const std::string& input) {
  const ProgramResult result = run("/bin/sh", {"-c", line + " 2>&1"}, {.input = input, .folder = LUBJOINT_SOURCE_DIR});
  return {result.status, result.out};
}

}  // namespace

TEST_CASE("documentation: outputs shown are what the program prints") {
  int blocks = 0;
  for (const char* file : {"/README.md", "/oracle/verify/README.md", "/data/README.md"}) {
    const std::string name = LUBJOINT_SOURCE_DIR + std::string(file);
    const std::string text = read_text(name);
    const std::string now = renewed(text, blocks);
    INFO(name);
    if (std::getenv("LUBJOINT_REWRITE_DOCUMENTATION") != nullptr) std::ofstream(name) << now;
    CHECK(read_text(name) == now);
  }
  // The bench's table has a writer of its own.
  if (std::getenv("LUBJOINT_REWRITE_DOCUMENTATION") != nullptr) {
    const ProgramResult table = lubjoint_program({"bench", "scenes", "--data", LUBJOINT_SOURCE_DIR "/data/measured",
                                                  "--readme", LUBJOINT_SOURCE_DIR "/README.md"});
    CHECK(table.status == 0);
  }
  CHECK(blocks >= 20);
  const std::string wrong = "<!-- run -->\n```\n$ ./lubjoint --version\nanother\n```\n";
  CHECK(renewed(wrong, blocks) != wrong);
}

TEST_CASE("documentation: the README's table of commands names every command, and what benchmark does besides") {
  const std::string text = read_text(LUBJOINT_SOURCE_DIR "/README.md");
  const std::size_t start = text.find("\n## Commands\n");
  REQUIRE(start != std::string::npos);
  const std::string commands = text.substr(start, text.find("\n## ", start + 1) - start);
  const std::string help = lubjoint_program({"--help"}).out;
  const std::size_t list = help.find("Subcommands:\n");
  REQUIRE(list != std::string::npos);
  std::istringstream lines(help.substr(list));
  std::string line;
  std::getline(lines, line);
  int names = 0;
  while (std::getline(lines, line)) {
    if (line.size() < 3 || line[2] == ' ') continue;  // the rest of a description
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    INFO(name);
    const bool is_named =
        commands.find("`" + name + "`") != std::string::npos || commands.find("`" + name + " ") != std::string::npos;
    CHECK(is_named);
    ++names;
  }
  CHECK(names >= 20);
  CHECK_THAT(commands, Catch::Contains("--work-precision"));
  CHECK_THAT(lubjoint_program({"benchmark", "--help"}).out, Catch::Contains("--work-precision"));
}

TEST_CASE("documentation: the accuracy that the README states is that of data/accuracy.csv") {
  std::map<std::string, std::pair<double, double>> largest;  // of ulp and of the share of |F|
  for (const CsvRow& row : read_csv(LUBJOINT_SOURCE_DIR "/data/accuracy.csv")) {
    auto& [ulp, share] = largest[row.at("law")];
    ulp = std::max(ulp, std::stod(row.at("max_ulp")));
    share = std::max(share, std::stod(row.at("max_error_over_force")));
  }
  REQUIRE(largest.size() == lubjoint::names_of_laws<lubjoint::StateFilmLaws>.size());
  const std::string readme = read_text(LUBJOINT_SOURCE_DIR "/README.md");
  for (const auto& [law, errors] : largest) {
    const std::size_t at = readme.find("\n| " + law + " | ");
    REQUIRE(at != std::string::npos);
    const std::string line = readme.substr(at + 1, readme.find('\n', at + 1) - at - 1);
    std::smatch match;
    REQUIRE(std::regex_match(line, match, std::regex(R"(\| \w+ \| (\S+) \| (\S+) \|)")));
    INFO(line);
    const bool dynamic = law.ends_with("_dynamic");
    CHECK((match[1] == "–") == dynamic);                                         // of |F| there: it is the other column
    if (!dynamic) CHECK(std::abs(std::stod(match[1]) - errors.first) <= 0.051);  // the digits given
    CHECK(std::abs(std::stod(match[2]) / errors.second - 1) <= 0.051);           // two digits
  }
}

TEST_CASE("documentation: rows and digits of agreement are those of the stored trajectories") {
  const std::string text = read_text(LUBJOINT_SOURCE_DIR "/data/README.md");
  std::map<std::string, double> digits;
  for (const auto& entry : std::filesystem::directory_iterator(LUBJOINT_SOURCE_DIR "/data/golden/trajectories")) {
    if (entry.path().extension() != ".csv") continue;
    const std::vector<CsvRow> rows = read_csv(entry.path().string());
    const std::string name = entry.path().stem().string();
    CHECK(rows.size() == (name.starts_with("journal-") ? 56 : 100));
    double largest = 0;
    for (const CsvRow& row : rows) largest = std::max(largest, std::stod(row.at("disagreement")));
    digits[name] = -std::log10(largest);
  }
  CHECK_THAT(text, Catch::Contains("| `journal-LAW.csv` | 56 |") && Catch::Contains("joint NAME | 100 |"));
  const auto stated = [&](const std::string& words, const std::vector<double>& numbers, const std::string& names) {
    INFO(words);
    CHECK_THAT(text, Catch::Contains(words));
    std::istringstream list(names);
    std::string name;
    for (const double number : numbers) {
      list >> name;
      INFO(name);
      CHECK(std::abs(digits.at(name) - number) <= 0.06);  // the digit given
    }
  };
  stated(
      "13.1 (c = 0.2 mm, 0.4 Pa s), 12.4, 12.1, 12.0, 11.2 (0.5 mm, 0.04 Pa s)", {13.1, 12.4, 12.1, 12.0, 11.2},
      "slider-crank slider-crank-c0.1-mu0.4 slider-crank-c0.5-mu0.4 slider-crank-c0.2-mu0.04 slider-crank-c0.5-mu0.04");
  stated("Radau IIA(5) and Fehlberg 7(8) | 15.2 |", {15.2}, "slider-crank-ideal");
  stated("the same equations, Fehlberg 7(8) | 13.0 |", {13.0}, "slider-crank-torque");
  stated("events, Fehlberg 7(8) | 10.5 |", {10.5}, "impact");
  stated("half films 15.0 to 15.7, others 15.4 to 16.4", {15.0, 15.0, 15.7, 15.4, 16.4, 16.4},
         "journal-long_half journal-long_half_eq5 journal-short_half journal-pinkus_sternlicht journal-long_full "
         "journal-long_dynamic");
}

TEST_CASE("documentation: the precision of the certified digits is that of their source") {
  const std::string source = read_text(LUBJOINT_SOURCE_DIR "/oracle/certified/digits.cpp");
  CHECK_THAT(source, Catch::Contains("first_bits = 192;") && Catch::Contains("last_bits = 12288;"));
  CHECK_THAT(read_text(LUBJOINT_SOURCE_DIR "/data/README.md"), Catch::Contains("(192 to 12288)"));
}

TEST_CASE("documentation: the program in C++ prints every field of the golden forces") {
  const TemporaryFolder folder;
  const std::string source = folder.write("read.cpp", block_of("/data/README.md", "cpp"));
  const std::string program = folder / "read";
  const Ending made = ended("c++ -o '" + program + "' '" + source + "'", "");
  INFO(made.output);
  REQUIRE(made.status == 0);
  std::string golden = read_text(LUBJOINT_SOURCE_DIR "/data/golden/film_force.csv");
  std::replace(golden.begin(), golden.end(), ',', ' ');
  std::string printed = ended("'" + program + "'", "").output;
  printed.erase(std::remove(printed.begin(), printed.end(), ' '), printed.end());
  golden.erase(std::remove(golden.begin(), golden.end(), ' '), golden.end());
  CHECK(printed == golden);
}

TEST_CASE("documentation: the laws written out in Python agree with the golden forces, and a wrong one does not") {
  const std::string program = block_of("/data/README.md", "python");
  CHECK_THAT(ended("python3 -", program).output, Catch::Contains("forces of 12 laws agree"));
  const std::size_t place = program.find("24 * e * b");
  REQUIRE(place != std::string::npos);
  std::string wrong = program;
  wrong.replace(place, 2, "12");
  CHECK(ended("python3 -", wrong).status != 0);
}

TEST_CASE("documentation: the program in Octave agrees with the golden forces") {
  if (ended("command -v octave-cli", "").status != 0) {
    WARN("skipped: Octave is not installed");
    return;
  }
  CHECK(ended("octave-cli -q -", block_of("/data/README.md", "matlab")).status == 0);
}

TEST_CASE("documentation: what the README says of the extreme cases is what is stored of their runs") {
  std::map<std::string, int> count;
  std::set<std::string> cases;
  int runs = 0;
  for (const CsvRow& row : read_csv(LUBJOINT_SOURCE_DIR "/data/measured/stress.csv")) {
    ++count[row.at("status")];
    cases.insert(row.at("case"));
    ++runs;
  }
  std::ostringstream said;
  said << "of " << runs << " runs of " << cases.size() << " cases " << count["finished"]
       << " finished near their reference in place, velocity and force, " << count["coarse"]
       << " finished further off and had warned of their own tolerance, " << count["unreferenced"]
       << " finished without a reference, " << count["stopped"] << " stopped with a reason, " << count["wrong"]
       << " are wrong.";
  CHECK(count["finished"] + count["coarse"] + count["unreferenced"] + count["stopped"] + count["wrong"] == runs);
  const std::string readme = std::regex_replace(read_text(LUBJOINT_SOURCE_DIR "/README.md"), std::regex("\\n"), " ");
  CHECK(readme.find(said.str()) != std::string::npos);
}

}  // namespace documentation_test

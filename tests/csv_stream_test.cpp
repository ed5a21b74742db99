// Tables of states as other programs write them, as long as they like: quoted, fed back, streamed, cut short by an
// error.
#include <fcntl.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>

#include "oracle/files/csv_table.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"

namespace csv_stream_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;
using Words = std::vector<std::string>;

namespace {

Words with_bearing(Words words) {
  for (const char* word :
       {"--states", "-", "--viscosity", "0.4", "--length", "0.04", "--radius", "0.0098", "--clearance", "0.0002"}) {
    words.emplace_back(word);
  }
  return words;
}

ProgramResult answered(const Words& words, const std::string& input) {
  const ProgramResult result = lubjoint_program(with_bearing(words), {.input = input});
  INFO(result.err);
  REQUIRE(result.status == 0);
  return result;
}

const std::string header = "eccentricity_ratio,slip_rate,squeeze_rate";
const std::string plain = header + "\n0.5,1,0.2\n0.7,-3,0.1\n";

/// The last columns of each row.
std::vector<std::string> tails(const std::string& csv, std::size_t columns) {
  std::vector<std::string> tails;
  std::istringstream stream(csv);
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> row = fields(line);
    std::string tail;
    for (std::size_t i = row.size() - columns; i < row.size(); ++i) tail += row[i] + ",";
    tails.push_back(tail);
  }
  return tails;
}

}  // namespace

TEST_CASE("states: quoted headers and fields, as R's write.csv and spreadsheets write them, are read") {
  const std::string of_r =
      "\"\",\"eccentricity_ratio\",\"slip_rate\",\"squeeze_rate\"\n\"1\",0.5,1,0.2\n\"2\",0.7,-3,0.1\n";
  const std::string of_a_spreadsheet =
      "\"note, with a comma\",eccentricity_ratio,slip_rate,squeeze_rate\r\n\"he said \"\"half, at most\"\"\",\"0.5\",1,"
      "\"0.2\"\r\n,0.7,-3,\"+0.1\"\r\n";
  for (const std::string law : {"short_half", "long_dynamic"}) {
    const std::size_t columns = law == "short_half" ? 2 : 4;
    const auto wanted = tails(answered({"force", "--law", law}, plain).out, columns);
    for (const std::string& text : {of_r, of_a_spreadsheet}) {
      INFO(text);
      const std::string out = answered({"force", "--law", law}, text).out;
      CHECK(tails(out, columns) == wanted);
      CHECK(out.substr(0, out.find(",radial")) == text.substr(0, text.find_first_of("\r\n")));  // as it was given
    }
  }
  const std::string motions = "\"ex\",\"ey\",\"vx\",\"vy\",\"omega_bearing\",\"omega_journal\"\n1e-5,0,0,0,0,100\n";
  CHECK_THAT(answered({"losses", "--law", "short_half"}, motions).out, Contains("\"omega_journal\",fx,fy"));
}

TEST_CASE("states: a quote that is not closed is refused with its line") {
  for (const std::string& text : {header + "\n0.5,1,\"0.2\n", "\"" + header + "\n0.5,1,0.2\n"}) {
    const ProgramResult result = lubjoint_program(with_bearing({"force", "--law", "short_half"}), {.input = text});
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Contains("standard input:") && Contains("a quote is not closed") && Contains("allowed"));
  }
}

TEST_CASE("states: a table in memory reads quotes as a stream does") {
  const reports::CsvTable table("\"a\",\"b, c\"\n\"1.5\",\"x\"\"y\"\n", "t");
  CHECK(table.columns() == std::vector<std::string>{"a", "b, c"});
  CHECK(table.number(0, table.column("a")) == 1.5);
  CHECK(table.field(0, 1) == "x\"\"y");
}

TEST_CASE("states: an answer can be given back as states, and its columns are replaced, not doubled") {
  for (const Words& command :
       {Words{"force", "--law", "short_dynamic"}, Words{"oracle", "force", "--film", "short_dynamic"},
        Words{"oracle", "force", "--film", "finite_half"}}) {
    const std::string first = answered(command, plain).out;
    CHECK(answered(command, first).out == first);
  }
  // Another law's columns are replaced where they have the same name, and stay where not.
  const std::string dynamic = answered({"force", "--law", "short_dynamic"}, plain).out;
  const std::string full = answered({"force", "--law", "short_full"}, dynamic).out;
  CHECK_THAT(full, Catch::Matchers::StartsWith(header + ",theta_s,theta_e,radial,tangential\n"));
  CHECK(tails(full, 2) == tails(answered({"force", "--law", "short_full"}, plain).out, 2));
  const std::string motions = "ex,ey,vx,vy,omega_bearing,omega_journal\n1e-5,0,0,0,0,100\n";
  const std::string losses = answered({"losses", "--law", "short_half"}, motions).out;
  CHECK(answered({"losses", "--law", "short_half"}, losses).out == losses);
}

TEST_CASE("states: a long stream is answered in constant memory, with progress on a terminal") {
  constexpr std::size_t rows = 300'000;
  std::string input = header + "\n";
  for (std::size_t i = 0; i < rows; ++i) input += "0." + std::to_string(100'000 + i % 800'000) + ",1.25,-0.375\n";
  const TemporaryFolder folder;
  const std::string file = folder.write("states.csv", input);
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  REQUIRE(terminal >= 0);
  REQUIRE(::grantpt(terminal) == 0);
  REQUIRE(::unlockpt(terminal) == 0);
  const std::string name = ::ptsname(terminal);
  const int other_end = ::open(name.c_str(), O_RDWR | O_NOCTTY);  // what was written stays until it is read
  REQUIRE(other_end >= 0);
  Words words = with_bearing({"oracle", "force", "--film", "long_dynamic"});
  std::replace(words.begin(), words.end(), std::string("-"), file);
  const ProgramResult result = lubjoint_program(words, {.seconds = 120, .before = [&] {
                                                          ::dup2(other_end, STDERR_FILENO);
                                                          // A table of these states takes three times as much.
                                                          const rlimit limit{32 << 20, 32 << 20};
                                                          ::setrlimit(RLIMIT_DATA, &limit);
                                                        }});
  CHECK(result.status == 0);
  CHECK(static_cast<std::size_t>(std::count(result.out.begin(), result.out.end(), '\n')) == rows + 1);
  ::fcntl(terminal, F_SETFL, O_NONBLOCK);
  std::string shown;
  char piece[4096];
  for (ssize_t got = 0; (got = ::read(terminal, piece, sizeof piece)) > 0;) {
    shown.append(piece, static_cast<std::size_t>(got));
  }
  ::close(other_end);
  ::close(terminal);
  CHECK_THAT(shown, Contains("oracle force [") && Contains(" rows, ") && Contains(" s left"));
}

TEST_CASE(
    "states: an error in a short table leaves no half of an answer, one far down in a long one is still an error") {
  const ProgramResult early =
      lubjoint_program(with_bearing({"force", "--law", "short_half"}), {.input = plain + "2,1,1\n"});
  CHECK(early.status == 2);
  CHECK(early.out.empty());
  std::string input = header + "\n";
  for (int i = 0; i < 200'000; ++i) input += "0.5,1,0.2\n";
  const ProgramResult late =
      lubjoint_program(with_bearing({"force", "--law", "short_half"}), {.input = input + "2,1,1\n"});
  CHECK(late.status == 2);
  CHECK_THAT(late.err, Contains("standard input:200002: ") && Contains("allowed"));
  CHECK_FALSE(late.out.empty());
}

TEST_CASE("oracle force: finite_reynolds warns where its grids no longer resolve the film") {
  const Words reynolds{"oracle", "force", "--film", "finite_reynolds"};
  CHECK(answered(reynolds, header + "\n0.5,1,0\n").err.empty());
  const ProgramResult thin = answered(reynolds, header + "\n0.5,1,0\n0.9999999999,1,0\n");
  CHECK_THAT(thin.err, Contains("1 of the states have an eccentricity ratio above 0.99"));
  CHECK(answered({"oracle", "force", "--film", "finite_half"}, header + "\n0.9999999999,1,0\n").err.find("0.99") ==
        std::string::npos);  // meant for any
}

}  // namespace csv_stream_test

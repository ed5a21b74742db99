// What the documentation shows of the program is what the program prints. LUBJOINT_REWRITE_DOCUMENTATION=1 in the
// environment writes it anew: ctest --test-dir build/release -R documentation
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "support/csv.hpp"
#include "support/run_program.hpp"

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
  CHECK(blocks >= 17);
  const std::string wrong = "<!-- run -->\n```\n$ ./lubjoint --version\nanother\n```\n";
  CHECK(renewed(wrong, blocks) != wrong);
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

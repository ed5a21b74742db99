// What the documentation shows of the program is what the program prints. LUBJOINT_REWRITE_DOCUMENTATION=1 in the
// environment writes it anew: ctest --test-dir build/release -R documentation
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "support/run_program.hpp"

using namespace lubjoint::test;

namespace {

constexpr std::string_view mark = "<!-- run -->\n```\n$ ./lubjoint ";
constexpr std::string_view fence = "```\n";

/// Standard output of a command of the program, run in the checkout.
std::string output_of(const std::string& arguments) {
  const std::string command =
      "cd '" LUBJOINT_SOURCE_DIR "' && '" LUBJOINT_PROGRAM "' " + arguments + " 2>/dev/null";
  FILE* pipe = ::popen(command.c_str(), "r");
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

}  // namespace

TEST_CASE("documentation: outputs shown are what the program prints") {
  const std::string name = LUBJOINT_SOURCE_DIR "/oracle/verify/README.md";
  const std::string text = read_text(name);
  int blocks = 0;
  const std::string now = renewed(text, blocks);
  CHECK(blocks >= 6);
  if (std::getenv("LUBJOINT_REWRITE_DOCUMENTATION") != nullptr) {
    std::ofstream(name) << now;
    SUCCEED("written anew");
  } else {
    CHECK(text == now);
  }
  CHECK(renewed("<!-- run -->\n```\n$ ./lubjoint --version\nanother\n```\n", blocks) !=
        "<!-- run -->\n```\n$ ./lubjoint --version\nanother\n```\n");  // a wrong output is noticed
}

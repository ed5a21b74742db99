#include "lubjoint/version.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "support/run_program.hpp"

namespace version_test {

using namespace lubjoint::test;

TEST_CASE("Version: the program says the header's, and the changelog begins with it") {
  CHECK(lubjoint_program({"--version"}).out == LUBJOINT_VERSION "\n");
  std::istringstream lines(read_text(LUBJOINT_SOURCE_DIR "/CHANGELOG.md"));
  std::string line;
  while (std::getline(lines, line) && !line.starts_with("## ")) {
  }
  CHECK(line == "## " LUBJOINT_VERSION);
}

}  // namespace version_test

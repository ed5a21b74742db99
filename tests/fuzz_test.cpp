// The inputs that are kept for fuzzing, and those that it found, through the same checks without Clang.
#include <catch2/catch.hpp>

#include "fuzz/targets.hpp"
#include "support/temporary_folder.hpp"

namespace fuzz_test {

using namespace lubjoint;

namespace {

/// Runs a target on every file of its corpus.
template <class Target>
void replay(const std::string& name, const Target& target) {
  const std::filesystem::path folder = std::filesystem::path(LUBJOINT_SOURCE_DIR) / "tests/fuzz/corpus" / name;
  std::size_t inputs = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    INFO(file.path());
    CHECK_NOTHROW(target(test::read_text(file.path())));
    ++inputs;
  }
  CHECK(inputs >= 5);
}

}  // namespace

TEST_CASE("Fuzz: every scene of the corpus is sound or refused with file, line and what is allowed") {
  replay("scene", fuzz::scene);
}

TEST_CASE("Fuzz: every states CSV of the corpus comes back with its numbers or is refused with file and line") {
  replay("states", fuzz::states);
}

TEST_CASE("Fuzz: every answers CSV of the corpus is read as the C library reads it or is refused") {
  replay("answers", fuzz::answers);
}

TEST_CASE("Fuzz: every command line of the corpus names an action or is refused in one line") {
  replay("command_line", fuzz::command_line);
}

}  // namespace fuzz_test

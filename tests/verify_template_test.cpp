// The adapters that `verify --template` prints: each is a program that agrees as printed, and is found out once
// spoiled.
#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

namespace verify_template_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

/// A language, how its program is made and run in the folder of film.EXTENSION, and what that takes.
struct Language {
  const char* name;
  const char* extension;
  const char* needs;
  const char* make;
  const char* run;
};

constexpr std::array languages = {
    Language{"python", "py", "python3", "true", "python3 film.py"},
    Language{"octave", "m", "octave-cli", "true", "octave-cli -q film.m"},
    Language{"c", "c", "cc", "cc -O2 -Wall -Wextra -Werror film.c -o film -lm", "./film"},
    Language{"cpp", "cpp", "c++", "c++ -O2 -Wall -Wextra -Werror film.cpp -o film", "./film"},
    Language{"fortran", "f90", "gfortran", "gfortran -O2 -Wall film.f90 -o film", "./film"},
    Language{"julia", "jl", "julia", "true", "julia film.jl"}};

ProgramResult in_folder(const TemporaryFolder& folder, const std::string& line) {
  ProgramSetting setting;
  setting.folder = folder.path().string();
  return run("/bin/sh", {"-c", line}, setting);
}

void check_language(const Language& language) {
  INFO(language.name);
  const TemporaryFolder folder;
  const std::string file = std::string("film.") + language.extension;
  const ProgramResult printed =
      in_folder(folder, std::string("'" LUBJOINT_PROGRAM "' verify --template ") + language.name + " > " + file);
  REQUIRE(printed.status == 0);
  if (in_folder(folder, std::string("command -v ") + language.needs).status != 0) {
    WARN("skipped: " << language.needs << " is not installed; its adapter was printed and not run");
    return;
  }
  const std::string verify =
      std::string("'" LUBJOINT_PROGRAM "' verify --law short_full --states 100 -- ") + language.run;
  REQUIRE(in_folder(folder, language.make).status == 0);
  const ProgramResult right = in_folder(folder, verify);
  CHECK(right.status == 0);
  CHECK_THAT(right.out, Contains("agrees: short_full"));

  // With the rate of the attitude left out, as if it were steady.
  REQUIRE(in_folder(folder, "sed -i 's/ - 2\\(gamma\\| \\* \\)/ - 0\\1/' " + file).status == 0);
  REQUIRE(in_folder(folder, language.make).status == 0);
  const ProgramResult wrong = in_folder(folder, verify);
  CHECK(wrong.status == 1);
  CHECK_THAT(wrong.out, Contains("disagrees"));
}

}  // namespace

TEST_CASE("verify: the Python adapter agrees as printed, and not without the attitude's rate") {
  check_language(languages[0]);
}
TEST_CASE("verify: the Octave adapter agrees as printed, and not without the attitude's rate") {
  check_language(languages[1]);
}
TEST_CASE("verify: the C adapter agrees as printed, and not without the attitude's rate") {
  check_language(languages[2]);
}
TEST_CASE("verify: the C++ adapter agrees as printed, and not without the attitude's rate") {
  check_language(languages[3]);
}
TEST_CASE("verify: the Fortran adapter agrees as printed, and not without the attitude's rate") {
  check_language(languages[4]);
}
TEST_CASE("verify: the Julia adapter agrees as printed, and not without the attitude's rate") {
  check_language(languages[5]);
}

TEST_CASE("verify: an adapter in another language is refused, and so is an option beside one") {
  const TemporaryFolder folder;
  const ProgramResult other = in_folder(folder, "'" LUBJOINT_PROGRAM "' verify --template cobol");
  CHECK(other.status == 2);
  CHECK_THAT(other.err, Contains("cobol") && Contains("python, octave, c, cpp, fortran, julia"));
  const ProgramResult beside = in_folder(folder, "'" LUBJOINT_PROGRAM "' verify --template c --law short_full");
  CHECK(beside.status == 2);
  CHECK_THAT(beside.err, Contains("--law does nothing with --template"));
}

}  // namespace verify_template_test

// Force programs that people write, and what must be said of each: tests/programs. Most were written by someone who did
// not know the gallery of mistakes.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdio>

#include "support/csv.hpp"

namespace verify_programs_test {

namespace {

std::vector<std::string> parts(const std::string& list) {
  std::vector<std::string> result;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find('|', at), list.size());
    result.push_back(list.substr(at, end - at));
    at = end + 1;
  }
  return result;
}

struct Said {
  std::string text;
  int status;
};

Said said(const std::string& arguments) {
  const std::string command = "'" LUBJOINT_PROGRAM "' verify " + arguments + " 2>&1";
  FILE* pipe = ::popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  Said result{};
  char buffer[4096];
  for (std::size_t got = 0; (got = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) result.text.append(buffer, got);
  const int status = ::pclose(pipe);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

/// The mistake or the set of them that a report names first; empty if it names none.
std::string first_named(const std::string& report) {
  const std::size_t list = report.find("\nLikely mistakes");
  if (list == std::string::npos) return {};
  const std::size_t share = report.find("%  ", report.find('\n', list + 1));
  return report.substr(share + 3, report.find('\n', share) - share - 3);
}

/// What the first words of a report and its exit status must be.
struct Verdict {
  const char* begin;
  int status;
};

Verdict verdict_of(const std::string& name) {
  if (name == "agrees") return {"agrees: ", 0};
  if (name == "agrees_to_digits") return {"agrees to ", 1};
  if (name == "undecided") return {"could not be judged", 2};
  REQUIRE(name == "disagrees");
  return {"disagrees: ", 1};
}

void check_programs(const std::string& name, std::size_t at_least) {
  const std::string folder = LUBJOINT_SOURCE_DIR "/tests/programs/";
  std::size_t asked = 0;
  for (const auto& row : lubjoint::test::read_csv(folder + name + ".csv")) {
    const Said report =
        said("--law " + row.at("law") + " --states 100 " + (row.contains("options") ? row.at("options") : "") +
             " -- python3 " + folder + name + ".py " + row.at("mode"));
    INFO(name << " " << row.at("mode") << ": " << row.at("truth") << "\n" << report.text);
    const Verdict verdict = verdict_of(row.at("verdict"));
    CHECK_THAT(report.text, Catch::StartsWith(verdict.begin));
    CHECK(report.status == verdict.status);
    if (row.contains("first")) CHECK(first_named(report.text) == row.at("first"));
    for (const std::string& words : parts(row.at("says"))) CHECK_THAT(report.text, Catch::Contains(words));
    for (const std::string& words : parts(row.at("never"))) CHECK_THAT(report.text, !Catch::Contains(words));
    CHECK_THAT(report.text, Catch::Contains("\nNext: "));
    ++asked;
  }
  CHECK(asked >= at_least);
}

}  // namespace

TEST_CASE("verify: sixteen programs of the kinds that people write are told what they are") {
  check_programs("kinds", 16);
}

TEST_CASE("verify: programs written without the gallery in mind are named or located") {
  check_programs("programs", 60);
}

TEST_CASE("verify: programs of stiffness, damping and equilibrium are named or located column by column") {
  check_programs("coefficients", 32);
}

TEST_CASE("verify: programs of torques, power and side flow are named or located column by column") {
  check_programs("losses", 24);
}

TEST_CASE("verify: programs of dry contact are named, by law and by mistake") { check_programs("contact", 20); }

TEST_CASE("verify: a program of each quantity agrees, and six mistakes or more in each are named first") {
  check_programs("quantities", 78);
}

TEST_CASE("verify: auto finds the law of numerical, steady and mistaken programs") {
  const std::string folder = LUBJOINT_SOURCE_DIR "/tests/programs/";
  for (const auto& [program, law] : {std::pair{"kinds.py midpoints_60", "short_dynamic"},
                                     {"kinds.py steady", "short_half"},
                                     {"kinds.py pi_lost", "short_half"},
                                     {"kinds.py steady_on_bearing", "short_half"},
                                     {"kinds.py nan_for_reverse", "short_half"},
                                     {"programs.py full_for_half", "short_full"},
                                     {"programs.py dynamic_for_half", "short_dynamic"},
                                     {"programs.py cut_at_pi", "long_half_eq5"},
                                     {"programs.py pinkus_for_dynamic", "pinkus_sternlicht"},
                                     {"programs.py trapezoid_2000", "long_dynamic"},
                                     {"programs.py steady_sommerfeld_number", "long_full"},
                                     {"programs.py relative_spin", "short_half"}}) {
    const Said report = said("--law auto --states 100 -- python3 " + folder + program);
    INFO(program << "\n" << report.text);
    CHECK_THAT(report.text.substr(0, report.text.find('\n')),
               Catch::Contains(std::string(": ") + law + " (found among all laws)"));
  }
}

}  // namespace verify_programs_test

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "oracle/verify/gallery/gallery_finite.hpp"
#include "oracle/verify/states/foreign_program.hpp"
#include "support/run_program.hpp"
#include "support/verify_answers.hpp"

namespace verify_protocol_test {

using namespace lubjoint;
using namespace lubjoint::verify;
using Catch::Contains;

namespace {

namespace fs = std::filesystem;

struct Ending {
  int status;
  std::string output;  ///< both streams
};

/// Runs a line of shell, with $LUBJOINT and $EXAMPLES set.
Ending shell(const std::string& line) {
  const std::string command = "export LUBJOINT='" LUBJOINT_PROGRAM "' EXAMPLES='" LUBJOINT_SOURCE_DIR
                              "/tests/examples'; { " +
                              line + "\n} 2>&1";
  FILE* pipe = ::popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string output;
  char buffer[4096];
  for (std::size_t got = 0; (got = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) output.append(buffer, got);
  const int status = ::pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

bool have(const std::string& program) { return shell("command -v " + program).status == 0; }

/// A right program whose answers are spoiled by an awk program.
Ending spoiled(const std::string& awk, const std::string& options = "") {
  return shell("\"$LUBJOINT\" verify --law pinkus_sternlicht --states 50 " + options +
               " -- sh -c 'python3 \"$EXAMPLES\"/pinkus_sternlicht.py | awk -F, \"$1\"' sh '" + awk + "'");
}

fs::path temporary(const std::string& name) {
  return fs::temp_directory_path() / ("lubjoint-" + std::to_string(::getpid()) + "-" + name);
}

}  // namespace

TEST_CASE("verify: the Python example agrees, and its wrong variant is told its mistake") {
  const Ending right = shell("\"$LUBJOINT\" verify --law pinkus_sternlicht -- python3 $EXAMPLES/pinkus_sternlicht.py");
  CHECK(right.status == 0);
  CHECK_THAT(right.output, Contains("agrees: pinkus_sternlicht"));
  const Ending wrong =
      shell("\"$LUBJOINT\" verify --law pinkus_sternlicht -- python3 $EXAMPLES/pinkus_sternlicht.py wrong");
  CHECK(wrong.status == 1);
  CHECK_THAT(wrong.output,
             Contains("100.0 %  inertial_attitude_rate") && Contains("Worst state") && Contains("expected"));
}

TEST_CASE("verify: the C example agrees, and its wrong variant is told its mistake") {
  const fs::path program = temporary("short_half");
  REQUIRE(shell("cc -O2 $EXAMPLES/short_half.c -o " + program.string() + " -lm").status == 0);
  const Ending right = shell("\"$LUBJOINT\" verify --law auto -- " + program.string());
  CHECK(right.status == 0);
  CHECK_THAT(right.output, Contains("agrees: short_half (found among all laws)"));
  const Ending wrong = shell("\"$LUBJOINT\" verify --law short_half -- " + program.string() + " wrong");
  CHECK(wrong.status == 1);
  CHECK_THAT(wrong.output, Contains("100.0 %  half_film_not_mirrored") && Contains("wrong where slip_rate < 0"));
  fs::remove(program);
}

TEST_CASE("verify: a program without dimensions agrees in its own unit, and is told its unit and its mistake") {
  const std::string verify = "\"$LUBJOINT\" verify --law short_dynamic --quantities dimensionless --states 200 ";
  const Ending right = shell(verify + "--unit 0.25 -- python3 $EXAMPLES/capone.py");
  CHECK(right.status == 0);
  CHECK_THAT(right.output, Contains("agrees: short_dynamic"));
  const Ending found = shell(
      "\"$LUBJOINT\" verify --law auto --quantities dimensionless --states 200 --unit 0.25 -- "
      "python3 $EXAMPLES/capone.py");
  CHECK_THAT(found.output, Contains("agrees: short_dynamic (found among all laws)"));
  const Ending unit = shell(verify + "-- python3 $EXAMPLES/capone.py");
  CHECK(unit.status == 1);
  CHECK_THAT(unit.output, Contains("unit_a_quarter") && Contains("--unit 0.25"));
  const Ending wrong = shell(verify + "--unit 0.25 -- python3 $EXAMPLES/capone.py wrong");
  CHECK(wrong.status == 1);
  CHECK_THAT(wrong.output, Contains("time_over_mean_spin"));
  const Ending refused = shell("\"$LUBJOINT\" verify --law short_dynamic --unit 0.25 -- python3 $EXAMPLES/capone.py");
  CHECK(refused.status == 2);
  CHECK_THAT(refused.output, Contains("--unit does nothing with --quantities cartesian"));
}

TEST_CASE("verify: the Octave example agrees, and its wrong variant is told its mistake") {
  if (!have("octave-cli")) {
    WARN("skipped: Octave is not installed");
    return;
  }
  CHECK(shell("\"$LUBJOINT\" verify --law long_full -- octave-cli -q $EXAMPLES/long_full.m").status == 0);
  const Ending wrong = shell("\"$LUBJOINT\" verify --law long_full -- octave-cli -q $EXAMPLES/long_full.m wrong");
  CHECK(wrong.status == 1);
  CHECK_THAT(wrong.output, Contains("diameter_for_radius"));
}

TEST_CASE("verify: rows in another order, a byte-order mark and carriage returns are fine") {
  CHECK(spoiled("{ row[NR] = $0 } END { print row[1]; for (i = NR; i > 1; --i) print row[i] }").status == 0);
  CHECK(spoiled("NR == 1 { printf \"\\357\\273\\277\" } { print $0 \"\\r\" }").status == 0);
}

TEST_CASE("verify: answers without ids are taken in the order of the states, if there is one for each") {
  const std::string without_id = "{ sub(/^[^,]*,/, \"\"); print }";
  CHECK(spoiled(without_id).status == 0);
  const Ending turned = spoiled(
      "NR == 1 { sub(/^[^,]*,/, \"\"); print } NR > 1 { sub(/^[^,]*,/, \"\"); row[NR] = $0 } "
      "END { for (i = NR; i > 1; --i) print row[i] }");
  CHECK(turned.status == 1);
  const Ending fewer = spoiled("NR < 200 " + without_id);
  CHECK(fewer.status == 2);
  CHECK_THAT(fewer.output, Contains("198 rows without ids") && Contains("one row a state, in order"));
}

TEST_CASE("verify: what can't be judged ends with status 2 and says why") {
  const auto refused = [](const Ending& outcome, const std::string& word) {
    INFO(outcome.output);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.output, Contains(word));
  };
  refused(spoiled("NR < 200 { print }"), "the first without an answer has id 199");
  refused(spoiled("{ print } END { print \"9999,1,1\" }"), "id is \"9999\"");
  refused(spoiled("{ print } END { print }"), "there twice");
  refused(spoiled("{ gsub(/\\./, \",\"); print }"), "points in decimals");
  refused(spoiled("{ gsub(/,/, \";\"); print }"), "column \"id\" is missing");
  refused(spoiled("NR > 1 { print }"), "is missing");
  refused(spoiled("NR == 20 { $2 = \"oops\" } { print $1 \",\" $2 \",\" $3 }"), "fx is \"oops\"");
  refused(spoiled("NR > 1 { $2 = $3 = \"nan\" } { print $1 \",\" $2 \",\" $3 }"), "is a number");
  refused(spoiled("BEGIN { exit 3 }"), "ended with status 3");
  const std::string verify = "\"$LUBJOINT\" verify --law short_full ";
  refused(shell(verify + "-- sh -c 'echo the reason >&2; kill -SEGV $$'"), "signal 11");
  refused(shell(verify + "-- sh -c 'echo the reason >&2; exit 1'"), "the reason");
  refused(shell(verify + "--timeout 0.3 -- sleep 20"), "not done after 0.3 s");
  refused(shell(verify + "-- /no/such/program"), "can't be started");
  refused(shell(verify + "-- true"), "empty");
  refused(shell(verify + "--answers /no/such/file"), "/no/such/file");
  refused(shell(verify), "needs one of");
  refused(shell("\"$LUBJOINT\" verify --law shorts -- true"), "short_full");
  refused(shell(verify + "--quantities moments -- true"), "transition");
}

TEST_CASE("verify: answers that are NaN beside answers that are wrong disagree") {
  const Ending outcome =
      spoiled("NR == 20 { $2 = \"nan\" } NR > 1 { $3 = -$3 } { print $1 \",\" $2 \",\" $3 }", "--json");
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.output, Contains("\"not_numbers\": 1"));
}

TEST_CASE("verify: an answer that is not a number in a part of the domain disagrees, and the part is named") {
  const Ending one = spoiled("NR == 20 { $2 = \"nan\" } { print $1 \",\" $2 \",\" $3 }", "--json");
  CHECK(one.status == 1);
  CHECK_THAT(one.output, Contains("\"verdict\": \"disagrees\"") && Contains("\"not_numbers\": 1,"));
}

TEST_CASE("verify: a numerical program agrees to digits, and a tolerance that covers them accepts it") {
  const std::string program = "-- python3 \"$EXAMPLES\"/numerical_short_dynamic.py";
  const std::string verify = "\"$LUBJOINT\" verify --law short_dynamic --states 100 ";
  const Ending judged = shell(verify + program);
  INFO(judged.output);
  CHECK(judged.status == 1);
  CHECK_THAT(judged.output, Contains("agrees to 4 digits where 1 - e/c >= 0.1") && Contains("say --tolerance 1e-04"));
  CHECK(shell(verify + "--tolerance 1e-3 " + program).status == 0);
  CHECK(shell(verify + "--tolerance 1e-6 " + program).status == 1);
}

TEST_CASE("verify: a declared domain is asked about alone, and the verdict repeats it") {
  const std::string verify = "\"$LUBJOINT\" verify --law pinkus_sternlicht --states 50 ";
  const std::string wrong = "-- python3 $EXAMPLES/pinkus_sternlicht.py wrong";  // right while the bearing is at rest
  const Ending resting = shell(verify + "--only 'omega_bearing == 0' " + wrong);
  INFO(resting.output);
  CHECK(resting.status == 0);
  CHECK_THAT(resting.output, Contains("agrees where omega_bearing == 0"));
  CHECK(shell(verify + "--steady " + wrong).status == 0);
  CHECK(shell(verify + wrong).status == 1);
  const Ending unknown = shell(verify + "--only 'omega > 0' " + wrong);
  CHECK(unknown.status == 2);
  CHECK_THAT(unknown.output, Contains("\"omega > 0\"") && Contains("omega_sum"));
  CHECK(shell(verify + "--only 'eccentricity_ratio > 2' " + wrong).status == 2);
  CHECK(shell(verify + "--tolerance 2 " + wrong).status == 2);
}

TEST_CASE("verify: an option that would do nothing is refused by name") {
  const auto refused = [](const std::string& arguments, const std::string& option) {
    const Ending ending = shell("\"$LUBJOINT\" verify " + arguments);
    INFO(arguments << "\n" << ending.output);
    CHECK(ending.status == 2);
    CHECK_THAT(ending.output, Contains(option + " does nothing"));
  };
  refused("--list-mistakes --states 5", "--states");
  refused("--scene a --trajectory b --only 'ex > 0'", "--only");
  refused("--scene a --trajectory b --timeout 5", "--timeout");
  refused("--states-out - --tolerance 1e-3", "--tolerance");
  refused("--law short_full --answers a --timeout 5", "--timeout");
  refused("--law short_full --markdown -- true", "--markdown");
}

TEST_CASE("verify: a hanging program is stopped with all that it started, in the time given") {
  const auto begin = std::chrono::steady_clock::now();
  CHECK_THROWS_AS(run_program({"sh", "-c", "sleep 30 | cat"}, "x\n", {.in_all = std::chrono::duration<double>(0.2)}),
                  UnjudgedError);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(5));
}

TEST_CASE("verify: --state-timeout counts from answer to answer, not in all") {
  // A fifth of a second for each of 24 states: longer in all than may pass from one answer to the next, and a fifteenth
  // of that, so that a busy machine is no reason to fail.
  const std::string slow =
      " -- sh -c 'while IFS= read -r row; do [ \"${row#id}\" = \"$row\" ] && sleep 0.2; echo "
      "\"$row\" | sed \"s/^id.*/id,fx,fy/;s/^\\([0-9]*\\),.*/\\1,0,0/\"; done'";
  const auto begin = std::chrono::steady_clock::now();
  const Ending patient = shell("\"$LUBJOINT\" verify --law short_half --at-most 24 --state-timeout 3" + slow);
  CHECK(patient.status == 1);  // zeros are wrong, and that they are was said
  CHECK_THAT(patient.output, Contains("disagrees: short_half, "));
  CHECK(std::chrono::steady_clock::now() - begin > std::chrono::milliseconds(4000));
  const Ending hasty = shell("\"$LUBJOINT\" verify --law short_half --at-most 24 --state-timeout 0.05" + slow);
  CHECK(hasty.status == 2);
  CHECK_THAT(hasty.output, Contains("printed no line for 0.05 s (--state-timeout)") && Contains("python3 -u"));
  const Ending both =
      shell("\"$LUBJOINT\" verify --law short_half --at-most 24 --state-timeout 5 --timeout 0.5" + slow);
  CHECK(both.status == 2);
  CHECK_THAT(both.output, Contains("(--timeout)"));
}

TEST_CASE("verify: --at-most sends so many states, of every regime, and a wrong program is still caught") {
  const Ending sent = shell("\"$LUBJOINT\" verify --law short_half --at-most 20 --states-out - | wc -l");
  CHECK_THAT(sent.output, Contains("21"));
  const Ending right = shell("\"$LUBJOINT\" verify --law short_half --at-most 20 -- python3 $EXAMPLES/short_half.py");
  CHECK(right.status == 0);
  for (const char* regime : {"near-concentric", "thin film", "separating", "reversing", "moderate"}) {
    CHECK_THAT(right.output, Contains(regime));
  }
  const Ending wrong =
      shell("\"$LUBJOINT\" verify --law short_half --at-most 20 -- python3 $EXAMPLES/short_half.py pi");
  CHECK(wrong.status == 1);
  CHECK_THAT(wrong.output, Contains("pi_left_out_of_squeeze"));
  const Ending none = shell("\"$LUBJOINT\" verify --law short_half --at-most 0 -- true");
  CHECK(none.status == 2);
}

TEST_CASE("verify: whatever interrupts it ends the program that it has started, and all that this one has") {
  for (const int signal : {SIGINT, SIGTERM}) {
    const test::TemporaryFolder folder;
    const std::string late = folder / "late";
    const test::ProgramResult result = test::lubjoint_program(
        {"verify", "--law", "short_full", "--", "sh", "-c", "(sleep 0.6; echo > '" + late + "'); cat"},
        {.signal = signal, .signal_after = 0.3});
    CHECK(result.status == 128 + signal);
    std::this_thread::sleep_for(std::chrono::milliseconds(900));  // when the file would long be there
    CHECK_FALSE(fs::exists(late));
  }
}

TEST_CASE("verify: a program may answer while it still reads, or not read at all") {
  const std::string much(4'000'000, 'x');
  CHECK(run_program({"cat"}, much, {}) == much);
  CHECK(run_program({"echo", "done"}, much, {}) == "done\n");
}

TEST_CASE("verify: states in a file and answers from a file are judged like a program's") {
  const std::string states = temporary("states.csv").string();
  const std::string answers = temporary("answers.csv").string();
  const std::string same = " --quantities cartesian --states 70 --seed 8";
  REQUIRE(shell("\"$LUBJOINT\" verify --states-out " + states + same).status == 0);
  REQUIRE(shell("python3 $EXAMPLES/pinkus_sternlicht.py < " + states + " > " + answers).status == 0);
  CHECK(shell("\"$LUBJOINT\" verify --law pinkus_sternlicht --answers " + answers + same).status == 0);
  CHECK(shell("\"$LUBJOINT\" verify --law pinkus_sternlicht --answers - < " + answers + same).status == 0);
  CHECK(shell("\"$LUBJOINT\" verify --law long_half --answers " + answers + same).status == 1);
  fs::remove(states);
  fs::remove(answers);
}

TEST_CASE("verify: a trajectory of a scene is judged, and one of another law is not the same") {
  const fs::path folder = temporary("run");
  const std::string scene = LUBJOINT_SOURCE_DIR "/data/scenes/journal.toml";
  REQUIRE(shell("\"$LUBJOINT\" simulate " + scene + " --out " + folder.string()).status == 0);
  std::string csv;
  for (const auto& entry : fs::directory_iterator(folder)) csv = entry.path().string();
  const std::string verify = "\"$LUBJOINT\" verify --scene " + scene + " --trajectory " + csv;
  const Ending same = shell(verify);
  INFO(same.output);
  CHECK(same.status == 0);
  const Ending other = shell(verify + " --law short_full");
  INFO(other.output);
  CHECK(other.status == 1);
  CHECK_THAT(other.output, Contains("disagrees") && Contains("clearances"));
  CHECK(shell("\"$LUBJOINT\" verify --scene " + scene).status == 2);
  CHECK(shell("\"$LUBJOINT\" verify --scene " + scene + " --trajectory " + scene).status == 2);
  fs::remove_all(folder);
}

TEST_CASE("verify: data/mistakes.md is what the program says") {
  std::ifstream file(LUBJOINT_SOURCE_DIR "/data/mistakes.md");
  std::stringstream text;
  text << file.rdbuf();
  CHECK(text.str() == gallery_markdown() + finite_gallery_markdown());
  CHECK_THAT(shell("\"$LUBJOINT\" verify --list-mistakes").output, Contains("transport_moment_left_out"));
}

TEST_CASE("verify: 10,000 states through a Python program take less than 3 s", "[.cost]") {
  const auto begin = std::chrono::steady_clock::now();
  CHECK(shell("\"$LUBJOINT\" verify --law pinkus_sternlicht --states 10000 -- python3 $EXAMPLES/pinkus_sternlicht.py")
            .status == 0);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(3));
}

}  // namespace verify_protocol_test

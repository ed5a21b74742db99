// Bad usage and bad input of every command: exit 2, one message that says what is allowed, nothing on standard output,
// nothing left behind.
#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace options_test {

using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Words = std::vector<std::string>;

namespace {

const std::string scene = journal_scene_file;
const std::string good_states = "eccentricity_ratio,slip_rate,squeeze_rate\n0.5,1,0.2\n";

/// Asserts what a refusal looks like. @returns the message
std::string check_refused(const Words& arguments, const Words& words, const ProgramSetting& setting = {}) {
  std::string line;
  for (const std::string& word : arguments) line += " " + word;
  INFO("lubjoint" << line << "\nstates: " << setting.input);
  const ProgramResult result = lubjoint_program(arguments, setting);
  INFO(result.err);
  CHECK(result.status == 2);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, StartsWith("lubjoint: "));
  CHECK(result.err.find("lubjoint: ", 1) == std::string::npos);  // one message
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') <= 2);
  CHECK_THAT(result.err, Contains("allowed") || Contains("required"));
  for (const std::string& word : words) CHECK_THAT(result.err, Contains(word));
  return result.err;
}

/// Arguments of `force` with some options replaced; an empty value leaves the option out.
Words force(const std::map<std::string, std::string>& changed = {}) {
  std::map<std::string, std::string> options{{"--law", "pinkus_sternlicht"}, {"--states", "-"},
                                             {"--viscosity", "0.4"},         {"--length", "0.04"},
                                             {"--radius", "0.0098"},         {"--clearance", "0.0002"}};
  for (const auto& [name, value] : changed) options[name] = value;
  Words words{"force"};
  for (const auto& [name, value] : options) {
    if (!value.empty()) words.insert(words.end(), {name + "=" + value});
  }
  return words;
}

void check_states_refused(const std::string& states, const Words& words) {
  check_refused(force(), words, {.input = states});
}

}  // namespace

TEST_CASE("Options: no command and an unknown one are refused with the list of commands and the nearest") {
  check_refused({}, {"a command is missing; allowed is one of", "simulate", "force", "equilibrium", "reproduce"});
  check_refused({"simulat", scene}, {"\"simulat\"", "did you mean simulate?"});
  check_refused({"--jsn"}, {"allowed is one of"});
  check_refused({""}, {"allowed is one of"});
}

TEST_CASE("Options: one that is unknown, twice there or without its value is refused by every command") {
  const std::vector<Words> commands{{"simulate", scene}, force(), {"equilibrium", scene}, {"reproduce"}, {"accuracy"}};
  for (Words command : commands) {
    const std::string name = command[0];
    command.push_back("--no-such-option");
    check_refused(command, {"--no-such-option"}, {.input = good_states});
    command.back() = "surplus";
    check_refused(command, {"surplus"}, {.input = good_states});
  }
  for (const char* option : {"--law", "--integrator", "--rtol", "--duration", "--out"}) {
    check_refused({"simulate", scene, option}, {option});
    check_refused({"simulate", scene, option, "1", option, "1"}, {option});
  }
  check_refused({"equilibrium", scene, "--law"}, {"--law"});
  for (const char* option : {"--out", "--scenes", "--data"}) check_refused({"reproduce", option}, {option});
  for (const char* option : {"--out", "--directions", "--seed"}) check_refused({"accuracy", option}, {option});
}

TEST_CASE("Options: what a command requires is named when it is missing") {
  check_refused({"simulate"}, {"scene is required"});
  check_refused({"equilibrium"}, {"scene is required"});
  for (const char* option : {"--law", "--states", "--viscosity", "--length", "--radius", "--clearance"}) {
    check_refused(force({{option, ""}}), {std::string(option) + " is required"}, {.input = good_states});
  }
}

TEST_CASE("Options: simulate refuses tolerances and durations that are no positive finite numbers") {
  const Words no_numbers{"abc", "1e-8x", "1,5", "1.0.0", "--json", "[1]"};
  const Words no_positive{"0", "-1", "-0.0", "nan", "inf", "-inf", "1e400", "-nan"};
  for (const char* option : {"--rtol", "--duration"}) {
    for (const std::string& value : no_numbers) check_refused({"simulate", scene, option, value}, {option});
    for (const std::string& value : no_positive) {
      check_refused({"simulate", scene, std::string(option) + "=" + value}, {option, " is ", "; allowed is"});
    }
  }
  for (const char* value : {"1", "2", "9e-15", "1e300"}) {
    check_refused({"simulate", scene, "--rtol", value}, {"allowed is a number from 1e-14 to below 1"});
  }
  check_refused({"simulate", scene, "--duration", "1e5"}, {"--duration is 100000; allowed is at most ten million"});
}

TEST_CASE("Options: an unknown law or integrator is refused with the list and the nearest") {
  for (const char* command : {"simulate", "equilibrium"}) {
    check_refused({command, scene, "--law", "short_hlf"},
                  {"--law is \"short_hlf\"; allowed is one of short_full", "did you mean short_half?"});
    check_refused({command, scene, "--law", "SHORT_HALF"}, {"--law is \"SHORT_HALF\""});
  }
  check_refused(force({{"--law", "pinkus"}}), {"--law is \"pinkus\"; allowed is one of"}, {.input = good_states});
  check_refused({"simulate", scene, "--integrator", "dopri"}, {"--integrator is \"dopri\"", "did you mean dopri5?"});
}

TEST_CASE("Options: force refuses bearings that can't be") {
  for (const char* option : {"--viscosity", "--length", "--radius", "--clearance"}) {
    for (const char* value : {"nan", "inf", "-inf", "-1", "0", "-0.0", "1e400"}) {
      check_refused(force({{option, value}}), {option, " is ", "; allowed is a finite number above 0"},
                    {.input = good_states});
    }
    for (const char* value : {"abc", "0,4", "1 m", "--law"}) {
      check_refused(force({{option, value}}), {option}, {.input = good_states});
    }
  }
  for (const char* clearance : {"0.0098", "0.01", "1"}) {
    check_refused(force({{"--clearance", clearance}}), {"--clearance is", "allowed is less than --radius"},
                  {.input = good_states});
  }
}

TEST_CASE("Options: force refuses states that no film has, with file, line, column and what is allowed") {
  const std::string header = "eccentricity_ratio,slip_rate,squeeze_rate\n0.1,1,1\n";
  for (const char* ratio : {"1", "1.0", "1.5", "-0.1", "-1e-300", "1e300"}) {
    check_states_refused(header + ratio + ",1,1\n", {"standard input:3: ", "eccentricity_ratio", "[0, 1)"});
  }
  const Words no_numbers{"nan", "inf",   "-inf", "NaN", "abc", "",    "1e400", "1e-400", "1.5.5",
                         "0x1", "1e-3x", "+-1",  "++1", "1_0", "1;5", "true",  "--1"};
  for (const std::string& value : no_numbers) {
    check_states_refused(header + value + ",1,1\n", {":3: eccentricity_ratio is \"" + value, "allowed is a finite"});
    check_states_refused(header + "0.5," + value + ",1\n", {":3: slip_rate is \"" + value});
    check_states_refused(header + "0.5,1," + value + "\n", {":3: squeeze_rate is \"" + value});
  }
  check_states_refused(header + "0.9999999,1e308,1\n", {":3: ", "beyond the range of double precision"});
}

TEST_CASE("Options: force refuses tables that are none, with the line") {
  const std::string header = "eccentricity_ratio,slip_rate,squeeze_rate\n";
  check_states_refused("", {"standard input: empty; required is a header row"});
  check_states_refused("\n\n\n", {"required is a header row"});
  check_states_refused("\xEF\xBB\xBF", {"required is a header row"});
  check_states_refused("0.5,1,0.2\n", {"standard input:1: column \"eccentricity_ratio\" is missing", "0.5, 1, 0.2"});
  check_states_refused("eccentricity_ratio,slip_rate\n0.5,1\n", {":1: column \"squeeze_rate\" is missing"});
  check_states_refused("eccentricity_ratio,slip_rate,squeeze_rate,slip_rate\n0.5,1,1,1\n", {"there more than once"});
  check_states_refused("Eccentricity_Ratio,slip_rate,squeeze_rate\n0.5,1,1\n", {"is missing"});
  check_states_refused(header + "0.5,1\n", {"standard input:2: 2 fields; allowed are 3"});
  check_states_refused(header + "0.5,1,1,1\n", {":2: 4 fields; allowed are 3"});
  check_states_refused(header + "0,5,1,5,0,2\n", {":2: 6 fields", "points in decimals"});
  check_states_refused("eccentricity_ratio;slip_rate;squeeze_rate\n0,5;1,5;0,2\n", {"allowed"});
  check_states_refused(header + "0.5,1,1\n\n0.5,1,1\n", {":3: empty line; allowed is a row"});
  check_states_refused(std::string("\x7f"
                                   "ELF\0\0\x01\xff\n",
                                   9),
                       {"is missing"});
}

TEST_CASE("Options: force accepts byte-order marks, carriage returns, blanks, plus signs and other columns") {
  const std::string plain = lubjoint_program(force(), {.input = good_states}).out;
  const std::string forces = plain.substr(plain.rfind("0.2,"));
  for (const std::string& same :
       Words{"\xEF\xBB\xBF" + good_states, "eccentricity_ratio,slip_rate,squeeze_rate\r\n0.5,1,0.2\r\n",
             "eccentricity_ratio,slip_rate,squeeze_rate\n0.5,1,0.2",
             "eccentricity_ratio,slip_rate,squeeze_rate\n0.5,1,0.2\n\n\r\n",
             " eccentricity_ratio ,\tslip_rate,squeeze_rate\n 5e-1 , +1.0 ,0.2\n",
             "id,eccentricity_ratio,slip_rate,squeeze_rate\nx y,.5,1,0.2\n"}) {
    const ProgramResult result = lubjoint_program(force(), {.input = same});
    INFO(same << result.err);
    CHECK(result.status == 0);
    CHECK_THAT(result.out, Catch::Matchers::EndsWith(forces));
    CHECK(result.out.find('\r') == std::string::npos);
  }
}

TEST_CASE("Options: files that can't be read are refused by name") {
  const TemporaryFolder folder;
  for (const char* command : {"simulate", "equilibrium"}) {
    check_refused({command, folder / "absent.toml"}, {"absent.toml: can't be read"});
    check_refused({command, folder.path().string()}, {"is a folder"});
    check_refused({command, folder.write("cut.toml", "name = \"cu")}, {"cut.toml:1: not valid TOML"});
    check_refused({command, folder.write("mass.toml", journal_text().with("bodies[0].mass", "nan"))},
                  {"mass.toml:11: bodies[0].mass is nan; allowed is a finite number, 0 or more [kg]"});
    check_refused({command, folder.write("e.toml", journal_text().with("bodies[0].position", "[1.0, 0.0]"))},
                  {"eccentricity ratio 5000"});
    const std::string text = read_text(scene);
    check_refused({command, folder.write("cut2.toml", text.substr(0, text.find("[[joints]]")))},
                  {"cut2.toml:", "joints"});
  }
  check_refused(force({{"--states", folder / "absent.csv"}}), {"absent.csv\" can't be read"});
  check_refused(force({{"--states", folder.path().string()}}), {"can't be read"});
  check_refused({"reproduce", "--scenes", folder / "absent", "--out", folder / "out"}, {"absent/journal.toml"});
  const std::string nowhere = folder / "nowhere";
  check_refused({"reproduce", "--data", nowhere, "--out", folder / "out"},
                {nowhere, "neither bench-scenes.csv nor stress.csv"});
  folder.write("stress.csv", "case,law\n");
  check_refused({"reproduce", "--data", folder.path().string(), "--out", folder / "out"}, {"stress.csv:1", "seconds"});
  CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_CASE("Options: a place that can't be written is refused before anything is computed or left there") {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "as it was");
  for (const std::string& place : Words{file, file + "/below", "/proc/lubjoint", "/proc/self/lubjoint", ""}) {
    check_refused({"simulate", scene, "--out=" + place}, {place.empty() ? "--out" : place});
    check_refused({"reproduce", "--out=" + place}, {place.empty() ? "--out" : place});
  }
  for (const std::string& place : Words{file + "/below.csv", "/proc/lubjoint.csv", folder.path().string()}) {
    check_refused({"accuracy", "--out", place}, {"allowed is"});
  }
  CHECK(read_text(file) == "as it was");
  CHECK(folder.entries() == std::set<std::string>{"file"});
}

TEST_CASE("Options: a run that is refused leaves no folder and no file") {
  const TemporaryFolder folder;
  const std::string out = "--out=" + (folder / "out");
  check_refused({"simulate", folder / "absent.toml", out}, {});
  check_refused({"simulate", scene, "--law", "none", out}, {});
  check_refused({"simulate", scene, "--rtol", "0", out}, {});
  const std::string outside = journal_text().with("joints[0].journal.point", "[1e-3, 0.0]");
  check_refused({"simulate", folder.write("s.toml", outside), out}, {"journal", "eccentricity ratio", "allowed is"});
  CHECK(folder.entries() == std::set<std::string>{"s.toml"});
}

TEST_CASE("Options: accuracy refuses counts and seeds that are none") {
  for (const char* option : {"--directions", "--seed"}) {
    for (const char* value : {"-1", "abc", "1.5", "nan", "99999999999999999999999999"}) {
      check_refused({"accuracy", std::string(option) + "=" + value}, {option});
    }
  }
  check_refused({"accuracy", "--directions", "1000001"}, {"--directions"});
}

TEST_CASE("Options: one that would have no effect is refused") {
  const std::string scenes = LUBJOINT_SOURCE_DIR "/data/scenes/";
  const TemporaryFolder folder;
  const auto oracle = [](const Words& film) {
    Words words = force({{"--law", ""}});
    words.insert(words.begin(), "oracle");
    words.insert(words.end(), film.begin(), film.end());
    return words;
  };
  check_refused({"simulate", scenes + "slider-crank-ideal.toml", "--law", "short_half"},
                {"--law has no effect", "no joint with a film"});
  check_refused({"cost", scenes + "slider-crank-ideal.toml", "--law", "short_half"}, {"--law has no effect"});
  check_refused(oracle({"--film=finite_half", "--rule=gauss_legendre"}), {"--rule has no effect on finite_half"});
  check_refused(oracle({"--film=short_half", "--onset=free"}), {"--onset has no effect on short_half"});
  check_refused({"model-error", scene, "--clearance", "1e-4"}, {"not both", "allowed"});
  check_refused({"model-error", "--length=0.02", "--radius=0.01", "--clearance=-1"}, {"--clearance is -1"});
  check_refused({"accuracy", "--directions", "0", "--seed", "2"}, {"--seed has no effect"});
  check_refused({"stress", "--references", folder / "r", "--out", folder / "o"}, {"have no effect with --references"});
  check_refused({"stress", "--references", folder / "r", "--integrator", "dopri5"}, {"have no effect"});
  check_refused({"sweep", scene, "--vary", "bodies[0].mass=1,2", "--out", folder / "o", "--merge", "--jobs", "2"},
                {"--jobs has no effect with --merge"});
  CHECK(folder.entries().empty());
}

TEST_CASE("Options: a standard output that takes nothing is an error, not a success") {
  for (const Words& command : {Words{"simulate", scene, "--json"}, Words{"equilibrium", scene}, force()}) {
    const ProgramResult result = lubjoint_program(command, {.input = good_states, .output = "/dev/full"});
    CHECK(result.status == 2);
    CHECK_THAT(result.err, Contains("lubjoint: standard output"));
  }
}

}  // namespace options_test

// What the commands answer, run as a user runs them.
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "lubjoint/film/law_list.hpp"
#include "oracle/cli/programs.hpp"
#include "support/csv.hpp"
#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace commands_test {

using namespace lubjoint::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;
namespace cli = lubjoint::cli;

namespace {

const std::string scene = journal_scene_file;
constexpr double load = 31.2753;  // 30 N and the weight of 0.13 kg

Words keys(const Json& object) {
  Words names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

Json json_of(const Words& arguments, int status = 0) {
  const ProgramResult result = lubjoint_program(arguments);
  INFO(result.err);
  REQUIRE(result.status == status);
  return Json::parse(result.out);
}

/// Processor time of the programs that have ended [s].
double children_seconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

const Words simulate_json{"simulate", scene, "--law", "pinkus_sternlicht", "--rtol", "1e-10", "--json"};

}  // namespace

TEST_CASE("simulate: the journal's film carries the load after 1 s, in less than 0.1 s of process time") {
  const double before = children_seconds();
  const Json summary = json_of(simulate_json);
#ifdef NDEBUG
  constexpr double limit = 0.1;
#else
  constexpr double limit = 1;  // sanitizers take 3 times as long, counting lines of code 6 times
#endif
  CHECK(children_seconds() - before < limit);
  CHECK(summary["status"] == "finished");
  CHECK(summary["message"] == "");
  CHECK(summary["t_end"] == 1.0);
  const Json& final_state = summary["joints"][0]["final"];
  CHECK(std::abs(final_state["fy"].get<double>() - load) < 1e-5);  // still decaying: 5e-6 N at 1 s
  CHECK(std::abs(final_state["fx"].get<double>()) < 1e-5);         // the same decay
  CHECK(std::abs(summary["joints"][0]["max_eccentricity_ratio"].get<double>() - 0.258) < 5e-4);  // printed digits
}

TEST_CASE("simulate: the keys of the JSON summary are the documented ones, in their order") {
  const Json summary = json_of(simulate_json);
  const Words all = keys(summary);
  const Words documented{"scene",           "law",    "integrator", "status", "message",        "t_end", "steps",
                         "rhs_evaluations", "wall_s", "joints",     "driver", "energy_residual"};
  Words found;
  for (const std::string& key : all) {
    if (std::find(documented.begin(), documented.end(), key) != documented.end()) found.push_back(key);
  }
  CHECK(found == documented);
  REQUIRE(summary["joints"].size() == 1);
  const Json& joint = summary["joints"][0];
  for (const char* key : {"name", "final", "max_eccentricity_ratio", "max_force", "min_film_thickness"}) {
    CHECK(joint.contains(key));
  }
  CHECK(keys(joint["final"]) == Words{"ex_over_c", "ey_over_c", "eccentricity_ratio", "fx", "fy"});
  CHECK(joint["name"] == "bearing");
  CHECK(summary["driver"].is_null());
  CHECK(summary["energy_residual"].is_null());
  CHECK(summary["steps"].is_number_unsigned());
  CHECK(summary["rhs_evaluations"].is_number_unsigned());
  CHECK(summary["wall_s"].get<double>() > 0);
}

TEST_CASE("simulate: the same run gives the same bits, whatever the locale and the order of the options") {
  const auto bits = [](const Words& arguments, const ProgramSetting& setting = {}) {
    Json summary = Json::parse(lubjoint_program(arguments, setting).out);
    summary.erase("wall_s");
    return summary.dump();
  };
  const std::string reference = bits(simulate_json);
  CHECK(bits(simulate_json) == reference);
  CHECK(bits({"simulate", "--json", "--rtol=1e-10", "--law", "pinkus_sternlicht", scene}) == reference);
  for (const char* locale : {"de_DE.UTF-8", "C", "C.UTF-8", "no_such_locale"}) {
    CHECK(bits(simulate_json, {.environment = {{"LC_ALL", locale}, {"LANG", locale}}}) == reference);
  }
}

TEST_CASE("simulate: the trajectory has the documented columns, a row each interval, and ends as the summary says") {
  const TemporaryFolder folder;
  const Json summary = json_of({"simulate", scene, "--out", folder / "a/b", "--json"});
  const std::string file = folder / "a/b/journal.csv";
  CHECK(folder.entries() == std::set<std::string>{"a", "a/b", "a/b/journal.csv"});
  CHECK(first_line(read_text(file)) ==
        "t,journal.x,journal.y,journal.phi,journal.vx,journal.vy,journal.omega,bearing.ex,bearing.ey,"
        "bearing.eccentricity_ratio,bearing.attitude,bearing.fx,bearing.fy,bearing.film_thickness");
  const std::vector<CsvRow> rows = read_csv(file);
  REQUIRE(rows.size() == 1001);
  CHECK(number(rows.front().at("t")) == 0);
  CHECK(number(rows.back().at("t")) == 1);
  constexpr double c = 2e-4;
  constexpr double spin = 52.35987755982989;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto at = [&](const char* name) { return number(rows[i].at(name)); };
    const double t = at("t");
    const double ratio = at("bearing.eccentricity_ratio");
    const bool fits = std::abs(t - 1e-3 * static_cast<double>(i)) < 1e-15 &&  // rounding
                      std::abs(at("journal.phi") - spin * t) < 1e-13 &&       // rounding of 52
                      at("journal.omega") == spin && at("journal.x") == at("bearing.ex") &&
                      std::abs(std::hypot(at("bearing.ex"), at("bearing.ey")) - c * ratio) < 1e-18 &&  // rounding of c
                      std::abs(at("bearing.film_thickness") - c * (1 - ratio)) < 1e-18;                // rounding of c
    INFO("row " << i);
    CHECK(fits);
  }
  const Json& final_state = summary["joints"][0]["final"];
  CHECK(number(rows.back().at("bearing.fx")) == final_state["fx"].get<double>());
  CHECK(number(rows.back().at("bearing.fy")) == final_state["fy"].get<double>());
  CHECK(number(rows.back().at("bearing.eccentricity_ratio")) == final_state["eccentricity_ratio"].get<double>());
}

TEST_CASE("simulate: a run that can't go on exits 1, names time, joint and eccentricity, and keeps what it has") {
  const TemporaryFolder folder;
  const std::string limited =
      folder.write("limited.toml", journal_text().replaced(journal_text().field("integrator.name"), "max_steps = 60"));
  const Json summary = json_of({"simulate", limited, "--json", "--out", folder / "out"}, 1);
  CHECK(summary["status"] == "stopped");
  const double t_end = summary["t_end"];
  CHECK((t_end > 1e-3 && t_end < 1));
  const std::string message = summary["message"];
  CHECK_THAT(message, StartsWith("stopped at t = ") && Contains("joint \"bearing\"") &&
                          Contains("eccentricity ratio 0.") && Contains("60 steps"));
  const std::vector<CsvRow> rows = read_csv(folder / "out/journal.csv");
  CHECK(rows.size() > 1);
  CHECK(number(rows.back().at("t")) == t_end);

  const std::string thin = folder.write("thin.toml", journal_text().with("joints[0].viscosity", "1e-300"));
  const Json fallen = json_of({"simulate", thin, "--json"}, 1);
  CHECK(fallen["status"] == "stopped");
  CHECK(fallen["joints"][0]["final"]["eccentricity_ratio"].get<double>() <= 1);
  CHECK(fallen["joints"][0]["min_film_thickness"].get<double>() >= 0);
  CHECK(lubjoint_program({"simulate", thin}).status == 1);
}

TEST_CASE("simulate: every law and integrator runs, and the integrators agree") {
  for (const std::string_view law : lubjoint::film_law_names) {
    const auto run = [&](const std::string& integrator) {
      return json_of({"simulate", scene, "--law", std::string(law), "--integrator", integrator, "--rtol", "1e-10",
                      "--duration", "0.02", "--json"});
    };
    const Json stiff = run("radau_iia5");
    CHECK(stiff["law"] == law);
    for (const char* integrator : {"dopri5", "fehlberg78"}) {
      const Json other = run(integrator);
      INFO(law << " " << integrator);
      CHECK(other["integrator"] == integrator);
      for (const char* key : {"ex_over_c", "ey_over_c"}) {
        const double difference =
            stiff["joints"][0]["final"][key].get<double>() - other["joints"][0]["final"][key].get<double>();
        CHECK(std::abs(difference) < 1e-7);  // tolerance 1e-10 a step, up to some thousand steps, and events
      }
    }
  }
}

TEST_CASE("simulate: auto says what it picked and why, and picks by what dies out, not by what oscillates") {
  // Films are stiff; neither a mechanism without one is, nor a journal that bounces on its wall (27 contacts). There,
  // in kinks, the pair of order 8 is of no use.
  struct Case {
    std::string name, rtol, picked, reason;
  };
  const std::string follows = "stiff: what dies out asks an explicit method for";
  for (const auto& [name, rtol, picked, begins] :
       {Case{"journal", "1e-8", "radau_iia5", follows}, Case{"slider-crank", "1e-8", "radau_iia5", follows},
        Case{"slider-crank", "1e-7", "radau_iia5", "stiff: stability asks an explicit method for"},
        Case{"slider-crank", "1e-9", "radau_iia5", follows}, Case{"slider-crank", "1e-10", "radau_iia9", follows},
        Case{"slider-crank-ideal", "1e-8", "fehlberg78", "not " + follows},
        Case{"impact", "1e-8", "dopri5", "not " + follows}}) {
    INFO(name << " at " << rtol);
    const std::string file = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/" + name + ".toml";
    const Json summary = json_of({"simulate", file, "--integrator", "auto", "--rtol", rtol, "--json"});
    CHECK(summary["integrator"] == picked);
    const std::string reason = summary["integrator_reason"];
    CHECK_THAT(reason, StartsWith(begins) && Contains("steps, accuracy for about"));
    CHECK((reason.find("order 9 for about") != std::string::npos) == (picked == "radau_iia9"));
    CHECK_THAT(lubjoint_program({"simulate", file, "--integrator", "auto", "--rtol", rtol}).out,
               Contains(picked + ", by auto: " + reason));
    CHECK(json_of({"simulate", file, "--json"})["integrator_reason"] == "");
  }
}

TEST_CASE("simulate: relative paths are those of the folder it runs in, and the summary alone is on standard output") {
  const TemporaryFolder folder;
  folder.write("s.toml", read_text(scene));
  const ProgramResult result =
      lubjoint_program({"simulate", "s.toml", "--out", "."}, {.folder = folder.path().string()});
  CHECK(result.status == 0);
  CHECK(folder.entries() == std::set<std::string>{"journal.csv", "s.toml"});
  CHECK_THAT(result.out, StartsWith("scene        journal\n"));
  CHECK_THAT(result.err, Contains("journal.csv"));
  CHECK(result.err.find('\r') == std::string::npos);  // no progress bar where there is no terminal
  const ProgramResult again =
      lubjoint_program({"simulate", "s.toml", "--out", "."}, {.folder = folder.path().string()});
  CHECK(again.status == 0);  // a second run replaces the first one's file
}

TEST_CASE("simulate: short_half comes to its equilibrium within 3 s") {
  const Json rest = json_of({"equilibrium", scene, "--law", "short_half", "--json"});
  const Json run = json_of({"simulate", scene, "--law", "short_half", "--rtol", "1e-10", "--duration", "3", "--json"});
  for (const char* key : {"ex_over_c", "ey_over_c", "eccentricity_ratio"}) {
    const double difference = rest[key].get<double>() - run["joints"][0]["final"][key].get<double>();
    CHECK(std::abs(difference) < 1e-7);  // e^(-5.9 · 3) of the start, 2e-9, and the integration's tolerance
  }
}

TEST_CASE("equilibrium: short_half rests at 0.1174, its film carries the load, and its eigenvalues come in pairs") {
  const Json rest = json_of({"equilibrium", scene, "--law", "short_half", "--json"});
  CHECK(std::abs(rest["eccentricity_ratio"].get<double>() - 0.1174) < 5e-5);  // printed digits
  CHECK(std::abs(rest["fx"].get<double>()) < 1e-12 * load);                   // rounding of e
  CHECK(std::abs(rest["fy"].get<double>() - load) < 1e-12 * load);            // rounding of e
  CHECK(rest["law"] == "short_half");
  CHECK(rest["stability"] == "decays");
  REQUIRE(rest["eigenvalues"].size() == 4);
  for (const Json& value : rest["eigenvalues"]) CHECK(value["re"].get<double>() < 0);
  CHECK(rest["eigenvalues"][0]["im"].get<double>() == -rest["eigenvalues"][1]["im"].get<double>());
  for (const char* matrix : {"stiffness", "damping"}) {
    REQUIRE(rest[matrix].size() == 2);
    CHECK(rest[matrix][0].size() == 2);
  }
  const ProgramResult text = lubjoint_program({"equilibrium", scene, "--law", "short_half"});
  CHECK(text.status == 0);
  CHECK_THAT(text.out, Contains("0.1174337638") && Contains("decays"));
}

TEST_CASE("Program: help and version are answers, of every command") {
  std::vector<Words> questions = {{"--help"}, {"--version"}, {"equilibrium", "-h"}};
  const std::filesystem::path beside = std::filesystem::path(LUBJOINT_PROGRAM).parent_path();
  for (const cli::ProgramCommand& each : cli::program_commands) {
    // Proofs and enclosures are built where their libraries are.
    if (std::filesystem::exists(beside / each.program)) questions.push_back({std::string(each.command), "--help"});
  }
  CHECK(questions.size() >= cli::program_commands.size() + 3 - 2);
  for (const Words& arguments : questions) {
    INFO(arguments.front());
    const ProgramResult result = lubjoint_program(arguments);
    CHECK(result.status == 0);
    CHECK_FALSE(result.out.empty());
    CHECK(result.err.empty());
  }
  const ProgramResult all = lubjoint_program({"--help"});
  for (const cli::ProgramCommand& each : cli::program_commands)
    CHECK_THAT(all.out, Contains("  " + std::string(each.command) + " "));
}

TEST_CASE("simulate: pictures beside the trajectory, of a journal and of a mechanism") {
  const TemporaryFolder folder;
  const std::string data = std::string(LUBJOINT_SOURCE_DIR) + "/data/";
  for (const auto& [file, name] :
       {std::pair{scene, std::string("journal")}, std::pair{data + "examples/four-bar.toml", std::string("four-bar")},
        std::pair{data + "scenes/impact.toml", std::string("impact")}}) {
    const ProgramResult result =
        lubjoint_program({"simulate", file, "--rtol", "1e-5", "--out", folder / name, "--plot"});
    INFO(result.err);
    CHECK(result.status == 0);
    for (const char* what : {"-orbit", "-force", "-film"}) {
      CHECK_THAT(result.err, Contains(" " + name + what + ".svg"));
      const std::string svg = read_text(folder / (name + "/" + name + what + ".svg"));
      CHECK_THAT(svg, Contains("<svg") && Contains("[") && Contains("<path"));
      CHECK(std::filesystem::file_size(folder / (name + "/" + name + what + ".png")) > 5000);
    }
  }
  for (const std::string& entry : folder.entries()) CHECK(entry.find(".unfinished-") == std::string::npos);
  const ProgramResult nowhere = lubjoint_program({"simulate", scene, "--plot"});
  CHECK(nowhere.status == 2);
  CHECK_THAT(nowhere.err, Contains("--plot") && Contains("--out"));
  const ProgramResult nothing =
      lubjoint_program({"simulate", data + "scenes/slider-crank-ideal.toml", "--out", folder / "ideal", "--plot"});
  CHECK(nothing.status == 2);
  CHECK_THAT(nothing.err, Contains("--plot draws joints"));
  CHECK_FALSE(std::filesystem::exists(folder / "ideal"));
}

TEST_CASE("simulate: every scene that ships runs to its end") {
  const std::filesystem::path folder = std::filesystem::path(LUBJOINT_SOURCE_DIR) / "data" / "scenes";
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;  // folders, and tables that scenes name
    INFO(entry.path().string());
    const ProgramResult result = lubjoint_program({"simulate", entry.path().string(), "--json"});
    CHECK(result.status == 0);
    CHECK_THAT(result.out, Catch::Contains("\"status\": \"finished\""));
    ++scenes;
  }
  // As many as the README and the command line promise, the published problems, machines, and scenes in space.
  CHECK(scenes == 10 + 4 + 3 + 7);
}

}  // namespace commands_test

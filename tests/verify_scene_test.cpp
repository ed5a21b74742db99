// Trajectories of the scenes that ship, as a user has them judged.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "oracle/verify/trajectory/trajectory.hpp"
#include "support/run_program.hpp"

namespace verify_scene_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

namespace fs = std::filesystem;

fs::path shipped(const std::string& scene) { return fs::path(LUBJOINT_SOURCE_DIR) / "data/scenes" / (scene + ".toml"); }

/// A scene file's text with a piece replaced, everywhere.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  REQUIRE(text.find(from) != std::string::npos);
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// What `simulate` writes of a scene.
std::string simulated_csv(const fs::path& scene, const std::string& name) {
  const TemporaryFolder folder;
  const ProgramResult run = lubjoint_program({"simulate", scene.string(), "--out", folder.path().string()});
  REQUIRE(run.status == 0);
  return read_text(folder.path() / (name + ".csv"));
}

std::string simulated_csv(const std::string& name) { return simulated_csv(shipped(name), name); }

/// The trajectory of a shipped scene whose file is changed.
std::string changed_scene_csv(const std::string& name, const std::string& from, const std::string& to) {
  const TemporaryFolder folder;
  return simulated_csv(folder.write("scene.toml", replaced(read_text(shipped(name)), from, to)), name);
}

ProgramResult verified(const std::string& name, const std::string& csv, std::vector<std::string> options = {}) {
  std::vector<std::string> arguments = {"verify", "--scene", shipped(name).string(), "--trajectory", "-"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return lubjoint_program(arguments, {.input = csv, .seconds = 300});
}

using Row = std::map<std::string, double>;

/// The CSV with every row changed, and every `stride`-th kept.
std::string changed(const std::string& csv, const std::function<void(Row&)>& change, std::size_t stride = 1) {
  const verify::Trajectory all = verify::read_trajectory(csv, "csv");
  std::string text;
  for (std::size_t i = 0; i < all.t.size(); i += stride) {
    Row row{{"t", all.t[i]}};
    for (const auto& [name, column] : all.columns) row[name] = column[i];
    change(row);
    std::string names, numbers;
    for (const auto& [name, number] : row) {
      names += (names.empty() ? "" : ",") + name;
      numbers += fmt::format("{}{}", numbers.empty() ? "" : ",", number);
    }
    if (text.empty()) text = names + '\n';
    text += numbers + '\n';
  }
  return text;
}

void check_disagrees(const ProgramResult& result, const std::string& words) {
  INFO(result.out << result.err);
  CHECK(result.status == 1);
  CHECK_THAT(result.out, Contains("disagrees") && Contains(words));
}

}  // namespace

TEST_CASE("verify: what simulate writes of a shipped scene is right, for each of them") {
  std::size_t scenes = 0;
  for (const auto& entry : fs::directory_iterator(shipped("journal").parent_path())) {
    if (!entry.is_regular_file()) continue;  // the published problems have a folder, and numbers of their own
    const std::string name = entry.path().stem().string();
    const ProgramResult result = verified(name, simulated_csv(name));
    INFO(name << "\n" << result.out << result.err);
    CHECK(result.status == 0);
    CHECK_THAT(result.out, Contains("agrees: scene " + name));
    ++scenes;
  }
  CHECK(scenes == 10);
}

TEST_CASE("verify: a trajectory at an integrator's usual accuracy is right, also in the scene most sensitive to it") {
  const fs::path scene = shipped("slider-crank-c0.5-mu0.04");
  const TemporaryFolder folder;
  for (const char* integrator : {"radau_iia5", "dopri5"}) {
    REQUIRE(lubjoint_program({"simulate", scene.string(), "--rtol", "1e-6", "--integrator", integrator, "--out",
                              folder.path().string()})
                .status == 0);
    const ProgramResult result =
        verified("slider-crank-c0.5-mu0.04", read_text(folder.path() / "slider-crank-c0.5-mu0.04.csv"));
    INFO(integrator << "\n" << result.out);
    CHECK(result.status == 0);
  }
}

TEST_CASE("verify: a trajectory with a few columns on few times is judged by these, and the report says by which") {
  const std::string csv = changed(
      simulated_csv("slider-crank"),
      [](Row& row) {
        row = {{"t", row["t"]},
               {"gudgeon-pin.eccentricity_ratio", row["gudgeon-pin.eccentricity_ratio"]},
               {"gudgeon-pin.attitude", row["gudgeon-pin.attitude"]},
               {"rod.vy", row["rod.vy"]},
               {"temperature", 300}};
      },
      7);
  const ProgramResult result = verified("slider-crank", csv);
  INFO(result.out << result.err);
  CHECK(result.status == 0);
  CHECK_THAT(result.out, Contains("in all of 3 quantities") && Contains("gudgeon-pin: eccentricity ") &&
                             Contains("rod: velocity, vy alone") && Contains("Not compared: temperature") &&
                             Contains("gudgeon-pin: force on the journal"));
}

TEST_CASE("verify: a clearance that is one per cent off is named") {
  check_disagrees(
      verified("slider-crank", changed_scene_csv("slider-crank", "clearance = 0.0002", "clearance = 0.000202")),
      "the clearance of gudgeon-pin were 1.0100 times");
  check_disagrees(verified("journal", changed_scene_csv("journal", "clearance = 0.0002", "clearance = 0.000202")),
                  "the clearance of bearing were 1.0100 times");
}

TEST_CASE("verify: a moment that is one per cent off is named") {
  check_disagrees(
      verified("slider-crank-torque", changed_scene_csv("slider-crank-torque", "moment = 10.0", "moment = 10.1")),
      "the load on crank were 1.0100 times");
}

TEST_CASE("verify: a viscosity that is ten times as large is fitted, and so are two numbers at once") {
  check_disagrees(verified("journal", changed_scene_csv("journal", "viscosity = 0.4", "viscosity = 4.0")),
                  "the viscosity of bearing were 10.000 times");
  const TemporaryFolder folder;
  const std::string text = replaced(replaced(read_text(shipped("journal")), "viscosity = 0.4", "viscosity = 0.36"),
                                    "clearance = 0.0002", "clearance = 0.000204");
  check_disagrees(
      verified("journal", simulated_csv(folder.write("scene.toml", text), "journal")),
      "the clearance of bearing were 1.0200 times as large, and the viscosity of bearing were 0.90000 times");
}

TEST_CASE("verify: a trajectory that is late is told from one that is wrong") {
  for (const char* scene : {"slider-crank", "slider-crank-ideal", "impact"}) {
    check_disagrees(verified(scene, changed(simulated_csv(scene), [](Row& row) { row["t"] += 2e-4; })),
                    "the whole trajectory is 0.0002 s late");
  }
}

TEST_CASE("verify: forces on the bearing are told from forces on the journal") {
  for (const auto& [scene, joint] : {std::pair<std::string, std::string>{"slider-crank", "gudgeon-pin"},
                                     {"impact", "bearing"},
                                     {"journal", "bearing"}}) {
    const auto opposite = [joint = joint](Row& row) {
      row[joint + ".fx"] *= -1;
      row[joint + ".fy"] *= -1;
    };
    check_disagrees(verified(scene, changed(simulated_csv(scene), opposite)),
                    joint + ": force on the journal: the opposite sign: the force on the bearing");
  }
}

TEST_CASE("verify: two bodies whose columns are exchanged are named") {
  const auto exchanged = [](Row& row) {
    for (const char* column : {"x", "y", "phi", "vx", "vy", "omega"}) {
      std::swap(row[std::string("crank.") + column], row[std::string("rod.") + column]);
    }
  };
  check_disagrees(verified("slider-crank-ideal", changed(simulated_csv("slider-crank-ideal"), exchanged)),
                  "the columns of crank and rod are exchanged");
}

TEST_CASE("verify: bearing and journal exchanged are named, in the columns and in the scene") {
  const auto opposite = [](Row& row) {
    for (const char* column : {"ex", "ey", "fx", "fy"}) row[std::string("gudgeon-pin.") + column] *= -1;
  };
  check_disagrees(verified("slider-crank", changed(simulated_csv("slider-crank"), opposite)),
                  "bearing and journal of gudgeon-pin are exchanged");
  const std::string other =
      replaced(replaced(read_text(shipped("slider-crank")), "bearing = {body = \"rod\"", "BEARING = {body = \"rod\""),
               "journal = {body = \"slider\"", "bearing = {body = \"slider\"");
  const TemporaryFolder folder;
  const std::string scene = folder.write("scene.toml", replaced(other, "BEARING", "journal"));
  check_disagrees(verified("slider-crank", simulated_csv(scene, "slider-crank")),
                  "bearing and journal of gudgeon-pin were exchanged");
}

TEST_CASE("verify: the law that a trajectory was made with is named") {
  check_disagrees(verified("journal", simulated_csv("journal"), {"--law", "short_half"}),
                  "the law of bearing were pinkus_sternlicht");
}

TEST_CASE("verify: a trajectory of a golden case is compared with a reference that the golden one confirms") {
  const ProgramResult result = verified("journal", simulated_csv("journal"));
  CHECK_THAT(result.out, Contains("golden trajectory journal-pinkus_sternlicht.csv"));
}

TEST_CASE("verify: --json of a trajectory has the verdict, each quantity with its error, and the likely mistakes") {
  const std::string right = simulated_csv("journal");
  const auto report_of = [](const ProgramResult& result) { return nlohmann::json::parse(result.out); };
  const ProgramResult good = verified("journal", right, {"--json"});
  CHECK(good.status == 0);
  const auto agreeing = report_of(good);
  CHECK(agreeing["verdict"] == "agrees");
  CHECK(agreeing["scene"] == "journal");
  CHECK(agreeing["law"] == "pinkus_sternlicht");
  CHECK(agreeing["mistakes"].empty());
  CHECK(agreeing["golden"]["worst"] < 1e-7);  // our own run at 1e-11; in a stiff film forces lose some digits more
  for (const auto& quantity : agreeing["quantities"]) {
    INFO(quantity.dump());
    CHECK(quantity["agrees"] == true);
    CHECK(quantity["explanation"].is_null());
    CHECK(quantity["times"] > 500);
    CHECK((quantity["worst_error"] >= 0 && quantity["worst_error"] <= quantity["worst_allowed"]));
    CHECK(quantity["rms_error"] <= quantity["worst_allowed"]);
  }
  const ProgramResult bad = verified("journal", changed(right, [](Row& row) { row["bearing.fy"] *= -1; }), {"--json"});
  CHECK(bad.status == 1);
  const auto disagreeing = report_of(bad);
  CHECK(disagreeing["verdict"] == "disagrees");
  CHECK_FALSE(disagreeing["mistakes"].empty());
  std::size_t wrong = 0;
  for (const auto& quantity : disagreeing["quantities"]) {
    if (quantity["agrees"] == true) continue;
    ++wrong;
    INFO(quantity.dump());
    CHECK(quantity["worst_error"] > quantity["worst_allowed"]);
    CHECK(quantity["columns"].dump().find("bearing.f") != std::string::npos);
  }
  CHECK(wrong == 1);
}

TEST_CASE("verify: trajectories that can't be judged end with status 2 and say why") {
  const auto refused = [](const ProgramResult& result, const std::string& words) {
    INFO(result.out << result.err);
    CHECK(result.status == 2);
    CHECK_THAT(result.err, Contains(words));
  };
  refused(verified("journal", "t,x\n0,0\n1,0\n2,0\n3,0\n4,0\n"), "bearing.ex");
  refused(verified("journal", ""), "empty");
  refused(verified("journal", "t,bearing.ex\n0,0\n0.1,nan\n"), "bearing.ex is \"nan\"");
  refused(verified("journal", "t;bearing.ex\n0;0\n"), "\"t\"");
  refused(verified("journal", changed(simulated_csv("journal"), [](Row& row) { row["t"] *= 0.3; })), "at least half");
  refused(verified("journal", "t,bearing.ex\n0,0\n", {"--tolerance", "0"}), "--tolerance");
  refused(lubjoint_program({"verify", "--scene", shipped("journal").string()}), "--trajectory");
}

}  // namespace verify_scene_test

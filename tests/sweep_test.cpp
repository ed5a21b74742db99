// Sweeps as a user runs them: whole, in shards, killed, resumed, and fed with what is not theirs.
#include <sys/file.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "oracle/files/files.hpp"
#include "oracle/files/quoted_csv.hpp"
#include "oracle/sweep/sweep_store.hpp"
#include "support/run_program.hpp"
#include "support/scene_text.hpp"

namespace sweep_test {

using namespace lubjoint::test;
using Catch::Matchers::Contains;
using lubjoint::reports::split_quoted;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

namespace {

const std::string journal = journal_scene_file;
const std::string slider_crank = LUBJOINT_SOURCE_DIR "/data/scenes/slider-crank.toml";
const Words small{
    "--vary", "joints[0].clearance=1e-4:3e-4:3", "--vary", "joints[0].film=short_half,long_dynamic", "--rtol", "1e-6"};

/// What a merge leaves.
const std::set<std::string> merged_files{"journal-sweep.csv", "journal-sweep.json"};

Words sweep(const std::string& scene, const Words& grid, const Words& more = {}) {
  Words words{"sweep", scene};
  words.insert(words.end(), grid.begin(), grid.end());
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string output_of(const Words& words, int status = 0) {
  const ProgramResult result = lubjoint_program(words);
  INFO(result.err);
  REQUIRE(result.status == status);
  return result.out;
}

std::string refusal(const Words& words) {
  const ProgramResult result = lubjoint_program(words);
  INFO(result.err << result.out);
  CHECK(result.status == 2);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Contains("allowed") || Contains("required") || Contains("need"));
  return result.err;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Rows of a sweep's CSV by column.
std::vector<std::map<std::string, std::string>> table_of(const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  const std::vector<std::string> header = split_quoted(lines.front());
  std::vector<std::map<std::string, std::string>> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> fields = split_quoted(lines[i]);
    REQUIRE(fields.size() == header.size());
    std::map<std::string, std::string> row;
    for (std::size_t k = 0; k < fields.size(); ++k) row[header[k]] = fields[k];
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

TEST_CASE("sweep: a row has what simulate says of a file with the point's values, bit for bit") {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& scene, const std::string& text, const Words& keys,
                         const std::map<std::string, std::string>& row) {
    INFO(text);
    const ProgramResult result = lubjoint_program({"simulate", folder.write("point.toml", text), "--json"});
    REQUIRE(result.status == 0);
    const Json summary = Json::parse(result.out);
    const Json& joint = summary["joints"][0];
    const std::string name = joint["name"];
    const auto same = [&](const std::string& column, const Json& value) {
      INFO(scene << ' ' << column);
      const std::string wanted = value.is_null()           ? std::string()
                                 : value.is_number_float() ? lubjoint::reports::number(value.get<double>())
                                                           : value.dump();
      CHECK(row.at(column) == wanted);
    };
    for (const char* key : {"max_eccentricity_ratio", "max_force", "min_film_thickness"}) {
      same(name + "." + key, joint[key]);
    }
    for (const char* key : {"ex_over_c", "ey_over_c", "fx", "fy"}) same(name + "." + key, joint["final"][key]);
    for (const char* key : {"t_end", "energy_residual", "steps", "rejected_steps", "rhs_evaluations"}) {
      same(key, summary[key]);
    }
    if (!summary["driver"].is_null()) {
      for (const char* key : {"max_moment", "min_moment"}) same("motor." + std::string(key), summary["driver"][key]);
    }
    CHECK(row.at("status") == "finished");
    CHECK(row.at("message").empty());
    for (const std::string& key : keys) CHECK_FALSE(row.at(key).empty());
  };
  const std::string journal_rows =
      output_of(sweep(journal, {"--vary", "joints[0].clearance=1e-4,2e-4", "--vary", "bodies[0].mass=0.13,0.5"}));
  const auto journals = table_of(journal_rows);
  REQUIRE(journals.size() == 4);
  CHECK(journals[1].at("bodies[0].mass") == "0.13");
  CHECK(journals[1].at("joints[0].clearance") == "0.0002");
  check("journal", journal_text().with("bodies[0].mass", "0.13"), {"bodies[0].mass"}, journals[1]);

  const SceneText crank(read_text(slider_crank));
  const auto cranks =
      table_of(output_of(sweep(slider_crank, {"--vary", "joints.gudgeon-pin.clearance=2e-4,5e-4", "--jobs", "2"})));
  REQUIRE(cranks.size() == 2);
  check("slider-crank", crank.with("joints[0].clearance", "5e-4"), {"joints[0].clearance"}, cranks[1]);
}

TEST_CASE("sweep: the CSV is sorted by index, and the same bytes for any number of threads and order of options") {
  const std::string one = output_of(sweep(journal, small, {"--jobs", "1"}));
  const auto rows = table_of(one);
  REQUIRE(rows.size() == 6);
  for (std::size_t i = 0; i < rows.size(); ++i) CHECK(rows[i].at("index") == std::to_string(i));
  CHECK(rows[1].at("joints[0].film") == "long_dynamic");
  CHECK(rows[2].at("joints[0].clearance") == "0.0002");
  CHECK(output_of(sweep(journal, small, {"--jobs", "4"})) == one);
  CHECK(output_of(sweep(journal, small)) == one);
  CHECK(output_of({"sweep", "--rtol=1e-6", small[2], small[3], small[0], small[1], journal}) == one);
  const ProgramResult german = lubjoint_program(sweep(journal, small), {.environment = {{"LC_ALL", "de_DE.UTF-8"}}});
  CHECK(german.out == one);
}

TEST_CASE("sweep: a folder gets the same CSV and nothing else; JSON has the same rows") {
  const TemporaryFolder folder;
  const std::string plain = output_of(sweep(journal, small));
  const Json summary = Json::parse(output_of(sweep(journal, small, {"--out", folder / "a/b", "--json"})));
  CHECK(folder.entries() == std::set<std::string>{"a", "a/b", "a/b/journal-sweep.csv", "a/b/journal-sweep.json"});
  CHECK(read_text(folder / "a/b/journal-sweep.csv") == plain);
  CHECK(summary["csv"] == folder / "a/b/journal-sweep.csv");
  CHECK(summary["points"] == 6);
  CHECK(summary["run_now"] == 6);
  CHECK(summary["finished"] == 6);
  CHECK(summary["stopped"] == 0);
  CHECK(summary["keys"] == Json{{"joints[0].clearance", 3}, {"joints[0].film", 2}});
  CHECK(summary["wall_s"].get<double>() > 0);
  REQUIRE(summary["rows"].size() == 6);
  const auto rows = table_of(plain);
  CHECK(lubjoint::reports::number(summary["rows"][4]["bearing.fy"].get<double>()) == rows[4].at("bearing.fy"));
  CHECK(summary["rows"][4]["joints[0].film"] == rows[4].at("joints[0].film"));
  CHECK(summary["rows"][4]["energy_residual"].is_null());
  CHECK(summary["rows"][4]["message"] == "");
}

TEST_CASE("sweep: shards leave parts, and the last of them the same CSV as one run") {
  const TemporaryFolder folder;
  const std::string whole = output_of(sweep(journal, small));
  const std::string csv = folder / "journal-sweep.csv";
  for (const std::string shard : {"2/3", "3/3"}) {
    CHECK_THAT(output_of(sweep(journal, small, {"--out", folder.path().string(), "--shard", shard})),
               Contains("2 of 6: 2 finished, 0 stopped; 2 ran now") && Contains("not yet"));
    CHECK_FALSE(std::filesystem::exists(csv));
  }
  CHECK_THAT(refusal(sweep(journal, small, {"--out", folder.path().string(), "--merge"})), Contains("4 of 6 points"));
  CHECK(folder.entries() == std::set<std::string>{"journal-sweep.2-of-3.part", "journal-sweep.3-of-3.part"});
  // The same shard again has nothing left to do; the rest may be cut into shards differently.
  CHECK_THAT(output_of(sweep(journal, small, {"--out", folder.path().string(), "--shard", "2/3"})),
             Contains("0 ran now"));
  CHECK_THAT(output_of(sweep(journal, small, {"--out", folder.path().string(), "--shard", "1/2"})),
             Contains("ran now"));
  CHECK_THAT(output_of(sweep(journal, small, {"--out", folder.path().string(), "--shard", "1/3"})), Contains(csv));
  CHECK(read_text(csv) == whole);
  CHECK(folder.entries() == merged_files);
}

TEST_CASE("sweep: --merge merges what shards have left, if that is all") {
  const TemporaryFolder folder;
  const std::string whole = output_of(sweep(journal, small));
  output_of(sweep(journal, small, {"--out", folder.path().string(), "--shard", "1/2"}));
  const std::string part = read_text(folder / "journal-sweep.1-of-2.part");
  output_of(sweep(journal, small, {"--out", folder.path().string(), "--shard", "2/2"}));
  CHECK(folder.entries() == merged_files);
  // Parts that were gathered from elsewhere.
  const TemporaryFolder gathered;
  gathered.write("journal-sweep.1-of-2.part", part);
  const TemporaryFolder second;
  output_of(sweep(journal, small, {"--out", second.path().string(), "--shard", "2/2"}));
  gathered.write("journal-sweep.2-of-2.part", read_text(second / "journal-sweep.2-of-2.part"));
  const Json merged =
      Json::parse(output_of(sweep(journal, small, {"--out", gathered.path().string(), "--merge", "--json"})));
  CHECK(merged["run_now"] == 0);
  CHECK(merged["rows"].size() == 6);
  CHECK(read_text(gathered / "journal-sweep.csv") == whole);
}

TEST_CASE("sweep: once merged, --merge and a shard say so again, compute nothing and leave no part") {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  for (const std::string shard : {"1/2", "2/2"}) output_of(sweep(journal, small, {"--out", out, "--shard", shard}));
  const std::string csv = read_text(folder / "journal-sweep.csv");
  for (const Words& again : {Words{"--merge"}, Words{"--shard", "1/2"}, Words{"--shard", "2/3"}, Words{}}) {
    Words words = sweep(journal, small, {"--out", out, "--json"});
    words.insert(words.end(), again.begin(), again.end());
    const ProgramResult result = lubjoint_program(words);
    CHECK(result.status == 0);
    CHECK_THAT(result.err, Contains("merged before; nothing is done"));
    const Json summary = Json::parse(result.out);
    CHECK(summary["run_now"] == 0);
    CHECK(summary["merged"] == true);
    CHECK(summary["rows"].size() == 6);
    CHECK(read_text(folder / "journal-sweep.csv") == csv);
    CHECK(folder.entries() == merged_files);
  }
  // Another sweep, or a CSV that was changed, is not the one that was merged.
  Words other = small;
  other.back() = "1e-5";
  CHECK_THAT(refusal(sweep(journal, other, {"--out", out, "--merge"})), Contains("0 of 6 points"));
  folder.write("journal-sweep.csv", csv + "7\n");
  CHECK_THAT(refusal(sweep(journal, small, {"--out", out, "--merge"})), Contains("0 of 6 points"));
  output_of(sweep(journal, small, {"--out", out}));
  CHECK(read_text(folder / "journal-sweep.csv") == csv);
}

TEST_CASE("sweep: a shard looks at its own points of the grid alone") {
  const TemporaryFolder folder;
  const Words grid{"--vary", "joints[0].clearance=1e-4,2e-4,3e-4,2e-2"};  // the last is larger than the journal
  CHECK_THAT(refusal(sweep(journal, grid, {"--out", folder / "a"})), Contains("point 3 ("));
  CHECK_THAT(refusal(sweep(journal, grid, {"--out", folder / "a", "--shard", "2/2"})), Contains("point 3 ("));
  CHECK(folder.entries().empty());
  CHECK_THAT(output_of(sweep(journal, grid, {"--out", folder / "a", "--shard", "1/2"})), Contains("2 finished"));
}

TEST_CASE("sweep: a lock that can't be had says why") {
  CHECK_THAT(lubjoint::reports::lock_refusal("x.part", EWOULDBLOCK),
             Contains("another process is at work on \"x.part\""));
  CHECK_THAT(lubjoint::reports::lock_refusal("x.part", ENOLCK),
             Contains("x.part\" can't be locked: No locks available") && Contains("allowed"));
}

TEST_CASE("sweep: the exit status tells points that stopped from a sweep that failed, or accepts them if asked to") {
  const Words grid{"--vary", "integrator.max_steps=5,100000"};
  const TemporaryFolder folder;
  CHECK(lubjoint_program(sweep(journal, grid)).status == 1);
  CHECK(lubjoint_program(sweep(journal, grid, {"--accept-stopped"})).status == 0);
  CHECK(lubjoint_program(sweep(journal, grid, {"--out", "/proc/lubjoint", "--accept-stopped"})).status == 2);
  const ProgramResult help = lubjoint_program({"sweep", "--help"});
  CHECK_THAT(help.out, Contains("0 all points finished") && Contains("1 all points ran, and some stopped") &&
                           Contains("2 the sweep failed"));
}

TEST_CASE("sweep: killed at any time and run again, it ends with the same bytes and runs only what is missing") {
  const TemporaryFolder folder;
  const Words grid{"--vary", "joints[0].clearance=1e-4:3e-4:40", "--vary", "bodies[0].spin=10:60:10", "--jobs", "1"};
  const std::string whole = output_of(sweep(journal, grid));
  const std::string part = folder / "journal-sweep.1-of-1.part";
  Words words = sweep(journal, grid, {"--out", folder.path().string()});
  words.insert(words.begin(), LUBJOINT_PROGRAM);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    detail::redirect("/dev/null", O_WRONLY, STDOUT_FILENO);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  std::error_code error;
  const auto size = [&] { return std::filesystem::exists(part, error) ? std::filesystem::file_size(part, error) : 0; };
  while (size() < 5000 && ::waitpid(child, nullptr, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  REQUIRE(std::filesystem::exists(part));
  const std::size_t kept = lines_of(read_text(part)).size() - 1;
  REQUIRE(kept > 3);
  REQUIRE(kept < 400);
  const Json summary = Json::parse(output_of(sweep(journal, grid, {"--out", folder.path().string(), "--json"})));
  CHECK(summary["run_now"].get<std::size_t>() <= 400 - kept + 1);  // one may have been cut off
  CHECK(summary["run_now"].get<std::size_t>() >= 400 - kept);
  CHECK(read_text(folder / "journal-sweep.csv") == whole);
  CHECK(folder.entries() == merged_files);
}

TEST_CASE("sweep: a part cut after any byte is continued, damaged rows run again, and both are said") {
  const std::string whole = output_of(sweep(journal, small));
  const TemporaryFolder made;
  output_of(sweep(journal, small, {"--out", made.path().string(), "--shard", "1/2"}));
  const std::string part = read_text(made / "journal-sweep.1-of-2.part");
  const auto continued = [&](const std::string& text) {
    const TemporaryFolder folder;
    folder.write("journal-sweep.1-of-2.part", text);
    const ProgramResult result =
        lubjoint_program(sweep(journal, small, {"--out", folder.path().string(), "--shard", "1/2"}));
    INFO(result.err);
    CHECK(result.status == 0);
    output_of(sweep(journal, small, {"--out", folder.path().string(), "--shard", "2/2"}));
    CHECK(read_text(folder / "journal-sweep.csv") == whole);
    return result.err;
  };
  for (std::size_t length : {std::size_t{0}, std::size_t{1}, part.find('\n'), part.find('\n') + 1, part.size() - 1}) {
    INFO("the first " << length << " bytes");
    const std::string message = continued(part.substr(0, length));
    if (length == part.size() - 1) CHECK_THAT(message, Contains("cut off, and ignored"));
  }
  std::string damaged = part;
  const std::size_t digit = damaged.find_last_of("0123456789");
  damaged[digit] = damaged[digit] == '1' ? '2' : '1';
  CHECK_THAT(continued(damaged), Contains("line 4: damaged, and ignored"));
  CHECK_THAT(continued(part + "what is this\n"), Contains("line 5: damaged, and ignored"));
}

TEST_CASE("sweep: parts of another scene, grid, option or program are refused, and left as they are") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("scene.toml", read_text(journal));
  const std::string out = folder / "out";
  output_of(sweep(scene, small, {"--out", out, "--shard", "1/2"}));
  const std::string file = "out/journal-sweep.1-of-2.part";
  const std::string part = read_text(folder / file);
  const auto refused = [&](const Words& words, const std::string& other) {
    const std::string message = refusal(words);
    CHECK_THAT(message, Contains("journal-sweep.1-of-2.part") && Contains(other) && Contains("delete it"));
    CHECK(read_text(folder / file) == part);
    CHECK(folder.entries() == std::set<std::string>{"scene.toml", "out", file});
  };
  Words grid = small;
  grid[1] = "joints[0].clearance=1e-4:3e-4:4";
  for (const std::string shard : {"1/2", "2/2"}) {
    refused(sweep(scene, grid, {"--out", out, "--shard", shard}), "(other grid)");
    grid.back() = "1e-5";
    refused(sweep(scene, grid, {"--out", out, "--shard", shard}), "(other options, grid)");
    grid.back() = "1e-6";
    folder.write("scene.toml", journal_text().with("bodies[0].mass", "0.14"));
    refused(sweep(scene, small, {"--out", out, "--shard", shard}), "(other scene)");
    folder.write("scene.toml", read_text(journal));
  }
  refused(sweep(scene, grid, {"--out", out, "--merge"}), "(other grid)");
  // Another program's, and no part at all.
  std::string text = part;
  const std::size_t at = text.find("\"program\":\"") + 11;
  text[at] = text[at] == '9' ? '8' : '9';
  folder.write(file, text);
  CHECK_THAT(refusal(sweep(scene, small, {"--out", out, "--shard", "1/2"})), Contains("(other program)"));
  CHECK(read_text(folder / file) == text);
  folder.write(file, "t,x\n0,1\n");
  CHECK_THAT(refusal(sweep(scene, small, {"--out", out, "--shard", "1/2"})), Contains("is no part of a sweep"));
  // A row that was moved from another sweep has another checksum: it counts for nothing.
  folder.write(file, part);
  const TemporaryFolder other;
  grid[1] = "joints[0].clearance=1e-4:4e-4:3";
  output_of(sweep(scene, grid, {"--out", other.path().string(), "--shard", "2/2"}));
  const std::string foreign = read_text(other / "journal-sweep.2-of-2.part");
  folder.write(file, part + foreign.substr(foreign.find('\n') + 1));
  const Json left = Json::parse(output_of(sweep(scene, small, {"--out", out, "--json"})));
  CHECK(left["run_now"] == 3);
  CHECK(read_text(folder / "out/journal-sweep.csv") == output_of(sweep(scene, small)));
}

TEST_CASE("sweep: a shard that another process is at work on is refused") {
  const TemporaryFolder folder;
  output_of(sweep(journal, small, {"--out", folder.path().string(), "--shard", "1/2"}));
  const int held = ::open((folder / "journal-sweep.1-of-2.part").c_str(), O_RDWR);
  REQUIRE(held >= 0);
  REQUIRE(::flock(held, LOCK_EX) == 0);
  CHECK_THAT(refusal(sweep(journal, small, {"--out", folder.path().string(), "--shard", "1/2"})),
             Contains("another process is at work"));
  ::close(held);
  output_of(sweep(journal, small, {"--out", folder.path().string(), "--shard", "1/2"}));
}

TEST_CASE("sweep: a point that stops is a row with its reason, all others run, and the exit status is 1") {
  const Words grid{"--vary", "integrator.max_steps=5,100000", "--vary", "bodies[0].mass=0.13,0.2"};
  const ProgramResult result = lubjoint_program(sweep(journal, grid));
  CHECK(result.status == 1);
  const auto rows = table_of(result.out);
  REQUIRE(rows.size() == 4);
  for (const auto& row : rows) {
    const bool few = row.at("integrator.max_steps") == "5";
    CHECK(row.at("status") == (few ? "stopped" : "finished"));
    CHECK(row.at("message").empty() != few);
    if (few) CHECK_THAT(row.at("message"), Contains("the limit of 5 steps is reached") && Contains("\"bearing\""));
    CHECK_FALSE(row.at("bearing.max_force").empty());
  }
  const TemporaryFolder folder;
  const ProgramResult kept = lubjoint_program(sweep(journal, grid, {"--out", folder.path().string(), "--json"}));
  CHECK(kept.status == 1);
  CHECK(Json::parse(kept.out)["stopped"] == 2);
  CHECK(read_text(folder / "journal-sweep.csv") == result.out);
}

TEST_CASE("sweep: a point that no file could hold is refused by its number and values before anything runs") {
  const TemporaryFolder folder;
  const Words out{"--out", folder / "out"};
  const auto refused = [&](const std::string& scene, const Words& grid, const Words& words) {
    const std::string message = refusal(sweep(scene, grid, out));
    for (const std::string& word : words) CHECK_THAT(message, Contains(word));
    CHECK(folder.entries().empty());
  };
  refused(journal, {"--vary", "joints[0].clearance=1e-3:2e-2:20"},
          {"point 9 (joints[0].clearance = 0.01): ", "journal.toml:",
           "joints[0].clearance is 0.01 m; allowed is less than journal_radius"});
  refused(journal, {"--vary", "joints[0].film=short_half,short_hal"}, {"point 1 (", "did you mean short_half?"});
  refused(journal, {"--vary", "bodies[0].position[0]=0,3e-4"}, {"point 1 (", "eccentricity ratio 1.5"});
  refused(journal, {"--vary", "joint[0].clearance=1,2"}, {"joint is not there", "did you mean joints?"});
  refused(journal, {"--vary", "bodies[0].mas=1,2"}, {"unknown key bodies[0].mas", "did you mean bodies[0].mass?"});
  refused(journal, {"--vary", "joints[0].clearance=1e-4,2e-4", "--vary", "joints.bearing.clearance=1e-4"},
          {"--vary joints[0].clearance: given twice"});
  refused(LUBJOINT_SOURCE_DIR "/data/scenes/slider-crank-ideal.toml",
          {"--vary", "constraints.main-bearing.first.point[1]=0,0.3"},
          {"point 1 (", "the constraints are conflicting: no position near the start fulfils them all"});
  refused(slider_crank, {"--vary", "constraints.crank-pin.first.point[0]=0.025,0.03"},
          {"point 1 (", "its journal starts at eccentricity ratio"});
  for (const Words& both : {Words{"--law", "short_half", "--vary", "joints[0].film=long_half,short_half"},
                            Words{"--rtol", "1e-6", "--vary", "integrator.relative_tolerance=1e-6,1e-7"},
                            Words{"--integrator", "dopri5", "--vary", "integrator.name=dopri5,radau_iia5"},
                            Words{"--duration", "1", "--vary", "duration=1,2"}}) {
    refused(journal, both, {"and " + both[0] + " set the same"});
  }
}

TEST_CASE("sweep: bad shards, jobs and combinations of options are refused") {
  const TemporaryFolder folder;
  const auto refused = [&](const Words& more, const std::string& word) {
    CHECK_THAT(refusal(sweep(journal, small, more)), Contains(word));
  };
  for (const std::string shard : {"0/2", "3/2", "1", "1/0", "a/b", "1/2/3", "-1/2", "1.5/2"}) {
    refused({"--out", folder.path().string(), "--shard", shard}, "--shard is \"" + shard + "\"");
  }
  refused({"--shard", "1/2"}, "need a folder");
  refused({"--merge"}, "need a folder");
  refused({"--merge", "--shard", "1/2", "--out", folder.path().string()}, "--shard and --merge");
  refused({"--merge", "--out", folder.path().string()}, "0 of 6 points");
  refused({"--jobs", "1025"}, "--jobs is 1025");
  refused({"--out", "/proc/lubjoint"}, "output folder");
  CHECK(folder.entries().empty());
  CHECK(lubjoint_program({"sweep", journal}).status == 2);
  CHECK(lubjoint_program(sweep(journal, small, {"--jobs", "-1"})).status == 2);
}

}  // namespace sweep_test

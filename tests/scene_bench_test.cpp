#include "oracle/measure/bench/scene_bench.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "lubjoint/scene/spatial_scene_file.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/golden_files.hpp"
#include "oracle/files/kept_rows.hpp"
#include "oracle/measure/bench/equal_error.hpp"
#include "oracle/measure/bench/golden_reference.hpp"
#include "oracle/measure/bench/simbody_case.hpp"
#include "support/temporary_folder.hpp"

namespace scene_bench_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

Scene shipped(const std::string& name) {
  return load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/" + name + ".toml");
}

reports::SceneBenchSettings few(std::vector<double> tolerances) {
  reports::SceneBenchSettings settings;
  settings.tolerances = std::move(tolerances);
  settings.limits = {1, 0.2};
  return settings;
}

}  // namespace

TEST_CASE("bench: every integrator's error on the journal falls with its tolerance, to the references' agreement") {
  const reports::SceneBench bench = reports::bench_scenes({shipped("journal")}, few({1e-4, 1e-8}));
  REQUIRE(bench.references.size() == 1);
  CHECK(bench.references[0].golden);
  CHECK(bench.references[0].agreement < 1e-14);  // as data/README.md says of it
  std::size_t finished = 0;
  for (const reports::BenchRow& row : bench.rows) {
    INFO(row.integrator << " at " << row.tolerance << ": " << row.run.message);
    CHECK((row.run.finished || !row.run.message.empty()));
    if (!row.run.finished) continue;
    ++finished;
    CHECK(row.run.error < 1e3 * row.tolerance);  // two decades of accumulation, one of looseness
    CHECK(row.run.steps > 0);
    CHECK(row.run.rhs_evaluations > row.run.steps);
  }
  CHECK(finished >= 4);  // the stiff ones at least, however slow the machine
}

TEST_CASE("bench: a slider-crank is raced in minimal and absolute coordinates and in space, and all have one answer") {
  const reports::SceneBench bench = reports::bench_scenes({shipped("slider-crank")}, few({1e-6}));
  CHECK(bench.references[0].agreement < 1e-12);  // as data/README.md says of it
  for (const char* formulation : {"minimal", "absolute", "embedded"}) {
    const auto floor = reports::error_floor(bench.rows, {"slider-crank", formulation}, "radau_iia5");
    REQUIRE(floor.has_value());
    CHECK(*floor < 1e-4);  // a hundred times the tolerance
  }
}

TEST_CASE("bench: a slider-crank in space is raced in three kinds of coordinates, by Simbody where it is") {
  const std::string file = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/space/spatial-slider-crank.toml";
  reports::SceneBenchSettings settings = few({1e-6});
  settings.integrators = {"radau_iia5", "simbody_cpodes"};
  settings.limits.seconds = 1;
  const reports::SceneBench bench = reports::bench_scenes({}, settings, {load_spatial_scene(file)});
  REQUIRE(bench.references.size() == 1);
  CHECK(bench.references[0].agreement < 1e-12);  // 1.7e-13 was measured
  for (const char* formulation : {"minimal", "absolute", "independent"}) {
    const auto floor = reports::error_floor(bench.rows, {"spatial-slider-crank", formulation}, "radau_iia5");
    REQUIRE(floor.has_value());
    CHECK(*floor < 1e-4);  // a hundred times the tolerance
  }
  CHECK(bench.rows.size() == 3 + reports::simbody_methods().size());
  CHECK_THROWS_WITH(
      reports::bench_scenes({}, settings,
                            {load_spatial_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/space/top.toml")}),
      Catch::Matchers::Contains("allowed is a spatial slider-crank"));
}

TEST_CASE("bench: a scene of one's own is measured against two integrators in extended precision") {
  const TemporaryFolder folder;
  const auto changed = [&](const std::string& name, const std::string& from, const std::string& to) {
    std::string text = read_text(shipped(name).file);
    REQUIRE(text.find(from) != std::string::npos);
    text.replace(text.find(from), from.size(), to);
    reports::write_file(folder / (name + ".toml"), text);  // its name is that of a golden trajectory
    return load_scene(folder / (name + ".toml"));
  };
  for (const Scene& scene : {changed("journal", "viscosity = 0.4", "viscosity = 0.3"),
                             changed("slider-crank-ideal", "mass = 0.21", "mass = 0.2"),
                             changed("slider-crank", "viscosity = 0.4", "viscosity = 0.3")}) {
    CAPTURE(scene.name);
    const reports::BenchScene made = reports::bench_scene(scene);
    CHECK_FALSE(made.golden);
    CHECK(made.reference_agreement < 1e-10);  // two methods over a kink of the law, where both lose their order
    for (const auto& each : made.cases) {
      if (each->formulation() == "joint") continue;
      const reports::MethodRun run = each->run("radau_iia5", 1e-8, {1, 10});
      INFO(each->formulation() << ": " << run.message);
      CHECK(run.finished);
      CHECK(run.error < 1e-5);  // a thousand tolerances
      CHECK(run.error > 0);
    }
  }
}

TEST_CASE("bench: ideal joints are compared in every body's place and angle") {
  const Scene scene = shipped("slider-crank-ideal");
  const auto golden = reports::golden_reference(scene);
  REQUIRE(golden.has_value());
  CHECK(golden->seen.size() == golden->times.size() * 2 * scene.bodies.size());
  reports::Reference wrong = golden->seen;
  const auto error_against = [](const reports::Reference& reference, const reports::Reference& seen) {
    return reports::measured_run({1, 1}, reference, [&](reports::Reference* look) {
      reports::MethodRun run;
      run.finished = true;
      if (look) *look = seen;
      return run;
    });
  };
  CHECK(error_against(golden->seen, wrong).error == 0);
  wrong[3].x() += 1e-3;  // the rod's angle at the first time
  CHECK(error_against(golden->seen, wrong).error == Approx(1e-3));
  wrong.pop_back();
  CHECK_FALSE(error_against(golden->seen, wrong).finished);  // an output time is missing
}

TEST_CASE("bench: the median and the spread of the repeats, and no time of a run that stops") {
  const reports::Reference reference{{0.5, 0}};
  std::vector<double> times = {9, 3, 1, 2, 5, 4};  // the first of the look
  std::size_t next = 0;
  const auto once = [&](reports::Reference* look) {
    reports::MethodRun run;
    run.finished = next < 6;
    run.seconds = times[std::min<std::size_t>(next++, 5)];
    if (look) look->emplace_back(0.5, 0.25);
    return run;
  };
  const reports::MethodRun run = reports::measured_run({5, 10}, reference, once);
  CHECK(run.error == 0.25);
  CHECK(run.seconds == 3);
  CHECK(run.spread == Approx(2.0 / 3));  // quartiles 2 and 4
  // On a machine that gets slower, the times are those of its usual pace: here 1, 1, 1, 1, 0.8.
  next = 0;
  times = {9, 1, 2, 3, 4, 4};
  double pace = 0.5;
  const auto slower = [&pace] { return pace++; };
  const reports::MethodRun paced = reports::measured_run({5, 10, slower}, reference, once);
  CHECK(paced.seconds == 1);
  CHECK(paced.spread == 0);
  times = {9, 3, 1, 2, 5, 4};
  next = 3;
  CHECK_FALSE(reports::measured_run({5, 10}, reference, once).finished);
}

TEST_CASE("bench: who runs out of time at two tolerances is spared the tighter ones, and it is said") {
  reports::SceneBenchSettings settings = few({1e-4, 1e-5, 1e-6, 1e-7});
  settings.limits = {1, 1e-6};  // of a run that takes a tenth of a second
  settings.integrators = {"dopri5"};
  const auto rows = reports::bench_scenes({shipped("journal")}, settings).rows;
  REQUIRE(rows.size() == 4);
  CHECK(rows[1].run.message == reports::out_of_time);
  CHECK(rows[2].run.message == "not run: out of time at looser tolerances");
  CHECK(rows[3].run.message == rows[2].run.message);
}

TEST_CASE("bench: an interrupted campaign goes on where it was, and one of other settings starts anew") {
  const TemporaryFolder folder;
  reports::SceneBenchSettings settings = few({1e-5});
  settings.resume_file = folder.path() / "bench.part";
  const std::string scene = shipped("slider-crank-ideal").file;
  std::string line = reports::KeptRows::first_line("repeats 1 seconds 0.2 tolerances 1e-05 " + scene + " " +
                                                   reports::sha256(read_text(scene)));
  line +=
      reports::bench_header + std::string("slider-crank-ideal,absolute,dopri5,1e-05,0.125,7,0,1,2,3,4,5,finished,\n");
  const auto dopri5_seconds = [&] {
    for (const reports::BenchRow& row : reports::bench_scenes({shipped("slider-crank-ideal")}, settings).rows) {
      if (row.integrator == "dopri5") return row.run.seconds;
    }
    return -1.0;
  };
  reports::write_file(*settings.resume_file, line);
  CHECK(dopri5_seconds() == 7);  // taken over
  CHECK(dopri5_seconds() == 7);  // still there: the results are not written yet
  reports::discard_kept_rows(settings.resume_file);
  CHECK(folder.entries().empty());
  settings.tolerances = {1e-6};
  reports::write_file(*settings.resume_file, line);
  CHECK(dopri5_seconds() < 7);  // run
}

}  // namespace scene_bench_test

#include "oracle/reports/bench/scene_bench.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "lubjoint/scene/scene_file.hpp"
#include "oracle/reports/files.hpp"
#include "oracle/reports/golden_files.hpp"
#include "oracle/reports/kept_rows.hpp"
#include "support/temporary_folder.hpp"

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

/// A campaign with errors that fall as the square of the tolerance and times that double.
reports::SceneBench invented() {
  reports::SceneBench bench;
  double seconds = 1;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    reports::BenchRow row{"s", "journal", "dopri5", tolerance, {}};
    row.run.finished = true;
    row.run.error = tolerance * tolerance;
    row.run.seconds = seconds;
    seconds *= 2;
    bench.rows.push_back(row);
  }
  return bench;
}

}  // namespace

TEST_CASE("bench: times between tolerances lie on the log-log line, and beyond the last there are none") {
  const reports::SceneBench bench = invented();
  const auto at = [&](double error) { return reports::seconds_at_error(bench, "s", "journal", "dopri5", error); };
  CHECK(*at(1e-4) == Approx(1).epsilon(1e-14));               // rounding
  CHECK(*at(1e-5) == Approx(std::sqrt(2.0)).epsilon(1e-14));  // halfway on the line
  CHECK(*at(1e-2) == Approx(1).epsilon(1e-14));               // the loosest run is better than asked
  CHECK_FALSE(at(1e-9).has_value());
  CHECK(*reports::error_floor(bench, "s", "journal", "dopri5") == Approx(1e-8).epsilon(1e-14));
}

TEST_CASE("bench: every integrator's error on the journal falls with its tolerance, to the references' agreement") {
  const reports::SceneBench bench = reports::bench_scenes({shipped("journal")}, few({1e-4, 1e-8}));
  REQUIRE(bench.references.size() == 1);
  CHECK(bench.references[0].agreement < 1e-10);  // two methods over a kink of the law, where both lose their order
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

TEST_CASE("bench: a slider-crank is raced in minimal and in absolute coordinates, and both have the same answer") {
  const reports::SceneBench bench = reports::bench_scenes({shipped("slider-crank")}, few({1e-6}));
  CHECK(bench.references[0].agreement < 1e-11);  // 64-bit significands, 600 clearances of coordinates
  for (const char* formulation : {"minimal", "absolute"}) {
    const auto floor = reports::error_floor(bench, "slider-crank", formulation, "radau_iia5");
    REQUIRE(floor.has_value());
    CHECK(*floor < 1e-4);  // a hundred times the tolerance
  }
}

TEST_CASE("bench: an interrupted campaign goes on where it was, and one of other settings starts anew") {
  const TemporaryFolder folder;
  reports::SceneBenchSettings settings = few({1e-5});
  settings.resume_file = folder.path() / "bench.part";
  const std::string scene = shipped("slider-crank-ideal").file;
  std::string line = reports::KeptRows::first_line("repeats 1 seconds 0.2 tolerances 1e-05 " + scene + " " +
                                                   reports::sha256(read_text(scene)));
  line +=
      "scene,formulation,integrator,tolerance,error,seconds,steps,rejected,rhs_evaluations,jacobian_evaluations,"
      "factorisations,status,message\nslider-crank-ideal,absolute,dopri5,1e-05,0.125,7,1,2,3,4,5,finished,\n";
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

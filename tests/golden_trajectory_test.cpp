#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <string>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/reports/csv_table.hpp"
#include "oracle/reports/files.hpp"
#include "oracle/reports/golden_files.hpp"

using namespace lubjoint;

TEST_CASE("golden trajectories: the files have their manifest's checksums") {
  const auto folder = std::filesystem::path(LUBJOINT_SOURCE_DIR) / "data" / "golden" / "trajectories";
  for (const auto& difference : reports::manifest_differences(folder)) FAIL_CHECK(difference.text());
}

TEST_CASE("golden trajectories: the simulator follows the reference of every law to its end") {
  const std::filesystem::path data = std::filesystem::path(LUBJOINT_SOURCE_DIR) / "data";
  for (const std::string_view law : film_law_names) {
    CAPTURE(law);
    const auto file = data / "golden" / "trajectories" / ("journal-" + std::string(law) + ".csv");
    const reports::CsvTable golden(reports::read_input(file.string()), file.string());
    Scene scene = load_scene(data / "scenes" / "journal.toml");
    scene.joints.front().film = law;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-12;
    for (const std::size_t back : {std::size_t{1}, golden.rows() / 2, golden.rows() - 4}) {
      const std::size_t row = golden.rows() - back;
      // The end of a run is the end of a step: no interpolant is compared.
      scene.run.duration = golden.number(row, golden.column("t"));
      scene.run.output_interval = scene.run.duration;
      const JournalTrajectory run = simulate_journal(scene);
      REQUIRE(run.outcome.status == RunStatus::finished);
      const JournalSample& last = run.samples.back();
      const double ex = golden.number(row, golden.column("ex_over_c"));
      const double ey = golden.number(row, golden.column("ey_over_c"));
      const double apart = std::hypot(last.state[0] - ex, last.state[1] - ey);
      CHECK(apart < 2e-9);  // tolerance 1e-12 a step, thousands of steps, and events of the half films
      const double fx = golden.number(row, golden.column("fx"));
      const double fy = golden.number(row, golden.column("fy"));
      const double force_error = std::hypot(last.force.x() - fx, last.force.y() - fy);
      CHECK(force_error < 1e-4);  // the film's damping, 1e5 N s/m, amplifies the velocity's error
    }
  }
}

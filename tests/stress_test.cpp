// The stability matrix, and the reasons that runs give when they stop.
#include "oracle/reports/stress/stress.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "lubjoint/dynamics/integrators.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/reports/csv_table.hpp"
#include "oracle/reports/kept_rows.hpp"
#include "oracle/reports/stress/stress_report.hpp"
#include "support/temporary_folder.hpp"

using namespace lubjoint;
using namespace lubjoint::reports;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

std::vector<StressCase> cases_named(const std::set<std::string>& names) {
  std::vector<StressCase> wanted;
  for (StressCase& each : stress_cases(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes")) {
    if (names.count(each.name)) wanted.push_back(std::move(each));
  }
  REQUIRE(wanted.size() == names.size());
  return wanted;
}

Scene scene_named(const std::string& name) { return cases_named({name}).front().scene; }

StressSettings small_settings() {
  StressSettings settings = stress_settings(true);
  settings.integrators = {"radau_iia5", "dopri5", "auto"};
  settings.most_steps = 2000;
  settings.threads = 2;
  return settings;
}

bool same_but_for_time(const StressCell& a, const StressCell& b) {
  return a.scenario == b.scenario && a.law == b.law && a.integrator == b.integrator && a.status == b.status &&
         a.error == b.error && a.steps == b.steps && a.message == b.message;
}

RunOutcome outcome_of(Scene scene, const std::string& law, const std::string& integrator) {
  scene.integrator = integrator;
  scene.joints.front().film = law;
  if (!is_free_journal(scene)) return simulate_multibody(scene).outcome;
  const JournalTrajectory run = simulate_journal(scene);
  CHECK(run.samples.back().t == run.outcome.t_end);  // the results so far are there
  return run.outcome;
}

/// A stop says when, and holds all the words.
void check_stop(const RunOutcome& outcome, const std::vector<std::string>& words) {
  CHECK(outcome.status == RunStatus::stopped);
  CHECK_THAT(outcome.message, Catch::StartsWith("stopped at t = "));
  for (const std::string& word : words) CHECK_THAT(outcome.message, Contains(word));
}

}  // namespace

TEST_CASE("stress: no cell of the extreme starts, loads and tolerances is wrong, with any integrator") {
  const auto cases = cases_named({"journal-start-centred", "journal-start-1e-300", "journal-start-near-wall-1e-12",
                                  "journal-start-near-wall-outward", "journal-at-rest", "journal-pure-squeeze",
                                  "journal-whirl-reversal", "journal-spin-reversal", "journal-clearance-1um",
                                  "journal-mass-1e-6kg", "journal-load-1e13N", "journal-thrown-at-wall",
                                  "journal-tolerance-1e-1", "journal-tolerance-1e-14", "impact-fast"});
  StressSettings settings = small_settings();
  settings.integrators.assign(integrator_names.begin(), integrator_names.end());
  std::size_t finished = 0;
  std::size_t known = 0;
  for (const StressCell& cell : run_stress(cases, settings)) {
    INFO(cell.scenario << ' ' << cell.law << ' ' << cell.integrator << ": " << cell.message);
    CHECK(cell.status != StressStatus::wrong);
    CHECK(std::isfinite(cell.error.value_or(0)));
    if (cell.status == StressStatus::stopped) {
      CHECK_THAT(cell.message, Contains("raise") || Contains("needs") || Contains("use "));  // what to change
      CHECK(cell.steps <= settings.most_steps);
    }
    finished += cell.status == StressStatus::finished;
    known += cell.error.has_value();
  }
  CHECK(finished > 80);  // of 210: the matrix is not one of stops
  CHECK(known > 150);
}

TEST_CASE("stress: what is far from its reference is wrong, or coarse if it has finished and warned of its tolerance") {
  CHECK(stress_error_limit(1e-6, 0) == 1e-3);     // a thousandth of a clearance
  CHECK(stress_error_limit(1e-5, 0) == 1e-2);     // a thousand tolerances
  CHECK(stress_error_limit(1e-1, 0) == 0.1);      // a tenth of a clearance
  CHECK(stress_error_limit(1e-6, 5e-3) == 0.05);  // ten times what is known
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const bool warned : {false, true}) {
    CHECK(stress_status(true, 1e-3, 1e-3, warned) == StressStatus::finished);
    CHECK(stress_status(true, std::nullopt, 1e-3, warned) == StressStatus::finished);
    CHECK(stress_status(false, 1e-3, 1e-3, warned) == StressStatus::stopped);
    CHECK(stress_status(false, std::nullopt, 1e-3, warned) == StressStatus::stopped);
  }
  for (const double far_off : {1.1e-3, nan}) {
    CHECK(stress_status(true, far_off, 1e-3, false) == StressStatus::wrong);
    CHECK(stress_status(false, far_off, 1e-3, false) == StressStatus::wrong);
    CHECK(stress_status(true, far_off, 1e-3, true) == StressStatus::coarse);
    CHECK(stress_status(false, far_off, 1e-3, true) == StressStatus::stopped);
  }
}

TEST_CASE("stress: a run further off than its tolerance has warned of that") {
  StressSettings settings = small_settings();
  settings.laws = {"short_full"};
  settings.integrators = {"rosenbrock4"};
  settings.most_steps = 20'000;  // of the references, which are runs of tighter tolerances
  // 1e-6 clearances in a film of 2e-5, and a journal that creeps along the wall.
  const StressCell cell = run_stress(cases_named({"journal-load-1e9N"}), settings).front();
  CHECK(cell.status == StressStatus::coarse);
  CHECK(cell.error.value_or(0) > stress_error_limit(1e-6, 0));
  CHECK_THAT(cell.message, Contains("of the thinnest film") && Contains("would resolve it"));

  // Of a free journal's two tolerances the coarser one counts, as in `simulate`.
  settings.integrators = {"dopri5"};
  for (const auto tolerance : {&RunSettings::absolute_tolerance, &RunSettings::relative_tolerance}) {
    auto cases = cases_named({"journal-clearance-2mm"});
    cases.front().scene.run.*tolerance = 0.9;
    CHECK_THAT(run_stress(cases, settings).front().message, Contains("tolerance of 9e-01 clearances"));
  }
}

TEST_CASE("stress: extrapolation does not jump off the wall where a film that opens lets go") {
  // A first step far too long has the same wrong end, x0 + H f(x0)/2, in every column: no error estimate sees it.
  StressSettings settings = small_settings();
  settings.laws = {"short_dynamic", "long_dynamic"};
  settings.integrators = {"bulirsch_stoer"};
  settings.most_steps = 20'000;
  for (const StressCell& cell :
       run_stress(cases_named({"journal-start-near-wall-1e-6", "journal-start-near-wall-outward"}), settings)) {
    INFO(cell.scenario << ' ' << cell.law << ": " << cell.message);
    CHECK(cell.status == StressStatus::finished);
    CHECK(cell.error.value_or(1) < 1e-5);  // ten tolerances
    CHECK_THAT(cell.message, Contains("thinnest film"));
  }
}

TEST_CASE("stress: samples inside the long steps of stiff runs are as good as the steps") {
  // A film thousands of times faster than the step: the rate at a step's end is the step's error times its eigenvalue.
  StressSettings settings = small_settings();
  settings.integrators = {"radau_iia5", "rosenbrock4"};
  for (const StressCell& cell : run_stress(cases_named({"journal-mass-1e-6kg", "journal-load-1e6N"}), settings)) {
    INFO(cell.scenario << ' ' << cell.law << ' ' << cell.integrator << ": " << cell.message);
    CHECK(cell.status == StressStatus::finished);
    CHECK(cell.error.value_or(1) < 1e-3);  // a thousand tolerances; 0.01 to 0.7 by the rates themselves
  }
}

TEST_CASE("stress: a resumed run equals an uninterrupted one, and any number of threads gives the same cells") {
  const auto cases = cases_named({"journal-start-centred", "journal-load-1e6N", "journal-step-limit"});
  StressSettings settings = small_settings();
  const auto whole = run_stress(cases, settings);
  REQUIRE(whole.size() == 18);
  settings.threads = 1;
  const auto alone = run_stress(cases, settings);
  REQUIRE(alone.size() == whole.size());

  // Interrupted after eight cells, the times of which no run takes.
  const TemporaryFolder folder;
  std::vector<StressCell> so_far(whole.begin(), whole.begin() + 8);
  for (StressCell& cell : so_far) cell.seconds = 12345;
  settings.resume_file =
      folder.write("stress.part", KeptRows::first_line(stress_key(cases, settings)) + stress_csv(so_far));
  const auto resumed = run_stress(cases, settings);
  REQUIRE(resumed.size() == whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    CHECK(same_but_for_time(whole[i], alone[i]));
    CHECK(same_but_for_time(whole[i], resumed[i]));
    CHECK((resumed[i].seconds == 12345) == (i < 8));
  }
  CHECK(KeptRows(settings.resume_file, stress_key(cases, settings), "").earlier()->rows() ==
        18);  // until it is discarded
  discard_kept_rows(settings.resume_file);
  CHECK(folder.entries().empty());  // nothing is left to resume

  // Rows of another campaign are left aside.
  settings.resume_file = folder.write("stress.part", "# another\n" + stress_csv(so_far));
  CHECK(run_stress(cases, settings).front().seconds < 12345);
}

TEST_CASE("stress: the CSV has a row a cell, and names case, law, integrator, status, error, seconds, steps, message") {
  const auto cases = cases_named({"journal-step-limit"});
  const CsvTable table(stress_csv(run_stress(cases, small_settings())), "stress.csv");
  CHECK(table.header() == "case,law,integrator,status,error,seconds,steps,message");
  CHECK(table.rows() == 6);
  CHECK(table.field(0, table.column("status")) == "stopped");
  CHECK(table.number(0, table.column("steps")) == 10);
  CHECK_THAT(std::string(table.field(0, table.column("message"))), Contains("limit of 10 steps"));
}

TEST_CASE("stop: a limit of steps says so, and which integrator or tolerance needs fewer") {
  const Scene journal = scene_named("journal-step-limit");
  check_stop(outcome_of(journal, "pinkus_sternlicht", "radau_iia5"),
             {"joint \"bearing\"", "eccentricity ratio", "limit of 10 steps", "relative_tolerance"});
  check_stop(outcome_of(journal, "pinkus_sternlicht", "dopri5"), {"limit of 10 steps", "radau_iia5 needs far fewer"});
  const Scene crank = scene_named("slider-crank-step-limit");
  check_stop(outcome_of(crank, "pinkus_sternlicht", "radau_iia5"), {"limit of 10 steps", "relative_tolerance"});
  check_stop(outcome_of(crank, "pinkus_sternlicht", "dopri5"), {"limit of 10 steps", "radau_iia5 needs far fewer"});
}

TEST_CASE("stop: a load that no film carries in double precision ends the run early, by the implicit method") {
  for (const char* load : {"journal-load-1e13N", "journal-load-1e25N"}) {
    const RunOutcome outcome = outcome_of(scene_named(load), "pinkus_sternlicht", "radau_iia5");
    INFO(load << ": " << outcome.message);
    CHECK(outcome.steps + outcome.rejected_steps < 50'000);  // a quarter of its limit
    check_stop(outcome, {"joint \"bearing\"", "can't carry", "raise the viscosity"});
  }
}

TEST_CASE("stop: near the wall a message prints the gap 1 - e/c, not an eccentricity ratio of 1") {
  Scene scene = scene_named("journal-start-near-wall-1e-12");
  scene.run.max_steps = 1;
  const RunOutcome outcome = outcome_of(scene, "pinkus_sternlicht", "radau_iia5");
  check_stop(outcome, {"eccentricity ratio 1 - 1e-12"});  // the four digits that 1 - 1e-12 keeps of its gap
}

TEST_CASE("stop: a multibody run names the half film that slides on its jump, and laws without one") {
  const RunOutcome outcome = outcome_of(scene_named("journal-spin-reversal"), "short_half", "dopri5");
  check_stop(outcome, {"joint \"bearing\"", "half film", "jump", "needs a law without one"});
}

TEST_CASE("stop: reasons are counted by kind, whatever the numbers in them") {
  CHECK(stop_kind("stopped at t = 0.5 s: joint \"b\" is at eccentricity ratio 0.3; radau_iia5 needs 1e-3") ==
        "joint \"b\" is at eccentricity ratio #; radau_iia5 needs #");
}

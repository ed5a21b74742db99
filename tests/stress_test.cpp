// The stability matrix, and the reasons that runs give when they stop.
#include "oracle/measure/stress/stress.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <limits>
#include <set>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/files/csv_table.hpp"
#include "oracle/files/files.hpp"
#include "oracle/files/kept_rows.hpp"
#include "oracle/measure/stress/stress_report.hpp"
#include "oracle/mechanisms/journal_films.hpp"
#include "oracle/trajectories/second_derivation.hpp"
#include "oracle/trajectories/slider_crank_scene.hpp"
#include "support/stress_scenes.hpp"
#include "support/temporary_folder.hpp"

namespace stress_test {

using namespace lubjoint;
using namespace lubjoint::reports;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

/// A reference of three output times whose disturbances stay as they are, and a run that has its every sample.
StressReference invented_reference() {
  StressReference reference;
  reference.rate_unit = 10;
  reference.force_unit = 100;
  for (const double t : {1.0, 2.0, 3.0}) reference.rows.push_back({t, {0.5, 0.1 * t}, {1, 2}, {30, 40}, 1, 2});
  return reference;
}
std::vector<StressSample> run_of(const StressReference& reference) {
  std::vector<StressSample> samples = {{0, {0, 0}, {0, 0}, {0, 0}}};
  for (const ReferencePlace& row : reference.rows) samples.push_back({row.t, row.place, row.rate, row.force});
  return samples;
}
/// 100 steps of tolerance 1e-6: errors of 1e-4 are expected, of forces 2e-4.
constexpr StressAccuracy invented_accuracy{1e-6, 0, 0.5, 100};

bool same_but_for_time(const StressCell& a, const StressCell& b) {
  return a.scenario == b.scenario && a.law == b.law && a.integrator == b.integrator && a.status == b.status &&
         a.deviation.place == b.deviation.place && a.deviation.rate == b.deviation.rate &&
         a.deviation.force == b.deviation.force && a.deviation.compared == b.deviation.compared && a.steps == b.steps &&
         a.program == b.program && a.message == b.message;
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
  settings.integrators.assign(integrator_names().begin(), integrator_names().end());
  std::size_t finished = 0;
  for (const StressCell& cell : run_stress(cases, settings)) {
    INFO(cell.scenario << ' ' << cell.law << ' ' << cell.integrator << ": " << cell.message);
    CHECK(cell.status != StressStatus::wrong);
    CHECK(std::isfinite(cell.deviation.place.value_or(0)));
    if (cell.status == StressStatus::stopped) {
      CHECK_THAT(cell.message, Contains("raise") || Contains("needs") || Contains("use "));  // what to change
      CHECK(cell.steps <= settings.most_steps);
    }
    if (cell.status != StressStatus::finished) continue;
    ++finished;
    // "finished" says that all three were compared at every output time.
    CHECK(cell.deviation.compared == 50);
    CHECK((cell.deviation.place && cell.deviation.rate && cell.deviation.force));
  }
  CHECK(finished > 70);  // a third of 210: the matrix is not one of stops, and each is near in all three
}

TEST_CASE("stress: statuses by what is known: whole truth table") {
  struct Row {
    bool finished, warned, whole;
    double over_expected, over_warned;
    StressStatus status;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Row table[] = {
      {true, false, true, 1, 1, StressStatus::finished},      {true, true, true, 0, 0, StressStatus::finished},
      {true, false, false, 0, 0, StressStatus::unreferenced}, {true, true, false, 0.5, 0, StressStatus::unreferenced},
      {true, true, true, 1.1, 0.9, StressStatus::coarse},     {true, true, false, 1.1, 0.9, StressStatus::coarse},
      {true, true, true, 1.1, 1.1, StressStatus::wrong},      {true, false, true, 1.1, 0.9, StressStatus::wrong},
      {true, false, false, 1.1, 0.9, StressStatus::wrong},    {true, true, true, nan, nan, StressStatus::wrong},
      {true, false, true, nan, 0, StressStatus::wrong},       {false, false, true, 0, 0, StressStatus::stopped},
      {false, false, false, 0, 0, StressStatus::stopped},     {false, true, false, 1.1, 0.9, StressStatus::stopped},
      {false, true, false, 1.1, 1.1, StressStatus::wrong},    {false, false, false, 1.1, 0, StressStatus::wrong},
      {false, false, false, nan, 0, StressStatus::wrong},
  };
  for (const Row& row : table) {
    StressDeviation deviation;
    deviation.over_expected = row.over_expected;
    deviation.over_warned = row.over_warned;
    deviation.whole = row.whole;
    INFO(row.finished << row.warned << row.whole << ' ' << row.over_expected << ' ' << row.over_warned);
    CHECK(stress_status(row.finished, deviation, row.warned) == row.status);
  }
}

TEST_CASE("stress: what a tolerance lets one expect grows with its steps and its motion, and never beyond a tenth") {
  const auto expected = [](double tolerance, std::size_t steps, double growth) {
    return expected_error({tolerance, 0, 1, steps}, growth);
  };
  // Products of the decimal numbers as written, to their rounding.
  CHECK(expected(1e-6, 100, 1) == Approx(1e-4).epsilon(1e-14));
  CHECK(expected(1e-6, 100'000, 1) == Approx(1e-3).epsilon(1e-14));  // a thousand steps count
  CHECK(expected(1e-6, 10, 20) == Approx(2e-4).epsilon(1e-14));
  CHECK(expected(1e-6, 100, 1e9) == 1e-3);
  CHECK(expected(1e-2, 100, 1) == 0.1);
  CHECK(expected_error({1e-14, 1e-13, 1, 100}, 1) == Approx(1.1e-11).epsilon(1e-14));  // rounding counts
}

TEST_CASE("stress: a place, a velocity or a force that is off is noticed, in the run and in the reference") {
  const StressReference reference = invented_reference();
  const auto status = [](const std::vector<StressSample>& run, const StressReference& against, bool warned = false) {
    return stress_status(true, deviation_of(run, against, invented_accuracy), warned);
  };
  CHECK(status(run_of(reference), reference) == StressStatus::finished);
  // By twice and by half of what is expected: 1e-4 clearances, 1e-4 V, and 2e-4 units of force.
  for (const double share : {0.5, 2.0}) {
    const StressStatus due = share < 1 ? StressStatus::finished : StressStatus::wrong;
    auto place = run_of(reference);
    place[2].place.x() += share * 1e-4;
    auto rate = run_of(reference);
    rate[3].rate.y() -= share * 1e-4 * 10;
    auto force = run_of(reference);
    force[1].force.x() += share * 2e-4 * 100;
    const auto falsified = [&](auto member, double by) {
      StressReference other = reference;
      (other.rows[1].*member).y() += share * by;
      return other;
    };
    CHECK(status(place, reference) == due);
    CHECK(status(rate, reference) == due);
    CHECK(status(force, reference) == due);
    CHECK(status(run_of(reference), falsified(&ReferencePlace::place, 1e-4)) == due);
    CHECK(status(run_of(reference), falsified(&ReferencePlace::rate, 1e-3)) == due);
    CHECK(status(run_of(reference), falsified(&ReferencePlace::force, 2e-2)) == due);
  }
  auto lost = run_of(reference);
  lost[1].force.x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(status(lost, reference) == StressStatus::wrong);
  CHECK(status(lost, reference, true) == StressStatus::wrong);
}

TEST_CASE("stress: no run without a reference to its end counts as near one") {
  const StressReference reference = invented_reference();
  StressReference none = reference;
  none.rows.clear();
  none.why_none = "no film carries it";
  StressReference cut = reference;
  cut.rows.pop_back();
  cut.why_none = "the two methods part";
  for (const StressReference& each : {none, cut}) {
    const StressDeviation deviation = deviation_of(run_of(reference), each, invented_accuracy);
    CHECK(stress_status(true, deviation, false) == StressStatus::unreferenced);
    CHECK(stress_status(false, deviation, false) == StressStatus::stopped);
    CHECK(deviation.place.has_value() == !each.rows.empty());
  }
  // A run whose samples are not at the reference's times was not compared.
  auto elsewhere = run_of(reference);
  for (StressSample& sample : elsewhere) sample.t += 0.25;
  const StressDeviation deviation = deviation_of(elsewhere, reference, invented_accuracy);
  CHECK(deviation.compared == 0);
  CHECK_FALSE(deviation.place);
  CHECK(stress_status(true, deviation, false) == StressStatus::unreferenced);
}

TEST_CASE("stress: a warning excuses what creep in a film that thin explains, and never a clearance") {
  StressReference reference = invented_reference();
  StressAccuracy thin = invented_accuracy;
  thin.thinnest_film = 1e-3;  // an error of 1e-4 is a tenth of it: a quarter of the way along the wall
  const auto off_by = [&](double distance) {
    auto run = run_of(reference);
    run[3].place.x() += distance;
    return stress_status(true, deviation_of(run, reference, thin), true);
  };
  CHECK(off_by(5e-5) == StressStatus::finished);
  CHECK(off_by(0.1) == StressStatus::coarse);  // the way from the start is 0.71 clearances
  CHECK(off_by(0.3) == StressStatus::wrong);
  thin.thinnest_film = 1e-9;
  CHECK(off_by(0.6) == StressStatus::coarse);
  CHECK(off_by(1.01) == StressStatus::wrong);

  // A rate that is off by more than creep explains is excused by no warning but one that gives up on rates.
  thin.thinnest_film = 0.5;
  auto run = run_of(reference);
  run[3].rate.x() += 100;
  CHECK(stress_status(true, deviation_of(run, reference, thin), true) == StressStatus::wrong);
  thin.no_digit = true;
  CHECK(stress_status(true, deviation_of(run, reference, thin), true) == StressStatus::coarse);
  CHECK(stress_status(true, deviation_of(run, reference, thin), false) == StressStatus::wrong);
}

TEST_CASE("stop: a tolerance wider than the blend of a contact names both, and a tolerance that would do") {
  Scene scene = scene_named("impact-as-shipped");
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 0.026;  // e0/c is 0.025
  check_stop(outcome_of(scene, "pinkus_sternlicht", "dopri5"),
             {"joint \"bearing\" meets its wall", "absolute_tolerance of 0.026", "e0/c = 0.025", "a tenth of e0/c"});
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 0.024;
  CHECK(outcome_of(scene, "pinkus_sternlicht", "dopri5").status == RunStatus::finished);
}

TEST_CASE("stress: a scene without a stored reference runs and counts as unreferenced; changed rows are refused") {
  auto cases = cases_named({"journal-start-centred"});
  StressSettings settings = small_settings();
  settings.integrators = {"radau_iia5"};
  cases.front().scene.bodies.front().mass *= 1 + 1e-15;
  for (const StressCell& cell : run_stress(cases, settings)) {
    CHECK(cell.status == StressStatus::unreferenced);
    CHECK(cell.deviation.compared == 0);
    CHECK_THAT(cell.message, Contains("no reference: none was made for this motion") && Contains("--references"));
  }

  const TemporaryFolder folder;
  StressReferences one;
  one.add(stored_references().of(with_law(scene_named("journal-start-centred"), "short_half")));
  one.write(folder.path());
  CHECK(StressReferences::read(folder.path()).all().size() == 1);
  std::string rows = read_input((folder.path() / reference_motions_name).string());
  const std::size_t digit = rows.find_last_of("123456789");
  rows[digit] = rows[digit] == '1' ? '2' : '1';
  folder.write(reference_motions_name, rows);
  CHECK_THROWS_WITH(StressReferences::read(folder.path()), Contains("checksum") && Contains("short_half"));
}

TEST_CASE("stress: stored references of journals are what another derivation by a third method gives") {
  // The turning frame and Lobatto's method (oracle/mechanisms): neither shares equations with the references' makers.
  std::size_t compared = 0;
  for (const char* name : {"journal-start-centred", "journal-whirl-reversal", "journal-spin-negative",
                           "journal-pure-squeeze-from-centre", "journal-thrown-at-wall", "impact-as-shipped"}) {
    for (const std::string_view law : film_law_names) {
      const Scene scene = with_law(scene_named(name), std::string(law));
      const StressReference reference = stored_references().of(scene);
      INFO(name << ' ' << law << ": " << reference.why_none);
      REQUIRE_FALSE(reference.rows.empty());
      std::vector<double> times;
      for (const ReferencePlace& row : reference.rows) times.push_back(row.t);
      const SecondDerivation second = second_derivation(scene, std::string(law), times);
      double worst = 0;
      for (std::size_t i = 0; i < times.size(); ++i) {
        const Vector2<double> place(second.rows[i][0], second.rows[i][1]);
        worst = std::max(worst, (place - reference.rows[i].place).norm() / (poor_agreement + second.own_error[i]));
      }
      CHECK(worst <= 1);
      ++compared;
    }
  }
  CHECK(compared == 6 * film_law_names.size());
}

namespace {

/// A row of a slider-crank's reference, and what the library's law says of its state.
struct RowForce {
  double off_side = 0;  ///< of the stored force from the law's on the side of a's sign, over the unit of force
  double off_jump = 0;  ///< from that of a = 0, in its radial share and in what it has across more than the law's reach
  bool on_jump = false;  ///< is a 0 to the row's digits?
};

/// With the spin that the closed loop gives: σ c e_y = −A_y − l sinφ, σ = 1 where the bearing is on the rod.
template <FilmLaw Law>
RowForce row_force(const Scene& scene, const StressReference& reference, const ReferencePlace& row) {
  const SceneJoint& joint = scene.joints.front();
  const auto m = mechanism_of<double>(scene);
  const double speed = crank_speed_of(scene);
  const double sign = scene.bodies[joint.bearing.body].name == "rod" ? 1 : -1;
  const double y = m.crank_length * std::sin(speed * row.t);
  const double y_rate = m.crank_length * speed * std::cos(speed * row.t);
  const double sine = (-y - sign * joint.clearance * row.place.y()) / m.rod_length;
  const double spin = (-y_rate - sign * joint.clearance * row.rate.y()) / (m.rod_length * std::sqrt(1 - sine * sine));
  const double ratio = row.place.norm();
  const Vector2<double> r = row.place / ratio;
  const Vector2<double> t(-r.y(), r.x());
  const double a = -2 * (row.rate.dot(t) - spin / 2 * ratio);
  const double b = row.rate.dot(r);
  const double scale = force_scale(Law::limit, Bearing<double>(joint.length, joint.journal_radius, joint.clearance),
                                   Lubricant<double>(joint.viscosity));
  const double radial = row.force.dot(r) / scale;
  const double across = row.force.dot(t) / scale;
  const auto law = [&](double slip, int side) {
    return mechanisms::LibraryFilm<Law>::ratio(ratio, (1 - ratio) * (1 + ratio), slip, b, {side, 1});
  };
  const auto one = law(a, a < 0 ? -1 : 1);
  const auto jump = law(0, 1);
  RowForce found;
  found.off_side = std::hypot(radial - one[0], across - one[1]) * scale / reference.force_unit;
  found.off_jump =
      std::hypot(radial - jump[0], std::max(0.0, std::abs(across) - jump[1])) * scale / reference.force_unit;
  found.on_jump = std::abs(a) < 1e-8 * reference.rate_unit;  // rates are stored to 11 digits
  return found;
}

}  // namespace

TEST_CASE("stress: slider-cranks' stored forces with half films are the law's on one side, or lie in its jump") {
  std::size_t on_jump = 0;
  std::size_t beside = 0;
  std::size_t motions = 0;
  for (const char* name : {"slider-crank-as-shipped", "slider-crank-clearance-2mm", "slider-crank-viscosity-10",
                           "slider-crank-speed-1e5rpm"}) {
    for (const char* law : {"short_half", "long_half", "long_half_eq5"}) {
      const Scene scene = with_law(scene_named(name), law);
      const StressReference reference = stored_references().of(scene);
      INFO(name << ' ' << law << ": " << reference.why_none);
      REQUIRE(reference.whole());
      ++motions;
      for (const ReferencePlace& row : reference.rows) {
        const RowForce found =
            with_film_law(law, [&]<class Law>() -> RowForce { return row_force<Law>(scene, reference, row); });
        INFO("t = " << row.t << ": " << found.off_side << ' ' << found.off_jump);
        // Eleven digits of rates, each of which may move the force by the film's gain.
        const double digits = 1e-10 * (1 + row.force_gain);
        CHECK((found.on_jump ? found.off_jump : found.off_side) <= digits);
        ++(found.on_jump ? on_jump : beside);
      }
    }
  }
  CHECK(motions == 12);
  CHECK(on_jump > 10);  // there are slides
  CHECK(beside > 100);
  // A force that is off by a thousandth of its unit is seen on either kind of row.
  const Scene scene = with_law(scene_named("slider-crank-as-shipped"), "long_half");
  const StressReference reference = stored_references().of(scene);
  for (ReferencePlace row : reference.rows) {
    const Vector2<double> r = row.place / row.place.norm();
    row.force += 1e-3 * reference.force_unit * r;
    const RowForce found = row_force<LongHalf>(scene, reference, row);
    CHECK((found.on_jump ? found.off_jump : found.off_side) > 0.9e-3);
  }
}

TEST_CASE("stress: the motion's key is of all that moves it, and of no tolerance, integrator or name") {
  const Scene scene = scene_named("impact-as-shipped");
  const std::string key = motion_key(scene);
  Scene same = scene;
  same.name = "other";
  same.integrator = "dopri5";
  same.run.relative_tolerance = 1e-3;
  same.run.max_steps = 1;
  CHECK(motion_key(same) == key);
  const std::function<void(Scene&)> changes[] = {[](Scene& s) { s.bodies[0].velocity.x() += 1e-9; },
                                                 [](Scene& s) { s.joints[0].film = "long_full"; },
                                                 [](Scene& s) { s.joints[0].contact->restitution = 0.5; },
                                                 [](Scene& s) { s.joints[0].transition->e0 /= 2; },
                                                 [](Scene& s) { s.gravity.y() = 0; },
                                                 [](Scene& s) { s.run.output_interval /= 2; }};
  for (const auto& change : changes) {
    Scene other = scene;
    change(other);
    CHECK(motion_key(other) != key);
  }
}

TEST_CASE("stress: the README's sentence and the stored table say the same, and name who measured") {
  const std::string name = (measured / "stress.csv").string();
  const std::vector<StressCell> cells = read_stress_cells(CsvTable(read_input(name), name));
  std::string readme = read_input(std::string(LUBJOINT_SOURCE_DIR) + "/README.md");
  std::replace(readme.begin(), readme.end(), '\n', ' ');
  CHECK_THAT(readme, Contains(stress_sentence(cells)));
  for (const StressCell& cell : cells) {
    INFO(cell.scenario << ' ' << cell.law << ' ' << cell.integrator);
    CHECK(cell.status != StressStatus::wrong);
    CHECK_FALSE(cell.program.empty());
    if (cell.status != StressStatus::finished) continue;
    CHECK(cell.deviation.compared == 50);
    CHECK(cell.deviation.over_expected <= 1);
  }
  CHECK_THAT(stress_table({}, cells), Contains("measured by " + cells.front().program));
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
    CHECK(cell.deviation.place.value_or(1) < 1e-5);  // ten tolerances
    CHECK_THAT(cell.message, Contains("thinnest film"));
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
  for (StressCell& cell : so_far) cell.seconds = 1234;
  settings.resume_file =
      folder.write("stress.part", KeptRows::first_line(stress_key(cases, settings)) + stress_csv(so_far));
  const auto resumed = run_stress(cases, settings);
  REQUIRE(resumed.size() == whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    CHECK(same_but_for_time(whole[i], alone[i]));
    CHECK(same_but_for_time(whole[i], resumed[i]));
    CHECK((resumed[i].seconds == 1234) == (i < 8));
  }
  CHECK(KeptRows(settings.resume_file, stress_key(cases, settings), "").earlier()->rows() ==
        18);  // until it is discarded
  discard_kept_rows(settings.resume_file);
  CHECK(folder.entries().empty());  // nothing is left to resume

  // Rows of another campaign are left aside.
  settings.resume_file = folder.write("stress.part", "# another\n" + stress_csv(so_far));
  CHECK(run_stress(cases, settings).front().seconds < 1234);
}

TEST_CASE("stress: the CSV has a row a cell, and names what was run, how it ended, its errors and its program") {
  const auto cases = cases_named({"journal-step-limit"});
  const CsvTable table(stress_csv(run_stress(cases, small_settings())), "stress.csv");
  CHECK(table.header() ==
        "case,law,integrator,status,error,rate_error,force_error,over_expected,compared,seconds,steps,program,message");
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

TEST_CASE("stress: a half film between moving parts runs to its end where its journal's spin reverses") {
  const RunOutcome outcome = outcome_of(scene_named("journal-spin-reversal"), "short_half", "dopri5");
  INFO(outcome.message);
  CHECK(outcome.status == RunStatus::finished);
}

TEST_CASE("stop: reasons are counted by kind, whatever the numbers in them") {
  CHECK(stop_kind("stopped at t = 0.5 s: joint \"b\" is at eccentricity ratio 0.3; radau_iia5 needs 1e-3") ==
        "joint \"b\" is at eccentricity ratio #; radau_iia5 needs #");
}

}  // namespace stress_test

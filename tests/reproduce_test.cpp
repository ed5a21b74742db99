// What `reproduce` judges: each check passes on what is right, and says no to what has been falsified.
#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "oracle/laws/law_check.hpp"
#include "oracle/paper/example_1.hpp"
#include "oracle/paper/journal_checks.hpp"
#include "oracle/paper/slider_crank_checks.hpp"

namespace reproduce_test {

using namespace lubjoint;
using namespace lubjoint::reports;
using Catch::Matchers::Contains;

namespace {

const std::string scenes = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/";

Scene journal_with(std::string_view law, double duration = 0.1) {
  Scene scene = load_scene(scenes + "journal.toml");
  scene.joints.front().film = law;
  scene.run.duration = duration;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-12;
  return scene;
}

JournalTrajectory by(Scene scene, const std::string& integrator) {
  scene.integrator = integrator;
  return simulate_journal(scene);
}

/// What the failed checks judge, in order.
std::vector<std::string> failed(const std::vector<Check>& checks) {
  std::vector<std::string> whats;
  for (const Check& check : checks) {
    if (check.outcome == CheckOutcome::failed) whats.push_back(check.what);
  }
  return whats;
}

using Names = std::vector<std::string>;

/// Samples of e^{αt} (cos βt, ¾ sin βt) about a point, with their rates.
std::vector<JournalSample> spiral(std::complex<double> lambda, double size, double duration,
                                  const Vector2<double>& centre) {
  std::vector<JournalSample> samples;
  const double step = 0.02 / std::abs(lambda.imag());
  for (double t = 0; t < duration; t += step) {
    const std::complex<double> z = size * std::exp(lambda * t);
    const std::complex<double> rate = lambda * z;
    samples.push_back({t,
                       {centre.x() + z.real(), centre.y() + 0.75 * z.imag(), rate.real(), 0.75 * rate.imag()},
                       Vector2<double>(0, 0)});
  }
  return samples;
}

const Vector2<double> centre(0.1, -0.2);

}  // namespace

TEST_CASE("check: a limit is kept or not, what is not a number fails, and what was not checked agrees with nothing") {
  const auto at = [](double value) { return Check::at_most("x", "y", value, 1e-3, "c", "why").outcome; };
  CHECK(at(1e-3) == CheckOutcome::passed);
  CHECK(at(-1e-3) == CheckOutcome::passed);
  CHECK(at(1.001e-3) == CheckOutcome::failed);
  CHECK(at(-1) == CheckOutcome::failed);
  CHECK(at(std::nan("")) == CheckOutcome::failed);
  CHECK(at(INFINITY) == CheckOutcome::failed);
  const Check good = Check::at_most("x", "y", 0, 1, "", "why");
  const Check bad = Check::at_most("x", "y", 2, 1, "c", "why");
  const Check none = Check::not_checked("x", "no such thing");
  CHECK(Verdict{{good, none}}.agrees());
  CHECK(Verdict{{good, none}}.in_letters() == "yes A–");
  CHECK_FALSE(Verdict{{none}}.agrees());
  CHECK_FALSE(Verdict{{none}}.failed());
  CHECK(Verdict{{none}}.in_letters() == "–");
  CHECK(Verdict{{none}}.in_a_word() == "-");
  CHECK_FALSE(Verdict{}.agrees());
  CHECK_FALSE(Verdict{{good, bad}}.agrees());
  CHECK(Verdict{{good, bad}}.in_letters() == "NO: B x: 2.0e+00 c, allowed 1e+00;");
  CHECK(Verdict{{good, bad}}.in_a_word() == "no");
}

TEST_CASE("check: the legend names every check with what it is held against, its worst case, its limit and why") {
  const Verdict one{{Check::at_most("path", "the other path", 1e-5, 1e-3, "c", "rounding"),
                     Check::not_checked("sliding", "no jump")}};
  const Verdict two{{Check::at_most("path", "the other path", -3e-5, 1e-3, "c", "rounding"),
                     Check::holds("sliding", "the other, too", false, "it does not", "as many times")}};
  const auto lines = summary_of_checks({&one, &two});
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].largest == "3.0e-05 c");
  CHECK(lines[0].allowed == "1e-03 c");
  CHECK(lines[0].passed == 2);
  CHECK(lines[1].failed == 1);
  CHECK(lines[1].not_checked == 1);
  CHECK_THAT(check_legend({&one, &two}),
             Contains("A  path, against the other path: at most 3.0e-05 c; allowed 1e-03 c, "
                      "rounding\n") &&
                 Contains("(not checked for 1 of 2)"));
  CHECK_THAT(check_legend({&one}), Contains("B  sliding: no jump\n"));
  const Verdict other{{Check::not_checked("path", "none")}};
  CHECK_THROWS_AS(summary_of_checks({&one, &other}), std::logic_error);
  CHECK_THAT(checks_csv({"a", "b"}, {&one, &two}),
             Contains("b,B,sliding,failed,,,,it does not,\"the other, too\",as many times\n"));
}

TEST_CASE("two integrators: every quantity, peak and time that is off is named, and nothing else") {
  const Scene scene = journal_with("long_half");
  const JournalTrajectory run = by(scene, "radau_iia5");
  const JournalTrajectory other = by(scene, "fehlberg78");
  const auto compare = [&](const auto& falsify) {
    JournalTrajectory false_run = run;
    falsify(false_run);
    return failed(compare_runs(scene, false_run, other, "another"));
  };
  CHECK(compare([](JournalTrajectory&) {}).empty());
  REQUIRE(run.sliding.size() == 1);
  const auto radially = [](JournalSample& s, double by) {
    const double e = s.eccentricity_ratio();
    const double x = s.state[0] / e;
    const double y = s.state[1] / e;
    s.state[0] += by * x;
    s.state[1] += by * y;
  };
  CHECK(compare([&](JournalTrajectory& r) { radially(r.samples[50], 2e-8); }) == Names{"e/c", "film thickness"});
  CHECK(compare([](JournalTrajectory& r) { r.samples[50].state[3] += 1e-4; }) == Names{"velocity"});
  CHECK(compare([](JournalTrajectory& r) { r.samples[7].force.x() += 1e-4; }) == Names{"force"});
  CHECK(compare([](JournalTrajectory& r) { r.samples[7].force.x() = std::nan(""); }) == Names{"force"});
  CHECK(compare([](JournalTrajectory& r) { r.max_eccentricity_ratio += 2e-8; }) == Names{"largest e/c"});
  CHECK(compare([](JournalTrajectory& r) { r.min_film_thickness *= 1.001; }) == Names{"least film"});
  CHECK(compare([](JournalTrajectory& r) { r.t_max_eccentricity_ratio += 1e-5; }) == Names{"time of both"});
  CHECK(compare([](JournalTrajectory& r) { r.max_force *= 1 + 1e-5; }) == Names{"largest force"});
  CHECK(compare([](JournalTrajectory& r) { r.t_max_force += 1e-3; }) == Names{"time of it"});
  CHECK(compare([](JournalTrajectory& r) { r.sliding[0].end += 1e-7; }) == Names{"sliding"});
  CHECK(compare([](JournalTrajectory& r) { r.sliding.clear(); }) == Names{"sliding"});
  CHECK(compare([](JournalTrajectory& r) { r.outcome.status = RunStatus::stopped; }) == Names{"runs"});
  CHECK(compare([](JournalTrajectory& r) { r.samples.pop_back(); }) ==
        Names{"e/c", "velocity", "force", "film thickness"});
  // A run with a hundredth more viscosity is another motion altogether.
  Scene thicker = scene;
  thicker.joints[0].viscosity *= 1.01;
  CHECK(failed(compare_runs(scene, by(thicker, "radau_iia5"), other, "another")).size() >= 8);
}

TEST_CASE("force of each sample: the quadrature says no to a force that is off by 1e-12, turned, or another law's") {
  for (const std::string_view law : film_law_names) {
    INFO(law);
    const Scene scene = journal_with(law);
    const JournalTrajectory run = by(scene, "radau_iia5");
    CHECK(sampled_force_check(scene, run).outcome == CheckOutcome::passed);
    JournalTrajectory off = run;
    off.samples.back().force *= 1 + 1e-12;
    CHECK(sampled_force_check(scene, off).outcome == CheckOutcome::failed);
    off.samples.back().force = -run.samples.back().force;
    CHECK(sampled_force_check(scene, off).outcome == CheckOutcome::failed);
    const bool full = law == "short_full";
    CHECK(sampled_force_check(journal_with(full ? "long_full" : "short_full"), run).outcome == CheckOutcome::failed);
    off.samples.clear();
    CHECK(sampled_force_check(scene, off).outcome == CheckOutcome::failed);
  }
}

TEST_CASE("equilibrium: the pressure's quadrature says no to an equilibrium that is 1e-10 c off") {
  for (const std::string_view law : film_law_names) {
    INFO(law);
    const Scene scene = journal_with(law);
    JournalEquilibrium rest = journal_equilibrium(scene);
    CHECK(equilibrium_check(scene, rest).outcome == CheckOutcome::passed);
    rest.eccentricity.x() += 1e-10;
    CHECK(equilibrium_check(scene, rest).outcome == CheckOutcome::failed);
  }
}

TEST_CASE("rate of a motion: that of a spiral, from any direction; none where it does not come round") {
  for (const double growth : {-10.0, -0.5, 1e-3, 2.0}) {
    INFO(growth);
    const std::complex<double> lambda(growth, 25);
    const auto samples = spiral(lambda, 1e-3, 2, centre);
    const auto motion = rate_of_motion(samples, centre, 2e-3, 1e-12);
    REQUIRE(motion);
    CHECK(std::abs(motion->rate / growth - 1) < 1e-4);     // cubics over 1/50 radian: 1e-8 of the distance in a turn
    CHECK(std::abs(motion->frequency / 25 - 1) < 1e-7);    // the same
    CHECK(motion->most_rate - motion->least_rate < 1e-5);  // the same
    CHECK(motion->turns == 7);
    CHECK(failed(rate_checks(motion, lambda)).empty());
    CHECK(failed(rate_checks(motion, {growth * 1.002, 25})) == Names{"growth or decay"});
    CHECK(failed(rate_checks(motion, {-growth, 25})) == Names{"growth or decay"});
    CHECK(failed(rate_checks(motion, {growth, 25.05})) == Names{"frequency"});
  }
  const auto half_a_turn = spiral({-1, 25}, 1e-3, 0.12, centre);
  CHECK_FALSE(rate_of_motion(half_a_turn, centre, 2e-3, 1e-12));
  CHECK(failed(rate_checks({}, {-1, 25})) == Names{"growth or decay", "frequency"});
  CHECK(rate_checks({}, {-1, 0})[0].outcome == CheckOutcome::not_checked);
  CHECK_FALSE(rate_of_motion(spiral({-1, 25}, 1e-3, 2, centre), centre, 1e-9, 1e-12));  // never that near
}

TEST_CASE("rate near the equilibrium: of every law the eigenvalue's within 0.1 %, not that of other data") {
  for (const std::string_view law : film_law_names) {
    INFO(law);
    const Scene scene = journal_with(law);
    const JournalEquilibrium rest = journal_equilibrium(scene);
    const bool full = law.ends_with("full");
    const auto run = simulate_journal(displaced_from(scene, rest));
    const Vector2<double> first(run.samples[0].state[0], run.samples[0].state[1]);
    CHECK(std::abs((first - rest.eccentricity).norm() - 1e-3) < 1e-15);  // rounding
    const auto motion = rate_of_motion(run.samples, rest.eccentricity, full ? 2e-3 : 1e-4, 1e-8);
    CHECK(failed(rate_checks(motion, rest.eigenvalues[0])).empty());
    Scene thicker = scene;
    thicker.joints[0].viscosity *= 1.01;
    CHECK_FALSE(failed(rate_checks(motion, journal_equilibrium(thicker).eigenvalues[0])).empty());
  }
}

TEST_CASE("circling is tested as circling, resting as resting, and what does neither is told so") {
  CHECK(behaviour_of(spiral({1e-3, 25}, 0.05, 3, centre), centre) == Behaviour::circles);
  CHECK(behaviour_of(spiral({-10, 25}, 0.05, 3, centre), centre) == Behaviour::rests);
  CHECK(behaviour_of(spiral({-0.1, 25}, 0.05, 3, centre), centre) == Behaviour::neither);    // shrinks by a quarter
  CHECK(behaviour_of(spiral({0.02, 25}, 0.05, 3, centre), centre) == Behaviour::neither);    // grows by 6 %
  CHECK(behaviour_of(spiral({1e-3, 25}, 0.05, 0.6, centre), centre) == Behaviour::neither);  // two turns
  // Nor is it circling to go round a point that is not inside, to swing on a line, or to turn back.
  CHECK(behaviour_of(spiral({1e-3, 25}, 0.05, 3, centre), Vector2<double>(0.3, 0.3)) == Behaviour::neither);
  auto swing = spiral({1e-3, 25}, 0.05, 3, centre);
  for (JournalSample& s : swing) s.state[1] = centre.y() + 1e-3 * (s.state[0] - centre.x());
  CHECK(behaviour_of(swing, centre) == Behaviour::neither);
  auto back = spiral({1e-3, 25}, 0.05, 3, centre);
  std::reverse(back.begin() + static_cast<long>(back.size() / 2), back.end());
  for (std::size_t i = 0; i < back.size(); ++i) back[i].t = 0.02 / 25 * static_cast<double>(i);
  CHECK(behaviour_of(back, centre) == Behaviour::neither);
  auto leaves = spiral({-10, 25}, 0.05, 3, centre);
  leaves.back().state[0] += 1e-3;  // at rest, and then no more
  CHECK(behaviour_of(leaves, centre) == Behaviour::neither);
  CHECK(behaviour_of({}, centre) == Behaviour::neither);
  for (JournalSample& s : swing) s.state = {centre.x(), centre.y(), 0, 0};
  CHECK(behaviour_of(swing, centre) == Behaviour::rests);
}

TEST_CASE("what the orbit does is held against the eigenvalue and the paper, and either can say no") {
  const auto outcome = [](Behaviour found, std::complex<double> eigenvalue) {
    return behaviour_check(found, eigenvalue, 3).outcome;
  };
  CHECK(outcome(Behaviour::rests, {-5, 25}) == CheckOutcome::passed);
  CHECK(outcome(Behaviour::circles, {-5, 25}) == CheckOutcome::failed);
  CHECK(outcome(Behaviour::neither, {-5, 25}) == CheckOutcome::failed);
  CHECK(outcome(Behaviour::circles, {1e-3, 25}) == CheckOutcome::passed);
  CHECK(outcome(Behaviour::rests, {1e-3, 25}) == CheckOutcome::failed);
  CHECK(outcome(Behaviour::neither, {-1e-3, 25}) == CheckOutcome::failed);
  CHECK(outcome(Behaviour::neither, {-1, 25}) == CheckOutcome::not_checked);  // between the two
  CHECK(paper_check(Behaviour::rests, "rests").outcome == CheckOutcome::passed);
  CHECK(paper_check(Behaviour::circles, "rests").outcome == CheckOutcome::failed);
  CHECK(paper_check(Behaviour::neither, "circles").outcome == CheckOutcome::failed);
  CHECK(paper_check(Behaviour::rests, "-").outcome == CheckOutcome::not_checked);
}

namespace {

Scene slider_crank(double tolerance) {
  Scene scene = load_scene(scenes + "slider-crank.toml");
  scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
  scene.run.output_interval = 0.012 / 720;
  scene.run.duration = 0.012;  // one revolution
  scene.energy_ledger = true;
  return scene;
}

std::vector<double> times_of(const MultibodyTrajectory& run) {
  std::vector<double> times;
  for (const MultibodySample& sample : run.samples) times.push_back(sample.t);
  return times;
}

}  // namespace

TEST_CASE("minimal coordinates say no to every force, moment, film, peak and time that is off, and to nothing else") {
  const Scene scene = slider_crank(1e-10);
  const MultibodyTrajectory run = simulate_multibody(scene);
  const ReferenceRun reference = minimal_coordinates_run_with_peaks(scene, times_of(run), 1e-12);
  const auto compare = [&](const auto& falsify) {
    MultibodyTrajectory false_run = run;
    falsify(false_run);
    return failed(compare_with_minimal_coordinates(scene, false_run, reference));
  };
  using Run = MultibodyTrajectory;
  CHECK(compare([](Run&) {}).empty());
  const double c = scene.joints[0].clearance;
  CHECK(compare([&](Run& r) { r.samples[99].joints[0].eccentricity.x() += 2e-8 * c; }) == Names{"e/c"});
  CHECK(compare([](Run& r) { r.samples[99].joints[0].force.y() += 0.1; }) == Names{"joint force"});
  CHECK(compare([](Run& r) { r.samples[99].driving_moments[0] *= -1; }) == Names{"driving moment"});
  CHECK(compare([](Run& r) { r.samples[99].driving_moments[0] = std::nan(""); }) == Names{"driving moment"});
  CHECK(compare([](Run& r) { r.samples[99].joints[0].film_thickness *= 1 + 1e-6; }) == Names{"film thickness"});
  CHECK(compare([](Run& r) { r.joints[0].eccentricity.value *= 1 + 1e-6; }) == Names{"least film"});
  CHECK(compare([](Run& r) { r.joints[0].force.value *= 1 + 1e-5; }) == Names{"largest force"});
  CHECK(compare([](Run& r) { r.drivers[0].min_moment.value *= 1 + 1e-5; }) == Names{"moment's extremes"});
  CHECK(compare([](Run& r) { r.joints[0].force.t += 1e-5; }) == Names{"times of these"});
  CHECK(compare([](Run& r) { r.drivers[0].max_moment.t += 1e-5; }) == Names{"times of these"});
  CHECK(compare([](Run& r) { r.outcome.status = RunStatus::stopped; }) == Names{"run"});
  CHECK(compare([](Run& r) { r.samples.pop_back(); }) ==
        Names{"e/c", "joint force", "driving moment", "film thickness"});
  Scene thicker = scene;
  thicker.joints[0].viscosity *= 1.001;
  const ReferenceRun wrong = minimal_coordinates_run_with_peaks(thicker, times_of(run), 1e-12);
  CHECK(failed(compare_with_minimal_coordinates(scene, run, wrong)).size() >= 5);
  // With the bearing on the other body the motion differs by 3e-4 c: the check knows one from the other.
  Scene swapped = scene;
  std::swap(swapped.joints[0].bearing, swapped.joints[0].journal);
  const MultibodyTrajectory other = simulate_multibody(swapped);
  const ReferenceRun of_swapped = minimal_coordinates_run_with_peaks(swapped, times_of(other), 1e-10);
  CHECK(swapped_check(swapped, other, of_swapped).outcome == CheckOutcome::passed);
  CHECK(swapped_check(swapped, other, reference).outcome == CheckOutcome::failed);
}

TEST_CASE("peaks in minimal coordinates lie above their samples, between the neighbours of one of them") {
  const Scene scene = slider_crank(1e-8);
  std::vector<double> times;
  for (int i = 0; i <= 90; ++i) times.push_back(0.012 * i / 90);
  const ReferenceRun coarse = minimal_coordinates_run_with_peaks(scene, times, 1e-12);
  times.clear();
  for (int i = 0; i <= 1000; ++i) times.push_back(0.012 * i / 1000);
  const ReferenceRun fine = minimal_coordinates_run_with_peaks(scene, times, 1e-12);
  const auto same = [](const Peak& one, const Peak& other) {
    CHECK(std::abs(one.value / other.value - 1) < 1e-10);  // the integration's 1e-12, some hundred steps
    CHECK(std::abs(one.t - other.t) < 1e-7);               // Brent's 24 bits of a peak that is flat
  };
  same(coarse.peaks.eccentricity_ratio, fine.peaks.eccentricity_ratio);
  same(coarse.peaks.force, fine.peaks.force);
  same(coarse.peaks.max_moment, fine.peaks.max_moment);
  same(coarse.peaks.min_moment, fine.peaks.min_moment);
  for (const ReferenceSample& sample : fine.samples) {
    CHECK(sample.force.norm() <= fine.peaks.force.value);
    CHECK(sample.driving_moment >= fine.peaks.min_moment.value);
  }
}

TEST_CASE("energy: an open ledger and a run that stopped are no, a run without ledger is not checked") {
  MultibodyTrajectory run;
  CHECK(energy_check(run, 1e-10).outcome == CheckOutcome::not_checked);
  run.energy_scale = 20;
  run.energy_residual = 1e-7;
  CHECK(energy_check(run, 1e-10).outcome == CheckOutcome::passed);
  run.energy_residual = 1e-6;
  CHECK(energy_check(run, 1e-10).outcome == CheckOutcome::failed);
  run.energy_residual = 0;
  run.outcome.status = RunStatus::stopped;
  CHECK(energy_check(run, 1e-10).outcome == CheckOutcome::failed);
}

TEST_CASE("force laws: a verdict lists quadrature and formula, and either can say no") {
  LawCheck law;
  law.law = "some";
  law.allowed = 1e-13;
  law.rounding = 1e-15;
  CHECK(law.verdict().in_letters() == "yes –B");
  law.quadrature = LawCheck::Quadrature{1e-16, 1e-15, 0.5};
  CHECK(law.verdict().in_letters() == "yes AB");
  law.quadrature->largest = 1e-12;
  CHECK_FALSE(law.agrees());
  law.quadrature->largest = 1e-15;
  law.rounding = std::nan("");
  CHECK_FALSE(law.agrees());
}

}  // namespace reproduce_test

#include "support/journal_cases.hpp"

namespace journal_run_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;

namespace {

RunSettings one_second() { return {.duration = 1, .relative_tolerance = 1e-9, .absolute_tolerance = 1e-9}; }

}  // namespace

TEST_CASE("journal of Table 1, Pinkus and Sternlicht: the film ends up carrying 31.2753 N, straight up") {
  const auto run = run_journal(journal_of_table_1<PinkusSternlicht>(), one_second());
  CHECK(run.outcome.status == RunStatus::finished);
  CHECK(run.outcome.message.empty());
  CHECK(run.outcome.t_end == 1);
  CHECK(run.last().t == 1);
  CHECK(run.last().force.y() == Approx(31.2753).margin(1e-5));  // the promise, for a rest that 1 s reaches
  CHECK(run.last().force.x() == Approx(0).margin(1e-5));        // the same
  CHECK(run.recorder.max_eccentricity_ratio() == Approx(0.258).margin(5e-4));  // three digits quoted
  CHECK(run.recorder.samples().size() == 1001);
  CHECK(run.recorder.sliding().empty());
}

TEST_CASE("journal of Table 1: the two steppers of the Pinkus–Sternlicht run agree, implicit and explicit") {
  RunSettings settings = one_second();
  settings.duration = 0.02;
  const auto journal = journal_of_table_1<PinkusSternlicht>();
  const auto implicit = run_journal(journal, settings);
  const auto explicit_run = run_journal<PinkusSternlicht>(journal, settings, "fehlberg78");
  REQUIRE(implicit.recorder.samples().size() == explicit_run.recorder.samples().size());
  for (std::size_t i = 0; i < implicit.recorder.samples().size(); ++i) {
    const JournalSample& x = implicit.recorder.samples()[i];
    const JournalSample& y = explicit_run.recorder.samples()[i];
    CHECK(x.t == y.t);
    const double apart = std::hypot(x.state[0] - y.state[0], x.state[1] - y.state[1]);
    // Samples inside Radau's steps are of order 3, to the tolerance of the embedded estimate, 0.1 (1e-9)^{2/3}.
    CHECK(apart < 1e-6);
  }
  const JournalSample& x = implicit.last();
  const JournalSample& y = explicit_run.last();
  CHECK(std::hypot(x.state[0] - y.state[0], x.state[1] - y.state[1]) < 1e-8);           // ten times the tolerance
  CHECK(explicit_run.outcome.rhs_evaluations > 10 * implicit.outcome.rhs_evaluations);  // the journal is stiff
}

TEST_CASE("journal of Table 1, full films: they circle, and their largest ε is 0.1187 and 0.1667") {
  const auto short_run = run_journal(journal_of_table_1<ShortFull>(), one_second());
  const auto long_run = run_journal(journal_of_table_1<LongFull>(), one_second());
  CHECK(short_run.outcome.status == RunStatus::finished);
  CHECK(long_run.outcome.status == RunStatus::finished);
  CHECK(short_run.recorder.max_eccentricity_ratio() == Approx(0.1187).margin(5e-5));  // four digits quoted
  CHECK(long_run.recorder.max_eccentricity_ratio() == Approx(0.1667).margin(5e-5));   // the same
  for (const auto* run : {&short_run, &long_run}) {  // no rest: after a second the orbit still comes by the centre
    double nearest = 1;
    for (const JournalSample& sample : run->recorder.samples()) {
      if (sample.t > 0.75) nearest = std::min(nearest, sample.eccentricity_ratio());
    }
    CHECK(nearest < 0.1 * run->recorder.max_eccentricity_ratio());
  }
}

TEST_CASE("a load that no film can carry stops the run before ε = 1, with time, joint, ε and a way out") {
  const auto run = run_journal(journal_of_table_1<ShortFull>(1e25), one_second());
  CHECK(run.outcome.status == RunStatus::stopped);
  CHECK(run.outcome.t_end > 0);
  CHECK(run.outcome.t_end < 1);
  CHECK_THAT(run.outcome.message, Contains("t = ") && Contains("joint \"bearing\"") && Contains("eccentricity ratio") &&
                                      Contains("viscosity"));
  CHECK(run.outcome.rejected_steps > 0);  // trial steps beyond the wall
  CHECK(run.last().eccentricity_ratio() > 0.99);
  CHECK(run.last().t == run.outcome.t_end);  // the results so far are there
}

TEST_CASE("trial steps beyond the wall are rejected by both kinds of stepper, and the run goes on") {
  // 2e8 N press the journal to ε = 0.9993 in two milliseconds: steps that grew in the middle overshoot the wall.
  RunSettings settings{.duration = 2e-3, .relative_tolerance = 1e-4, .absolute_tolerance = 1e-4};
  const auto implicit = run_journal(journal_of_table_1<ShortFull>(2e8), settings);
  CHECK(implicit.outcome.rejected_steps > 0);
  CHECK(implicit.outcome.status == RunStatus::finished);
  CHECK(implicit.recorder.max_eccentricity_ratio() < 1);
  CHECK(implicit.recorder.max_eccentricity_ratio() > 0.9);
  settings.duration = 2e-5;  // and 2e6 N
  const auto explicit_run = run_journal(journal_of_table_1<ShortFull>(2e6), settings, "fehlberg78");
  CHECK(explicit_run.outcome.rejected_steps > 0);
  CHECK(explicit_run.recorder.max_eccentricity_ratio() < 1);
}

TEST_CASE("a half film that leaves its jump and meets it again within one step does not hold up the run") {
  RunSettings settings = one_second();
  settings.duration = 0.1;
  for (const char* method : {"dopri5", "fehlberg78", "bulirsch_stoer"}) {  // by steps far too long
    settings.relative_tolerance = settings.absolute_tolerance = 0.1;
    CHECK(run_journal(journal_of_table_1<LongHalf>(), settings, method).outcome.status == RunStatus::finished);
    // From the centre the first step reaches the wall.
    settings.relative_tolerance = settings.absolute_tolerance = 1e-6;
    const auto heavy = run_journal(journal_of_table_1<ShortHalf>(1e13), settings, method);
    CHECK(heavy.outcome.t_end > 0);
    CHECK_THAT(heavy.outcome.message, !Contains("jump"));
  }
}

TEST_CASE("a half film that a loose step brings beyond its jump is on the side on which it is") {
  RunSettings settings = one_second();
  settings.duration = 0.1;
  settings.relative_tolerance = settings.absolute_tolerance = 0.1;
  const auto loose = run_journal(journal_of_table_1<LongHalfEq5>(), settings, "bulirsch_stoer");
  CHECK(loose.outcome.status == RunStatus::finished);
}

TEST_CASE("near the wall no half film is said to stop for its jump: it is the thin film that stops it") {
  RunSettings settings = one_second();
  settings.relative_tolerance = settings.absolute_tolerance = 1e-6;
  settings.max_steps = 20000;
  for (const double gap : {1e-12, 3e-13, 1e-14}) {
    for (const char* method : {"radau_iia5", "rosenbrock4"}) {
      JournalRun<ShortHalf> run(journal_of_table_1<ShortHalf>(), "bearing", method, settings);
      const RunOutcome outcome = run.run({1 - gap, 0, 0, 0});
      CHECK(outcome.status == RunStatus::stopped);
      CHECK_THAT(outcome.message, !Contains("jump") && (Contains("raise the clearance") ||
                                                        Contains("raise the viscosity or lower the load")));
    }
  }
}

TEST_CASE("a run that uses up its steps stops with the limit, the time, the joint and ε") {
  RunSettings settings = one_second();
  settings.max_steps = 7;
  const auto run = run_journal(journal_of_table_1<PinkusSternlicht>(), settings);
  CHECK(run.outcome.status == RunStatus::stopped);
  CHECK(run.outcome.steps + run.outcome.rejected_steps == 7);
  CHECK_THAT(run.outcome.message,
             Contains("limit of 7 steps") && Contains("joint \"bearing\"") && Contains("eccentricity ratio"));
  CHECK(run.last().t == run.outcome.t_end);
}

}  // namespace journal_run_test

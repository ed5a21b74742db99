#include "support/journal_cases.hpp"

namespace sliding_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

constexpr double tolerance = 1e-9;

RunSettings lasting(double duration) {
  return {.duration = duration,
          .relative_tolerance = tolerance,
          .absolute_tolerance = tolerance,
          .output_interval = duration / 1000};
}

/// While a run slides: a = 0, and the film's tangential force lies inside the jump of its law.
template <PolarLaw Law>
void check_sliding(const FreeJournal<Law>& journal, const JournalRecorder& recorder) {
  int checked = 0;
  for (const JournalSample& sample : recorder.samples()) {
    for (const SlidingInterval& slide : recorder.sliding()) {
      // A sample at the end of a slide belongs to what follows.
      if (sample.t <= slide.start || sample.t >= slide.end) continue;
      const FilmState<double> film = journal.film(sample.state);
      const Vector2<double> r = direction(film.eccentricity);
      const double a = -2 * cross(r, film.velocity);
      INFO(Law::name << ", t " << sample.t);
      CHECK(std::abs(a) <= 1e-12 * film.velocity.norm());  // rounding of u, made of two terms 100 times its size
      const double tangential = dot(sample.force, perpendicular(r));
      const double above = dot(journal.joint().force(film, HalfFilmSide::converging), perpendicular(r));
      const double below = dot(journal.joint().force(film, HalfFilmSide::mirrored), perpendicular(r));
      CHECK(tangential <= std::max(above, below) * (1 + 1e-9));  // rounding; located to the tolerance at the end
      CHECK(tangential >= std::min(above, below) * (1 + 1e-9));  // the same, below zero
      const double radial = dot(sample.force, r);
      const double of_law = dot(journal.joint().force(film, HalfFilmSide::converging), r);
      CHECK(std::abs(radial - of_law) <= 1e-9 * sample.force.norm());  // both sides have the same radial force
      ++checked;
    }
  }
  CHECK(checked > 10);
}

}  // namespace

TEST_CASE("journal of Table 1, long half film: it slides on a = 0 from about 5e-5 s to 0.0276 s, and ε reaches 0.535") {
  const auto journal = journal_of_table_1<LongHalf>();
  const auto run = run_journal(journal, lasting(0.25));
  CHECK(run.outcome.status == RunStatus::finished);
  REQUIRE(run.recorder.sliding().size() == 1);
  const SlidingInterval slide = run.recorder.sliding().front();
  CHECK(slide.start > 1e-5);                                                   // "about 5e-5 s"
  CHECK(slide.start < 1e-4);                                                   // the same
  CHECK(slide.end == Approx(0.0276).margin(5e-5));                             // three digits quoted
  CHECK(run.recorder.max_eccentricity_ratio() == Approx(0.535).margin(5e-4));  // the same
  CHECK(run.outcome.steps < 2000);  // a hundred times less than without the mode
  check_sliding(journal, run.recorder);
}

TEST_CASE("journal of Table 1, half film of eq. 5: it slides from the start to 0.0322 s, and ε reaches 0.190") {
  const auto journal = journal_of_table_1<LongHalfEq5>();
  const auto run = run_journal(journal, lasting(0.25));
  CHECK(run.outcome.status == RunStatus::finished);
  REQUIRE(run.recorder.sliding().size() == 1);
  CHECK(run.recorder.sliding().front().start == 0);
  CHECK(run.recorder.sliding().front().end == Approx(0.0322).margin(5e-5));    // three digits quoted
  CHECK(run.recorder.max_eccentricity_ratio() == Approx(0.190).margin(5e-4));  // the same
  check_sliding(journal, run.recorder);
}

TEST_CASE("journal of Table 1, short half film: no sliding, ε reaches 0.1821, rest at 0.1174 under 31.2753 N") {
  const auto journal = journal_of_table_1<ShortHalf>();
  const auto run = run_journal(journal, lasting(3));
  CHECK(run.outcome.status == RunStatus::finished);
  CHECK(run.recorder.sliding().empty());
  CHECK(run.recorder.max_eccentricity_ratio() == Approx(0.1821).margin(5e-5));  // four digits quoted
  CHECK(run.last().eccentricity_ratio() == Approx(0.1174).margin(5e-5));        // the same
  CHECK(run.last().force.y() == Approx(31.2753).margin(1e-5));  // what is left of the slowest mode, and the tolerance
  CHECK(run.last().force.x() == Approx(0).margin(1e-5));        // the same
}

TEST_CASE("sliding: the film is on a = 0 although an instant beside it the law pushes back from both sides") {
  const auto journal = journal_of_table_1<LongHalf>();
  const auto run = run_journal(journal, lasting(0.02));
  const JournalSample& inside = run.last();  // still sliding at 0.02 s
  REQUIRE(run.recorder.sliding().back().end == 0.02);
  const Vector2<double> t = perpendicular(direction(journal.film(inside.state).eccentricity));
  const auto acceleration_across = [&](HalfFilmSide side) {
    JournalState<double> rate;
    journal.rate(inside.state, rate, side);
    return dot(Vector2<double>(rate[2], rate[3]), t);
  };
  JournalState<double> state = inside.state;
  const double needed = dot(Vector2<double>(inside.force + journal.drive().load), t) / journal.inertia();
  // a > 0 is u·t < 0: the converging film pushes u·t up, the mirrored one down.
  CHECK(acceleration_across(HalfFilmSide::converging) > needed);
  CHECK(acceleration_across(HalfFilmSide::mirrored) < needed);
  CHECK(std::abs(cross(Vector2<double>(state[0], state[1]), journal.film(state).velocity)) < 1e-12);  // a = 0
}

}  // namespace sliding_test

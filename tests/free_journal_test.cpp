// The free journal of oracle/mechanisms, which the library's runs are held against: its integrator, its events.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <vector>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/trajectories/free_journal_scene.hpp"

namespace free_journal_test {

using namespace lubjoint;
using namespace lubjoint::mechanisms;

namespace {

using R = long double;

Scene shipped(const std::string& name) {
  return load_scene(std::filesystem::path(LUBJOINT_SOURCE_DIR) / "data" / "scenes" / (name + ".toml"));
}

std::vector<R> every(double interval, int count) {
  std::vector<R> times;
  for (int i = 1; i <= count; ++i) times.push_back(R(interval) * i);
  return times;
}

template <class Law>
FreeJournalRun<R> run_of(const Scene& scene, const std::vector<R>& times, double tolerance) {
  return free_journal_run<typename JournalFilmOf<Law>::Type, R>(reports::free_journal_case<R>(scene), times,
                                                                R(tolerance));
}

struct Span {
  double from;
  double to;
};

/// When the run slides; from and to are 0 if it never does.
Span sliding_of(const FreeJournalRun<R>& run) {
  Span span{0, 0};
  for (std::size_t i = 0; i + 1 < run.changes.size(); ++i) {
    if (!run.changes[i].piece.slides) continue;
    if (span.to == 0) span.from = static_cast<double>(run.changes[i].t);
    span.to = static_cast<double>(run.changes[i + 1].t);
  }
  return span;
}

}  // namespace

TEST_CASE("Lobatto IIIC: the weights integrate powers up to the thirteenth, the method is L-stable") {
  constexpr std::size_t s = 8;
  const LobattoTableau<R, s> tableau;
  const auto& b = tableau.a[s - 1];
  const auto miss = [&](int power) {
    R sum = 0;
    for (std::size_t j = 0; j < s; ++j) sum += b[j] * std::pow(tableau.c[j], R(power));
    return std::abs(static_cast<double>(sum - R(1) / (power + 1)));
  };
  for (int power = 0; power <= 13; ++power) CHECK(miss(power) < 1e-17);  // a few roundings to 64 bits
  CHECK(miss(14) > 1e-12);
  // L-stable: one step, however long, ends a decay.
  struct Decay {
    static std::size_t states() { return 1; }
    static void rate(const R&, const ShortState<R, 1>& y, ShortState<R, 1>& dydt) { dydt[0] = -1e15L * y[0]; }
    static void weights(const ShortState<R, 1>&, ShortState<R, 1>& w) { w[0] = 1e15L; }
    static void increments(const ShortState<R, 1>&, ShortState<R, 1>& d) { d[0] = 1e-3L; }
  };
  Lobatto<R, 1> method(R(1e-9));
  ShortState<R, 1> y{1};
  R dt = 1;
  CHECK(method.step(Decay(), R(0), y, dt) == 1);
  CHECK(std::abs(y[0]) < 1e-12L);  // R(z) falls as 1/z² from |z| of some hundred on
}

TEST_CASE("free journal: half films slide as long as was found with two integrators") {
  Scene scene = shipped("journal");
  const std::vector<R> times = every(0.02, 3);
  const Span published = sliding_of(run_of<LongHalf>(scene, times, 1e-11));
  CHECK(std::abs(published.from - 4.2e-5) < 0.1e-5);  // to the digits that are known
  CHECK(std::abs(published.to - 0.0276) < 5e-5);
  const Span cut = sliding_of(run_of<LongHalfEq5>(scene, times, 1e-11));
  CHECK(cut.from == 0);
  CHECK(std::abs(cut.to - 0.0322) < 5e-5);
  CHECK(sliding_of(run_of<ShortHalf>(scene, times, 1e-11)).to == 0);
}

TEST_CASE("free journal: the impact crosses its seams 27 times, when the library says") {
  Scene scene = shipped("impact");
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-12;
  scene.energy_ledger = false;
  const MultibodyTrajectory library = simulate_multibody(scene);
  const auto run = run_of<PinkusSternlicht>(scene, every(scene.run.duration, 1), 1e-11);
  REQUIRE(run.stopped.empty());
  std::vector<double> seams;
  std::size_t turns = 0;
  for (std::size_t i = 1; i < run.changes.size(); ++i) {
    if (run.changes[i].piece.where != run.changes[i - 1].piece.where) {
      seams.push_back(static_cast<double>(run.changes[i].t));
    } else {
      ++turns;
    }
  }
  REQUIRE(seams.size() == 27);
  CHECK(turns == 17);  // of ε̇: both numbers are in data/README.md
  REQUIRE(library.events.size() == seams.size());
  double worst = 0;
  for (std::size_t i = 0; i < seams.size(); ++i) worst = std::max(worst, std::abs(seams[i] - library.events[i].t));
  CHECK(worst < 1e-11);  // 1e-9 of a clearance, at some 0.1 m/s
}

TEST_CASE("free journal: friction at the wall turns the journal as in the library") {
  Scene scene = shipped("impact");
  scene.joints[0].contact->restitution = 0;
  scene.joints[0].contact->friction = 0.3;
  scene.bodies[0].spin = 50;
  scene.run.duration = 0.005;
  scene.run.output_interval = 1e-4;
  scene.run.stop_at_outputs = true;
  scene.energy_ledger = false;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-12;
  const MultibodyTrajectory library = simulate_multibody(scene);
  const auto run = run_of<PinkusSternlicht>(scene, every(1e-4, 50), 1e-11);
  REQUIRE(run.samples.size() == 50);
  REQUIRE(library.samples.size() == 51);
  double position = 0;
  double spin = 0;
  for (std::size_t i = 0; i < 50; ++i) {
    const auto& mine = run.samples[i];
    const MultibodySample& other = library.samples[i + 1];
    const Vector2<double> e = other.joints[0].eccentricity / scene.joints[0].clearance;
    position = std::max(position, std::hypot(static_cast<double>(mine.eccentricity[0]) - e.x(),
                                             static_cast<double>(mine.eccentricity[1]) - e.y()));
    spin = std::max(spin, std::abs(static_cast<double>(mine.spin) - other.state[5]));
  }
  CHECK(std::abs(static_cast<double>(run.samples.back().spin) - 50) > 1);  // friction has acted
  CHECK(position < 1e-9);                                                  // the library in double, 1e-12 a step
  CHECK(spin < 1e-7);                                                      // of 50 rad/s: 2e-9, impacts multiply errors
}

TEST_CASE("free journal: a film of a millionth of the clearance carries the load, and no rounding of velocities") {
  Scene scene = shipped("journal");
  scene.bodies[0].position = {(1 - 1e-6) * scene.joints[0].clearance, 0};
  const auto run = run_of<ShortFull>(scene, every(0.002, 5), 1e-12);
  REQUIRE(run.samples.size() == 5);
  const double load = 30 + 0.13 * 9.81;
  // At that gap the film turns the journal with half its spin, at mc(ω/2)² = 0.018 N, and lets it go nowhere.
  for (const auto& sample : run.samples) {
    CHECK(std::abs(std::hypot(static_cast<double>(sample.force[0]), static_cast<double>(sample.force[1])) - load) <
          0.02);
  }
}

TEST_CASE("free journal: a run that can't go on keeps what it has, and says why") {
  const Scene scene = shipped("journal");
  const auto journal = reports::free_journal_case<R>(scene);
  const auto run = free_journal_run<LibraryFilm<LongFull>, R>(journal, every(0.01, 100), R(1e-11), 70);
  CHECK_FALSE(run.stopped.empty());
  CHECK(run.samples.size() < 100);
  CHECK_FALSE(run.samples.empty());
}

}  // namespace free_journal_test

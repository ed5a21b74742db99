// Half films between moving bodies that slide on their jump, against an own solution in minimal coordinates.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "lubjoint/film/law_list.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "oracle/mechanisms/half_film_slider_crank.hpp"
#include "support/scenes.hpp"

namespace half_film_slide_test {

using namespace lubjoint;
using namespace lubjoint::test;
using namespace lubjoint::mechanisms;

namespace {

const std::string scenes = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/";

/// From when to when a film slides [s].
using Slides = std::vector<std::array<double, 2>>;

/// Slides that follow each other at once are one: where a film lets go slowly, errors of the run may hold it again.
Slides joined(const Slides& slides, double at_once) {
  Slides all;
  for (const auto& slide : slides) {
    if (!all.empty() && slide[0] - all.back()[1] < at_once) {
      all.back()[1] = slide[1];
    } else {
      all.push_back(slide);
    }
  }
  return all;
}

Slides slides_of(const PinRun<double>& run, double end) {
  Slides slides;
  for (std::size_t i = 0; i < run.changes.size(); ++i) {
    if (run.changes[i].side != JumpSide::sliding) continue;
    slides.push_back({run.changes[i].t, i + 1 < run.changes.size() ? run.changes[i + 1].t : end});
  }
  return slides;
}

Slides slides_of(const MultibodyTrajectory& run) {
  Slides slides;
  for (const JointSlide& slide : run.slides) slides.push_back({slide.start, slide.end});
  return slides;
}

/// Largest differences of a run from the solution in minimal coordinates.
struct Apart {
  double place = 0;     ///< of e, in clearances
  double velocity = 0;  ///< of ė, over cΩ
  double force = 0;     ///< of F, over the largest
  double turn = 0;      ///< of entries and exits, as an angle of the crank [rad]
  std::size_t slides = 0;
};

template <PolarLaw Law>
Apart apart(const Scene& scene, const MultibodyTrajectory& run) {
  const SceneJoint& joint = scene.joints[0];
  const double speed = 500 * pi<double>() / 3;
  std::vector<double> times;
  for (const MultibodySample& sample : run.samples) {
    if (sample.t > 0) times.push_back(sample.t);
  }
  // A tenth of the tolerance of the run that is compared.
  const PinRun<double> own =
      HalfFilmSliderCrank<Law, double>({}, speed,
                                       {joint.length, joint.journal_radius, joint.clearance, joint.viscosity}, 1e-11)
          .run(times);
  INFO(own.stopped);
  REQUIRE(own.samples.size() == times.size());
  Apart most;
  const auto larger = [](double& of, double value) { of = std::max(of, value); };
  double largest = 0;
  for (const auto& sample : own.samples) larger(largest, sample.force.norm());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const MultibodySample& sample = run.samples[i + 1];
    larger(most.place, (sample.joints[0].eccentricity / joint.clearance - own.samples[i].eccentricity).norm());
    larger(most.force, (sample.joints[0].force - own.samples[i].force).norm() / largest);
    // Bodies crank, rod, slider; the bearing at the rod's far end, the journal at the slider's centre.
    const double* y = sample.state.data();
    const double* v = y + 9;
    const Vector2<double> arm(0.06 * std::cos(y[5]), 0.06 * std::sin(y[5]));
    const Vector2<double> rate(v[6] - v[3] + v[5] * arm.y(), v[7] - v[4] - v[5] * arm.x());
    larger(most.velocity, (rate / joint.clearance - own.samples[i].velocity).norm() / speed);
  }
  const double at_once = 1e-6 / speed;
  const Slides mine = joined(slides_of(run), at_once);
  const Slides theirs = joined(slides_of(own, times.back()), at_once);
  REQUIRE(mine.size() == theirs.size());
  most.slides = mine.size();
  for (std::size_t i = 0; i < mine.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) larger(most.turn, speed * std::abs(mine[i][k] - theirs[i][k]));
  }
  return most;
}

/// The journal of example 1 with a half film.
Scene journal_with(std::string_view law) {
  Scene scene = load_scene(scenes + "journal.toml");
  scene.joints[0].film = law;
  scene.run.duration = 0.1;
  set_tolerance(scene, 1e-10);
  return scene;
}

/// Largest difference of ê between a free journal's run and that of the first joint of a system.
double largest_difference(const JournalTrajectory& one, const MultibodyTrajectory& other, double clearance) {
  REQUIRE(one.samples.size() == other.samples.size());
  double largest = 0;
  for (std::size_t i = 0; i < one.samples.size(); ++i) {
    const Vector2<double> place(one.samples[i].state[0], one.samples[i].state[1]);
    largest = std::max(largest, (other.samples[i].joints[0].eccentricity / clearance - place).norm());
  }
  return largest;
}

void check_same_slides(const JournalTrajectory& one, const MultibodyTrajectory& other, std::size_t joints) {
  const Slides mine = slides_of(other);
  REQUIRE(mine.size() == joints * one.sliding.size());
  for (std::size_t i = 0; i < mine.size(); ++i) {
    const SlidingInterval& slide = one.sliding[i / joints];
    CHECK(mine[i][0] == Approx(slide.start).margin(1e-9));
    CHECK(mine[i][1] == Approx(slide.end).margin(1e-7));  // where the force needed leaves the jump slowly
  }
}

constexpr std::array half_films = {"short_half", "long_half", "long_half_eq5"};

}  // namespace

TEST_CASE("an energy ledger, or an anchor off its body's centre, changes nothing of a journal that slides") {
  for (const char* law : half_films) {
    INFO(law);
    Scene scene = journal_with(law);
    const double c = scene.joints[0].clearance;
    const JournalTrajectory alone = simulate_journal(scene);
    scene.energy_ledger = true;
    const MultibodyTrajectory booked = simulate_multibody(scene);
    CHECK(booked.outcome.status == RunStatus::finished);
    CHECK(largest_difference(alone, booked, c) < 1e-8);  // a hundred tolerances: what the film makes of one
    CHECK(*booked.energy_residual < 100 * scene.run.relative_tolerance * booked.energy_scale);
    check_same_slides(alone, booked, 1);
    scene.energy_ledger = false;
    scene.joints[0].journal.point = {1e-9, 0};
    scene.bodies[0].position = {-1e-9, 0};
    scene.bodies[0].velocity = {0, -1e-9 * scene.bodies[0].spin};
    REQUIRE_FALSE(is_free_journal(scene));
    const MultibodyTrajectory apart = simulate_multibody(scene);
    CHECK(largest_difference(alone, apart, c) < 1e-7);  // the mass centre's circle of 5e-6 clearances bends the orbit
    check_same_slides(alone, apart, 1);
  }
}

TEST_CASE("a half film begins on the side of a start so near the centre that products of it are zero") {
  Scene scene = journal_with("long_half_eq5");
  scene.run.duration = 0.01;
  scene.bodies[0].position = {1e-20 * scene.joints[0].clearance, 0};
  const JournalTrajectory near = simulate_journal(scene);
  scene.bodies[0].position = {1e-300 * scene.joints[0].clearance, 0};
  const JournalTrajectory nearer = simulate_journal(scene);
  const JournalState<double>& one = near.samples.back().state;
  const JournalState<double>& other = nearer.samples.back().state;
  CHECK(std::hypot(one[0] - other[0], one[1] - other[1]) <
        1e-6);  // errors of runs near the centre, where the law turns
}

TEST_CASE("a heavy journal parts from the jump of its half film by less than the error of a first step") {
  Scene scene = journal_with("long_half_eq5");
  scene.bodies[0].mass = 1e3;
  scene.run.duration = 0.01;
  set_tolerance(scene, 1e-8);
  const JournalTrajectory near = simulate_journal(scene);
  REQUIRE(near.outcome.status == RunStatus::finished);
  set_tolerance(scene, 1e-6);
  for (const char* method : {"adams_bashforth_moulton", "bulirsch_stoer", "dopri5", "fehlberg78"}) {
    INFO(method);
    scene.integrator = method;
    const JournalTrajectory run = simulate_journal(scene);
    INFO(run.outcome.message);
    REQUIRE(run.outcome.status == RunStatus::finished);
    const double apart = (Vector2<double>(run.samples.back().state[0], run.samples.back().state[1]) -
                          Vector2<double>(near.samples.back().state[0], near.samples.back().state[1]))
                             .norm();
    CHECK(apart < 1e-4);  // a hundred tolerances
  }
}

TEST_CASE("a joint's half film that a loose step brings beyond its jump is on the side on which it is") {
  for (const char* law : half_films) {
    for (const char* method : {"adams_bashforth_moulton", "bulirsch_stoer"}) {
      INFO(law << " " << method);
      Scene scene = load_scene(scenes + "slider-crank.toml");
      scene.joints[0].film = law;
      scene.run.duration = 0.006;  // half a revolution
      scene.integrator = method;
      set_tolerance(scene, 0.1);
      const MultibodyTrajectory run = simulate_multibody(scene);
      INFO(run.outcome.message);
      CHECK(run.outcome.status == RunStatus::finished);
    }
  }
}

TEST_CASE("two half films on one pin slide together: half the oil in each is all of it in one") {
  for (const char* law : half_films) {
    INFO(law);
    Scene scene = journal_with(law);
    const JournalTrajectory alone = simulate_journal(scene);
    scene.joints[0].viscosity /= 2;
    scene.joints.push_back(scene.joints[0]);
    scene.joints[1].name = "second";
    const MultibodyTrajectory both = simulate_multibody(scene);
    INFO(both.outcome.message);
    CHECK(both.outcome.status == RunStatus::finished);
    CHECK(largest_difference(alone, both, scene.joints[0].clearance) < 1e-8);  // as above
  }
}

TEST_CASE("slider-crank of all five parameter sets, each half film: places, velocities, forces, entries and exits") {
  std::size_t slides = 0;
  for (const std::string file : {"slider-crank", "slider-crank-c0.1-mu0.4", "slider-crank-c0.5-mu0.4",
                                 "slider-crank-c0.2-mu0.04", "slider-crank-c0.5-mu0.04"}) {
    for_each_film_law([&]<class Law>() {
      if constexpr (PolarLaw<Law>) {
        Scene scene = load_scene(scenes + file + ".toml");
        scene.joints[0].film = Law::name;
        set_tolerance(scene, 1e-10);
        const MultibodyTrajectory run = simulate_multibody(scene);
        INFO(file << " " << Law::name);
        REQUIRE(run.outcome.status == RunStatus::finished);
        const Apart most = apart<Law>(scene, run);
        // The published long half film depends on the direction of e down to the centre: where an orbit passes it at
        // a thousandth of a clearance, errors of a tolerance turn the force by a thousand tolerances.
        const bool passes_centre = std::is_same_v<Law, LongHalf>;
        CHECK(most.place < (passes_centre ? 2e-7 : 3e-9));     // a thousand tolerances, or thirty
        CHECK(most.velocity < (passes_centre ? 3e-5 : 3e-7));  // of cΩ: the film's rates are a hundred times Ω
        CHECK(most.force < (passes_centre ? 2e-4 : 3e-6));     // of the largest: as the velocities, in a stiff film
        CHECK(most.turn < 1e-6);  // of the crank: where the force needed leaves the jump slowly
        CHECK(*run.energy_residual < 100 * scene.run.relative_tolerance * run.energy_scale);
        slides += most.slides;
      }
    });
  }
  CHECK(slides > 50);  // 58 entries and as many exits were compared
}

}  // namespace half_film_slide_test

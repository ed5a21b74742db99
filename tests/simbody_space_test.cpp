// An engine that nobody here wrote, in space: its spatial slider-crank with a lubricated pin moves as the library's.
#include "oracle/measure/bench/simbody_space.hpp"

#include <catch2/catch.hpp>

#include "lubjoint/scene/spatial_scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "oracle/measure/bench/simbody_case.hpp"
#include "oracle/measure/bench/spatial_reference.hpp"
#include "oracle/trajectories/spatial_slider_crank_scene.hpp"

namespace simbody_space_test {

using namespace lubjoint;
using namespace lubjoint::reports;
using mechanisms::SimbodyFilm;
using mechanisms::SimbodyFilmForce;
using mechanisms::SimbodyFilmLaw;

namespace {

constexpr double allowed = 1e-7;  // of a clearance
// Simbody's accuracy is a share of metres and radians: 1e-12 of the rod is 1.5e-9 of a clearance of 0.2 mm, and
// thousands of steps add up. Measured: 4e-9.
constexpr double accuracy = 1e-12;

/// The scene that ships, its outputs at the ends of steps.
SpatialScene shipped(double duration) {
  SpatialScene scene =
      load_spatial_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/space/spatial-slider-crank.toml");
  scene.run.duration = duration;
  scene.run.output_interval = duration / 100;
  scene.run.stop_at_outputs = true;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-10;
  return scene;
}

struct Motion {
  std::vector<double> times;
  Reference seen;
};

/// e/c of the library's run in the mechanism's plane.
Motion run_of(const SpatialScene& scene) {
  const SpatialTrajectory run = simulate_spatial(scene);
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  const PinInPlane in_plane(scene);
  const BodyAxes<double>& bearing = scene.joints[0].bearing;
  Motion motion;
  for (std::size_t i = 1; i < run.samples.size(); ++i) {
    const SpatialSample& sample = run.samples[i];
    const SpatialFrame<double> rod(spatial_motion_in(sample.state.data(), scene.bodies.size(), bearing.body));
    motion.times.push_back(sample.t);
    motion.seen.push_back(in_plane(inertial_vector(rod, bearing.axis), sample.joints[0].eccentricity));
  }
  return motion;
}

/// Largest |Δe|/c of Simbody's motion; nothing if it is not built in.
std::optional<double> apart(const SpatialScene& scene, const Motion& motion, double at, const FilmChange& change = {}) {
  const auto simbody = simbody_spatial_case(scene, motion.times, motion.seen, change);
  if (!simbody) {
    WARN("skipped: built without Simbody");
    return std::nullopt;
  }
  const MethodRun run = simbody->run("simbody_cpodes", at, {1, 60});
  INFO(run.message);
  REQUIRE(run.finished);
  return run.error;
}

/// A law of which something is changed before and after.
template <class Before, class After>
FilmChange changed(const Before& before, const After& after) {
  return [=](const SimbodyFilmLaw& law) -> SimbodyFilmLaw {
    return [=](SimbodyFilm film) {
      before(film);
      SimbodyFilmForce force = law(film);
      after(force);
      return force;
    };
  };
}

/// The journal's axis askew in the slider, and its point beside the bearing's middle plane: X is not the journal's
/// point, and goes round the axis of the pin.
SpatialScene with_tilted_pin(SpatialScene scene) {
  constexpr double tilt = 2e-3;  // the edges of the film come nearer by a fifth of the clearance
  BodyAxes<double>& journal = scene.joints[0].journal;
  const Vector3<double> n = journal.axis;
  journal.point += 0.01 * n;
  journal.axis = std::cos(tilt) * n + std::sin(tilt) * journal.third();
  return scene;
}

}  // namespace

TEST_CASE("Simbody in space: the lubricated slider-crank is the library's and minimal coordinates', to 1e-7 c") {
  const SpatialScene scene = shipped(2);
  const Motion motion = run_of(scene);
  const auto off = apart(scene, motion, accuracy);
  if (!off) return;
  CHECK(*off < allowed);
  const SpatialReference minimal = spatial_reference(scene, motion.times);
  CHECK(minimal.agreement < 1e-12);  // 1.7e-13 was measured: rounding of places of 0.3 m in extended precision
  CHECK(*apart(scene, {motion.times, minimal.seen}, accuracy) < allowed);
  const double less_close = *apart(scene, motion, 1e-9);
  CHECK(less_close < 1e-5);  // three decades of accuracy
  CHECK(less_close > 10 * *off);
}

TEST_CASE("Simbody in space: a film force at another point, without the spins, or of another film is noticed") {
  const SpatialScene scene = shipped(0.6);  // a revolution
  const Motion motion = run_of(scene);
  const auto same_film = [](SimbodyFilm&) {};
  const auto same_force = [](SimbodyFilmForce&) {};
  const std::vector<std::pair<std::string, FilmChange>> mistakes = {
      {"at the bearing's centre, not at X", changed(same_film,
                                                    [](SimbodyFilmForce& f) {
                                                      f.point = {0, 0, 0};
                                                    })},
      {"without the spins", changed([](SimbodyFilm& film) { film.spin = 0; }, same_force)},
      {"the whole spin, not its half", changed([](SimbodyFilm& film) { film.spin *= 2; }, same_force)},
      {"a force that is 0.1 % off", changed(same_film,
                                            [](SimbodyFilmForce& f) {
                                              for (double& each : f.force) each *= 1.001;
                                            })},
  };
  for (const auto& [what, mistake] : mistakes) {
    CAPTURE(what);
    const auto off = apart(scene, motion, 1e-9, mistake);
    if (!off) return;
    CHECK(*off > 100 * allowed);
  }
  const std::vector<std::pair<std::string, std::function<void(SpatialScene&)>>> changes = {
      {"slider's mass", [](SpatialScene& s) { s.bodies[2].mass *= 1.001; }},
      {"rod's inertia", [](SpatialScene& s) { s.bodies[1].inertia *= 1.001; }},
      {"crank's inertia", [](SpatialScene& s) { s.bodies[0].inertia *= 1.001; }},
      {"gravity", [](SpatialScene& s) { s.gravity *= 1.001; }},
  };
  for (const auto& [what, change] : changes) {
    CAPTURE(what);
    SpatialScene other = scene;
    change(other);
    CHECK(*apart(other, motion, 1e-9) > 100 * allowed);
  }
}

TEST_CASE("Simbody in space: a journal whose axis is askew, and whose point is not X, moves as the library's") {
  const SpatialScene scene = with_tilted_pin(shipped(0.6));
  const Motion motion = run_of(scene);
  const auto off = apart(scene, motion, accuracy);
  if (!off) return;
  CHECK(*off < allowed);
  CHECK(*apart(shipped(0.6), motion, 1e-9) > 1e5 * allowed);  // the tilt is no small matter: a tenth of the clearance
}

}  // namespace simbody_space_test

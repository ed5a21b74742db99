// Joints in space that touch, and half films that change their side, as runs: against the plane's, and what a tilt
// adds.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/scene/multibody_scene.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "support/embedded_scene.hpp"
#include "support/scenes.hpp"

namespace space_contact_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

Scene shipped(const std::string& name) {
  Scene scene = load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/" + name + ".toml");
  set_tolerance(scene, 1e-10);
  scene.run.stop_at_outputs = true;  // no sample is interpolated
  return scene;
}

/// Largest difference of the first joint's e between the runs in the plane and in space [clearances].
double distance(const Scene& flat, const MultibodyTrajectory& wanted, const SpatialTrajectory& run,
                const Embedding& in) {
  REQUIRE(run.samples.size() == wanted.samples.size());
  double largest = 0;
  for (std::size_t i = 0; i < wanted.samples.size(); ++i) {
    const Vector3<double> e = in.vector(wanted.samples[i].joints[0].eccentricity);
    largest = std::max(largest, (run.samples[i].joints[0].eccentricity - e).norm() / flat.joints[0].clearance);
  }
  return largest;
}

}  // namespace

TEST_CASE("contact in space: a journal that is thrown at its wall meets and leaves it as in the plane") {
  for (const char* name : {"impact", "hybrid"}) {
    const Scene flat = shipped(name);
    const Embedding in(some_plane(4));
    const MultibodyTrajectory wanted = simulate_multibody(flat);
    const SpatialTrajectory run = simulate_spatial(in.scene(flat));
    INFO(name << ": " << run.outcome.message);
    REQUIRE(run.outcome.status == RunStatus::finished);
    REQUIRE(wanted.events.size() > 10);
    REQUIRE(run.events.size() == wanted.events.size());
    for (std::size_t i = 0; i < run.events.size(); ++i) {
      INFO("event " << i << " at " << wanted.events[i].t);
      CHECK(run.events[i].from == wanted.events[i].from);
      CHECK(run.events[i].to == wanted.events[i].to);
      CHECK(std::abs(run.events[i].t - wanted.events[i].t) < 1e-9);  // a clearance takes 2e-4 s; 1e-10 of it, impacts
      CHECK(run.events[i].normal_speed == Approx(wanted.events[i].normal_speed).margin(1e-6));  // multiply that
    }
    CHECK(distance(flat, wanted, run, in) < 1e-6);  // likewise
    CHECK(run.joints[0].eccentricity.value > flat.joints[0].clearance);
    CHECK(*run.energy_residual < 1e-8 * run.energy_scale);  // of the tolerance, a hundred steps
    // Without a tilt no share of the film is taken at its edge, however near the wall is.
    CHECK(run.joints[0].edge_share.value == 0);
  }
}

TEST_CASE("contact in space: a tilted journal that passes its wall takes a finite share of the film, and runs on") {
  const Scene flat = shipped("impact");
  SpatialScene space = Embedding(some_plane(4)).scene(flat);
  space.run.duration = 2e-3;
  const double tilt = 1e-4;
  // About the axis along which the journal flies: the tilt stays.
  const Vector3<double> axis = direction(space.bodies[0].velocity);
  const Vector3<double> in_body = transposed_product(rotation_matrix(space.bodies[0].orientation), axis);
  const Vector3<double>& n = space.joints[0].journal.axis;
  space.joints[0].journal.axis = direction(Vector3<double>(n + std::tan(tilt) * in_body.cross(n)));
  space.joints[0].journal.across = any_perpendicular(space.joints[0].journal.axis);
  const SpatialTrajectory run = simulate_spatial(space);
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  CHECK(run.joints[0].eccentricity.value > flat.joints[0].clearance);  // through |e| = c
  CHECK(run.joints[0].tilt.value >= tilt * (1 - 1e-9));
  // ψL/2 over the transition's width e0: 1e-4 · 0.02 / 5e-6, and no pole where |e| = c.
  CHECK(run.joints[0].edge_share.value ==
        Approx(run.joints[0].tilt.value * 0.02 / 5e-6).epsilon(1e-2));  // the looks inside a step
}

TEST_CASE("half films in space: a run is the plane's, and slides on the jump when and where that slides") {
  std::size_t slid = 0;
  for (const char* law : {"short_half", "long_half", "long_half_eq5"}) {
    for (const char* name : {"journal", "slider-crank"}) {
      Scene flat = shipped(name);
      flat.joints[0].film = law;
      flat.joints[0].shear = ShearExtent::film;
      flat.energy_ledger = true;
      flat.run.duration /= 8;
      flat.run.output_interval = flat.run.duration / 100;
      const Embedding in(some_plane(5));
      SpatialScene space = in.scene(flat);
      allow_what_is_redundant(space);
      const MultibodyTrajectory wanted = simulate_multibody(flat);
      for (const SceneCoordinates coordinates : {SceneCoordinates::absolute, SceneCoordinates::independent}) {
        space.coordinates = coordinates;
        const SpatialTrajectory run = simulate_spatial(space);
        INFO(law << " in " << name << ", " << run.outcome.coordinates << ": " << run.outcome.message);
        REQUIRE(run.outcome.status == RunStatus::finished);
        // Ten to a thousand tolerances, by the jumps; the published long half film depends on the direction of e down
        // to the centre, and multiplies them where an orbit passes it.
        CHECK(distance(flat, wanted, run, in) < 1e-7);
        CHECK(*run.energy_residual < 1e-7 * run.energy_scale);  // likewise
        REQUIRE(run.slides.size() == wanted.slides.size());
        for (std::size_t i = 0; i < run.slides.size(); ++i) {
          CHECK(std::abs(run.slides[i].start - wanted.slides[i].start) < 1e-6 * flat.run.duration);  // as the places
          CHECK(std::abs(run.slides[i].end - wanted.slides[i].end) < 1e-4 * flat.run.duration);      // the force needed
          ++slid;                                                                                    // leaves it slowly
        }
      }
    }
  }
  CHECK(slid == 10);  // five entries and exits in either coordinates
}

TEST_CASE("half films in space: a journal that slides with a tilt keeps a = 0 to the square of the tilt") {
  Scene flat = shipped("journal");
  flat.joints[0].film = "long_half_eq5";
  flat.run.duration = 0.02;
  flat.run.output_interval = flat.run.duration / 200;
  flat.energy_ledger = true;
  std::vector<double> largest;
  for (const double tilt : {0.0, 1e-3, 4e-3}) {
    SpatialScene space = Embedding(some_plane(4)).scene(flat);
    // The bearing leans, and the journal turns about its own axis: θ runs ahead of ∫ω and behind it, by turns.
    Vector3<double>& n = space.joints[0].bearing.axis;
    n = direction(Vector3<double>(n + std::tan(tilt) * any_perpendicular(n)));
    space.joints[0].bearing.across = any_perpendicular(n);
    space.joints[0].plane.length /= 100;  // a film whose edge stays away from its wall
    space.joints[0].plane.viscosity *= 100;
    const SpatialTrajectory run = simulate_spatial(space);
    INFO(tilt << ": " << run.outcome.message);
    REQUIRE(run.outcome.status == RunStatus::finished);
    REQUIRE(!run.slides.empty());
    CHECK(*run.energy_residual < 1e-7 * run.energy_scale);  // errors of the run
    CHECK(run.joints[0].tilt.value == Approx(tilt).margin(1e-9));
    // The sine between e and u in the middle of the longest slide.
    const SpatialSystem<double> system = spatial_system<double>(space);
    auto w = system.workspace<double>();
    largest.push_back(0);
    for (const SpatialSample& sample : run.samples) {
      if (std::none_of(run.slides.begin(), run.slides.end(),
                       [&](const JointSlide& slide) { return slide.start < sample.t && sample.t < slide.end; }))
        continue;
      system.place(sample.state.data(), w);
      const JournalMotion<double> seen = system.joint_kinematics(0, w).motion;
      const Vector2<double>& e = seen.eccentricity;
      const Vector2<double> u = seen.velocity - seen.journal_spin / 2 * perpendicular(e);
      largest.back() = std::max(largest.back(), std::abs(cross(e, u)) / (e.norm() * u.norm()));
    }
  }
  CAPTURE(largest[0], largest[1], largest[2]);
  CHECK(largest[0] < 1e-7);  // a thousand tolerances: e and u are small beside the mechanism
  CHECK(largest[1] > 0);
  CHECK(largest[2] / largest[1] == Approx(16).epsilon(0.2));  // the square
}

}  // namespace space_contact_test

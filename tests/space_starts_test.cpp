// Starts in space: which of its closures a constraint comes to, and rows that stop being redundant.
#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "support/embedded_scene.hpp"

namespace space_starts_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;

namespace {

SpatialScene parsed(const std::string& rest) {
  return parse_spatial_scene("dimension = 3\nname = \"s\"\nduration = 0.1\njoints = []\n" + rest, "s.toml");
}

std::string refusal(const std::string& rest) {
  try {
    prepare_spatial(parsed(rest));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "accepted";
}

std::string body_at(const std::string& orientation) {
  return "[[bodies]]\nname = \"b\"\nmass = 2.0\ninertia = [1e-3, 2e-3, 2.5e-3]\n" + orientation;
}

std::string held(const std::string& orientation) {
  return "[[constraints]]\nname = \"hold\"\ntype = \"ground\"\nbody = \"b\"\norientation = " + orientation + "\n";
}

std::string pin(const std::string& second_axis) {
  return "[[constraints]]\nname = \"pin\"\ntype = \"revolute\"\nfirst = {body = \"ground\", axis = [0.0, 0.0, 1.0]}\n"
         "second = {body = \"b\"" +
         second_axis + "}\n";
}

/// How far the body is turned from an orientation [rad].
double turned(const PreparedSpatialScene& prepared, const EulerParameters<double>& from) {
  return 2 * std::acos(std::min(1.0, std::abs(spatial_motion_in(prepared.start.data(), 1, 0).parameters.dot(from))));
}

}  // namespace

TEST_CASE("start in space: a body that is held at an orientation has that, however far it starts from it") {
  const double pi = std::acos(-1.0);
  // Half turns and turns by 120 degrees about a diagonal permute axes, whose rows all of them fulfil.
  const std::vector<std::pair<std::string, double>> turns = {
      {"[1.0, 2.0, -0.5]", 0.3}, {"[1.0, 2.0, -0.5]", 1.4}, {"[1.0, 2.0, -0.5]", 3.0},      {"[1.0, 0.0, 0.0]", pi},
      {"[0.0, 1.0, 0.0]", pi},   {"[0.0, 0.0, 1.0]", pi},   {"[1.0, 1.0, 1.0]", 2 * pi / 3}};
  for (const auto& [axis, angle] : turns) {
    INFO(axis << " by " << angle);
    std::ostringstream turn;
    turn.precision(17);
    turn << "{axis = " << axis << ", angle = " << angle << "}";
    const SpatialScene scene = parsed(body_at("position = [0.1, 0.0, 0.0]\n") + held(turn.str()));
    const SpatialScene there = parsed(body_at("orientation = " + turn.str() + "\n") + held(turn.str()));
    const auto prepared = prepare_spatial(scene);
    CHECK(turned(prepared, there.bodies[0].orientation) < 1e-7);                // acos of 1
    CHECK(prepared.found.correction.position < 1e-15);                          // held where it starts
    CHECK(prepared.found.correction.angle > 0.29);                              // and it is said
    CHECK(turned(prepare_spatial(there), there.bodies[0].orientation) < 1e-7);  // likewise
  }
}

TEST_CASE("start in space: axes that point against each other, or lie far apart, are refused by line and key") {
  CHECK(refusal(body_at("") + pin("")) == "accepted");
  CHECK(refusal(body_at("") + pin(", axis = [0.3, 0.0, 1.0]")) == "accepted");
  CHECK_THAT(refusal(body_at("") + pin(", axis = [0.0, 0.0, -1.0]")),
             Contains("constraints[0].second.axis is along [") && Contains("less than 60 degrees apart"));
  CHECK_THAT(refusal(body_at("") + pin(", axis = [1.0, 0.0, 0.0]")), Contains("less than 60 degrees apart"));
}

TEST_CASE("start in space: scenes that are made by programs close as they ask, or are refused") {
  const BodyAxes<double> on_ground{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, ground_body};
  const auto with = [&](const AnySpatialConstraint<double>& constraint) {
    SpatialScene scene = parsed(body_at("") + pin(""));
    scene.constraints = {{"c", constraint}};
    return scene;
  };
  // Against its axis; a slider turned by half a turn about it.
  const BodyAxes<double> against{{{0, 0, 0}, {0, 0, -1}, {1, 0, 0}}, 0};
  const BodyAxes<double> half{{{0, 0, 0}, {0, 0, 1}, {-1, 0, 0}}, 0};
  for (const SpatialScene& scene :
       {with(RevoluteJoint<double>{{on_ground, against}}), with(CylindricalJoint<double>{{on_ground, against}}),
        with(PlanarJoint<double>{{on_ground, against}}), with(PrismaticJoint<double>{{on_ground, half}})}) {
    CHECK_THROWS_WITH(prepare_spatial(scene), Contains("\"c\" closes with body \"b\" turned by 3.14159 rad"));
  }
  // An angle about an axis along which the other body's first axis lies: no number.
  const BodyAxes<double> across{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, 0};
  SpatialScene motor = with(SphericalJoint<double>{{{ground_body, {0, 0, 0}}, {0, {0, 0, 0}}}});
  motor.constraints.push_back({"motor", RotationalDriver<double>{{on_ground, across}, {0, 1, 0}}});
  CHECK_THROWS_WITH(prepare_spatial(motor), Contains("\"motor\" has no finite value near the start"));
}

namespace {

/// A slider along x whose rod of length l lies across at the start, where it repeats the slider; it falls along x.
SpatialScene repeating_rod(double l) {
  SpatialScene scene = parsed(body_at("") + pin(""));
  scene.bodies[0].inertia = l * l * Matrix3<double>::Identity();
  const BodyAxes<double> first{{{0, 0, l / 2}, {1, 0, 0}, {0, 1, 0}}, ground_body};
  BodyAxes<double> second = first;
  second.body = 0;
  scene.constraints = {{"slider", PrismaticJoint<double>{{first, second}}},
                       {"rod", DistanceJoint<double>{{{ground_body, {0, l, 0}}, {0, {0, 0, 0}}}, l}}};
  scene.redundant = RedundantConstraints::allow;
  scene.gravity = {9.81, 0, 0};
  scene.run.duration = 0.5 * std::sqrt(l);
  scene.run.output_interval = scene.run.duration / 100;
  scene.run.stop_at_outputs = true;
  return scene;
}

}  // namespace

TEST_CASE("rows left out: one that is redundant no more stops the run by name, at the same place in every size") {
  std::vector<double> places;
  for (const double l : {1.0, 1e-3}) {
    const SpatialTrajectory run = simulate_spatial(repeating_rod(l));
    CHECK(run.outcome.status == RunStatus::stopped);
    CHECK_THAT(run.outcome.message, Contains("constraint \"rod\"") && Contains("it is redundant no more"));
    places.push_back(run.samples.back().state[0] / l);
  }
  // x²/2l is off by 1e-6 of the mechanism, l/2, at x = l/1000; outputs are 1e-4 l apart there.
  CHECK(places[0] > 1e-3);
  CHECK(places[0] < 1.3e-3);                            // two outputs beyond
  CHECK(places[1] == Approx(places[0]).epsilon(1e-3));  // Baumgarte's gains have a time of their own
}

TEST_CASE("rows left out: rows of angles are told from those of lengths in a small mechanism") {
  Scene flat = load_scene(std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/slider-crank-ideal.toml");
  const double scale = 1e-5;  // a mechanism of micrometres
  for (SceneBody& body : flat.bodies) {
    body.position *= scale;
    body.velocity *= scale;
    body.inertia *= scale * scale;
  }
  SpatialScene space = Embedding(some_plane(1)).scene(flat);
  for (SpatialSceneConstraint& each : space.constraints) {
    std::visit(
        [&](auto& c) {
          c.first.point *= scale;
          c.second.point *= scale;
        },
        each.constraint);
  }
  space.gravity *= scale;
  for (SpatialSceneBody& body : space.bodies) body.position += (scale - 1) * some_plane(1).shift;
  space.redundant = RedundantConstraints::allow;
  space.run.relative_tolerance = space.run.absolute_tolerance = 1e-5;
  const SpatialTrajectory run = simulate_spatial(space);
  INFO(run.outcome.message);
  CHECK(run.outcome.status == RunStatus::finished);
  CHECK(run.left_out.size() == 3);
  // Angles are off by more than 1e-6 of what lengths may be.
  CHECK(run.drift.left_out_position > 1e-6 * scene_units(space).mechanism);
}

TEST_CASE("units in space: a moment's rate is that of the axis about which it turns") {
  SpatialScene scene = parsed(body_at("") + "[[loads]]\nbody = \"b\"\nmoment = [0.0, 0.0, 40.0]\n" + pin(""));
  CHECK(scene_units(scene).rate == Approx(std::sqrt(40 / 2.5e-3)));  // and not sqrt(40 / 1e-3)
  // Turned a quarter about y, the body's z lies along the inertial x: about z it is its x that turns, backwards.
  scene.bodies[0].orientation = euler_parameters<double>({0, 1, 0}, std::acos(0.0));
  CHECK(scene_units(scene).rate == Approx(std::sqrt(40 / 1e-3)));
}

TEST_CASE("space: a spring that comes to length 0 stops the run by its name, one that passes beside it does not") {
  const auto thrown = [](double beside, const std::string& integrator) {
    std::ostringstream scene;
    scene << "[integrator]\nname = \"" << integrator << "\"\n[[bodies]]\nname = \"mass\"\nmass = 1.0\n"
          << "inertia = [1e-3, 1e-3, 1e-3]\nposition = [0.06, 0.08, " << beside << "]\nvelocity = [-1.8, -2.4, 0.0]\n"
          << "[[springs]]\nname = \"coil\"\nfirst = {body = \"ground\"}\nsecond = {body = \"mass\"}\n"
          << "stiffness = 50.0\nfree_length = 0.1\n";
    return simulate_spatial(parsed(scene.str())).outcome;
  };
  for (const std::string integrator : {"radau_iia5", "dopri5", "fehlberg78"}) {
    INFO(integrator);
    const RunOutcome stopped = thrown(0, integrator);
    CHECK(stopped.status == RunStatus::stopped);
    CHECK_THAT(stopped.message, Contains("spring \"coil\" has length 0 at 0.03"));  // 0.1 m at 3 m/s
    CHECK(thrown(0.002, integrator).status == RunStatus::finished);
  }
}

}  // namespace space_starts_test

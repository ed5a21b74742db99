// What scene files in space say of loads, inertia, ground, fixed, distance and drivers, against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "lubjoint/scene/spatial_scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"

namespace space_readers_test {

using namespace lubjoint;
using V3 = Eigen::Vector3d;

namespace {

/// A scene of a second in ten samples, by steps of 1e-11.
SpatialScene parsed(const std::string& rest, const std::string& gravity = "[0.0, 0.0, 0.0]") {
  return parse_spatial_scene("dimension = 3\nname = \"s\"\nduration = 1.0\njoints = []\ngravity = " + gravity + "\n" +
                                 rest +
                                 "\n[integrator]\nname = \"dopri5\"\nrelative_tolerance = 1e-11\n"
                                 "absolute_tolerance = 1e-11\n[output]\ninterval = 0.1\n",
                             "s.toml");
}

std::string body(const std::string& rest = "", const std::string& name = "b") {
  return "[[bodies]]\nname = \"" + name + "\"\nmass = 2.0\ninertia = [1e-3, 1e-3, 1.5e-3]\n" + rest;
}

SpatialTrajectory finished(const SpatialScene& scene) {
  SpatialTrajectory run = simulate_spatial(scene);
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  return run;
}

SpatialMotion<double> motion(const SpatialTrajectory& run, std::size_t sample, std::size_t bodies = 1,
                             std::size_t of = 0) {
  return spatial_motion_in(run.samples[sample].state.data(), bodies, of);
}

constexpr double near = 1e-8;  ///< of the tolerance, a thousand steps

}  // namespace

TEST_CASE("readers in space: six numbers of an inertia are Jxx, Jyy, Jzz, Jxy, Jxz, Jyz") {
  const SpatialScene scene = parsed(
      "[[bodies]]\nname = \"b\"\nmass = 2.0\ninertia = [3.0, 4.0, 5.0, 0.1, -0.2, 0.3]\nspin = [1.0, -2.0, 0.5]\n");
  Eigen::Matrix3d j;
  j << 3, 0.1, -0.2, 0.1, 4, 0.3, -0.2, 0.3, 5;
  const V3 spin(1, -2, 0.5);
  const V3 wanted = j.inverse() * -spin.cross(j * spin);
  const auto system = spatial_system<double>(scene);
  auto w = system.workspace<double>();
  system.evaluate(0.0, scene_start<double>(scene).data(), {}, w);
  for (int k = 0; k < 3; ++k)
    CHECK(w.accelerations[3 + static_cast<std::size_t>(k)] == Approx(wanted(k)).margin(1e-14));
}

TEST_CASE("readers in space: a harmonic load is F cos(speed t + phase), and moves a free mass so") {
  const SpatialTrajectory run = finished(
      parsed(body() + "[[loads]]\nbody = \"b\"\nforce = [3.0, 0.0, -1.0]\nharmonic = {speed = 7.0, phase = 0.4}\n"));
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const double t = run.samples[i].t;
    // Twice the integral of cos(7t + 0.4)/m, from rest.
    const double way = (std::cos(0.4) - std::cos(7 * t + 0.4)) / 49 - std::sin(0.4) * t / 7;
    CHECK((motion(run, i).position - way / 2 * V3(3, 0, -1)).norm() < near);
  }
}

TEST_CASE("readers in space: a load of the body's frame turns with it, one of the ground does not") {
  const auto with = [](const std::string& frame) {
    return finished(
        parsed(body("spin = [0.0, 0.0, 4.0]\n") + "[[loads]]\nbody = \"b\"\nforce = [3.0, 0.0, 0.0]\n" + frame));
  };
  const SpatialTrajectory turning = with("frame = \"body\"\n");
  const SpatialTrajectory still = with("");
  for (std::size_t i = 0; i < turning.samples.size(); ++i) {
    const double t = turning.samples[i].t;
    const V3 way = 3.0 / 2 / 16 * V3(1 - std::cos(4 * t), 4 * t - std::sin(4 * t), 0);
    CHECK((motion(turning, i).position - way).norm() < near);
    CHECK((motion(still, i).position - V3(3.0 / 4 * t * t, 0, 0)).norm() < near);
  }
  // A moment about the body's z, and the point where a force acts.
  const SpatialTrajectory spun =
      finished(parsed(body("orientation = {axis = [1.0, 0.0, 0.0], angle = 1.0}\n") +
                      "[[loads]]\nbody = \"b\"\nmoment = [0.0, 0.0, 3e-3]\nframe = \"body\"\n"));
  CHECK((motion(spun, 10).body_spin - V3(0, 0, 2)).norm() < near);  // M t / J
  const SpatialScene off =
      parsed(body() + "[[loads]]\nbody = \"b\"\nforce = [0.0, 1.0, 0.0]\npoint = [0.01, 0.0, 0.0]\n");
  const auto system = spatial_system<double>(off);
  auto w = system.workspace<double>();
  system.evaluate(0.0, scene_start<double>(off).data(), {}, w);
  CHECK(w.accelerations[5] == Approx(0.01 * 1 / 1.5e-3));
}

TEST_CASE("readers in space: ground holds a body with its weight and the moment of a load") {
  const SpatialTrajectory run =
      finished(parsed(body("position = [0.1, 0.2, 0.3]\n") +
                          "[[constraints]]\nname = \"hold\"\ntype = \"ground\"\nbody = \"b\"\n"
                          "[[loads]]\nbody = \"b\"\nforce = [0.0, 0.0, 5.0]\npoint = [0.4, 0.0, 0.0]\n",
                      "[0.0, 0.0, -10.0]"));
  CHECK((motion(run, 10).position - V3(0.1, 0.2, 0.3)).norm() < 1e-14);  // rounding
  CHECK(run.reactions[0].force.value == Approx(2 * 10 - 5));
  CHECK(run.reactions[0].moment->value == Approx(0.4 * 5));
}

TEST_CASE("readers in space: bodies that are fixed to each other are one") {
  // Two masses 0.6 m apart that spin about z as one: each moves on a circle of 0.3 m.
  const SpatialTrajectory run = finished(
      parsed(body("position = [0.3, 0.0, 0.0]\nvelocity = [0.0, 1.5, 0.0]\nspin = [0.0, 0.0, 5.0]\n", "a") +
             body("position = [-0.3, 0.0, 0.0]\nvelocity = [0.0, -1.5, 0.0]\nspin = [0.0, 0.0, 5.0]\n") +
             "[[constraints]]\nname = \"weld\"\ntype = \"fixed\"\nfirst = {body = \"a\", point = [-0.3, 0.0, 0.0]}\n"
             "second = {body = \"b\", point = [0.3, 0.0, 0.0]}\n"));
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const double t = run.samples[i].t;
    const V3 at(0.3 * std::cos(5 * t), 0.3 * std::sin(5 * t), 0);
    CHECK((motion(run, i, 2, 0).position - at).norm() < near);
    CHECK((motion(run, i, 2, 1).position + at).norm() < near);
  }
  CHECK(run.reactions[0].force.value == Approx(2.0 * 25 * 0.3).epsilon(1e-6));  // m ω² r
}

TEST_CASE("readers in space: a mass on a rod is a conical pendulum") {
  // v² = g l sinθ tanθ keeps the angle θ; a rod pulls with m g/cosθ.
  const double l = 0.5, theta = 0.7, g = 9.81;
  const double radius = l * std::sin(theta);
  SpatialScene scene = parsed(body() +
                                  "[[constraints]]\nname = \"rod\"\ntype = \"distance\"\nlength = 0.5\n"
                                  "first = {body = \"ground\"}\nsecond = {body = \"b\"}\n",
                              "[0.0, 0.0, -9.81]");
  scene.bodies[0].position = {radius, 0, -l * std::cos(theta)};
  scene.bodies[0].velocity = {0, std::sqrt(g * l * std::sin(theta) * std::tan(theta)), 0};
  const SpatialTrajectory run = finished(scene);
  const double rate = std::sqrt(g / (l * std::cos(theta)));
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const double angle = rate * run.samples[i].t;
    const V3 at(radius * std::cos(angle), radius * std::sin(angle), -l * std::cos(theta));
    CHECK((motion(run, i).position - at).norm() < near);
  }
  CHECK(run.reactions[0].force.value == Approx(2 * g / std::cos(theta)).epsilon(1e-6));  // of the states' errors
  // Without a length it is that of the start.
  const SpatialScene as_it_is = parsed(body("position = [0.0, 0.3, 0.4]\n") +
                                       "[[constraints]]\nname = \"rod\"\ntype = \"distance\"\n"
                                       "first = {body = \"ground\"}\nsecond = {body = \"b\"}\n");
  CHECK(std::get<DistanceJoint<double>>(as_it_is.constraints[0].constraint).length == Approx(0.5));
}

TEST_CASE("readers in space: drivers turn and push by what is prescribed, with the moment and the force of it") {
  const std::string sleeve =
      "[[constraints]]\nname = \"sleeve\"\ntype = \"cylindrical\"\nfirst = {body = \"ground\", axis = [0.0, 0.0, "
      "1.0]}\n"
      "second = {body = \"b\"}\n";
  const auto driver = [](const std::string& name, const std::string& rest) {
    return "[[constraints]]\nname = \"" + name + "\"\ntype = \"driver\"\nof = \"sleeve\"\n" + rest;
  };
  const SpatialTrajectory run =
      finished(parsed(body("spin = [0.0, 0.0, 2.0]\nvelocity = [0.0, 0.0, 0.5]\nposition = [0.0, 0.0, 0.2]\n") +
                          sleeve + driver("motor", "speed = 2.0\nacceleration = 6.0\n") +
                          driver("ram", "motion = \"translation\"\nspeed = 0.5\nacceleration = 3.0\n"),
                      "[0.0, 0.0, -10.0]"));
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const double t = run.samples[i].t;
    const SpatialMotion<double> at = motion(run, i);
    CHECK((at.position - V3(0, 0, 0.2 + 0.5 * t + 1.5 * t * t)).norm() < near);  // displacement: that of the start
    const double half = (2 * t + 3 * t * t) / 2;
    CHECK(std::min((at.parameters - Eigen::Vector4d(std::cos(half), 0, 0, std::sin(half))).norm(),
                   (at.parameters + Eigen::Vector4d(std::cos(half), 0, 0, std::sin(half))).norm()) < near);
  }
  CHECK(run.driver_turns == std::vector<bool>{true, false});
  CHECK(run.drivers[0].max_moment.value ==
        Approx(6 * 1.5e-3).epsilon(1e-6));  // of the states' errors, and Baumgarte's share
  CHECK(run.drivers[1].max_moment.value ==
        Approx(2 * (3 + 10)).epsilon(1e-6));  // of the states' errors, and Baumgarte's share
  // A driver's own angle: the start is brought to it.
  const SpatialScene turned = parsed(body() + sleeve + driver("motor", "angle = 0.25\nspeed = 0.0\n"));
  const auto prepared = prepare_spatial(turned);
  CHECK(prepared.start[6] == Approx(std::sin(0.125)));
}

}  // namespace space_readers_test

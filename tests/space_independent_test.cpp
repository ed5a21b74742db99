// Independent coordinates in space: the motion of absolute ones, on the constraints to rounding, in fewer states.
#include <Eigen/Dense>
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "lubjoint/motion/in_space.hpp"
#include "lubjoint/motion/independent_integrator.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "lubjoint/scene/spatial_coordinates.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "oracle/files/files.hpp"
#include "support/embedded_scene.hpp"
#include "support/scenes.hpp"

namespace space_independent_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Contains;
using Long = boost::multiprecision::cpp_bin_float_50;

namespace {

const std::string data = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/";

void set_tolerance(SpatialScene& scene, double tolerance) {
  scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
}

/// A scene that ships, without its stabilisation.
SpatialScene shipped(const std::string& name) {
  SpatialScene scene = load_spatial_scene(data + "space/" + name + ".toml");
  scene.stabilisation = {};
  return scene;
}

SpatialScene embedded(const Scene& flat, unsigned plane) {
  SpatialScene scene = Embedding(some_plane(plane)).scene(flat);
  allow_what_is_redundant(scene);
  return scene;
}
SpatialScene embedded_slider_crank(unsigned plane = 3) {
  return embedded(load_scene(data + "slider-crank.toml"), plane);
}

/// A crank and a rocker: the rocker's places are no coordinates where the coupler and the crank are in line.
Scene crank_rocker() {
  Scene scene;
  scene.file = scene.name = "crank-rocker";
  const double crank = 0.1, coupler = 0.25, rocker = 0.2, base = 0.25;
  const double diagonal = std::hypot(base, crank);  // the crank upright
  const double at_base =
      std::acos((rocker * rocker + diagonal * diagonal - coupler * coupler) / (2 * rocker * diagonal));
  const double angle = std::numbers::pi - std::atan2(crank, base) - at_base;
  const Vector2<double> end(base + rocker * std::cos(angle), rocker * std::sin(angle));
  const Vector2<double> pin(0, crank);
  scene.bodies = {body("rocker", 0.2, 1e-3, 0.5 * (Vector2<double>(base, 0) + end), angle),
                  body("coupler", 0.2, 1e-3, 0.5 * (pin + end), std::atan2(end.y() - pin.y(), end.x() - pin.x())),
                  body("crank", 1, 1e-2, 0.5 * pin, std::numbers::pi / 2)};
  scene.bodies[2].spin = 20;
  scene.gravity = {0, -9.81};
  const auto joint = [](const char* name, BodyPoint<double> first, BodyPoint<double> second) {
    return SceneConstraint{name, Revolute<double>{first, second}};
  };
  scene.constraints = {joint("a", {ground_body, {0, 0}}, {2, {-crank / 2, 0}}),
                       joint("b", {2, {crank / 2, 0}}, {1, {-coupler / 2, 0}}),
                       joint("c", {1, {coupler / 2, 0}}, {0, {rocker / 2, 0}}),
                       joint("d", {ground_body, {base, 0}}, {0, {-rocker / 2, 0}})};
  scene.run.duration = 2;
  scene.run.output_interval = 0.01;
  return scene;
}

/// Mechanisms of 2, 3, 6, 3, 3 and 1 freedoms: a film and a motor; a film and a free crank; two films, a cross joint
/// and springs; turns alone; springs, dampers and distances; a closed loop with rows left out.
std::vector<SpatialScene> mechanisms_in_space() {
  return {embedded_slider_crank(), shipped("spatial-slider-crank"), shipped("engine"),
          shipped("top"),          shipped("flyball-governor"),     embedded(crank_rocker(), 2)};
}

template <class R>
struct Prepared {
  explicit Prepared(const SpatialScene& scene, bool ledger = false)
      : system(spatial_system<R>(scene)), start(scene_start<R>(scene)), ode(assembled(scene), ledger) {
    start.resize(ode.dimension(), R(0));
    const SceneUnits units_of_scene = scene_units(scene);
    for (std::size_t i = 0; i < system.velocities(); ++i)
      units.push_back(R(i % 6 < 3 ? units_of_scene.length : units_of_scene.angle));
  }
  SpatialSystem<R> system;
  std::vector<R> start;
  SpatialOde<R> ode;
  std::vector<R> units;

 private:
  const SpatialSystem<R>& assembled(const SpatialScene& scene) {
    assemble_spatial_start(system, R(0), R(scene_units(scene).mechanism), start, scene.redundant);
    return system;
  }
};

template <class R>
using SmallOde = IndependentOde<InSpace<R>, run_time_size>;

/// (z, ż) of a start, moved at random: a film's eccentricities and velocities, places, or turns.
template <class R>
std::vector<R> moved(SmallOde<R>& small, const Prepared<R>& prepared, const SpatialScene& scene, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<R> x;
  small.take(prepared.start, x);
  const std::size_t f = small.freedoms();
  for (std::size_t k = 0; k < f; ++k) {
    const double size = small.chart().is_of_joint(k)
                            ? scene.joints[small.chart().joint_of(k)].plane.clearance
                            : 0.1 * (small.chart().is_turn(k) ? 1 : scene_units(scene).mechanism);
    x[k] += R(size * 0.4 * number(random));
    x[f + k] += R(size * 40 * number(random));
  }
  return x;
}

template <class R>
double largest_constraint(const SpatialSystem<R>& system, const R& t, const std::vector<R>& y) {
  SpatialWorkspace<R> w = system.template workspace<R>();
  system.evaluate_kinematics(t, y.data(), w);
  double largest = 0;
  for (const auto& row : w.rows) largest = std::max(largest, std::abs(static_cast<double>(row.value)));
  return largest;
}

double largest_norm_error(const std::vector<double>& y, std::size_t bodies) {
  double largest = 0;
  for (std::size_t b = 0; b < bodies; ++b)
    largest = std::max(largest, std::abs(spatial_motion_in(y.data(), bodies, b).parameters.norm() - 1));
  return largest;
}

/// Places of mass centres and axes of bodies at a sample: p and −p are the same.
std::vector<double> places(const SpatialSample& sample, std::size_t bodies) {
  std::vector<double> all;
  for (std::size_t b = 0; b < bodies; ++b) {
    const auto motion = spatial_motion_in(sample.state.data(), bodies, b);
    const Matrix3<double> a = rotation_matrix(motion.parameters);
    all.insert(all.end(), motion.position.data(), motion.position.data() + 3);
    all.insert(all.end(), a.data(), a.data() + 9);
  }
  return all;
}

double distance(const SpatialTrajectory& one, const SpatialTrajectory& other, std::size_t bodies) {
  REQUIRE(one.samples.size() == other.samples.size());
  double largest = 0;
  for (std::size_t i = 0; i < one.samples.size(); ++i) {
    const std::vector<double> a = places(one.samples[i], bodies);
    const std::vector<double> b = places(other.samples[i], bodies);
    for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  }
  return largest;
}

std::unique_ptr<Integrator<double, run_time_size>> radau(const StepTolerance<double, run_time_size>& tolerance) {
  return make_integrator<run_time_size>("radau_iia5", tolerance);
}
using SpatialIntegrator = IndependentIntegrator<InSpace<double>, run_time_size>;

}  // namespace

TEST_CASE("independent in space: after a search that finds no places the next one starts from the last good ones") {
  const SpatialScene scene = shipped("spatial-slider-crank");
  Prepared<double> prepared(scene);
  SmallOde<double> small(prepared.ode, prepared.units);
  small.choose(0, prepared.start);
  std::vector<double> good;
  small.take(prepared.start, good);
  good[0] += 0.2 * scene.joints[0].plane.clearance;
  std::vector<double> far = good, nan = good, expected(good.size()), rate(good.size());
  far[0] += 10;  // metres, both ways across the pin: one of them leaves the slider's guide
  far[1] += 10;
  nan[1] = std::nan("");
  small.rate(good, expected, 1e-4);
  const auto same = [&] {
    small.rate(good, rate, 1e-4);
    double scale = 0;
    for (const double each : expected) scale = std::max(scale, std::abs(each));
    for (std::size_t i = 0; i < rate.size(); ++i) CHECK(std::abs(rate[i] - expected[i]) < 1e-11 * scale);  // rounding
  };
  for (const std::vector<double>* bad : {&far, &nan}) {
    for (const double t : {1e-4, 2e-4}) {                             // where places are known, and at a new time
      CHECK_THROWS_AS(small.rate(*bad, rate, t), std::domain_error);  // none, or a journal across its bearing
      same();
    }
    std::vector<double> x;
    small.take(prepared.start, x);  // nothing is known then
    CHECK_THROWS_AS(small.rate(*bad, rate, 1e-4), std::domain_error);
    same();
  }
}

TEST_CASE("independent in space: accelerations, reactions and powers are those of the multipliers' equations") {
  for (const SpatialScene& scene : mechanisms_in_space()) {
    CAPTURE(scene.name);
    Prepared<double> prepared(scene, true);
    SmallOde<double> small(prepared.ode, prepared.units);
    small.choose(0, prepared.start);
    const std::size_t f = small.freedoms();
    REQUIRE(f == prepared.system.velocities() - prepared.system.kept().size());
    const std::size_t places_end = prepared.system.places();
    const std::size_t states = prepared.system.states();
    for (unsigned seed = 1; seed <= 20; ++seed) {
      CAPTURE(seed);
      const double t = 1e-5 * seed;
      const std::vector<double> x = moved(small, prepared, scene, seed);
      std::vector<double> rate(x.size()), y, y_rate(prepared.ode.dimension()), expected(prepared.ode.dimension());
      small.rate(x, rate, t);
      small.expand(t, x, y);
      CHECK(largest_constraint(prepared.system, t, y) < 4e-15);  // rounding of metres and cosines, and arms of them
      CHECK(largest_norm_error(y, scene.bodies.size()) < 4e-16);
      small.expand_rate(rate, y_rate);
      prepared.ode.rate(y, expected, t);
      double scale = 1;
      for (std::size_t i = places_end; i < states; ++i) scale = std::max(scale, std::abs(expected[i]));
      for (std::size_t i = places_end; i < states; ++i)
        CHECK(std::abs(y_rate[i] - expected[i]) < 1e-10 * scale);  // condition of the Schur complement, up to 1e5
      const std::vector<double>& wanted = prepared.ode.last().multipliers;
      const std::vector<double>& given = small.multipliers(x, t);
      double largest = 1;
      for (const double each : wanted) largest = std::max(largest, std::abs(each));
      for (std::size_t row = 0; row < wanted.size(); ++row)
        CHECK(std::abs(given[row] - wanted[row]) < 1e-9 * largest);  // likewise, times masses over inertias
      for (std::size_t i = states; i < y.size(); ++i) {
        const double size = std::max(1.0, std::abs(expected[i])) * largest;
        CHECK(std::abs(rate[2 * f + i - states] - expected[i]) < 1e-9 * size);  // of forces, times speeds below 1e3
      }
    }
  }
}

TEST_CASE("independent in space: ż of a chart's functions is the rate of z, and γ that of ż, by differences") {
  // Two bodies at constant ṙ and ω′, a bearing and a journal that tilts and slides in it.
  const auto axes = [](const Vector3<double>& point, const Vector3<double>& axis) {
    const Vector3<double> n = direction(axis);
    return AxisFrame<double>{point, n, any_perpendicular(n)}.cast<Long>();
  };
  const AxisFrame<Long> bearing = axes({0.02, 0.03, -0.01}, {1, 2, -1});
  const AxisFrame<Long> journal = axes({0.01, -0.02, 0.015}, {1, 1.5, -1.2});
  const Vector3<Long> axis = axes({0, 0, 0}, {3, -1, 2}).axis;
  const EulerParameters<Long> from = normalised(EulerParameters<Long>(Long(0.9), Long(0.1), Long(0.2), Long(-0.3)));
  struct Start {
    Vector3<double> position;
    EulerParameters<double> parameters;
    Vector3<double> velocity, spin;
  };
  const std::array<Start, 2> starts = {Start{{0.1, 0.2, 0.3}, {0.8, 0.3, -0.2, 0.4}, {1, 2, -1}, {3, -2, 5}},
                                       Start{{0.12, 0.18, 0.33}, {0.7, 0.4, -0.1, 0.45}, {-1, 0.5, 2}, {-4, 1, 2}}};
  const auto at = [&](const Long& h) {
    std::array<SpatialFrame<Long>, 2> frames;
    for (std::size_t b = 0; b < 2; ++b) {
      const Vector3<Long> spin = starts[b].spin.cast<Long>();
      const Vector3<Long> velocity = starts[b].velocity.cast<Long>();
      EulerParameters<Long> p = normalised<Long>(starts[b].parameters.cast<Long>());
      const auto q = euler_parameters<Long>(direction(spin), Long(norm(spin) * h));
      const Vector3<Long> e(p(1), p(2), p(3)), f(q(1), q(2), q(3));
      const Vector3<Long> turned = sum(sum(scaled(p(0), f), scaled(q(0), e)), cross(e, f));
      p = EulerParameters<Long>(Long(p(0) * q(0) - dot(e, f)), turned(0), turned(1), turned(2));
      frames[b] = SpatialFrame<Long>(
          {sum(Vector3<Long>(starts[b].position.cast<Long>()), scaled(h, velocity)), p, velocity, spin});
    }
    std::array<SpatialRow<Long>, 2> of_joint;
    fill_eccentricity(frames[0], frames[1], spatial_joint_kinematics(frames[0], bearing, frames[1], journal), of_joint);
    SpatialRow<Long> turn;
    fill_turn(frames[0], axis, from, turn);
    turn.second.fill(Long(0));
    std::array<std::array<Long, 3>, 3> rows;  // z, ż, γ
    for (std::size_t i = 0; i < 3; ++i) {
      const SpatialRow<Long>& row = i < 2 ? of_joint[i] : turn;
      Long rate = 0;
      for (std::size_t k = 0; k < 6; ++k) {
        const auto part = static_cast<Eigen::Index>(k % 3);
        const auto v = [&](std::size_t b) { return k < 3 ? frames[b].velocity(part) : frames[b].body_spin(part); };
        rate += row.first[k] * v(0) + row.second[k] * v(1);
      }
      rows[i] = {row.value, rate, row.gamma};
    }
    return rows;
  };
  const Long h = 1e-15;
  const auto above = at(h), below = at(-h), now = at(0);
  for (std::size_t i = 0; i < 3; ++i) {
    CAPTURE(i);
    // Of fifty digits the differences have twenty good ones; what is compared is rounded to double.
    CHECK(static_cast<double>(Long((above[i][0] - below[i][0]) / (2 * h))) ==
          Approx(static_cast<double>(now[i][1])).epsilon(1e-14).margin(1e-14));
    CHECK(static_cast<double>(Long((above[i][1] - below[i][1]) / (2 * h))) ==
          Approx(-static_cast<double>(now[i][2])).epsilon(1e-14).margin(1e-14));
  }
}

TEST_CASE("independent in space: the exact Jacobian and slope in time are those of differences of longer numbers") {
  std::vector<SpatialScene> all = {embedded_slider_crank(), shipped("spatial-slider-crank"), shipped("engine"),
                                   shipped("top")};
  const std::size_t half_films = all.size();  // from here on, which slide on their jump
  for (const char* law : {"short_half", "long_half"}) {
    for (const std::size_t i : {0u, 1u}) {
      all.push_back(all[i]);
      all.back().name += std::string(" with ") + law;
      all.back().joints[0].plane.film = law;
      if (i == 1) all.back().joints[0].plane.shear = ShearExtent::film;
    }
  }
  for (std::size_t number = 0; number < all.size(); ++number) {
    const SpatialScene& scene = all[number];
    CAPTURE(scene.name);
    Prepared<Long> prepared(scene, true);
    if (number >= half_films) {
      JointMemory<Long>& memory = prepared.ode.memory()[0];
      memory.side = FilmSide::sliding;
      memory.line = direction(Vector2<Long>(Long(0.6), Long(-0.3)));
      memory.line_angle = Long(0.2);
    }
    SmallOde<Long> small(prepared.ode, prepared.units);
    small.choose(Long(0), prepared.start);
    const std::vector<Long> x = moved(small, prepared, scene, 7);
    const Long t = 1e-4;
    SmallOde<Long>::Jacobian exact;
    small.jacobian(x, exact, t);
    std::vector<Long> slope(x.size());
    small.time_slope(x, slope, t);
    const std::size_t f = small.freedoms();
    const auto rate_at = [&](std::size_t column, const Long& by) {
      std::vector<Long> near = x, rate(x.size());
      if (column < 2 * f) near[column] += by;
      small.rate(near, rate, column < 2 * f ? t : Long(t + by));
      return rate;
    };
    for (std::size_t column = 0; column <= 2 * f; ++column) {
      const Long h = 1e-18;  // of fifty digits, of clearances of 1e-4: differences have twenty good ones
      const std::vector<Long> above = rate_at(column, h), below = rate_at(column, -h);
      for (std::size_t row = 0; row < x.size(); ++row) {
        const Long wanted = (above[row] - below[row]) / (2 * h);
        const Long given =
            column < 2 * f ? exact(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) : slope[row];
        const double size = 1 + std::abs(static_cast<double>(wanted));
        INFO("row " << row << ", column " << column << ": " << static_cast<double>(given) << " and "
                    << static_cast<double>(wanted));
        CHECK(std::abs(static_cast<double>(Long(given - wanted))) < 1e-12 * size);  // h² times third derivatives
      }
    }
  }
}

TEST_CASE("independent in space: mechanisms take the way of absolute coordinates, to the tolerance") {
  for (SpatialScene scene : {shipped("spatial-slider-crank"), shipped("engine"), shipped("top"),
                             shipped("flyball-governor"), embedded(crank_rocker(), 1)}) {
    CAPTURE(scene.name);
    set_tolerance(scene, 1e-11);
    scene.run.duration = std::min(scene.run.duration, 0.2);
    scene.run.output_interval = scene.run.duration / 40;
    scene.run.max_steps = 1'000'000;
    scene.integrator = "radau_iia5";
    scene.coordinates = SceneCoordinates::independent;
    if (scene.name == "engine") set_tolerance(scene, 1e-13);  // two revolutions of a turn, in thousands of steps
    const SpatialTrajectory run = simulate_spatial(scene);
    set_tolerance(scene, 1e-11);
    INFO(run.outcome.message);
    REQUIRE(run.outcome.status == RunStatus::finished);
    CHECK(run.outcome.coordinates == "independent");
    scene.coordinates = SceneCoordinates::absolute;
    scene.stabilisation.projection = true;
    const SpatialTrajectory wanted = simulate_spatial(scene);
    REQUIRE(wanted.outcome.status == RunStatus::finished);
    // Thousands of steps of 1e-11 of the smallest length, turns over the mechanism's; most of it interpolation's.
    CHECK(distance(run, wanted, scene.bodies.size()) < 1e-8);
    for (std::size_t i = 0; i < run.samples.size(); ++i) {
      for (std::size_t j = 0; j < scene.joints.size(); ++j) {
        const Vector3<double> off = run.samples[i].joints[j].eccentricity - wanted.samples[i].joints[j].eccentricity;
        CHECK(off.norm() < 1e-7 * scene.joints[j].plane.clearance);  // likewise
      }
    }
  }
}

TEST_CASE(
    "independent in space: a plane's slider-crank takes the plane's way to 1e-9 of a clearance, however it lies") {
  for (const char* name : {"slider-crank", "slider-crank-c0.5-mu0.04"}) {
    Scene flat = load_scene(data + name + ".toml");
    test::set_tolerance(flat, 1e-13);
    flat.run.duration /= 4;
    flat.run.output_interval = flat.run.duration / 40;
    flat.run.stop_at_outputs = true;  // no sample is interpolated
    flat.coordinates = SceneCoordinates::independent;
    const MultibodyTrajectory wanted = simulate_multibody(flat);
    for (const unsigned plane : {1u, 2u, 4u}) {
      INFO(name << ", plane " << plane);
      SpatialScene scene = embedded(flat, plane);
      scene.coordinates = SceneCoordinates::independent;
      const SpatialTrajectory run = simulate_spatial(scene);
      REQUIRE(run.outcome.status == RunStatus::finished);
      REQUIRE(run.samples.size() == wanted.samples.size());
      const Embedding in(some_plane(plane));
      for (std::size_t i = 0; i < run.samples.size(); ++i) {
        const Vector3<double> e = in.vector(wanted.samples[i].joints[0].eccentricity);
        CHECK((run.samples[i].joints[0].eccentricity - e).norm() < 1e-9 * flat.joints[0].clearance);  // asked for
      }
      CHECK(run.outcome.steps < wanted.outcome.steps + wanted.outcome.steps / 10);
    }
  }
}

TEST_CASE("independent in space: a film on a loop with rows left out takes the plane's way to 1e-9 of a clearance") {
  Scene flat = crank_rocker();  // and a weight that hangs on the rocker's end in a film
  const SceneBody& rocker = flat.bodies[0];
  const Vector2<double> end = 2 * rocker.position - Vector2<double>(0.25, 0);
  flat.bodies.push_back(body("weight", 0.3, 4e-4, end + Vector2<double>(2e-5, -0.05)));
  SceneJoint film = load_scene(data + "slider-crank.toml").joints[0];
  film.bearing = {0, {0.1, 0}};
  film.journal = {3, {0, 0.05}};
  flat.joints = {film};
  flat.run.duration = 0.2;
  flat.run.output_interval = 0.01;
  flat.run.stop_at_outputs = true;
  test::set_tolerance(flat, 1e-13);
  flat.coordinates = SceneCoordinates::independent;
  const MultibodyTrajectory wanted = simulate_multibody(flat);
  INFO(wanted.outcome.message);
  REQUIRE(wanted.outcome.status == RunStatus::finished);
  SpatialScene scene = embedded(flat, 4);
  CHECK(scene.redundant == RedundantConstraints::allow);
  scene.coordinates = SceneCoordinates::independent;
  const SpatialTrajectory run = simulate_spatial(scene);
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  CHECK(run.left_out.size() == 3);
  CHECK(run.drift.left_out_position < 1e-14);  // rounding, as of the others
  const Embedding in(some_plane(4));
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const Vector3<double> e = in.vector(wanted.samples[i].joints[0].eccentricity);
    CHECK((run.samples[i].joints[0].eccentricity - e).norm() < 1e-9 * film.clearance);  // what is asked for
  }
}

TEST_CASE("independent in space: constraints and |p| = 1 hold to rounding at every step of 200 revolutions") {
  SpatialScene scene = embedded_slider_crank();
  scene.energy_ledger = false;
  set_tolerance(scene, 1e-6);
  Prepared<double> prepared(scene);
  std::vector<std::array<double, 2>> of_joints = {{2e-10, 1e-7}};
  SpatialIntegrator method(prepared.ode, {0, scene_tolerances(scene), 1e-6, 0}, of_joints, radau);
  std::vector<double> y = prepared.start;
  const double duration = 100 * scene.run.duration;
  double t = 0, dt = 1e-6, open = 0, norm = 0, pace = 0;
  std::size_t steps = 0;
  auto w = prepared.system.workspace<double>();
  while (t < duration) {
    dt = std::min(dt, duration - t);
    if (!method.try_step(prepared.ode, y, t, dt)) continue;
    ++steps;
    prepared.system.evaluate_kinematics(t, y.data(), w);
    for (std::size_t row = 0; row < w.rows.size(); ++row) {
      const bool is_motor = prepared.system.constraints()[prepared.system.constraint_of(row)].is_driver();
      // Angles of 1257 rad have steps of 2e-13, which Φ of the motor shows.
      open = std::max(open, std::abs(w.rows[row].value) / (is_motor ? 1000 : 1));
      pace = std::max(pace, std::abs(prepared.system.constraint_rate(row, w)));
    }
    norm = std::max(norm, largest_norm_error(y, scene.bodies.size()));
  }
  CHECK(steps > 5000);
  CHECK(open < 4e-15);           // rounding of metres and cosines; rows that are left out are in it
  CHECK(norm < 4e-16);           // rounding
  CHECK(pace < 1e-11);           // rounding of speeds up to 524 rad/s times a condition of some 100
  CHECK(method.charts() > 200);  // the pivots of a crank that turns do not last for a revolution
}

TEST_CASE("independent in space: the ledger closes over 50 revolutions of a mechanism with a film") {
  SpatialScene scene = shipped("spatial-slider-crank");
  scene.energy_ledger = true;
  set_tolerance(scene, 1e-8);
  scene.run.duration = 50;
  scene.run.output_interval = 1;
  scene.coordinates = SceneCoordinates::independent;
  const SpatialTrajectory run = simulate_spatial(scene);
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  CHECK(run.drift.position < 1e-14);  // rounding of metres and cosines
  CHECK(run.drift.norm < 1e-15);
  CHECK(*run.energy_residual < 1e-8 * static_cast<double>(run.outcome.steps) * run.energy_scale);  // a step's error
}

TEST_CASE("independent in space: a chart that wears out is replaced between two steps, unseen") {
  // The crank-rocker, whose rocker is chosen first; and a top, whose turns since an orientation end with it.
  SpatialScene rocker = embedded(crank_rocker(), 3);
  SpatialScene top = shipped("top");
  top.run.duration = std::min(top.run.duration, 0.5);
  for (SpatialScene* scene : {&rocker, &top}) {
    CAPTURE(scene->name);
    scene->energy_ledger = false;
    set_tolerance(*scene, 1e-13);
    Prepared<double> prepared(*scene);
    std::vector<double> tolerances = scene_tolerances(*scene);
    if (scene == &rocker) {
      for (std::size_t i = 0; i < tolerances.size(); ++i)
        tolerances[i] *= i < prepared.system.places() && i >= 7 ? 1e2 : 1;  // the rocker is known best
    } else {
      for (std::size_t i = 0; i < 3; ++i) tolerances[i] *= 1e6;  // turns before places
    }
    SpatialIntegrator method(prepared.ode, {0, tolerances, 1e-13, 0}, {}, radau);
    std::vector<double> y = prepared.start;
    double t = 0, dt = 1e-5, worst = 0;
    while (t < scene->run.duration) {
      dt = std::min(dt, scene->run.duration - t);
      if (method.try_step(prepared.ode, y, t, dt)) worst = std::max(worst, largest_constraint(prepared.system, t, y));
    }
    CHECK(method.charts() > 2);
    CHECK(worst < 4e-15);  // rounding of lengths of 0.25 m and cosines
    scene->run.output_interval = scene->run.duration / 50;
    set_tolerance(*scene, 1e-12);
    scene->integrator = "radau_iia5";
    scene->coordinates = SceneCoordinates::absolute;
    scene->stabilisation.projection = true;
    const SpatialTrajectory wanted = simulate_spatial(*scene);
    REQUIRE(wanted.outcome.status == RunStatus::finished);
    const std::size_t bodies = scene->bodies.size();
    SpatialSample end = wanted.samples.back();
    end.state.assign(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(prepared.system.states()));
    const std::vector<double> given = places(end, bodies), expected = places(wanted.samples.back(), bodies);
    for (std::size_t i = 0; i < given.size(); ++i)
      CHECK(given[i] == Approx(expected[i]).margin(3e-7));  // some 3000 steps, to 1e-11 each, and what angles make of it
    scene->coordinates = SceneCoordinates::independent;
    scene->stabilisation = {};
    CHECK(distance(simulate_spatial(*scene), wanted, bodies) < 1e-7);  // within steps, too
  }
}

TEST_CASE("independent in space: a journal that touches does so when it does in the plane") {
  Scene flat = load_scene(data + "slider-crank-c0.5-mu0.04.toml");
  flat.joints[0].contact = SceneContact{207e9, 0.3, 207e9, 0.3, 0.9, 1e-3, 0.03, 1e-3};
  flat.joints[0].transition = SceneTransition{5e-6, 2.5e-5};
  flat.joints[0].viscosity = 0.004;
  test::set_tolerance(flat, 1e-10);
  flat.run.duration /= 2;
  flat.run.max_steps = 1'000'000;
  flat.coordinates = SceneCoordinates::independent;
  const MultibodyTrajectory wanted = simulate_multibody(flat);
  INFO(wanted.outcome.message);
  REQUIRE(wanted.outcome.status == RunStatus::finished);
  REQUIRE(wanted.events.size() > 1);
  SpatialScene scene = embedded(flat, 2);
  scene.coordinates = SceneCoordinates::independent;
  const SpatialTrajectory run = simulate_spatial(scene);
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  REQUIRE(run.events.size() == wanted.events.size());
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    CHECK(run.events[i].to == wanted.events[i].to);
    CHECK(run.events[i].t == Approx(wanted.events[i].t).margin(1e-6 * flat.run.duration));  // 1e-10, grown by impacts
  }
}

TEST_CASE("independent in space: auto picks them where they are few, and says why") {
  const auto chosen = [](const SpatialScene& scene) {
    const Prepared<double> prepared(scene);
    return choose_coordinates(scene, prepared.system);
  };
  CHECK(chosen(embedded_slider_crank()).independent);
  CHECK(chosen(embedded_slider_crank()).reason == "2 degrees of freedom in 18 coordinates");
  SpatialScene scene = embedded_slider_crank();
  scene.stabilisation.asked = true;
  CHECK_FALSE(chosen(scene).independent);
  CHECK_THAT(chosen(scene).reason, Contains("stabilisation"));
  scene = embedded(load_scene(data + "slider-crank-ideal.toml"), 1);
  scene.stabilisation = {};
  CHECK(chosen(scene).reason == "the constraints prescribe all motion");
  scene.coordinates = SceneCoordinates::independent;
  CHECK_THROWS_WITH(chosen(scene), Contains("prescribe all motion") && Contains("\"absolute\""));
  scene = embedded_slider_crank();
  scene.coordinates = SceneCoordinates::absolute;
  CHECK_FALSE(chosen(scene).independent);
  CHECK(chosen(scene).reason.empty());
  scene = embedded(pendulum_chain(11, 0.3), 1);  // of 66 coordinates
  CHECK(chosen(scene).reason == "66 coordinates are more than 60");
}

TEST_CASE("independent in space: what a scene may ask for is refused by line and key where it makes no sense") {
  const std::string text = reports::read_input(data + "space/spatial-slider-crank.toml");
  const auto with = [&](const std::string& value, const std::string& more = "") {
    std::string changed = text;
    const std::string line = "coordinates = \"auto\"";
    changed.replace(changed.find(line), line.size(), "coordinates = " + value);
    return changed + more;
  };
  const std::string table = "[stabilisation]\nmethod = \"projection\"\n";
  const auto read = [](const std::string& scene) { return parse_spatial_scene(scene, "s.toml").coordinates; };
  CHECK(read(text) == SceneCoordinates::automatic);
  CHECK(read(with("\"absolute\"")) == SceneCoordinates::absolute);
  CHECK(read(with("\"independent\"")) == SceneCoordinates::independent);
  CHECK_THROWS_WITH(read(with("\"minimal\"")), Contains("s.toml:15: coordinates is \"minimal\"") &&
                                                   Contains("\"auto\", \"independent\" or \"absolute\""));
  CHECK_THROWS_WITH(read(with("2")), Contains("s.toml:15: coordinates"));
  CHECK_THROWS_WITH(read(with("\"independent\"", table)), Contains("beside a stabilisation table"));
  CHECK(read(with("\"absolute\"", table)) == SceneCoordinates::absolute);
  const std::string free =
      "dimension = 3\nname = \"free\"\nduration = 1.0\njoints = []\n[[bodies]]\nname = \"b\"\n"
      "mass = 1.0\ninertia = [1.0, 1.0, 1.0]\n";
  for (const char* value : {"\"absolute\"", "\"independent\""})
    CHECK_THROWS_WITH(read("coordinates = " + std::string(value) + "\n" + free), Contains("without constraints"));
  CHECK_NOTHROW(read("coordinates = \"auto\"\n" + free));
}

}  // namespace space_independent_test

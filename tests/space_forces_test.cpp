// Springs about axes, tables, unbalances and prescribed motions in space: closed forms, the plane, and refusals.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "lubjoint/motion/in_space.hpp"
#include "lubjoint/ode/integrators.hpp"
#include "lubjoint/scene/simulate.hpp"
#include "support/embedded_scene.hpp"
#include "support/scenes.hpp"
#include "support/spatial_refusals.hpp"
#include "support/temporary_folder.hpp"

namespace space_forces_test {

using namespace lubjoint;
using namespace lubjoint::test;
using V3 = Vector3<double>;

namespace {

const std::string data = std::string(LUBJOINT_SOURCE_DIR) + "/data/";

/// A wheel of inertia 2 kg m² on a pin about an axis of no special direction, at rest.
SpatialScene wheel() {
  SpatialScene scene;
  scene.file = scene.name = "wheel";
  SpatialSceneBody body;
  body.name = "wheel";
  body.mass = 3;
  body.inertia.diagonal() << 1.5, 1.2, 2;
  body.orientation = euler_parameters<double>(direction(V3(1, 2, -0.5)), 0.8);
  body.position = {0.3, -0.1, 0.2};
  scene.bodies = {body};
  const Matrix3<double> a = rotation_matrix(body.orientation);
  const BodyAxes<double> on_ground{{body.position, a.col(2), a.col(0)}, ground_body};
  const BodyAxes<double> on_wheel{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, 0};
  scene.constraints = {{"pin", RevoluteJoint<double>{{on_ground, on_wheel}}}};
  scene.angles = {{on_ground, on_wheel, 0}};
  scene.sensors = {{"turn", SpatialAngleSensor{0}}};
  scene.energy_ledger = true;
  scene.run.duration = 2;
  scene.run.output_interval = 0.02;
  return scene;
}

void set_tolerance(SpatialScene& scene, double tolerance) {
  scene.run.relative_tolerance = scene.run.absolute_tolerance = tolerance;
}

}  // namespace

TEST_CASE("space: a spring about an axis turns a wheel through many revolutions as a pendulum of one frequency") {
  constexpr double stiffness = 30, free = 41;  // six revolutions and a half
  for (const SceneCoordinates coordinates : {SceneCoordinates::absolute, SceneCoordinates::independent}) {
    for (const std::string_view method : integrator_names()) {
      if (method == automatic_integrator) continue;
      // At the loosest ones steps are as wide as they may be: they turn the wheel by three eighths of a revolution.
      for (const double tolerance : {1e-2, 1e-3, 1e-5, 1e-9}) {
        SpatialScene scene = wheel();
        scene.springs = {{"spiral", SpatialRotationalSpring<double>{0, ground_body, 0, stiffness, 0, free}}};
        scene.coordinates = coordinates;
        scene.integrator = method;
        set_tolerance(scene, tolerance);
        const SpatialTrajectory run = simulate_spatial(scene);
        INFO(method << ", " << run.outcome.coordinates << ", " << tolerance << ", " << run.outcome.steps
                    << " steps: " << run.outcome.message);
        REQUIRE(run.outcome.status == RunStatus::finished);
        const double rate = std::sqrt(stiffness / 2);  // of J = 2 kg m²
        double worst = 0;
        for (const SpatialSample& sample : run.samples)
          worst = std::max(worst, std::abs(sample.sensors[0] - free * (1 - std::cos(rate * sample.t))));
        // No revolution is lost: errors of steps add up, over the way of 82 rad; the worst are 0.9 of that.
        CHECK(worst < 2 * (2 * free) * tolerance);
        CHECK(run.sensors[0].max.value == Approx(2 * free).margin(2 * (2 * free) * tolerance));
        CHECK(*run.energy_residual < 100 * tolerance * run.energy_scale);  // likewise, of rates that force the places
      }
    }
  }
}

TEST_CASE("space: a damper about an axis takes what the ledger says, and a wheel comes to rest") {
  SpatialScene scene = wheel();
  scene.bodies[0].spin = {0, 0, 100};
  scene.springs = {{"brake", SpatialRotationalSpring<double>{0, ground_body, 0, 0, 4, 0}}};
  set_tolerance(scene, 1e-10);
  const SpatialTrajectory run = simulate_spatial(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  const SpatialSample& last = run.samples.back();
  CHECK(last.sensors[0] == Approx(50 * (1 - std::exp(-4))).epsilon(1e-8));       // J/c = 0.5 s; the run's error
  CHECK(last.sensors[1] == Approx(100 * std::exp(-4)).epsilon(1e-8));            // likewise
  CHECK(last.ledger.back() == Approx(-1e4 * (1 - std::exp(-8))).epsilon(1e-8));  // ½ J ω², likewise
  CHECK(*run.energy_residual < 1e-8 * run.energy_scale);                         // likewise
}

TEST_CASE("space: a table over an angle does the work under its curve, through every revolution") {
  // Over two revolutions, so that odd ones differ from even ones: M = m₀ + m₁ sin(θ/2) in 64 lines.
  constexpr double period = 4 * std::numbers::pi;
  std::vector<double> knots;
  std::vector<std::array<TableCurves<6>::Cubic, 6>> pieces;
  const auto moment = [](double angle) { return 3 + 20 * std::sin(angle / 2); };
  for (int k = 0; k <= 64; ++k) knots.push_back(period * k / 64);
  const auto under = [&](double to) {  // of the lines, from 0 on
    double work = 0;
    for (std::size_t k = 0; k < 64; ++k) {
      const double share = std::clamp((to - knots[k]) / (knots[k + 1] - knots[k]), 0.0, 1.0);
      const double from = moment(knots[k]);
      const double rise = moment(knots[k + 1]) - from;
      work += (knots[k + 1] - knots[k]) * share * (from + share * rise / 2);
    }
    return work;
  };
  SpatialScene scene = wheel();
  const V3 n = inertial_vector(frame_at_start(scene, 0), V3(0, 0, 1));
  for (std::size_t k = 0; k < 64; ++k) {
    pieces.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const double along = n(static_cast<Eigen::Index>(i));
      pieces.back()[i] = {0, 0, 0, 0};
      pieces.back()[3 + i] = {along * moment(knots[k]),
                              along * (moment(knots[k + 1]) - moment(knots[k])) / (knots[k + 1] - knots[k]), 0, 0};
    }
  }
  SpatialSceneLoad load;
  load.table = SpatialSceneTable{std::make_shared<const TableCurves<6>>(knots, pieces, true), true, 0};
  scene.loads = {load};
  for (const double spin : {20.0, -20.0}) {
    for (const SceneCoordinates coordinates : {SceneCoordinates::absolute, SceneCoordinates::independent}) {
      SpatialScene turning = scene;
      turning.bodies[0].spin = {0, 0, spin};
      turning.coordinates = coordinates;
      set_tolerance(turning, 1e-10);
      const SpatialTrajectory run = simulate_spatial(turning);
      INFO(spin << ", " << run.outcome.coordinates << ": " << run.outcome.message);
      REQUIRE(run.outcome.status == RunStatus::finished);
      CHECK(std::abs(run.samples.back().sensors[0]) > 2 * period);  // or odd and even ones were not told apart
      for (const SpatialSample& sample : run.samples) {
        const double angle = sample.sensors[0];
        const double turns = std::floor(angle / period);
        const double work = turns * under(period) + under(angle - turns * period);
        CHECK(sample.sensors[1] * sample.sensors[1] - 400 == Approx(work).margin(1e-6));  // ½ J; errors of the run
      }
    }
  }
}

TEST_CASE("space: a held spin turns a body about its axis, and its unbalance moves it as an offset mass does") {
  SpatialScene scene;
  scene.file = scene.name = "rotor";
  scene.gravity = {0.3, -0.2, -9};
  SpatialSceneBody body;
  body.name = "rotor";
  body.mass = 5;
  body.inertia.diagonal() << 0.1, 0.15, 0.2;
  body.orientation = euler_parameters<double>(direction(V3(0.2, -1, 0.6)), 2.1);
  body.spin = {10, -30, 20};
  body.spin_is_held = true;
  scene.bodies = {body};
  SpatialSceneLoad load;
  const V3 u = 0.02 * direction(V3(V3(1, 1, 1).cross(body.spin)));
  load.unbalance = u;
  scene.loads = {load};
  scene.run.duration = 0.5;
  scene.run.output_interval = 0.01;
  scene.energy_ledger = true;
  set_tolerance(scene, 1e-11);
  const Matrix3<double> a = rotation_matrix(body.orientation);
  const double rate = body.spin.norm();
  const V3 e = a * u;
  const V3 across = a * body.spin.cross(u) / rate;
  for (const SceneCoordinates coordinates : {SceneCoordinates::absolute, SceneCoordinates::independent}) {
    scene.coordinates = coordinates;
    const SpatialTrajectory run = simulate_spatial(scene);
    INFO(run.outcome.coordinates << ": " << run.outcome.message);
    REQUIRE(run.outcome.status == RunStatus::finished);
    CHECK(run.driver_names == std::vector<std::string>{"rotor.spin"});
    // m r̈ = m g + U ω² (e cos ωt + e′ sin ωt), from rest: of an offset mass the same, with its centre at r − (U/m) u.
    for (const SpatialSample& sample : run.samples) {
      const double t = sample.t;
      const V3 wanted = V3(scene.gravity * (t * t / 2)) +
                        V3(e * (1 - std::cos(rate * t)) + across * (rate * t - std::sin(rate * t))) / body.mass;
      for (Eigen::Index k = 0; k < 3; ++k)
        CHECK(std::abs(sample.state[static_cast<std::size_t>(k)] - wanted(k)) < 1e-9);  // errors of the run
      const auto turned = euler_parameters<double>(direction(body.spin), rate * t);
      const Matrix3<double> r =
          rotation_matrix(EulerParameters<double>(sample.state[3], sample.state[4], sample.state[5], sample.state[6]));
      CHECK((r - a * rotation_matrix(turned)).cwiseAbs().maxCoeff() < 1e-8);  // what is prescribed, to the drift
    }
    CHECK(*run.energy_residual < 1e-8 * run.energy_scale);  // errors of the run
  }
}

TEST_CASE("space: springs about pins, swings, tables and held spins of the plane's scenes take the plane's way") {
  for (const char* name : {"examples/lever", "examples/shaker", "scenes/machines/rotor", "scenes/machines/engine"}) {
    Scene flat = load_scene(data + name + ".toml");
    lubjoint::test::set_tolerance(flat, 1e-11);
    flat.run.duration /= 4;
    flat.run.output_interval = flat.run.duration / 40;
    flat.run.stop_at_outputs = true;  // no sample is interpolated
    flat.energy_ledger = true;
    flat.sensors.clear();
    const Embedding in(some_plane(5));
    SpatialScene space = in.scene(flat);
    allow_what_is_redundant(space);
    const MultibodyTrajectory wanted = simulate_multibody(flat);
    REQUIRE(wanted.outcome.status == RunStatus::finished);  // the engine: also after a step of 3e-15 s to an output
    for (const SceneCoordinates coordinates : {SceneCoordinates::absolute, SceneCoordinates::independent}) {
      space.coordinates = coordinates;
      const SpatialTrajectory run = simulate_spatial(space);
      INFO(name << ", " << run.outcome.coordinates << ": " << run.outcome.message);
      REQUIRE(run.outcome.status == RunStatus::finished);
      REQUIRE(run.samples.size() == wanted.samples.size());
      const double clearance = flat.joints.empty() ? 1e-3 : flat.joints[0].clearance;
      double worst = 0;
      for (std::size_t i = 0; i < run.samples.size(); ++i) {
        const std::vector<double> state = in.state(wanted.samples[i].state, wanted.samples[i].t);
        for (std::size_t b = 0; b < flat.bodies.size(); ++b) {
          for (std::size_t k = 7 * b; k < 7 * b + 3; ++k)
            worst = std::max(worst, std::abs(run.samples[i].state[k] - state[k]));
        }
      }
      CHECK(worst < 1e-7 * clearance);                        // errors of both runs
      CHECK(*run.energy_residual < 1e-8 * run.energy_scale);  // likewise
      for (std::size_t d = 0; d < run.drivers.size(); ++d) {
        const double size = std::max(std::abs(wanted.drivers[d].max_moment.value), 1e-3);
        CHECK(run.drivers[d].max_moment.value == Approx(wanted.drivers[d].max_moment.value).margin(1e-6 * size));
      }
    }
  }
}

TEST_CASE("space: the fan's springs, tables, unbalance, points and sensors run, and its ledger closes") {
  SpatialScene scene = load_spatial_scene(data + "examples/fan.toml");
  const SpatialTrajectory run = simulate_spatial(scene);
  INFO(run.outcome.message);
  REQUIRE(run.outcome.status == RunStatus::finished);
  CHECK(*run.energy_residual < 1e-6 * run.energy_scale);  // errors of a run at 1e-8
  const TrajectoryTable table = trajectory_table(scene, run);
  for (const char* column : {"rotor.spin.moment", "motor.moment", "work.dampers", "corner.x", "flap-angle.angle",
                             "flap-angle.rate", "wheel-angle.angle", "torsion.tension", "hub-force.mx"})
    CHECK(std::count(table.columns.begin(), table.columns.end(), column) == 1);
  CHECK(run.samples.back().sensors[8] >
        2 * std::numbers::pi);  // the wheel's angle, after the corner's six and the flap's
  SpatialScene absolute = scene;
  absolute.coordinates = SceneCoordinates::absolute;
  absolute.integrator = "dopri5";
  const SpatialTrajectory other = simulate_spatial(absolute);
  REQUIRE(other.outcome.status == RunStatus::finished);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(std::abs(other.samples.back().sensors[k] - run.samples.back().sensors[k]) <
          1e-6);                                                                            // drift of the constraints
  CHECK(std::abs(other.samples.back().sensors[8] - run.samples.back().sensors[8]) < 1e-5);  // likewise
  // A name is a place: the same scene with the point's numbers.
  const std::string text = read_text(data + "examples/fan.toml");
  const std::string named = "second = {body = \"plate\", point = \"a\"}";
  const std::size_t at = text.find(named);
  REQUIRE(at != std::string::npos);
  const SpatialScene placed = parse_spatial_scene(
      std::string(text).replace(at, named.size(), "second = {body = \"plate\", point = [0.2, 0.15, 0.0]}"),
      data + "examples/fan.toml");
  const auto end = [](const SpatialScene& of) {
    return std::get<SpatialTranslationalSpring<double>>(of.springs[0].spring).second.point;
  };
  CHECK(end(placed) == end(scene));
}

TEST_CASE("space: what springs, loads, spins and sensors may not say is refused by line, key, given and allowed") {
  const Refused all[] = {
      {"spin = {held = [0.0, 0.0, 150.0]}", "spin = {kept = [0.0, 0.0, 150.0]}",
       "bodies[1].spin is a table without held", "{held = [x, y, z]} where it is prescribed"},
      {"spin = {held = [0.0, 0.0, 150.0]}", "spin = [0.0, 0.0, 150.0]",
       "unbalance is on body \"rotor\", whose spin is not", "a body with spin = {held = [x, y, z]}"},
      {"spin = {held = [0.0, 0.0, 150.0]}", "spin = {held = [0.0, 0.0, 0.0]}",
       "mass_radius is given for body \"rotor\"", "an unbalance that does not turn does nothing"},
      {"direction = [1.0, 0.0, 0.0]", "direction = [1.0, 0.0, 0.1]", "unbalance.direction is one that leans by 0.0996",
       "across that spin"},
      {"direction = [1.0, 0.0, 0.0]", "direction = [0.0, 0.0, 0.0]", "unbalance.direction is [0, 0, 0]", "a direction"},
      {"mass_radius = 4.0e-5", "mass_radius = -4.0e-5", "mass_radius is -4", "a finite number above 0 [kg m]"},
      {"unbalance = {", "point = \"a\"\nunbalance = {", "point is \"a\"", "body \"rotor\" names no points"},
      {"revolute = \"hinge\"\nstiffness", "revolute = \"hub\"\nstiffness", "springs[4].revolute is \"hub\"",
       "revolute or cylindrical constraint: \"hinge\" \"pivot\" \"axle\""},
      {"free_angle = -0.1", "free_length = -0.1", "springs[4].free_angle is missing", "a finite number [rad]"},
      {"point = [0.26, 0.21, 0.1]", "point = [0.2, 0.15, 0.0]", "springs[0].second is where first is",
       "a distance above 0"},
      {"against = \"axle\"", "against = \"wheel\"", "loads[2].against is \"wheel\"", "\"axle\""},
      {"periodic = true", "periodic = true\nstart_angle = 0.1", "start_angle is given for a table over t",
       "a table whose first column is angle"},
      {"table = \"tables/ratchet.csv\"", "table = \"tables/gusts.csv\"", "against is given for a table over t",
       "a table whose first column is angle"},
      {"table = \"tables/gusts.csv\"\nperiodic = true", "table = \"tables/gusts.csv\"",
       "loads[1].table is a table from 0 s to 0.4 s", "one that covers the run"},
      {"table = \"tables/gusts.csv\"", "table = \"tables/wind.csv\"\nmoment = [0.0, 0.0, 1.0]",
       "unknown key loads[1].moment", "point"},
      {"frequency = 5.0", "frequency = 5e6", "harmonic.frequency is 5e+06 Hz, by which the run has 5e+06 periods",
       "at most 1000000 periods"},
      {"amplitude = 0.4, frequency = 2.0", "amplitude = 0.0, frequency = 2.0", "harmonic.amplitude is 0",
       "a swing that does something"},
      {"harmonic = {amplitude = 0.4, frequency = 2.0}", "table = \"tables/gusts.csv\"",
       "gusts.csv:2: a column is \"fz\"", "one of angle"},
      {"type = \"angle\"       # angle [rad], rate [rad/s]; counted through revolutions\nrevolute = \"hinge\"",
       "type = \"angle\"\nbody = \"flap\"", "revolute is missing", "a string"},
      {"point = \"tip\"", "point = \"tap\"", "loads[1].point is \"tap\"", "one of hinge, tip"},
  };
  const std::string file = data + "examples/fan.toml";
  check_refusals(read_text(file), file, all);
}

TEST_CASE("space: Euler parameters go on from a step to the next, whatever revolution a search found") {
  const EulerParameters<double> p = euler_parameters<double>(direction(V3(0.3, -2, 1)), 1.1);
  const V3 axis = direction(V3(1, 0.4, -0.7));
  constexpr double h = 0.1;
  for (const double angle : {0.0, 1e-3, 0.5, 2.0, 3.1, 5.0}) {
    const EulerParameters<double> next = turned<double>(p, V3(angle * axis));
    const EulerParameters<double> wanted =
        next.dot(p) * std::cos(angle / 2) < 0 ? EulerParameters<double>(-next) : next;
    for (const int sign : {1, -1}) {
      const auto state = [&](const EulerParameters<double>& at) {
        const V3 spin = angle / h * axis;
        return std::vector<double>{0, 0, 0, at(0), at(1), at(2), at(3), 0, 0, 0, spin(0), spin(1), spin(2)};
      };
      std::vector<double> y = state(sign * wanted);
      InSpace<double>::go_on_from(state(p), h, 1, y);
      INFO(angle << ", " << sign);
      CHECK(y == state(wanted));
    }
  }
}

TEST_CASE("space: a turn by a rotation vector of any size is a turn about it") {
  const EulerParameters<double> p = euler_parameters<double>(direction(V3(0.3, -2, 1)), 1.1);
  const V3 axis = direction(V3(1, 0.4, -0.7));
  for (const double angle : {1e-3, 0.01, 1.5, 3.0, 7.0, 40.0}) {
    const Matrix3<double> wanted =
        rotation_matrix(p) * rotation_matrix(euler_parameters<double>(axis, angle));  // in the body's axes
    const Matrix3<double> found = rotation_matrix(turned<double>(p, V3(angle * axis)));
    INFO(angle);
    CHECK((found - wanted).cwiseAbs().maxCoeff() < 1e-14);  // rounding; the series' next term is 4e-4 of 0.01^7
  }
}

TEST_CASE("space: what slides on a guide of no special direction moves alike in all coordinates") {
  const Matrix3<double> a = rotation_matrix(euler_parameters<double>(direction(V3(1, -2, 0.7)), 0.9));
  const BodyAxes<double> guide{{{0.1, 0.2, -0.1}, a.col(2), a.col(0)}, ground_body};
  const BodyAxes<double> on_body{{{0.02, -0.01, 0.03}, {0, 0, 1}, {1, 0, 0}}, 0};
  const AnySpatialConstraint<double> guides[] = {PrismaticJoint<double>{{guide, on_body}},
                                                 CylindricalJoint<double>{{guide, on_body}},
                                                 PlanarJoint<double>{{guide, on_body}}};
  for (const AnySpatialConstraint<double>& each : guides) {
    for (const bool driven : {false, true}) {
      SpatialScene scene;
      scene.file = scene.name = "guide";
      scene.gravity = {1, 2, -9};
      SpatialSceneBody body;
      body.name = "slider";
      body.mass = 2;
      body.inertia.diagonal() << 0.01, 0.012, 0.015;
      body.orientation = euler_parameters<double>(a);
      body.position = guide.point - a * on_body.point;
      scene.bodies = {body};
      scene.constraints = {{"guide", each}};
      const auto* sleeve = std::get_if<CylindricalJoint<double>>(&each);
      if (driven && std::holds_alternative<PlanarJoint<double>>(each)) continue;  // it has no way to be driven along
      if (driven) {
        const auto swing = std::make_shared<const MotionShape<double>>(MotionShape<double>{0.05, 12, 0});
        scene.constraints.push_back({"ram", TranslationalDriver<double>{{guide, on_body}, {-0.05, 0, 0, swing}}});
      }
      scene.springs = {{"spring", SpatialTranslationalSpring<double>{
                                      {ground_body, {0.5, 0.3, 0.2}}, {0, {0.05, 0, 0}}, 300, 3, 0.4, 0}}};
      scene.run.duration = 1;
      scene.run.output_interval = 0.05;
      scene.run.stop_at_outputs = true;
      scene.energy_ledger = true;
      set_tolerance(scene, 1e-11);
      std::vector<SpatialTrajectory> runs;
      for (const SceneCoordinates coordinates : {SceneCoordinates::absolute, SceneCoordinates::independent}) {
        scene.coordinates = coordinates;
        if (driven && sleeve == nullptr && coordinates == SceneCoordinates::independent) continue;  // nothing is free
        runs.push_back(simulate_spatial(scene));
        INFO(each.index() << ", " << driven << ": " << runs.back().outcome.message);
        REQUIRE(runs.back().outcome.status == RunStatus::finished);
        CHECK(*runs.back().energy_residual < 1e-9 * runs.back().energy_scale);  // errors of the run
      }
      if (runs.size() < 2) continue;
      double worst = 0;
      for (std::size_t i = 0; i < runs[0].samples.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k)
          worst = std::max(worst, std::abs(runs[0].samples[i].state[k] - runs[1].samples[i].state[k]));
      }
      INFO(each.index() << ", " << driven);
      CHECK(worst < 1e-9);  // drift of the constraints in absolute coordinates
      if (driven)
        CHECK(runs[1].drivers[0].max_moment.value == Approx(runs[0].drivers[0].max_moment.value).epsilon(1e-7));
    }
  }
}

}  // namespace space_forces_test

// Equations of motion in space: derivatives, wrenches, momentum, energy, drivers, stops.
#include <Eigen/Geometry>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "lubjoint/ode/shifted_solver.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/spatial_scene_file.hpp"
#include "lubjoint/scene/spatial_simulate.hpp"
#include "support/embedded_scene.hpp"

namespace space_system_test {

using namespace lubjoint;
using namespace lubjoint::test;
using Catch::Matchers::Contains;
using V3 = Vector3<double>;
using Long = boost::multiprecision::cpp_bin_float_50;

namespace {

const std::string scenes = std::string(LUBJOINT_SOURCE_DIR) + "/data/scenes/space/";

BodyAxes<double> axes(std::size_t body, const V3& point, const V3& axis) {
  const V3 n = direction(axis);
  return {{point, n, any_perpendicular(n)}, body};
}

SpatialSceneBody some_body(const std::string& name, std::mt19937& random) {
  std::normal_distribution<double> normal;
  SpatialSceneBody body;
  body.name = name;
  body.mass = 0.5 + std::abs(normal(random));
  body.inertia << 3e-4, 1e-5, 2e-5, 1e-5, 4e-4, -1e-5, 2e-5, -1e-5, 5e-4;
  body.position = {normal(random), normal(random), normal(random)};
  body.orientation =
      normalised(EulerParameters<double>(normal(random), normal(random), normal(random), normal(random)));
  body.velocity = {normal(random), normal(random), normal(random)};
  body.spin = {normal(random), normal(random), normal(random)};
  return body;
}

/// Two free bodies, one with a bearing, one with a journal in it, off centre, tilted and sliding.
SpatialScene free_pair(unsigned seed) {
  std::mt19937 random(seed);
  SpatialScene scene;
  scene.file = scene.name = "pair";
  scene.bodies = {some_body("housing", random), some_body("shaft", random)};
  SceneJoint joint;
  joint.name = "film";
  joint.film = "pinkus_sternlicht";
  joint.viscosity = 0.1;
  joint.length = 0.04;
  joint.journal_radius = 0.0098;
  joint.clearance = 0.0002;
  const SpatialFrame<double> housing = frame_at_start(scene, 0);
  SpatialSceneBody& shaft = scene.bodies[1];
  const BodyAxes<double> bearing = axes(0, {0.02, 0.03, -0.01}, {1, 2, -1});
  const V3 n = inertial_vector(housing, bearing.axis);
  const V3 pierced = point_motion(housing, bearing.point).position + 7e-5 * inertial_vector(housing, bearing.across) +
                     4e-5 * inertial_vector(housing, bearing.third());
  const V3 n_journal = direction(V3(n + 2e-3 * inertial_vector(housing, bearing.across)));
  const V3 arm(0.01, -0.02, 0.015);
  const Matrix3<double> a = rotation_matrix(shaft.orientation);
  shaft.position = pierced + 5e-3 * n_journal - product(a, arm);
  // It nearly moves with the housing, and spins in it.
  const V3 spin = housing.spin + 30.0 * n;
  shaft.spin = transposed_product(a, spin);
  shaft.velocity = point_motion(housing, bearing.point).velocity - spin.cross(product(a, arm));
  scene.joints.push_back({joint, bearing, axes(1, arm, transposed_product(a, n_journal))});
  scene.run.duration = 0.05;
  scene.run.output_interval = 0.005;
  return scene;
}

/// Six cubics that are all different, over three turns.
std::shared_ptr<const TableCurves<6>> some_curves() {
  using Cubic = TableCurves<6>::Cubic;
  std::vector<std::array<Cubic, 6>> pieces(3);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      const double x = 0.3 * static_cast<double>(k + 1) + static_cast<double>(i);
      pieces[i][k] = {x, std::sin(3 * x), std::cos(5 * x), 0.1 * std::sin(7 * x)};
    }
  }
  return std::make_shared<const TableCurves<6>>(std::vector<double>{-7, -1, 3, 11.8}, pieces, true);
}

/// A mechanism with most kinds of constraint, at a random state that fulfils none: its equations hold anywhere.
SpatialScene every_constraint(unsigned seed) {
  SpatialScene scene = free_pair(seed);
  std::mt19937 random(seed + 100);
  scene.bodies.push_back(some_body("third", random));
  scene.bodies.push_back(some_body("fourth", random));
  const auto swing = std::make_shared<const MotionShape<double>>(MotionShape<double>{0.2, 6, 0.4});
  const BodyAxes<double> a = axes(0, {0.05, 0.02, 0.03}, {1, 2, 3});
  const BodyAxes<double> b = axes(2, {0.01, -0.02, 0.03}, {0.3, 2, -1});
  const BodyAxes<double> c = axes(ground_body, {0.1, 0.2, 0.3}, {1, 0.2, 0.5});
  scene.constraints = {{"pin", RevoluteJoint<double>{{c, a}}},
                       {"cross", UniversalJoint<double>{{a, b}}},
                       {"rod", DistanceJoint<double>{{{1, {0.05, 0.02, 0.03}}, {2, {-0.03, 0.01, 0.02}}}, 0.3}},
                       {"sleeve", CylindricalJoint<double>{{axes(1, {0.01, 0, 0}, {0, 1, 1}), b}}},
                       {"motor", RotationalDriver<double>{{c, a}, {0.3, 2, 5, swing}}},
                       {"held", HeldSpin<double>{{c, axes(3, {0, 0, 0}, {0.4, -1, 0.2})}, {0.1, 3, 0}}},
                       {"ram", TranslationalDriver<double>{{axes(1, {0.01, 0, 0}, {0, 1, 1}), b}, {0.1, 1, 2, swing}}}};
  scene.angles = {{c, a, 0}, {axes(1, {0.01, 0, 0}, {0, 1, 1}), b, 7}};
  scene.springs = {{"spring", SpatialTranslationalSpring<double>{{0, {0.01, 0, 0}}, {2, {0, 0.02, 0}}, 100, 2, 0.1, 3}},
                   {"torsion", SpatialRotationalSpring<double>{1, 1, 2, 5, 0.2, 0.3}}};
  SpatialSceneLoad load;
  load.body = 2;
  load.force = {1, 2, 3};
  load.moment = {0.1, 0.2, 0.3};
  load.point = {0.01, 0.02, 0};
  load.turns_with_body = true;
  load.harmonic = SceneHarmonic{10, 0.3};
  scene.loads = {load};
  load.harmonic.reset();
  load.table = SpatialSceneTable{some_curves(), true, 0};
  scene.loads.push_back(load);
  load.turns_with_body = false;
  load.table->of_angle = false;
  scene.loads.push_back(load);
  SpatialSceneLoad unbalance;
  unbalance.body = 3;
  unbalance.unbalance = V3(0.01, 0.02, -0.03);
  scene.loads.push_back(unbalance);
  scene.gravity = {0, 1, -9.81};
  return scene;
}

/// Spatial angular momentum about the origin, and its rate from accelerations.
V3 momentum_rate(const SpatialScene& scene, const SpatialWorkspace<double>& w) {
  V3 total = V3::Zero();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SpatialFrame<double>& at = w.frames[b];
    const V3 a(w.accelerations[6 * b], w.accelerations[6 * b + 1], w.accelerations[6 * b + 2]);
    const V3 alpha(w.accelerations[6 * b + 3], w.accelerations[6 * b + 4], w.accelerations[6 * b + 5]);
    const V3 in_body = scene.bodies[b].inertia * alpha + at.body_spin.cross(V3(scene.bodies[b].inertia * at.body_spin));
    total += scene.bodies[b].mass * at.position.cross(a) + at.rotation * in_body;
  }
  return total;
}

V3 angular_momentum(const SpatialScene& scene, const std::vector<double>& y) {
  V3 total = V3::Zero();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SpatialFrame<double> at(spatial_motion_in(y.data(), scene.bodies.size(), b));
    total +=
        scene.bodies[b].mass * at.position.cross(at.velocity) + at.rotation * (scene.bodies[b].inertia * at.body_spin);
  }
  return total;
}

/// The same scene, turned and shifted as a whole.
SpatialScene moved(SpatialScene scene, const Plane& by) {
  const Matrix3<double> a = rotation_matrix(by.orientation);
  const auto turned = [&](V3& v) { v = a * v; };
  const auto placed = [&](V3& v) { v = a * v + by.shift; };
  turned(scene.gravity);
  for (SpatialSceneBody& body : scene.bodies) {
    placed(body.position);
    turned(body.velocity);
    body.orientation = euler_parameters<double>(Matrix3<double>(a * rotation_matrix(body.orientation)));
  }
  const auto moved_axes = [&](BodyAxes<double>& at) {
    if (at.body != ground_body) return;
    placed(at.point);
    turned(at.axis);
    turned(at.across);
  };
  for (SpatialSceneJoint& joint : scene.joints) {
    moved_axes(joint.bearing);
    moved_axes(joint.journal);
  }
  for (SpatialSceneConstraint& each : scene.constraints) {
    std::visit(
        [&](auto& c) {
          if constexpr (requires { c.first.axis; }) {
            moved_axes(c.first);
            moved_axes(c.second);
          } else {
            for (SpatialBodyPoint<double>* at : {&c.first, &c.second}) {
              if (at->on_ground()) placed(at->point);
            }
          }
        },
        each.constraint);
  }
  for (NamedSpatialSpring<double>& each : scene.springs) {
    auto* spring = std::get_if<SpatialTranslationalSpring<double>>(&each.spring);
    if (spring == nullptr) continue;
    for (SpatialBodyPoint<double>* at : {&spring->first, &spring->second}) {
      if (at->on_ground()) placed(at->point);
    }
  }
  for (CountedAngle<double>& angle : scene.angles) {
    moved_axes(angle.first);
    moved_axes(angle.second);
  }
  return scene;
}

}  // namespace

TEST_CASE("space: the Jacobian is exact, by differences of longer numbers") {
  for (const unsigned seed : {1u, 2u}) {
    const SpatialScene scene = every_constraint(seed);
    const auto system = spatial_system<double>(scene);
    SpatialOde<double> ode(system, false);
    const std::vector<double> y = scene_start<double>(scene);
    const double t = 0.1;
    Eigen::MatrixXd jacobian;
    ode.jacobian(y, jacobian, t);
    std::vector<double> slope;
    ode.time_slope(y, slope, t);
    const auto longer = spatial_system<Long>(scene);
    auto w = longer.workspace<Long>();
    const auto at = [&](std::size_t column, const Long& by) {
      std::vector<Long> x(y.begin(), y.end());
      if (column < x.size()) x[column] += by;
      longer.evaluate(Long(column < x.size() ? Long(t) : Long(t + by)), x.data(), {}, w);
      std::vector<Long> result;
      for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const auto p = euler_rate(w.frames[b].parameters, w.frames[b].body_spin);
        for (Eigen::Index k = 0; k < 3; ++k) result.push_back(w.frames[b].velocity(k));
        for (Eigen::Index k = 0; k < 4; ++k) result.push_back(p(k));
      }
      result.insert(result.end(), w.accelerations.begin(), w.accelerations.end());
      return result;
    };
    for (std::size_t column = 0; column <= y.size(); ++column) {
      const Long h = 1e-15;  // of fifty digits, differences have twenty good ones
      const auto above = at(column, h);
      const auto below = at(column, -h);
      for (std::size_t row = 0; row < y.size(); ++row) {
        const double wanted = static_cast<double>(Long((above[row] - below[row]) / (2 * h)));
        const double given = column < y.size()
                                 ? jacobian(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column))
                                 : slope[row];
        const double size = 1 + jacobian.row(static_cast<Eigen::Index>(row)).cwiseAbs().maxCoeff();
        INFO("row " << row << ", column " << column << ": " << given << " and " << wanted);
        CHECK(std::abs(given - wanted) < 1e-9 * size);  // rounding, by the condition of the constraints, some 1e5
      }
    }
  }
}

TEST_CASE("space: the Jacobian of a journal that slides on its half film's jump is exact, and it stays on its line") {
  for (const char* file : {"engine", "spatial-slider-crank"}) {  // two films, of which one slides; one with a shear
    SpatialScene scene = load_spatial_scene(scenes + std::string(file) + ".toml");
    scene.joints[0].plane.film = "short_half";
    if (scene.joints.size() == 1) scene.joints[0].plane.shear = ShearExtent::film;
    const auto prepared = prepare_spatial(scene);
    SpatialOde<double> ode(prepared.system, true);
    std::vector<double> y = prepared.start;
    y.resize(ode.dimension(), 0.0);
    const std::size_t moves = 7 * scene.bodies.size();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] += i < moves ? 1e-6 * number(random) : number(random);  // off it all
    JointMemory<double> memory;
    memory.side = FilmSide::sliding;
    memory.line = direction(Vector2<double>(0.6, -0.3));
    memory.line_angle = 0.2;
    ode.memory()[0] = memory;
    const double t = 1e-4;
    Eigen::MatrixXd jacobian;
    ode.jacobian(y, jacobian, t);
    std::vector<double> slope(y.size());
    ode.time_slope(y, slope, t);
    const auto longer = spatial_system<Long>(scene);
    auto w = longer.workspace<Long>();
    std::vector<JointMemory<Long>> memories(scene.joints.size());
    memories[0].side = FilmSide::sliding;
    memories[0].line = memory.line.cast<Long>();
    memories[0].line_angle = memory.line_angle;
    const auto at = [&](std::size_t column, const Long& by) {
      std::vector<Long> x(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(longer.states()));
      if (column < x.size()) x[column] += by;
      longer.evaluate(Long(column < x.size() ? Long(t) : Long(t + by)), x.data(), memories, w);
      return w.accelerations;
    };
    for (std::size_t column = 0; column <= longer.states(); ++column) {
      const bool of_time = column == longer.states();
      const Long h = 1e-20;  // of fifty digits, of clearances of 1e-4 m: differences have twenty good ones
      const auto above = at(column, h);
      const auto below = at(column, -h);
      for (std::size_t i = 0; i < above.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(moves + i);
        const double wanted = static_cast<double>(Long((above[i] - below[i]) / (2 * h)));
        const double given = of_time ? slope[moves + i] : jacobian(row, static_cast<Eigen::Index>(column));
        // Of what film and constraints do to the row, and what cancels in the column.
        double size = 1 + std::max(std::abs(wanted), jacobian.row(row).cwiseAbs().maxCoeff());
        if (!of_time) size = std::max(size, jacobian.col(static_cast<Eigen::Index>(column)).cwiseAbs().maxCoeff());
        INFO(file << ": row " << row << ", column " << column << ": " << given << " and " << wanted);
        CHECK(std::abs(given - wanted) < 1e-8 * size);  // rounding, by the condition of constraints and line, some 1e7
      }
    }
    // Φ̈ of its line: the slope of Φ̇ along the motion.
    const auto rate_across = [&](const std::vector<double>& at, double time) {
      const SpatialWorkspace<double>& w = ode.at(time, at);
      REQUIRE(w.slides.size() == 1);
      const double* v = at.data() + moves;
      return detail::across_line(prepared.system, w.slides[0], [v](std::size_t i) { return v[i]; });
    };
    std::vector<double> rate(y.size()), later = y, earlier = y;
    ode.rate(y, rate, t);
    double largest = 0;
    for (std::size_t i = moves; i < ode.mechanical_states(); ++i) largest = std::max(largest, std::abs(rate[i]));
    const double h = 1e-8;
    for (std::size_t i = 0; i < y.size(); ++i) {
      later[i] += h * rate[i];
      earlier[i] -= h * rate[i];
    }
    const double bent = (rate_across(later, t + h) - rate_across(earlier, t - h)) / (2 * h);
    CHECK(std::abs(bent) < 1e-6 * largest);  // of the accelerations: rounding over h
  }
}

TEST_CASE("space: implicit steps solve six equations a body, and give what all thirteen give") {
  SpatialScene scene = load_spatial_scene(scenes + "engine.toml");
  const auto prepared = prepare_spatial(scene);
  SpatialOde<double> ode(prepared.system, true);
  std::vector<double> y = prepared.start;
  y.resize(ode.dimension(), 0.0);
  Eigen::MatrixXd jacobian;
  ode.jacobian(y, jacobian, 0.0);
  REQUIRE(bodies_of_kinematic_form(jacobian) == 3);
  Eigen::MatrixXd other = jacobian;
  other(3, 0) = 0.1;  // a parameter whose rate depends on a place: another form
  REQUIRE(bodies_of_kinematic_form(other) == 0);
  const double gamma = 2e4, alpha = 1.5e4, beta = 1e4;
  for (const Eigen::MatrixXd& j : {jacobian, other}) {
    ShiftedSolver<double, Eigen::Dynamic> solver(j.rows());
    solver.factorise(j, gamma, {alpha}, {beta});
    const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(j.rows(), -1, 2);
    const Eigen::VectorXd also = Eigen::VectorXd::LinSpaced(j.rows(), 3, 1);
    const Eigen::VectorXd right = gamma * wanted - j * wanted;
    Eigen::VectorXd x(j.rows());
    solver.solve(right, x);
    // Residuals, in parts of what is subtracted: rounding, by the condition of the film's stiffness.
    const auto near_zero = [&](const Eigen::VectorXd& residual, const Eigen::VectorXd& of) {
      const Eigen::VectorXd size = gamma * of.cwiseAbs() + j.cwiseAbs() * of.cwiseAbs();
      return (residual.array().abs() <= 1e-12 * size.array() + 1e-12).all();
    };
    CHECK(near_zero(gamma * x - j * x - right, x));
    Eigen::VectorXd real = alpha * wanted - beta * also - j * wanted;
    Eigen::VectorXd imaginary = alpha * also + beta * wanted - j * also;
    const Eigen::VectorXd r = real, s = imaginary;
    solver.solve_in_place(0, real, imaginary);
    const Eigen::VectorXd sizes = real.cwiseAbs() + imaginary.cwiseAbs();
    CHECK(near_zero(alpha * real - beta * imaginary - j * real - r, sizes));
    CHECK(near_zero(alpha * imaginary + beta * real - j * imaginary - s, sizes));
  }
}

TEST_CASE("space: every γ is the rate of Φ̇, and Φ̇ that of Φ, by differences along the motion") {
  const SpatialScene scene = every_constraint(5);
  const auto system = spatial_system<Long>(scene);
  const std::vector<Long> start = scene_start<Long>(scene);
  auto w = system.workspace<Long>();
  system.evaluate_kinematics(Long(0.1), start.data(), w);
  std::vector<Long> gamma;
  for (const auto& row : w.rows) gamma.push_back(row.gamma);
  const auto at = [&](const Long& h) {  // a motion of constant ṙ and ω′
    std::vector<Long> y = start;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const auto motion = spatial_motion_in(start.data(), scene.bodies.size(), b);
      const Long rate = norm(motion.body_spin);
      const EulerParameters<Long>& p = motion.parameters;
      const auto q = euler_parameters<Long>(direction(motion.body_spin), Long(rate * h));
      const Vector3<Long> e = p.tail<3>();
      const Vector3<Long> f = q.tail<3>();
      const Vector3<Long> turned = sum(sum(scaled(p(0), f), scaled(q(0), e)), cross(e, f));
      y[7 * b + 3] = p(0) * q(0) - dot(e, f);
      for (std::size_t k = 0; k < 3; ++k) {
        y[7 * b + k] += h * motion.velocity(static_cast<Eigen::Index>(k));
        y[7 * b + 4 + k] = turned(static_cast<Eigen::Index>(k));
      }
    }
    system.evaluate_kinematics(Long(Long(0.1) + h), y.data(), w);
    std::vector<std::pair<Long, Long>> rows;
    for (std::size_t row = 0; row < system.constraint_rows(); ++row)
      rows.push_back({w.rows[row].value, system.constraint_rate(row, w)});
    return rows;
  };
  const Long h = 1e-15;
  const auto above = at(h);
  const auto below = at(-h);
  const auto now = at(0);
  for (std::size_t row = 0; row < system.constraint_rows(); ++row) {
    INFO(scene.constraints[system.constraint_of(row)].name << ", row " << row);
    const double rate = static_cast<double>(Long((above[row].first - below[row].first) / (2 * h)));
    const double second = static_cast<double>(Long((above[row].second - below[row].second) / (2 * h)));
    // Of fifty digits the differences have twenty good ones; what is compared is rounded to double.
    CHECK(rate == Approx(static_cast<double>(now[row].second)).epsilon(1e-14).margin(1e-14));
    CHECK(second == Approx(-static_cast<double>(gamma[row])).epsilon(1e-14).margin(1e-14));
  }
}

TEST_CASE("space: a joint's wrenches have no resultant and no moment, and no momentum comes of them") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const SpatialScene scene = free_pair(seed);
    const auto system = spatial_system<double>(scene);
    auto w = system.workspace<double>();
    system.evaluate(0.0, scene_start<double>(scene).data(), {}, w);
    const SpatialWrench<double> on_journal = w.joints[0].on_journal();
    const SpatialWrench<double> on_bearing = w.joints[0].on_bearing();
    const double size = on_journal.force.norm();
    REQUIRE(size > 1);
    const V3 between = w.frames[1].position - w.frames[0].position;
    // About the housing's mass centre; rounding of arms of metres.
    CHECK((on_journal.force + on_bearing.force).norm() <= 1e-15 * size);  // rounding, as all below
    CHECK((on_journal.moment + on_bearing.moment + between.cross(on_journal.force)).norm() <= 1e-14 * size);
    CHECK(momentum_rate(scene, w).norm() <= 1e-13 * size);
    // The force lies in the bearing's middle plane, and acts where the journal's axis pierces it.
    const auto& k = w.joints[0].kinematics;
    CHECK(std::abs(on_journal.force.dot(k.axis)) <= 1e-14 * size);
    CHECK((w.frames[0].position + k.bearing_arm - w.frames[1].position - k.journal_arm).norm() < 1e-14);
    CHECK(std::abs(k.tilt() - 2e-3) < 1e-8);         // atan 2e-3
    CHECK(k.sliding == Approx(5e-3).epsilon(1e-9));  // rounding of places of a metre
    // Power of the wrenches, by the bodies' own velocities.
    double power = 0;
    for (std::size_t b : {0u, 1u}) {
      const SpatialWrench<double>& wrench = b == 0 ? on_bearing : on_journal;
      power += wrench.force.dot(w.frames[b].velocity) + wrench.moment.dot(w.frames[b].spin);
    }
    CHECK(w.joints[0].film_power() == Approx(power).epsilon(1e-9));  // of the two terms' rounding
  }
}

TEST_CASE("space: a free pair keeps its momentum, its energy is in the ledger, and |p| is 1") {
  for (const char* integrator : {"radau_iia5", "dopri5"}) {
    SpatialScene scene = free_pair(4);
    scene.run.duration = 0.005;
    scene.run.output_interval = 5e-4;
    scene.energy_ledger = true;
    scene.integrator = integrator;
    scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-10;
    const SpatialTrajectory run = simulate_spatial(scene);
    INFO(integrator << ": " << run.outcome.message);
    REQUIRE(run.outcome.status == RunStatus::finished);
    const V3 start = angular_momentum(scene, run.samples.front().state);
    for (const SpatialSample& sample : run.samples) {
      // To the run's tolerance, in units of places of a metre.
      CHECK((angular_momentum(scene, sample.state) - start).norm() < 1e-8 * start.norm());
      for (std::size_t b = 0; b < 2; ++b) {
        const EulerParameters<double> p = spatial_motion_in(sample.state.data(), 2, b).parameters;
        CHECK(std::abs(p.norm() - 1) < 4 * std::numeric_limits<double>::epsilon());  // rounding
      }
    }
    CHECK(*run.energy_residual < 1e-8 * run.energy_scale);  // of the tolerance, a hundred steps
    CHECK(run.drift.norm < 1e-9);                           // of a step at this tolerance
    const double film = run.samples.back().ledger[2 + static_cast<std::size_t>(LedgerTerm::film)];
    CHECK(std::abs(film) > 100 * *run.energy_residual);  // it would be missed
  }
}

TEST_CASE("space: a scene that is turned and shifted gives the turned and shifted answer") {
  SpatialScene scene = load_spatial_scene(scenes + "engine.toml");
  scene.run.duration /= 20;
  scene.run.output_interval = scene.run.duration / 10;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-10;
  scene.run.stop_at_outputs = true;
  const Plane by = some_plane(2);
  const SpatialTrajectory one = simulate_spatial(scene);
  const SpatialTrajectory other = simulate_spatial(moved(scene, by));
  REQUIRE(one.outcome.status == RunStatus::finished);
  REQUIRE(other.outcome.status == RunStatus::finished);
  const Matrix3<double> a = rotation_matrix(by.orientation);
  double worst = 0;
  for (std::size_t i = 0; i < one.samples.size(); ++i) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const auto first = spatial_motion_in(one.samples[i].state.data(), scene.bodies.size(), b);
      const auto second = spatial_motion_in(other.samples[i].state.data(), scene.bodies.size(), b);
      worst = std::max(worst, (a * first.position + by.shift - second.position).norm());
    }
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
      const V3 force = a * one.samples[i].joints[j].force - other.samples[i].joints[j].force;
      CHECK(force.norm() < 1e-5 * one.joints[j].force.value);  // a film multiplies errors of places
    }
  }
  CHECK(worst < 1e-8 * 50e-6);  // of the tolerance, in clearances
}

TEST_CASE("space: the order of bodies, constraints and joints is irrelevant") {
  const SpatialScene scene = load_spatial_scene(scenes + "engine.toml");
  SpatialScene other = scene;
  const std::vector<std::size_t> order = {2, 0, 1};  // body b is order[b] of the first scene
  for (std::size_t b = 0; b < 3; ++b) other.bodies[b] = scene.bodies[order[b]];
  const auto renumber = [&](std::size_t& body) {
    if (body != ground_body)
      body = static_cast<std::size_t>(std::find(order.begin(), order.end(), body) - order.begin());
  };
  std::reverse(other.constraints.begin(), other.constraints.end());
  std::reverse(other.joints.begin(), other.joints.end());
  for (auto& joint : other.joints) {
    renumber(joint.bearing.body);
    renumber(joint.journal.body);
  }
  for (auto& each : other.constraints) {
    std::visit(
        [&](auto& c) {
          renumber(c.first.body);
          renumber(c.second.body);
        },
        each.constraint);
  }
  for (auto& each : other.springs) {
    auto& spring = std::get<SpatialTranslationalSpring<double>>(each.spring);
    renumber(spring.first.body);
    renumber(spring.second.body);
  }
  const auto first = spatial_system<double>(scene);
  const auto second = spatial_system<double>(other);
  auto v = first.workspace<double>();
  auto w = second.workspace<double>();
  first.evaluate(0.0, scene_start<double>(scene).data(), {}, v);
  second.evaluate(0.0, scene_start<double>(other).data(), {}, w);
  double scale = 0;
  for (const double a : v.accelerations) scale = std::max(scale, std::abs(a));
  for (std::size_t b = 0; b < 3; ++b) {
    for (std::size_t k = 0; k < 6; ++k)
      CHECK(std::abs(w.accelerations[6 * b + k] - v.accelerations[6 * order[b] + k]) < 1e-12 * scale);  // rounding
  }
}

TEST_CASE("space: a motor's angle is counted through revolutions, and its moment is what the body takes") {
  SpatialScene scene;
  scene.file = scene.name = "motor";
  SpatialSceneBody rotor;
  rotor.name = "rotor";
  rotor.mass = 1;
  rotor.inertia.diagonal() << 1e-3, 2e-3, 2.5e-3;
  scene.bodies = {rotor};
  const BodyAxes<double> on_ground{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, ground_body};
  const BodyAxes<double> on_rotor{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, 0};
  scene.constraints = {{"pin", RevoluteJoint<double>{{on_ground, on_rotor}}},
                       {"motor", RotationalDriver<double>{{on_ground, on_rotor}, {0, 0, 8}}}};
  scene.run.duration = 5;  // ½ 8 5² = 100 rad, sixteen revolutions
  scene.run.output_interval = 0.05;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-10;
  const SpatialTrajectory run = simulate_spatial(scene);
  REQUIRE(run.outcome.status == RunStatus::finished);
  const auto at_end = spatial_motion_in(run.samples.back().state.data(), 1, 0);
  CHECK(at_end.body_spin.z() == Approx(40).epsilon(1e-9));                     // of the tolerance
  CHECK(std::abs(at_end.parameters(0) - std::cos(50.0)) < 1e-7);               // of the tolerance, on 100 rad
  CHECK(run.drivers[0].max_moment.value == Approx(8 * 2.5e-3).epsilon(1e-7));  // of the tolerance
  CHECK(run.driver_turns[0]);
}

TEST_CASE("space: a journal that tilts to the bearing's edge stops the run there, by name") {
  SpatialScene scene = free_pair(7);
  scene.bodies[1].spin =
      transposed_product(rotation_matrix(scene.bodies[1].orientation),
                         V3(frame_at_start(scene, 0).spin +
                            3.0 * inertial_vector(frame_at_start(scene, 0), scene.joints[0].bearing.third())));
  const SpatialTrajectory run = simulate_spatial(scene);
  CHECK(run.outcome.status == RunStatus::stopped);
  CHECK_THAT(run.outcome.message, Contains("film of joint \"film\" ends at its edge") && Contains("tilt of"));
  const SpatialJointSample& last = run.samples.back().joints[0];
  // |e| + ψL/2 = c, located as an event.
  CHECK(last.eccentricity_ratio * 2e-4 + last.tilt * 0.02 ==
        Approx(2e-4).epsilon(1e-9));  // the step to an event ends there to 1e-12 of a clearance
  CHECK(run.joints[0].edge_share.value == Approx(1).epsilon(1e-6));  // c − |e| is a difference
}

TEST_CASE("space: a journal across its bearing has no film: it is refused, and named") {
  SpatialScene scene = free_pair(7);
  const V3 across = inertial_vector(frame_at_start(scene, 0), scene.joints[0].bearing.across);
  scene.joints[0].journal.axis = transposed_product(rotation_matrix(scene.bodies[1].orientation), across);
  scene.joints[0].journal.across = any_perpendicular(scene.joints[0].journal.axis);
  CHECK_THROWS_WITH(simulate_spatial(scene), Contains("starts across its bearing"));
}

TEST_CASE("space: Euler parameters of a rotation matrix give it back, whichever of them is largest") {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    EulerParameters<double> p(normal(random), normal(random), normal(random), normal(random));
    if (i % 5 > 0) p(i % 5 - 1) *= 1e-9;  // one of them next to nothing
    p = normalised(p);
    const EulerParameters<double> back = euler_parameters<double>(rotation_matrix(p));
    CHECK((rotation_matrix(back) - rotation_matrix(p)).norm() < 1e-14);  // rounding of products
    CHECK(std::min((back - p).norm(), (back + p).norm()) < 1e-14);       // rounding
  }
}

}  // namespace space_system_test
